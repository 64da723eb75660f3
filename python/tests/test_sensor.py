"""sensor: bearings, the meaning of ranges, and the update against plain loops."""

from __future__ import annotations

import math

import numpy as np
import pytest

from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.portable_math import pi
from occgrid.sensor import (
    NoReturn,
    Scan,
    beam_angles,
    flaser_angles,
    read_ranges,
    update_grid_from_scan,
)
from occgrid.world import Pose


def test_beam_angles() -> None:
    angles = beam_angles(pi, 181)
    assert angles[0] == -pi / 2
    assert angles[90] == 0.0
    assert angles[180] == pi / 2
    assert angles[37] == -(pi / 2.0) + (pi * 37.0) / 180.0
    assert beam_angles(pi, 1).tolist() == [0.0]


@pytest.mark.parametrize(
    ("beams", "last_degrees"),
    [
        (180, 89),
        (181, 90),
        (360, 89.5),
        (361, 90),
        (400, 9.75),
        (401, 10),
        (5, 90),
    ],
)
def test_flaser_angles(beams: int, last_degrees: float) -> None:
    angles = flaser_angles(beams)
    assert angles.size == beams
    assert angles[0] == -pi / 2
    assert math.degrees(angles[-1]) == pytest.approx(last_degrees)


def test_read_ranges() -> None:
    ranges = np.array([3.0, 0.0, 10.0 - 1e-13, 10.0, 11.0, math.inf, math.nan])
    z, hit, used = read_ranges(ranges, 10.0, "free")
    assert z[:6].tolist() == [3.0, 0.0, 10.0, 10.0, 10.0, 10.0]
    assert hit.tolist() == [True, True] + [False] * 5
    assert used.tolist() == [True] * 6 + [False]
    _, _, used = read_ranges(ranges, 10.0, "ignore")
    assert used.tolist() == hit.tolist()


def grid_after(ranges: list[float], no_return: NoReturn = "free") -> str:
    """A row of cells after beams along x: . free, # occupied, blank unknown."""
    grid = OccupancyGrid(GridSpec(9, 1, 1.0, 0.0, 0.0))
    scan = Scan(Pose(1.5, 0.5, 0.0), np.zeros(len(ranges)), np.array(ranges))
    update_grid_from_scan(grid, scan, 6.0, no_return)
    signs = np.sign(grid.log_odds[0]).astype(int)
    return "".join({-1: ".", 0: " ", 1: "#"}[s] for s in signs.tolist())


def test_inverse_sensor_model() -> None:
    assert grid_after([3.0]) == " ...#    "
    assert grid_after([0.0]) == " #       "


def test_problem_3_no_return_marks_nothing_occupied() -> None:
    assert grid_after([6.0]) == " ....... "
    assert grid_after([math.inf]) == " ....... "
    assert grid_after([6.0], "ignore") == "         "
    assert grid_after([math.nan]) == "         "
