"""ray: exact cells, and the closed form against the line's definition."""

from __future__ import annotations

import numpy as np
import plain
import pytest

from occgrid.ray import CELLS_AT_ONCE, bresenham, clip_ray, trace_rays


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
            assert cells(5, -3, 5 + dx, -3 + dy) == plain.bresenham(
                5, -3, 5 + dx, -3 + dy
            )


def test_closed_form_is_the_definition_on_long_random_lines() -> None:
    rng = np.random.default_rng(5)
    for ends in rng.integers(-3000, 3000, (300, 4)).tolist():
        assert cells(*ends) == plain.bresenham(*ends)


@pytest.mark.parametrize(("width", "height"), [(1, 1), (9, 4), (3, 25)])
def test_clip_ray_finds_the_cells_in_the_grid(width: int, height: int) -> None:
    rng = np.random.default_rng(width)
    ends = rng.integers(-30, 45, (4, 5000))
    gx0, gy0, gx1, gy1 = ends
    first, last = clip_ray(gx0, gy0, gx1, gy1, width, height)
    missed = 0
    for line, k0, k1 in zip(ends.T.tolist(), first, last, strict=True):
        walked = plain.bresenham(*line)
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
    monkeypatch.setattr("occgrid.ray.CELLS_AT_ONCE", at_once)
    rng = np.random.default_rng(height)
    gx0, gy0, gx1, gy1 = rng.integers(-12, 30, (4, 3000))
    trace = trace_rays(gx0, gy0, gx1, gy1, width, height)
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


def test_trace_rays_of_the_longest_lines() -> None:
    """Extents of a million cells: the quotient in floating point is exact."""
    rng = np.random.default_rng(6)
    extents = rng.integers(999_000, 1_000_001, 20)
    for dx in extents.tolist():
        dy = int(rng.integers(0, dx + 1))
        gx, gy = bresenham(0, 0, dx, dy)
        zero, ex, ey = (np.array([g]) for g in (0, dx, dy))
        trace = trace_rays(zero, zero, ex, ey, dx + 1, dy + 1)
        assert (trace.cells == gy * (dx + 1) + gx).all()
