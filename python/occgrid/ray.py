"""Which cells a beam crosses: Bresenham's line (lesson section 4, line traversal)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Cells = npt.NDArray[np.int64]


# [snippet: bresenham]
def bresenham(
    gx0: Cells | int,
    gy0: Cells | int,
    gx1: Cells | int,
    gy1: Cells | int,
    k: Cells | None = None,
) -> tuple[Cells, Cells]:
    """Cells of the line from (gx0, gy0) to (gx1, gy1), in order.

    Bresenham's integer line (1965). Step k goes k cells along the longer
    axis and floor((2 k b + a - 1) / (2 a)) along the shorter one, where
    a and b are the line's extents along the two. Without k: all steps of
    one line, k = 0 .. a. With k, everything may be arrays of one shape.
    Returns gx and gy.
    """
    dx, dy = np.abs(np.subtract(gx1, gx0)), np.abs(np.subtract(gy1, gy0))
    sx = np.where(np.less(gx0, gx1), 1, -1)
    sy = np.where(np.less(gy0, gy1), 1, -1)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    if k is None:
        k = np.arange(int(a) + 1)
    a = np.maximum(a, 1)  # a line of one cell has step 0 only
    minor = (2 * k * b + a - 1) // (2 * a)
    along_x = dx >= dy
    gx: Cells = gx0 + sx * np.where(along_x, k, minor)
    gy: Cells = gy0 + sy * np.where(along_x, minor, k)
    return gx, gy


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
