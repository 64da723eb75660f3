"""sensor: bearings, the meaning of ranges, and the update against plain loops."""

from __future__ import annotations

import math

import numpy as np
import plain
import pytest

from occgrid import sensor
from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.sensor import (
    PI,
    NoReturn,
    Scan,
    beam_angles,
    flaser_angles,
    read_ranges,
    update_grid_from_scan,
    update_grid_from_scans,
)
from occgrid.world import Pose


def test_beam_angles() -> None:
    angles = beam_angles(PI, 181)
    assert angles[0] == -PI / 2
    assert angles[90] == 0.0
    assert angles[180] == PI / 2
    assert angles[37] == -(PI / 2.0) + (PI * 37.0) / 180.0
    assert beam_angles(PI, 1).tolist() == [0.0]


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
    assert angles[0] == -PI / 2
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


def random_scans(rng: np.random.Generator, scans: int) -> list[Scan]:
    made = []
    for _ in range(scans):
        n = int(rng.integers(1, 60))
        x, y, theta = rng.uniform([-4.0, -4.0, -9.0], [4.0, 4.0, 9.0])
        pose = Pose(x, y, theta)
        ranges = rng.uniform(0.0, 6.0, n)
        ranges[rng.random(n) < 0.05] = math.inf
        ranges[rng.random(n) < 0.05] = math.nan
        made.append(Scan(pose, rng.uniform(-2.0, 2.0, n), ranges))
    return made


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("no_return", ["free", "ignore"])
def test_update_is_the_plain_loop(
    seed: int, no_return: NoReturn, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Scan by scan, all at once, and in small parts: the same bits."""
    rng = np.random.default_rng(seed)
    spec = GridSpec(23, 17, 0.25, -2.6, -1.9)
    model = (0.45, 0.8, 0.35, -2.9, 2.3)
    scans = random_scans(rng, 12)
    looped, single, batched, parts = (
        OccupancyGrid(spec, *model) for _ in range(4)
    )
    for scan in scans:
        plain.update_grid_from_scan(
            looped,
            scan.pose,
            scan.angles.tolist(),
            scan.ranges.tolist(),
            5.0,
            no_return,
        )
        update_grid_from_scan(single, scan, 5.0, no_return)
    update_grid_from_scans(batched, scans, 5.0, no_return)
    monkeypatch.setattr(sensor, "MAX_CELLS", 50)
    update_grid_from_scans(parts, scans, 5.0, no_return)
    expected = looped.log_odds.tobytes()
    assert single.log_odds.tobytes() == expected
    assert batched.log_odds.tobytes() == expected
    assert parts.log_odds.tobytes() == expected
