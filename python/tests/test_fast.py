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
    _lines_in_grid,
    _parts,
    _trace_rays,
    _update_cells,
    clip_ray,
    map_scenario_fast,
    update_grid_from_scans,
)
from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.mapper import map_scenario
from occgrid.portable_math import Array
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
    monkeypatch.setattr(fast, "CELLS_AT_ONCE", at_once)
    rng = np.random.default_rng(height)
    ends = rng.integers(-12, 30, (4, 3000))
    gx0, gy0, gx1, gy1 = ends
    hit = rng.random(3000) < 0.5
    lines = _lines_in_grid(gx0, gy0, gx1, gy1, hit, width, height)
    found, occupied = _trace_rays(lines)
    expected, hits = [], []
    for line, is_hit in zip(ends.T.tolist(), hit.tolist(), strict=True):
        walked = cells(*line)
        for k, (gx, gy) in enumerate(walked):
            if 0 <= gx < width and 0 <= gy < height:
                expected.append(gy * width + gx)
                hits.append(is_hit and k == len(walked) - 1)
    assert found.tolist() == expected
    assert occupied.tolist() == hits


def test_parts() -> None:
    counts = np.array([3, 0, 4, 9, 0, 0, 2, 2, 0])
    parts = [counts[part].tolist() for part in _parts(counts, 7)]
    assert parts == [[3, 0, 4], [9], [0, 0, 2, 2, 0]]
    assert not list(_parts(counts[:0], 7))


def test_longer_lines_are_refused() -> None:
    zero, longest = np.array([0, 0]), np.array([0, MAX_STEPS])
    clip_ray(zero, zero, longest, zero, 9, 9)
    with pytest.raises(
        ValueError, match="of 1048577 steps, more than 1048576"
    ):
        clip_ray(zero, zero, zero, longest + 1, 9, 9)


def test_trace_rays_of_the_longest_lines() -> None:
    """Extents of up to 2**20 cells: the quotient in floating point is exact."""
    rng = np.random.default_rng(6)
    extents = [*rng.integers(999_000, 1 << 20, 20), 1 << 20]
    for dx in map(int, extents):
        dy = int(rng.integers(0, dx + 1))
        gx, gy = bresenham(0, 0, dx, dy)
        zero, ex, ey = (np.array([g]) for g in (0, dx, dy))
        lines = _lines_in_grid(zero, zero, ex, ey, zero == 0, dx + 1, dy + 1)
        found, occupied = _trace_rays(lines)
        assert (found == gy * (dx + 1) + gx).all()
        assert np.flatnonzero(occupied).tolist() == [dx]


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


Z_MAX = 5.0


def ranges_at_the_limits(rng: np.random.Generator, n: int) -> Array:
    """Ordinary ranges, nothing, and what lies around both limits, a step of the doubles more or less."""
    ranges = rng.uniform(0.0, 6.0, n)
    special = [0.0, 5e-324, math.inf, math.nan, 81.91]
    for limit in (Z_MAX, Z_MAX - 1e-12):
        special += [limit, np.nextafter(limit, 0), np.nextafter(limit, 9)]
    chosen = rng.random(n) < 0.3
    ranges[chosen] = rng.choice(special, int(chosen.sum()))
    return ranges


def random_scans(
    rng: np.random.Generator, spec: GridSpec, scans: int
) -> list[Scan]:
    """Scans from inside the grid and outside it; of some, robot and hits lie on edges of cells."""
    made = []
    low = np.array([spec.origin_x, spec.origin_y])
    size = spec.resolution * np.array([spec.width, spec.height])
    for number in range(scans):
        n = int(rng.integers(1, 60))
        angles: Array
        ranges: Array
        if number % 3 == 0:  # along the axes, from edge to edge
            x, y = (low + rng.integers(-3, 30, 2) * spec.resolution).tolist()
            theta = 0.0
            angles = rng.integers(-3, 4, n).astype(float) * (math.pi / 4)
            ranges = rng.integers(0, 25, n).astype(float) * spec.resolution
        else:
            x, y = (low + rng.uniform(-0.7, 1.7, 2) * size).tolist()
            theta = rng.uniform(-9.0, 9.0)
            angles = rng.uniform(-2.0, 2.0, n)
            ranges = ranges_at_the_limits(rng, n)
        made.append(Scan(Pose(x, y, theta), angles, ranges))
    return made


