"""The grid of log-odds (lesson sections 1 and 3)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import overload

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.portable_math import Array, Mask

Cells = npt.NDArray[np.int64]
Cell = int | np.int64  # the column or the row of one cell


# [snippet: grid-spec]
@dataclass(frozen=True)
class GridSpec:
    """Where the cells lie in the world (lesson section 1)."""

    width: int  # number of columns
    height: int  # number of rows
    resolution: float  # side of a cell, metres
    origin_x: float  # world x of the lower left corner, metres
    origin_y: float  # world y of the lower left corner, metres


# [/snippet]


# [snippet: logit]
def logit(p: float) -> float:
    """Log-odds of a probability, which is kept within [1e-9, 1 - 1e-9]."""
    q = min(max(p, 1e-9), 1.0 - 1e-9)
    return float(portable_math.log(q / (1.0 - q)))


# [/snippet]


# [snippet: sigmoid]
def sigmoid(log_odds: Array | float) -> Array:
    """Probability of log-odds, of any shape; no overflow at either end."""
    z = portable_math.exp(-np.abs(log_odds))
    return np.where(log_odds >= 0.0, 1.0, z) / (1.0 + z)


# [/snippet]


class OccupancyGrid:
    """Log-odds of every cell, and the steps that an update adds (lesson section 3).

    ``log_odds`` has the shape (height, width); row 0 is the row with the smallest y. Every cell starts at
    ``l0 = logit(p0)``. ``l_min`` and ``l_max`` bound each cell after each update; l0 lies between them.
    """

    def __init__(
        self,
        spec: GridSpec,
        p0: float = 0.5,
        p_occ: float = 0.75,
        p_free: float = 0.30,
        l_min: float = -8.0,
        l_max: float = 8.0,
    ) -> None:
        self.spec = spec
        self.l0 = logit(p0)
        self.l_occ = logit(p_occ)
        self.l_free = logit(p_free)
        self.l_min = l_min
        self.l_max = l_max
        self.log_odds = np.full((spec.height, spec.width), self.l0)

    @overload
    def world_to_grid(
        self, x: float, y: float
    ) -> tuple[np.int64, np.int64]: ...
    @overload
    def world_to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]: ...

    # [snippet: world-to-grid]
    def world_to_grid(
        self, x: Array | float, y: Array | float
    ) -> tuple[Cells | np.int64, Cells | np.int64]:
        """Cells (gx, gy) of a point, or of points (n,), in metres.

        They may lie outside the grid.
        """
        gx = np.floor((x - self.spec.origin_x) / self.spec.resolution)
        gy = np.floor((y - self.spec.origin_y) / self.spec.resolution)
        return gx.astype(np.int64), gy.astype(np.int64)

    def grid_to_world_center(self, gx: Cell, gy: Cell) -> tuple[float, float]:
        """Centre of a cell in metres."""
        x = self.spec.origin_x + (gx + 0.5) * self.spec.resolution
        y = self.spec.origin_y + (gy + 0.5) * self.spec.resolution
        return float(x), float(y)

    def in_bounds(
        self, gx: Cells | Cell, gy: Cells | Cell
    ) -> Mask | np.bool_ | bool:
        """Whether a cell lies in the grid, or which of cells (n,) do."""
        in_x = (gx >= 0) & (gx < self.spec.width)
        in_y = (gy >= 0) & (gy < self.spec.height)
        return in_x & in_y

    # [/snippet]

    # [snippet: update-cell]
    def update_cell(self, gx: Cell, gy: Cell, l_update: float) -> None:
        """Add the evidence l_update - l0 to one cell and clamp it.

        A cell outside the grid is skipped.
        """
        if self.in_bounds(gx, gy):
            value = self.log_odds[gy, gx] + (l_update - self.l0)
            self.log_odds[gy, gx] = np.clip(value, self.l_min, self.l_max)

    def update_cells(self, gx: Cells, gy: Cells, l_update: float) -> None:
        """update_cell for cells (n,) at once, none of them twice."""
        inside = self.in_bounds(gx, gy)
        gx, gy = gx[inside], gy[inside]
        values = self.log_odds[gy, gx] + (l_update - self.l0)
        self.log_odds[gy, gx] = np.clip(values, self.l_min, self.l_max)

    # [/snippet]

    # [snippet: probability-grid]
    def probability_grid(self) -> Array:
        """P(occupied) of every cell, (height, width)."""
        return sigmoid(self.log_odds)

    # [/snippet]
