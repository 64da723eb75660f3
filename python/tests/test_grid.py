"""grid: cells, log-odds and their update, with the lesson's Problems 1 and 4."""

from __future__ import annotations

import math

import numpy as np
import pytest

from occgrid.grid import GridSpec, OccupancyGrid, logit, sigmoid


def small_grid(**model: float) -> OccupancyGrid:
    return OccupancyGrid(GridSpec(6, 4, 0.5, -1.0, 2.0), **model)


def cell_of(grid: OccupancyGrid, x: float, y: float) -> tuple[int, int]:
    gx, gy = grid.world_to_grid(x, y)
    return int(gx), int(gy)


@pytest.mark.parametrize(
    ("x", "y", "cell"),
    [
        (-1.0, 2.0, (0, 0)),
        (-0.51, 2.49, (0, 0)),
        (-0.5, 2.5, (1, 1)),
        (1.99, 3.99, (5, 3)),
        (2.0, 4.0, (6, 4)),
        (-1.01, 1.99, (-1, -1)),
        (-1.51, 1.49, (-2, -2)),
    ],
)
def test_world_to_grid(x: float, y: float, cell: tuple[int, int]) -> None:
    assert cell_of(small_grid(), x, y) == cell


def test_the_centre_of_a_cell_lies_in_it() -> None:
    grid = small_grid()
    assert grid.grid_to_world_center(0, 0) == (-0.75, 2.25)
    for gx in range(6):
        for gy in range(4):
            x, y = grid.grid_to_world_center(gx, gy)
            assert cell_of(grid, x, y) == (gx, gy)


def test_in_bounds() -> None:
    grid = small_grid()
    inside = [
        (gx, gy)
        for gx in range(-2, 9)
        for gy in range(-2, 9)
        if grid.in_bounds(gx, gy)
    ]
    assert inside == [(gx, gy) for gx in range(6) for gy in range(4)]


def test_problem_1_size_and_memory() -> None:
    """30 m x 20 m at 0.05 m: 600 x 400 cells, 1.92 million bytes."""
    width, height = math.floor(30 / 0.05), math.floor(20 / 0.05)
    assert (width, height) == (600, 400)
    grid = OccupancyGrid(GridSpec(width, height, 0.05, 0.0, 0.0))
    assert grid.log_odds.size == 240_000
    assert grid.log_odds.nbytes == 1_920_000
    # the far corner's cell is the last one: the sizes are right
    assert cell_of(grid, 29.99, 19.99) == (599, 399)


@pytest.mark.parametrize("p_inv", [0.3, 0.75])
@pytest.mark.parametrize("p0", [0.5, 0.2])
def test_problem_4_repeated_evidence(p0: float, p_inv: float) -> None:
    """t equal updates give the odds O0 (Oinv / O0)**t."""
    grid = small_grid(p0=p0, l_min=-100.0, l_max=100.0)
    odds_0, odds_inv = p0 / (1 - p0), p_inv / (1 - p_inv)
    for t in range(1, 21):
        grid.update_cell(2, 1, logit(p_inv))
        odds = odds_0 * (odds_inv / odds_0) ** t
        p = grid.probability_grid()[1, 2]
        # 1e-13: rounding of the closed form itself, t multiplications
        assert p == pytest.approx(odds / (1 + odds), rel=1e-13)
    assert np.count_nonzero(grid.log_odds != grid.l0) == 1


def test_update_cell_clamps_after_each_addition() -> None:
    grid = small_grid(l_min=-1.0, l_max=2.0)
    for _ in range(9):
        grid.update_cell(0, 0, grid.l_occ)
    assert grid.log_odds[0, 0] == 2.0
    grid.update_cell(0, 0, grid.l_free)
    assert grid.log_odds[0, 0] == 2.0 + (logit(0.3) - logit(0.5))
    for _ in range(9):
        grid.update_cell(0, 0, grid.l_free)
    assert grid.log_odds[0, 0] == -1.0


def test_update_cell_skips_what_is_outside() -> None:
    grid = small_grid()
    for cell in ((-1, 0), (0, -1), (6, 0), (0, 4)):
        grid.update_cell(*cell, grid.l_occ)
    assert (grid.log_odds == grid.l0).all()


def test_update_cells_is_update_cell_for_each() -> None:
    """Inside the grid and outside, at both bounds and between them."""
    rng = np.random.default_rng(2)
    model = {"p0": 0.4, "l_min": -1.5, "l_max": 2.0}
    together, one_by_one = small_grid(**model), small_grid(**model)
    seen: set[float] = set()
    for _ in range(60):
        n = int(rng.integers(0, 40))
        cells = rng.choice(np.arange(-20, 100), n, replace=False)
        gx, gy = cells % 10 - 2, cells // 10
        l_update = (together.l_occ, together.l_free)[int(rng.integers(5)) > 0]
        together.update_cells(gx, gy, l_update)
        for x, y in zip(gx.tolist(), gy.tolist(), strict=True):
            one_by_one.update_cell(x, y, l_update)
        assert together.log_odds.tobytes() == one_by_one.log_odds.tobytes()
        seen |= set(together.log_odds.ravel().tolist())
    assert {-1.5, 2.0} < seen


def test_a_grid_owns_its_cells() -> None:
    one, other = small_grid(), small_grid()
    one.update_cell(2, 1, one.l_occ)
    assert other.log_odds[1, 2] == other.l0
    assert (one.log_odds - other.log_odds)[1, 2] == one.l_occ - one.l0


def test_logit_and_sigmoid() -> None:
    assert logit(0.5) == 0.0
    assert logit(0.75) == pytest.approx(math.log(3), rel=1e-15)
    assert logit(0.0) == logit(1e-9)
    assert logit(1.0) == logit(1.0 - 1e-9)
    l_values = np.array([-1000.0, -8.0, -0.3, 0.0, 0.3, 8.0, 1000.0])
    p = sigmoid(l_values)
    assert p[0] == 0.0 and p[3] == 0.5 and p[-1] == 1.0
    np.testing.assert_allclose(p + p[::-1], 1.0, rtol=1e-15)
    assert [logit(v) for v in p[1:-1]] == pytest.approx(l_values[1:-1])
