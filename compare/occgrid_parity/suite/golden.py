"""Golden results: the hash of every scan's log-odds and the picture of the last."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.formats.errors import OutputError, shown
from occgrid_parity.formats.pgm import Pixels, read_pgm
from occgrid_parity.suite.modes import Mode

LINE = re.compile(r"scan (0|[1-9][0-9]*) ([0-9a-f]{64})")


@dataclass(frozen=True)
class GoldenMap:
    """A committed result.

    ``scans[s]`` is the hash of the log-odds after scan s (see
    occgrid_parity.formats.log_odds.hash_log_odds), ``pixels`` the picture of the finished map, with
    shape (height, width), largest y first.
    """

    hash_file: Path
    picture_file: Path
    scans: Sequence[str]
    pixels: Pixels


def golden_files(folder: Path, name: str, mode: Mode) -> tuple[Path, Path]:
    """The files of a golden result: hashes, picture."""
    stem = f"{name}.{mode.map_name}"
    return folder / f"{stem}.sha256", folder / f"{stem}.pgm"


def read_golden(folder: Path, name: str, mode: Mode) -> GoldenMap | None:
    """The golden result, or None where neither of its files is there.

    Raises OutputError where one of them alone is there or is not well formed.
    """
    hash_file, picture_file = golden_files(folder, name, mode)
    there = [path.is_file() for path in (hash_file, picture_file)]
    if not any(there):
        return None
    if not all(there):
        raise OutputError(
            (hash_file, picture_file)[there.index(False)], "is missing"
        )
    return GoldenMap(
        hash_file, picture_file, read_hashes(hash_file), read_pgm(picture_file)
    )


def read_hashes(path: Path) -> list[str]:
    """The hash of each scan. Raises OutputError at the first line that is none."""
    hashes: list[str] = []
    text = path.read_bytes().decode("ascii", "backslashreplace")
    for number, line in enumerate(text.splitlines(), 1):
        match = LINE.fullmatch(line)
        if match is None or int(match[1]) != len(hashes):
            found = shown(line.encode())
            expected = f"scan {len(hashes)} and 64 hexadecimal digits"
            raise OutputError(
                path, f"expected {expected}, found {found}", number
            )
        hashes.append(match[2])
    if not hashes or not text.endswith("\n"):
        raise OutputError(
            path, "has no scan" if not hashes else "has no last LF"
        )
    return hashes


def hashes_text(hashes: Sequence[str]) -> str:
    """The hashes as the file's text."""
    return "".join(
        f"scan {scan} {digest}\n" for scan, digest in enumerate(hashes)
    )
