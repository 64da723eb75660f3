"""Which cells a beam crosses: Bresenham's line (lesson section 4, line traversal)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Cells = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]

# cells of a trace that are worked on at once, a line more or less: what stays in the processor's cache
CELLS_AT_ONCE = 1 << 15


# [snippet: bresenham]
def bresenham(gx0: int, gy0: int, gx1: int, gy1: int) -> tuple[Cells, Cells]:
    """Cells from (gx0, gy0) to (gx1, gy1), both included, in order.

    Bresenham's integer line (1965). Step k goes k cells along the longer
    axis and floor((2 k b + a - 1) / (2 a)) along the shorter one, where
    a and b are the line's extents along the two.
    Returns gx and gy, (a + 1,) each.
    """
    dx, dy = abs(gx1 - gx0), abs(gy1 - gy0)
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    a, b = max(dx, dy), min(dx, dy)
    k = np.arange(a + 1)
    minor = (2 * k * b + a - 1) // (2 * a) if a > 0 else k
    if dx >= dy:
        return gx0 + sx * k, gy0 + sy * minor
    return gx0 + sx * minor, gy0 + sy * k


# [/snippet]


# [snippet: clip-ray]
def clip_ray(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, width: int, height: int
) -> tuple[Cells, Cells]:
    """First and last step of each line that lie in the grid.

    A line that misses the grid gets last < first. All arguments but the
    grid's size may be arrays of one shape. No cell outside is visited:
    step k has gone m cells along the shorter axis, or more, exactly
    when 2 k b >= 2 a m - a + 1.
    """
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    along_x = dx >= dy
    # steps that each axis may go: low <= step <= high
    x_low, x_high = _steps_inside(gx0, gx1, width)
    y_low, y_high = _steps_inside(gy0, gy1, height)
    low, high = np.where(along_x, [x_low, x_high], [y_low, y_high])
    minor = np.where(along_x, [y_low, y_high], [x_low, x_high])
    minor_low, minor_high = minor
    enters = _first_step(minor_low, a, b)
    leaves = _first_step(minor_high + 1, a, b)
    first = np.maximum(np.maximum(low, 0), enters)
    last = np.minimum(np.minimum(high, a), leaves - 1)
    return first, last


def _steps_inside(g0: Cells, g1: Cells, size: int) -> tuple[Cells, Cells]:
    """Fewest and most cells to go from g0 towards g1 to be in 0 .. size-1."""
    forward = g0 < g1
    low = np.where(forward, -g0, g0 - (size - 1))
    high = np.where(forward, size - 1 - g0, g0)
    return low, high


def _first_step(m: Cells, a: Cells, b: Cells) -> Cells:
    """The first step that has gone m cells along the shorter axis."""
    never = a + 1
    ceiling = -((a - 1 - 2 * a * m) // np.maximum(2 * b, 1))
    return np.where(m <= 0, 0, np.where(b == 0, never, ceiling))


# [/snippet]


class Trace(NamedTuple):
    """The cells in the grid of many lines, one line after another."""

    cells: Cells  # (cells,) flat indices gy * width + gx
    counts: Cells  # (lines,) cells of each line
    ends: Mask  # (cells,) whether a cell is the last of its whole line


def trace_rays(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, width: int, height: int
) -> Trace:
    """bresenham for many lines at once, only the cells in the grid.

    The same closed form, on long arrays: NumPy's cost is in the number of its calls. On too long ones it is in the
    memory, so the lines are taken some at a time.
    """
    first, last = clip_ray(gx0, gy0, gx1, gy1, width, height)
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    along_x = dx >= dy
    step_x = np.where(gx0 < gx1, 1, -1)
    step_y = np.where(gy0 < gy1, width, -width)
    major = np.where(along_x, step_x, step_y)
    minor = np.where(along_x, step_y, step_x)
    longest = np.maximum(a, 1)  # a line of one cell has step 0 only
    start = gy0 * width + gx0

    counts = np.maximum(last - first + 1, 0)
    after = np.cumsum(counts)  # cells of the lines up to each line
    cells = np.empty(after[-1] if after.size else 0, dtype=np.int64)
    lines = 0
    while lines < counts.size:
        done = after[lines - 1] if lines else 0
        upto = int(np.searchsorted(after, done + CELLS_AT_ONCE)) + 1
        part = slice(lines, upto)
        n = counts[part]
        k = np.arange(after[part][-1] - done)
        k -= np.repeat(after[part] - done - n - first[part], n)
        # In floating point: with extents of at most a million the quotient is at least 1 / (2 a) below the next
        # integer, or is that integer, and so never rounds up to it.
        quotient = k * np.repeat(2.0 * b[part], n)
        quotient += np.repeat(longest[part] - 1.0, n)
        quotient /= np.repeat(2.0 * longest[part], n)
        found = quotient.astype(np.int64)  # not negative: its floor
        found *= np.repeat(minor[part], n)
        k *= np.repeat(major[part], n)
        found += k
        found += np.repeat(start[part], n)
        cells[done : done + k.size] = found
        lines = upto

    ends = np.zeros(cells.size, dtype=np.bool_)
    ends[after[(counts > 0) & (last == a)] - 1] = True
    return Trace(cells, counts, ends)