@pytest.mark.parametrize("no_return", ["free", "ignore"])
@pytest.mark.parametrize(
    "origin", [(-2.6, -1.9), (1e7 - 3.0, -1e7), (-1e7, 1e7 - 0.5)]
)
@pytest.mark.parametrize(
    "model",
    [
        (0.45, 0.8, 0.35, -2.9, 2.3),
        (0.5, 0.75, 0.3, -8.0, 8.0),
        (0.3, 0.2, 0.9, -3.0, 4.0),  # the signs reversed: hits clear cells
        (0.6, 0.7, 0.65, -1.0, 3.0),  # both raise it
        (0.4, 0.4, 0.4, -1.0, 1.0),  # nothing changes
        (0.5, 0.9, 0.1, 0.0, 2.0),  # the prior is the lower bound
    ],
)
def test_update_is_the_printed_one(
    model: tuple[float, ...],
    origin: tuple[float, float],
    no_return: NoReturn,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Scan by scan, all at once, and in small parts: the same bits."""
    rng = np.random.default_rng(11)
    spec = GridSpec(23, 17, 0.25, *origin)
    scans = random_scans(rng, spec, 15)
    printed, single, batched, parts = (
        OccupancyGrid(spec, *model) for _ in range(4)
    )
    for scan in scans:
        update_grid_from_scan(printed, scan, Z_MAX, no_return)
        update_grid_from_scans(single, [scan], Z_MAX, no_return)
    update_grid_from_scans(batched, scans, Z_MAX, no_return)
    monkeypatch.setattr(fast, "BATCH_CELLS", 50)
    update_grid_from_scans(parts, scans, Z_MAX, no_return)
    expected = printed.log_odds.tobytes()
    assert single.log_odds.tobytes() == expected
    assert batched.log_odds.tobytes() == expected
    assert parts.log_odds.tobytes() == expected
    changed = model[0] != model[1] or model[0] != model[2]
    assert (printed.log_odds != printed.l0).any() == changed


def test_no_scans() -> None:
    grid = OccupancyGrid(GridSpec(2, 2, 1.0, 0.0, 0.0))
    update_grid_from_scans(grid, [], 5.0)
    assert (grid.log_odds == grid.l0).all()


def test_ranges_without_bearings_are_refused() -> None:
    """Also where two scans together have as many of each."""
    grid = OccupancyGrid(GridSpec(2, 2, 1.0, 0.0, 0.0))
    pose = Pose(0.5, 0.5, 0.0)
    few = Scan(pose, np.zeros(3), np.ones(2))
    many = Scan(pose, np.zeros(2), np.ones(3))
    with pytest.raises(ValueError, match="as many ranges as bearings"):
        update_grid_from_scans(grid, [few, many], 5.0)
    with pytest.raises(ValueError, match="could not be broadcast"):
        update_grid_from_scan(grid, few, 5.0)


def test_two_grids_in_turn() -> None:
    """Neither knows of the other, printed or fast."""
    spec = GridSpec(23, 17, 0.25, -2.6, -1.9)
    scans = random_scans(np.random.default_rng(8), spec, 8)
    alone, *in_turn = (OccupancyGrid(spec) for _ in range(3))
    update_grid_from_scans(alone, scans[::2], Z_MAX)
    for one, other in zip(scans[::2], scans[1::2], strict=True):
        update_grid_from_scans(in_turn[0], [one], Z_MAX)
        update_grid_from_scan(in_turn[1], other, Z_MAX)
    assert in_turn[0].log_odds.tobytes() == alone.log_odds.tobytes()
    assert in_turn[1].log_odds.tobytes() != alone.log_odds.tobytes()


@pytest.mark.parametrize("seed", [None, 0])
@pytest.mark.parametrize(
    "name", [file.stem for file in sorted(SCENARIOS.glob("*.log"))]
)
def test_every_scenario(name: str, seed: int | None) -> None:
    with read_scenario(SCENARIOS / f"{name}.log") as scenario:
        printed = map_scenario(scenario, seed)
        quick = map_scenario_fast(scenario, seed)
    assert quick.log_odds.tobytes() == printed.log_odds.tobytes()
    # no beam of "beside" meets its grid
    assert (quick.log_odds != quick.l0).any() == (name != "beside")
