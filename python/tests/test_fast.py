"""fast: the same bits as the printed program, step by step and as a whole."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from occgrid import fast
from occgrid.fast import (
    CELLS_AT_ONCE,
    SPREAD,
    _trace_rays,
    _update_cells,
    clip_ray,
    map_scenario_fast,
    update_grid_from_scans,
)
from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.mapper import map_scenario
from occgrid.ray import MAX_STEPS, bresenham
from occgrid.scenario import read_scenario
from occgrid.sensor import NoReturn, Scan, update_grid_from_scan
from occgrid.world import Pose

SCENARIOS = Path(__file__).parents[2] / "scenarios"


def cells(gx0: int, gy0: int, gx1: int, gy1: int) -> list[tuple[int, int]]:
    gx, gy = bresenham(gx0, gy0, gx1, gy1)
    return list(zip(gx.tolist(), gy.tolist(), strict=True))


@pytest.mark.parametrize(("width", "height"), [(1, 1), (9, 4), (3, 25)])
def test_clip_ray_finds_the_cells_in_the_grid(width: int, height: int) -> None:
    rng = np.random.default_rng(width)
    ends = rng.integers(-30, 45, (4, 5000))
    gx0, gy0, gx1, gy1 = ends
    first, last = clip_ray(gx0, gy0, gx1, gy1, width, height)
    missed = 0
    for line, k0, k1 in zip(ends.T.tolist(), first, last, strict=True):
        walked = cells(*line)
        inside = [
            k
            for k, (gx, gy) in enumerate(walked)
            if 0 <= gx < width and 0 <= gy < height
        ]
        assert list(range(k0, k1 + 1)) == inside
        missed += not inside
    assert 0 < missed < 5000  # both kinds were tried


def test_clip_ray_of_a_distant_robot() -> None:
    """Two million cells away: found without a walk."""
    far = np.array([2_000_000_000])
    first, last = clip_ray(
        far, far, far - 1_000_000, far - 999_999, 5000, 5000
    )
    assert (last < first).all()


@pytest.mark.parametrize("at_once", [1, 50, CELLS_AT_ONCE])
@pytest.mark.parametrize(("width", "height"), [(1, 1), (9, 4), (3, 25)])
def test_trace_rays_is_bresenham_in_the_grid(
    width: int, height: int, at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("occgrid.fast.CELLS_AT_ONCE", at_once)
    rng = np.random.default_rng(height)
    gx0, gy0, gx1, gy1 = rng.integers(-12, 30, (4, 3000))
    trace = _trace_rays(gx0, gy0, gx1, gy1, width, height)
    expected, ends, counts = [], [], []
    for line in zip(*map(list, (gx0, gy0, gx1, gy1)), strict=True):
        walked = cells(*line)
        inside = [
            (gy * width + gx, k == len(walked) - 1)
            for k, (gx, gy) in enumerate(walked)
            if 0 <= gx < width and 0 <= gy < height
        ]
        counts.append(len(inside))
        expected += [cell for cell, _ in inside]
        ends += [end for _, end in inside]
    assert trace.cells.tolist() == expected
    assert trace.ends.tolist() == ends
    assert trace.counts.tolist() == counts


def test_longer_lines_are_refused() -> None:
    zero, longest = np.array([0, 0]), np.array([0, MAX_STEPS])
    clip_ray(zero, zero, longest, zero, 9, 9)
    with pytest.raises(ValueError, match="more than 1048576 steps"):
        clip_ray(zero, zero, zero, longest + 1, 9, 9)


def test_trace_rays_of_the_longest_lines() -> None:
    """Extents of a million cells: the quotient in floating point is exact."""
    rng = np.random.default_rng(6)
    extents = rng.integers(999_000, 1_000_001, 20)
    for dx in extents.tolist():
        dy = int(rng.integers(0, dx + 1))
        gx, gy = bresenham(0, 0, dx, dy)
        zero, ex, ey = (np.array([g]) for g in (0, dx, dy))
        trace = _trace_rays(zero, zero, ex, ey, dx + 1, dy + 1)
        assert (trace.cells == gy * (dx + 1) + gx).all()


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("p_free", [0.21, 0.4, 0.7])
@pytest.mark.parametrize("bounds", [(-2.3, 3.1), (-30.0, 30.0)])
@pytest.mark.parametrize("spread", [0, SPREAD])
def test_update_cells_is_update_cell_in_order(
    seed: int,
    p_free: float,
    bounds: tuple[float, float],
    spread: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With the table of cells and without; some cells are only passed, up to a bound and on, or not so far."""
    monkeypatch.setattr("occgrid.fast.SPREAD", spread)
    rng = np.random.default_rng(seed)
    model = {"p0": 0.4, "p_free": p_free}
    model |= dict(zip(("l_min", "l_max"), bounds, strict=True))
    looped, quick = (
        OccupancyGrid(GridSpec(6, 4, 0.5, -1.0, 2.0), **model),
        OccupancyGrid(GridSpec(6, 4, 0.5, -1.0, 2.0), **model),
    )
    for _ in range(4):
        n = int(rng.integers(0, 400))
        cells = rng.integers(0, 24, n) // rng.integers(1, 4)
        occupied = (rng.random(n) < 0.3) & (cells % 3 == 0)
        for cell, hit in zip(cells.tolist(), occupied.tolist(), strict=True):
            evidence = looped.l_occ if hit else looped.l_free
            looped.update_cell(cell % 6, cell // 6, evidence)
        _update_cells(quick, cells, occupied)
        assert quick.log_odds.tobytes() == looped.log_odds.tobytes()


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
def test_update_is_the_printed_one(
    seed: int, no_return: NoReturn, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Scan by scan, all at once, and in small parts: the same bits."""
    rng = np.random.default_rng(seed)
    spec = GridSpec(23, 17, 0.25, -2.6, -1.9)
    model = (0.45, 0.8, 0.35, -2.9, 2.3)
    scans = random_scans(rng, 12)
    printed, single, batched, parts = (
        OccupancyGrid(spec, *model) for _ in range(4)
    )
    for scan in scans:
        update_grid_from_scan(printed, scan, 5.0, no_return)
        update_grid_from_scans(single, [scan], 5.0, no_return)
    update_grid_from_scans(batched, scans, 5.0, no_return)
    monkeypatch.setattr(fast, "MAX_CELLS", 50)
    update_grid_from_scans(parts, scans, 5.0, no_return)
    expected = printed.log_odds.tobytes()
    assert single.log_odds.tobytes() == expected
    assert batched.log_odds.tobytes() == expected
    assert parts.log_odds.tobytes() == expected


@pytest.mark.parametrize("seed", [None, 0])
@pytest.mark.parametrize(
    "name", [file.stem for file in sorted(SCENARIOS.glob("*.log"))]
)
def test_every_scenario(name: str, seed: int | None) -> None:
    with read_scenario(SCENARIOS / f"{name}.log") as scenario:
        printed = map_scenario(scenario, seed)
        quick = map_scenario_fast(scenario, seed)
    assert quick.log_odds.tobytes() == printed.log_odds.tobytes()
    assert (quick.log_odds != quick.l0).any()
