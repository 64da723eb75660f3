"""Writing a map: picture (PGM), its description (YAML), log-odds (SPEC.md section 7)."""

from __future__ import annotations

import errno
import os
import re
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from decimal import ROUND_HALF_EVEN, Decimal, localcontext
from pathlib import Path
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from occgrid.grid import OccupancyGrid, logit, sigmoid
from occgrid.portable_math import Array

# cells whose pixels are computed together, a row or more: bounds the memory, whatever the grid
CELLS_AT_ONCE = 1 << 14
# seconds after which the temporary file of a run that was killed is removed
OLD_AGE = 24 * 60 * 60


# [snippet: pixel]
def pixel(log_odds: Array | float) -> npt.NDArray[np.int64]:
    """Grey values of log-odds, of any shape: 0 is occupied, 255 is free."""
    free = 1.0 - sigmoid(log_odds)
    return np.floor(free * 255.0 + 0.5).astype(np.int64)


# [/snippet]


# [snippet: map-pgm]
def map_pgm(grid: OccupancyGrid) -> Iterator[str]:
    """The map as an ASCII PGM (P2), the row with the largest y first.

    Yields the text in pieces, so that it never is in memory as a whole.
    """
    width, height = grid.spec.width, grid.spec.height
    yield f"P2\n{width} {height}\n255\n"
    rows_at_once = max(CELLS_AT_ONCE // width, 1)
    for top in range(height, 0, -rows_at_once):
        rows = grid.log_odds[max(top - rows_at_once, 0) : top]
        for row in pixel(rows[::-1]).tolist():
            yield " ".join(map(str, row)) + "\n"


# [/snippet]


def map_yaml(grid: OccupancyGrid, image: str) -> str:
    """The description that map_server and Nav2 read beside the picture ``image``.

    The thresholds follow the prior: a cell at the prior, which nothing touched, loads as unknown.
    """
    spec = grid.spec
    prior = 255 - int(pixel(grid.l0))
    occupied = max(_shifted(grid.l0, 0.65), (prior + 0.5) / 255.0)
    free = min(_shifted(grid.l0, 0.196), (prior - 0.5) / 255.0)
    return (
        f"image: {_quoted(image)}\n"
        "mode: trinary\n"
        f"resolution: {_fixed(spec.resolution)}\n"
        f"origin: [{_fixed(spec.origin_x)}, {_fixed(spec.origin_y)}, 0.0]\n"
        "negate: 0\n"
        f"occupied_thresh: {_fixed(min(occupied, 1.0))}\n"
        f"free_thresh: {_fixed(max(free, 0.0))}\n"
    )


def map_log_odds(grid: OccupancyGrid) -> Iterator[str]:
    """The log-odds as text that reads back to the same doubles, the row with the smallest y first; in pieces."""
    yield f"# logodds {grid.spec.width} {grid.spec.height}\n"
    for row in grid.log_odds:
        yield " ".join(map(repr, row.tolist())) + "\n"


def write_map(folder: str | Path, name: str, grid: OccupancyGrid) -> None:
    """Write NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is made where it is missing.

    All of them are written or, with an error, none. Raises OSError, its ``filename`` the folder or file that cannot be
    written.
    """
    files = _MapFiles(str(folder))
    try:
        files.write(f"{name}.pgm", map_pgm(grid))
        files.write(f"{name}.yaml", [map_yaml(grid, f"{name}.pgm")])
        files.write(f"{name}.logodds", map_log_odds(grid))
        files.rename()
    finally:
        files.remove_unfinished()


def remove_unfinished_maps() -> None:
    """Remove what write_map has not finished: for a program that a signal ends while it is writing."""
    for files in list(_MapFiles.all_unfinished):
        files.remove_unfinished()


# --- Text ---


def _shifted(l0: float, p: float) -> float:
    """The probability that the evidence p makes of the prior l0."""
    return float(sigmoid(l0 + logit(p)))


def _quoted(image: str) -> str:
    """A file name as YAML: as it is where that is safe, else in double quotes."""
    if re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]*", image):
        return image
    text = re.sub(r'["\\]', r"\\\g<0>", image)
    text = re.sub("[\x00-\x1f\x7f]", lambda c: f"\\x{ord(c[0]):02X}", text)
    return f'"{text}"'


def _fixed(value: float) -> str:
    """The exact value rounded to nine decimals, without trailing zeros but one."""
    with localcontext(prec=60, rounding=ROUND_HALF_EVEN):
        text = f"{Decimal(value).quantize(Decimal('1e-9')):f}".rstrip("0")
    text += "0" if text.endswith(".") else ""
    return "0.0" if text == "-0.0" else text


# --- Files ---


class _MapFiles:
    """The files of one map in a folder: written under temporary names, then renamed, all of them or none."""

    all_unfinished: ClassVar[set[_MapFiles]] = set()

    def __init__(self, folder: str) -> None:
        """Make the folder, and clear it of what killed runs have left there."""
        separators = "/" if os.sep == "/" else f"/{os.sep}"
        self.folder = folder.rstrip(separators)
        self.written: dict[str, Path] = {}  # from file to temporary file
        self.unfinished: set[Path] = set()
        path = Path(folder)
        with _error_names(self.folder or folder):
            path.mkdir(parents=True, exist_ok=True)
        self.path = path
        self.remove_old_leftovers()
        _MapFiles.all_unfinished.add(self)

    def remove_old_leftovers(self) -> None:
        """Remove the temporary files of runs that were killed long ago."""
        before = time.time() - OLD_AGE
        with suppress(OSError):  # who may not do it leaves it
            for file in self.path.glob(".occgrid-*.part"):
                form = r"\.occgrid-[A-Za-z0-9-]{1,40}\.part"
                if re.fullmatch(form, file.name):
                    with suppress(OSError):
                        if file.lstat().st_mtime < before:
                            file.unlink()

    def write(self, name: str, pieces: Iterable[str]) -> None:
        """Write a file under a temporary name, which does not depend on its own: that may fill all that a name can."""
        temporary = self.path / f".occgrid-{os.urandom(8).hex()}.part"
        self.unfinished.add(temporary)
        self.written[name] = temporary
        with _error_names(f"{self.folder}/{name}"):
            if (self.path / name).is_dir():
                raise IsADirectoryError(
                    errno.EISDIR, os.strerror(errno.EISDIR)
                )
            # the characters of NAME as the bytes that the system gave
            with temporary.open(
                "x",
                encoding=sys.getfilesystemencoding(),
                errors=sys.getfilesystemencodeerrors(),
                newline="\n",
            ) as file:
                file.writelines(pieces)

    def rename(self) -> None:
        """Give all files their names."""
        for name, temporary in self.written.items():
            file = self.path / name
            with _error_names(f"{self.folder}/{name}"):
                # first noted, then done: a signal may come in between
                self.unfinished.add(file)
                try:
                    temporary.replace(file)
                except OSError:
                    self.unfinished.discard(file)  # it is a former map's
                    raise
        self.unfinished.clear()

    def remove_unfinished(self) -> None:
        """Remove what is there if the files are not all there."""
        for file in self.unfinished:
            with suppress(OSError):
                file.unlink()
        self.unfinished.clear()
        _MapFiles.all_unfinished.discard(self)


@contextmanager
def _error_names(path: str) -> Iterator[None]:
    """Have an OSError name this path."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, path) from error
