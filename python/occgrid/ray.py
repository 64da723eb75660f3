"""Which cells a beam crosses: Bresenham's line (lesson section 4, line traversal)."""

from __future__ import annotations

import numpy as np

from occgrid.grid import Cell, Cells

MAX_STEPS = 1 << 20


# [snippet: bresenham]
def bresenham(
    gx0: Cell, gy0: Cell, gx1: Cell, gy1: Cell
) -> tuple[Cells, Cells]:
    """Cells from (gx0, gy0) to (gx1, gy1), both included, in order.

    Bresenham's integer line (1965). Step k goes k cells along the longer
    axis and floor((2 k b + a - 1) / (2 a)) along the shorter one, where
    a and b are the line's extents along the two.
    Returns gx and gy, (a + 1,) each; ValueError above 2**20 steps.
    """
    dx, dy = abs(int(gx1 - gx0)), abs(int(gy1 - gy0))
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    a, b = max(dx, dy), min(dx, dy)
    if a > MAX_STEPS:
        raise ValueError(f"a line of {a} steps, more than {MAX_STEPS}")
    k = np.arange(a + 1)
    minor = (2 * b * k + (a - 1)) // (2 * a) if a > 0 else k
    if dx >= dy:
        return gx0 + sx * k, gy0 + sy * minor
    return gx0 + sx * minor, gy0 + sy * k


# [/snippet]
