"""Writing a map: picture (PGM), its description (YAML), log-odds (SPEC.md section 7)."""

from __future__ import annotations

import os
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.grid import Array, OccupancyGrid, sigmoid


# [snippet: pixel]
def pixel(log_odds: Array | float) -> npt.NDArray[np.int64]:
    """Grey values of log-odds, of any shape: 0 is occupied, 255 is free."""
    free = 1.0 - sigmoid(log_odds)
    return np.floor(free * 255.0 + 0.5).astype(np.int64)


# [/snippet]


# [snippet: map-pgm]
def map_pgm(grid: OccupancyGrid) -> str:
    """The map as an ASCII PGM (P2), the row with the largest y first."""
    lines = ["P2", f"{grid.spec.width} {grid.spec.height}", "255"]
    for row in pixel(grid.log_odds)[::-1].tolist():
        lines.append(" ".join(map(str, row)))
    return "\n".join(lines) + "\n"


# [/snippet]


def map_yaml(grid: OccupancyGrid, image: str) -> str:
    """The description that map_server and Nav2 read beside the picture ``image``."""
    spec = grid.spec
    return (
        f"image: {image}\n"
        "mode: trinary\n"
        f"resolution: {_fixed(spec.resolution)}\n"
        f"origin: [{_fixed(spec.origin_x)}, {_fixed(spec.origin_y)}, 0.0]\n"
        "negate: 0\n"
        "occupied_thresh: 0.65\n"
        "free_thresh: 0.196\n"
    )


def map_log_odds(grid: OccupancyGrid) -> str:
    """The log-odds as text that reads back to the same doubles, the row with the smallest y first."""
    lines = [f"# logodds {grid.spec.width} {grid.spec.height}"]
    for row in grid.log_odds.tolist():
        lines.append(" ".join(map(repr, row)))
    return "\n".join(lines) + "\n"


def write_map(folder: Path, name: str, grid: OccupancyGrid) -> None:
    """Write NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is made where it is missing.

    Each file is renamed into place when all of them are whole. Raises OSError, its ``filename`` the folder or file
    that cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(folder)) from error
    texts = {
        folder / f"{name}.pgm": map_pgm(grid),
        folder / f"{name}.yaml": map_yaml(grid, f"{name}.pgm"),
        folder / f"{name}.logodds": map_log_odds(grid),
    }
    written: dict[Path, Path] = {}
    try:
        for path, text in texts.items():
            beside = path.with_name(f".{path.name}.{os.getpid()}.part")
            written[path] = beside
            try:
                beside.write_text(
                    text,
                    encoding="utf-8",
                    errors="surrogateescape",
                    newline="\n",
                )
            except OSError as error:
                raise OSError(
                    error.errno, error.strerror, str(path)
                ) from error
        for path, beside in written.items():
            beside.replace(path)
    except BaseException:
        for beside in written.values():
            beside.unlink(missing_ok=True)
        raise


def _fixed(value: float) -> str:
    """The exact value rounded to nine decimals, without trailing zeros but one."""
    with localcontext(prec=60):
        text = f"{Decimal(value).quantize(Decimal('1e-9')):f}".rstrip("0")
    text += "0" if text.endswith(".") else ""
    return "0.0" if text == "-0.0" else text
