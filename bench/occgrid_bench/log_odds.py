"""Compares maps, as the contestants wrote them, with the contract's."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.fast import update_grid_from_scans
from occgrid.grid import OccupancyGrid
from occgrid.sensor import Scan
from occgrid_bench.work import Work

Array = npt.NDArray[np.float64]


def contract_map(work: Work) -> Array:
    """The work's log-odds (height, width), as the Python port maps it."""
    grid = OccupancyGrid(work.spec)
    scans = [
        Scan(pose, work.angles, ranges)
        for pose, ranges in zip(work.poses, work.ranges, strict=True)
    ]
    update_grid_from_scans(grid, scans, work.max_range)
    return grid.log_odds


def differing(path: Path, expected: Array) -> int:
    """How many cells of a map differ from the expected one, in any bit."""
    text = path.read_text(encoding="ascii").split("\n", 1)[1]
    found = np.array(text.split(), dtype=np.float64)
    if found.size != expected.size:
        raise ValueError(f"{path}: {found.size} cells, not {expected.size}")
    return int(np.sum(found.view(np.int64) != expected.ravel().view(np.int64)))
