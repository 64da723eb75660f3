"""The grid of log-odds (lesson sections 1 and 3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from occgrid import portable_math

Array = npt.NDArray[np.float64]
Cells = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]

# up to so many cells of the grid for each update, a table of the cells costs less than sorting the updates
SPREAD = 16


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
def sigmoid(log_odds: Array) -> Array:
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

    # [snippet: world-to-grid]
    def world_to_grid(
        self, x: Array | float, y: Array | float
    ) -> tuple[Cells, Cells]:
        """Cells (gx, gy) of points (n,) in metres; they may lie outside."""
        gx = np.floor((x - self.spec.origin_x) / self.spec.resolution)
        gy = np.floor((y - self.spec.origin_y) / self.spec.resolution)
        return gx.astype(np.int64), gy.astype(np.int64)

    def grid_to_world_center(self, gx: int, gy: int) -> tuple[float, float]:
        """Centre of a cell in metres."""
        x = self.spec.origin_x + (gx + 0.5) * self.spec.resolution
        y = self.spec.origin_y + (gy + 0.5) * self.spec.resolution
        return x, y

    def in_bounds(self, gx: int, gy: int) -> bool:
        """Whether a cell lies in the grid."""
        return 0 <= gx < self.spec.width and 0 <= gy < self.spec.height

    # [/snippet]

    # [snippet: update-cell]
    def update_cell(self, gx: int, gy: int, l_update: float) -> None:
        """Add the evidence l_update - l0 to one cell and clamp it.

        A cell outside the grid is skipped.
        """
        if self.in_bounds(gx, gy):
            value = self.log_odds[gy, gx] + (l_update - self.l0)
            self.log_odds[gy, gx] = np.clip(value, self.l_min, self.l_max)

    # [/snippet]

    def update_cells(self, cells: Cells, occupied: Mask) -> None:
        """Apply update_cell to many cells in order, as l_occ where ``occupied`` and l_free elsewhere.

        cells: (n,) flat indices gy * width + gx, all in the grid, any of them repeated; occupied: (n,).

        Cells are independent of each other: only the order of the updates of one cell counts. Most cells are only
        passed, and need but the count of it.
        """
        if cells.size == 0:
            return
        low, high = int(cells.min()), int(cells.max())
        if high - low < SPREAD * cells.size:
            hit = np.zeros(high - low + 1, dtype=np.bool_)
            hit[cells[occupied] - low] = True
            ordered = hit[cells - low]
            self._update_passed_cells(cells[~ordered] - low, low)
            cells, occupied = cells[ordered], occupied[ordered]
        self._update_cells_in_order(cells, occupied)

    def _update_passed_cells(self, cells: Cells, low: int) -> None:
        """update_cells where nothing is occupied, of the cells low + ``cells``."""
        times = np.bincount(cells)
        touched = np.flatnonzero(times)
        times = times[touched]
        most_first = np.argsort(-times)
        touched = touched[most_first] + low
        values = self.log_odds.reshape(-1)[touched]
        step = self.l_free - self.l0
        bound = self.l_min if step < 0.0 else self.l_max
        for n in _how_many_reach(times[most_first]):
            head = values[:n]
            head += step
            np.maximum(head, self.l_min, out=head)
            np.minimum(head, self.l_max, out=head)
            if (head == bound).all():
                break  # where they stay
        self.log_odds.reshape(-1)[touched] = values

    def _update_cells_in_order(self, cells: Cells, occupied: Mask) -> None:
        """update_cells by sorting the updates by cell, in order within it, and applying the j-th of all at once."""
        # cell, place in the order and kind in one number each: sorting these is much faster than a stable argsort
        bits = int(cells.size).bit_length() + 1
        keys = cells << bits | np.arange(cells.size) << 1 | occupied
        keys.sort()
        cells = keys >> bits
        steps = np.where(keys & 1, self.l_occ - self.l0, self.l_free - self.l0)

        starts = np.flatnonzero(np.diff(cells, prepend=-1))
        counts = np.diff(starts, append=cells.size)
        most_first = np.argsort(-counts)
        starts, counts = starts[most_first], counts[most_first]
        touched = cells[starts]
        values = self.log_odds.reshape(-1)[touched]
        for j, n in enumerate(_how_many_reach(counts)):
            head = values[:n]
            head += steps[starts[:n] + j]
            np.maximum(head, self.l_min, out=head)
            np.minimum(head, self.l_max, out=head)
        self.log_odds.reshape(-1)[touched] = values

    # [snippet: probability-grid]
    def probability_grid(self) -> Array:
        """P(occupied) of every cell, (height, width)."""
        return sigmoid(self.log_odds)

    # [/snippet]


def _how_many_reach(counts: Cells) -> list[int]:
    """How many of the counts, the greatest first, are more than j: for j = 0, 1, ..., below the greatest."""
    most = counts[0] if counts.size else 0
    reached = np.searchsorted(-counts, -np.arange(most), side="left")
    return list(map(int, reached))
