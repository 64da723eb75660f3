"""Finds the map that a program has written, in whatever way it did, and says what is wrong with the file."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.log_odds import LogOdds, read_log_odds
from occgrid_parity.formats.map_files import YAML_LIMIT
from occgrid_parity.formats.pgm import Pixels
from occgrid_parity.formats.pictures import (
    SUFFIXES,
    CutOff,
    WrongKind,
    read_picture,
)
from occgrid_parity.formats.plain_text import clean

FLOAT = re.compile(rb"[-+]?[0-9]*\.[0-9]+(?:[eE][-+]?[0-9]+)?|nan|inf", re.I)
PICTURE = (b"P2", b"P5")


@dataclass(frozen=True)
class Observed:
    """The map that a program has drawn.

    ``pixels`` (height, width), largest y first; ``log_odds`` the same shape, smallest y first, or None where the
    program writes none. ``yaml`` is the text beside the picture, None where there is none; ``digest`` tells pictures
    apart byte for byte; ``top`` is the picture's own maximum, to which its levels are scaled to 0 .. 255; ``remarks``
    say what is odd about the file.
    """

    pixels: Pixels
    log_odds: LogOdds | None
    source: str
    yaml: str | None = None
    digest: str = ""
    top: int = 255
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Unreadable:
    """Why there is no map to look at: in a word or two, and at length."""

    word: str
    message: str


def find_map(out: Path, pgm: Path, stdout: Path) -> Observed | Unreadable:
    """The map of one run.

    It is ``pgm``, else the folder's only PGM picture, else one on standard output, else the folder's only picture of
    another kind.
    """
    remarks: tuple[str, ...] = ()
    picture = pgm if pgm.is_file() else _only(out, pgm, (".pgm",))
    if picture is None and (remark := _printed(stdout)) is not None:
        picture = stdout
        remarks = (remark,) if remark else ()
    if picture is None:
        picture = _only(out, pgm, SUFFIXES)
    if picture is None:
        return _nothing(out, stdout)
    if isinstance(picture, Unreadable):
        return picture
    name = "standard output" if picture == stdout else picture.name
    try:
        read = read_picture(picture)
    except OutputError as error:
        return _diagnosis(picture, name, error)
    except OSError as error:
        return Unreadable("no map", f"{name} cannot be read: {error.strerror}")
    if read.kind:
        remarks += (
            f"{name} is a {read.kind} picture; the programs of the suite write PGM. Its grey values are graded",
        )
    pixels = read.pixels
    found = Observed(
        pixels,
        None,
        name,
        _yaml(out, pgm),
        hashlib.sha256(picture.read_bytes()).hexdigest(),
        read.top,
        remarks,
    )
    log_odds_file = _beside(out, pgm, ".logodds")
    if log_odds_file is None:
        return found
    try:
        log_odds = read_log_odds(log_odds_file)
    except OutputError as error:
        return Unreadable("not a log-odds file", str(error))
    if log_odds.shape != pixels.shape:
        return Unreadable(
            "wrong size",
            f"{log_odds_file.name} has {_size(log_odds.shape)} cells, the picture {_size(pixels.shape)}",
        )
    return replace(found, log_odds=log_odds)


def _beside(out: Path, pgm: Path, suffix: str) -> Path | None:
    """The file of that kind beside the picture: its own, else the folder's only one."""
    own = pgm.with_suffix(suffix)
    if own.is_file():
        return own
    others = list(out.glob(f"*{suffix}"))
    return others[0] if len(others) == 1 else None


def _yaml(out: Path, pgm: Path) -> str | None:
    file = _beside(out, pgm, ".yaml")
    if file is None or file.stat().st_size > YAML_LIMIT:
        return None
    return file.read_bytes().decode("utf-8", "replace")


def _printed(stdout: Path) -> str | None:
    """What to remark about a picture on standard output, empty where it is alone there; None where there is none.

    What was printed before it is dropped.
    """
    with stdout.open("rb") as file:
        begin = file.read(64).lstrip()
    if re.match(rb"P[1-7]\s|\x89PNG\r\n", begin):
        return ""
    data = stdout.read_bytes()
    start = re.search(rb"(?:^|[\n\r])(P[25]\s+[0-9#])", data)
    if start is None:
        return None
    before = data[: start.start(1)]
    printed = clean(before.decode("utf-8", "replace").strip())[:40]
    stdout.write_bytes(data[start.start(1) :])
    return (
        f"standard output has {len(before)} bytes before the picture ({printed!r}); print such lines on standard "
        "error. The map behind them is graded"
    )


def _only(
    out: Path, pgm: Path, suffixes: Sequence[str]
) -> Path | Unreadable | None:
    """The only picture of these kinds in the folder; None where there is none."""
    files = sorted(p for p in out.rglob("*") if p.is_file())
    found = [p for p in files if p.suffix.lower() in suffixes]
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:4])
        return Unreadable(
            "no map",
            f"there are {len(found)} pictures and none is {pgm.name}: {names}",
        )
    return found[0] if found else None


def _nothing(out: Path, stdout: Path) -> Unreadable:
    """Why no picture was found."""
    with stdout.open("rb") as file:
        begin = file.read(64).lstrip()
    files = sorted(p.name for p in out.rglob("*") if p.is_file())
    if files:
        said = f"it wrote {', '.join(files[:4])}"
    elif begin:
        printed = begin.splitlines()[0].decode("utf-8", "replace")
        said = f"it wrote no file and printed {printed[:40]!r}"
    else:
        said = "it wrote no file and printed nothing"
    return Unreadable(
        "no map", f"no picture (*.pgm) in the output folder: {said}"
    )


def _diagnosis(path: Path, name: str, error: OutputError) -> Unreadable:
    """What is wrong with a picture, in the clearest words."""
    data = path.read_bytes()
    if not data.strip():
        return Unreadable("half a file", f"{name} is empty")
    if isinstance(error, WrongKind):
        return Unreadable("wrong magic", f"{name} {error.reason}")
    if isinstance(error, CutOff):
        return Unreadable("half a file", f"{name}: {error.reason}")
    if data[:2] not in PICTURE:
        return Unreadable("not a picture", f"{name}: {error.reason}")
    words = re.sub(rb"#[^\n\r]*", b"", data[2:]).split()
    floats = (
        [w for w in words[3:] if FLOAT.fullmatch(w)]
        if data[:2] == b"P2"
        else []
    )
    if floats:
        first = floats[0].decode()
        return Unreadable(
            "floats instead of integers",
            f"{name} has pixels such as {first}; a pixel is a whole number from 0 to 255",
        )
    short = re.fullmatch(r"([0-9]+) pixels, expected ([0-9]+)", error.reason)
    if short or len(words) < 3:
        said = error.reason if short else "it ends within its first lines"
        return Unreadable("half a file", f"{name}: {said}")
    return Unreadable("not a picture", f"{name}: {error.reason}")


def _size(shape: tuple[int, ...]) -> str:
    return f"{shape[1]} x {shape[0]}"
