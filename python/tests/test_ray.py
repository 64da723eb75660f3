"""ray: exact cells, and the closed form against the line's definition."""

from __future__ import annotations

import numpy as np
import pytest

from occgrid.ray import MAX_STEPS, bresenham


def walk(gx0: int, gy0: int, gx1: int, gy1: int) -> list[tuple[int, int]]:
    """The line as SPEC.md section 2.4 defines it, step by step."""
    dx, dy = abs(gx1 - gx0), abs(gy1 - gy0)
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    err = dx - dy
    gx, gy = gx0, gy0
    cells = []
    while True:
        cells.append((gx, gy))
        if (gx, gy) == (gx1, gy1):
            return cells
        e2 = 2 * err
        if e2 > -dy:
            err -= dy
            gx += sx
        if e2 < dx:
            err += dx
            gy += sy


def cells(gx0: int, gy0: int, gx1: int, gy1: int) -> list[tuple[int, int]]:
    gx, gy = bresenham(gx0, gy0, gx1, gy1)
    return list(zip(gx.tolist(), gy.tolist(), strict=True))


@pytest.mark.parametrize(
    ("end", "expected"),
    [
        ((0, 0), [(0, 0)]),
        ((3, 0), [(0, 0), (1, 0), (2, 0), (3, 0)]),
        ((0, -2), [(0, 0), (0, -1), (0, -2)]),
        ((2, 2), [(0, 0), (1, 1), (2, 2)]),
        # halfway between two cells at the odd steps: the line stays back
        ((4, 2), [(0, 0), (1, 0), (2, 1), (3, 1), (4, 2)]),
        ((-4, 2), [(0, 0), (-1, 0), (-2, 1), (-3, 1), (-4, 2)]),
        ((4, -2), [(0, 0), (1, 0), (2, -1), (3, -1), (4, -2)]),
        ((2, 4), [(0, 0), (0, 1), (1, 2), (1, 3), (2, 4)]),
        ((-2, -4), [(0, 0), (0, -1), (-1, -2), (-1, -3), (-2, -4)]),
        ((5, 2), [(0, 0), (1, 0), (2, 1), (3, 1), (4, 2), (5, 2)]),
    ],
)
def test_exact_cells(
    end: tuple[int, int], expected: list[tuple[int, int]]
) -> None:
    assert cells(0, 0, *end) == expected


def test_closed_form_is_the_definition_on_all_short_lines() -> None:
    for dx in range(-17, 18):
        for dy in range(-17, 18):
            assert cells(5, -3, 5 + dx, -3 + dy) == walk(
                5, -3, 5 + dx, -3 + dy
            )


def test_closed_form_is_the_definition_on_long_random_lines() -> None:
    rng = np.random.default_rng(5)
    for ends in rng.integers(-3000, 3000, (300, 4)).tolist():
        assert cells(*ends) == walk(*ends)


def test_the_longest_line() -> None:
    gx, gy = bresenham(3, 0, 3 + MAX_STEPS, 1)
    assert (gx.size, gx[-1], gy[-1]) == (MAX_STEPS + 1, 3 + MAX_STEPS, 1)
    with pytest.raises(ValueError, match="1048577 steps, more than 1048576"):
        bresenham(0, 3, 0, 2 - MAX_STEPS)
