"""Finds the map that a program has written, in whatever way it did, and says what is wrong with the file."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.log_odds import LogOdds, read_log_odds
from occgrid_parity.formats.map_files import YAML_LIMIT
from occgrid_parity.formats.pgm import Pixels, read_any_pgm
from occgrid_parity.formats.plain_text import clean

KNOWN = {
    b"\x89PNG": "a PNG picture",
    b"\xff\xd8\xff": "a JPEG picture",
    b"BM": "a BMP picture",
    b"GIF8": "a GIF picture",
    b"P1": "a PBM picture (P1: two colours)",
    b"P3": "a PPM picture (P3: colours)",
    b"P4": "a PBM picture (P4: two colours)",
    b"P6": "a PPM picture (P6: colours)",
    b"P7": "a PAM picture (P7)",
}
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
    """The map of one run: ``pgm``, else the folder's only picture, else standard output."""
    remarks: tuple[str, ...] = ()
    picture = _find(out, pgm)
    if isinstance(picture, Unreadable):
        return picture
    if picture is None:
        with stdout.open("rb") as file:
            begin = file.read(64).lstrip()
        if not re.match(rb"P[1-7]\s", begin):
            remark = _cut_banner(stdout)
            if not remark:
                return _nothing(out, begin)
            remarks = (remark,)
        picture = stdout
    name = "standard output" if picture == stdout else picture.name
    try:
        pixels = read_any_pgm(picture)
    except OutputError as error:
        return _diagnosis(picture, name, error)
    except OSError as error:
        return Unreadable("no map", f"{name} cannot be read: {error.strerror}")
    found = Observed(
        pixels,
        None,
        name,
        _yaml(out, pgm),
        hashlib.sha256(picture.read_bytes()).hexdigest(),
        _top(picture),
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


def _top(picture: Path) -> int:
    """The maximum in the header of a picture that has been read."""
    with picture.open("rb") as file:
        head = file.read(65536)
    words = re.sub(rb"#[^\n\r]*", b"", head).split(maxsplit=4)
    return int(words[3])


def _cut_banner(stdout: Path) -> str:
    """Drops what was printed before a picture; says what it was, empty where there is no picture."""
    data = stdout.read_bytes()
    start = re.search(rb"(?:^|[\n\r])(P[25]\s+[0-9#])", data)
    if start is None:
        return ""
    before = data[: start.start(1)]
    printed = clean(before.decode("utf-8", "replace").strip())[:40]
    stdout.write_bytes(data[start.start(1) :])
    return (
        f"standard output has {len(before)} bytes before the picture ({printed!r}); print such lines on standard "
        "error. The map behind them is graded"
    )


def _find(out: Path, pgm: Path) -> Path | Unreadable | None:
    """The picture in the folder, None where there is none."""
    if pgm.is_file():
        return pgm
    found = sorted(p for p in out.rglob("*.pgm") if p.is_file())
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:4])
        return Unreadable(
            "no map",
            f"there are {len(found)} pictures and none is {pgm.name}: {names}",
        )
    return found[0] if found else None


def _nothing(out: Path, begin: bytes) -> Unreadable:
    """Why no picture was found."""
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
    if data[:2] not in PICTURE:
        for magic, what in KNOWN.items():
            if data.startswith(magic):
                return Unreadable(
                    "wrong magic", f"{name} is {what}, not P2 or P5"
                )
        shown = data[:8].decode("ascii", "backslashreplace").split("\n")[0]
        return Unreadable(
            "wrong magic",
            f"{name} begins with {shown!r}, a PGM picture with P2 or P5",
        )
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
