"""The map that one way for each beam draws, cell by cell."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from occgrid_parity.model.array_types import (
    Array,
    Cells,
    Mask,
    index_type,
)
from occgrid_parity.model.line_cells import contract_lines
from occgrid_parity.model.rounding import Beams

NOTHING, FREE, OCCUPIED = 0, 1, 2

CHUNK = 4096


class UpdateModel(NamedTuple):
    """Where a cell starts, what it can get, and its bounds."""

    start: float
    free: float
    occupied: float
    low: float
    high: float


class TracedWays:
    """The cells of ways of beams, in the grid; ``cell`` is flat, smallest y first."""

    def __init__(
        self, beams: Beams, width: int, height: int, ways: Cells
    ) -> None:
        self.beams = beams
        self.width, self.height = width, height
        parts = [
            self._trace(part) for part in _parts(ways[beams.ways.used[ways]])
        ]
        self.way, self.cell, self.hit = (
            np.concatenate(column) for column in zip(*parts, strict=True)
        )

    def _trace(self, part: Cells) -> tuple[Cells, Cells, Mask]:
        w = self.beams.ways
        lines = contract_lines(
            w.gx0[part], w.gy0[part], w.gx1[part], w.gy1[part]
        )
        inside = (lines.gx >= 0) & (lines.gx < self.width)
        inside &= (lines.gy >= 0) & (lines.gy < self.height)
        lines = lines.where(inside)
        way = part[lines.beam]
        return way, lines.gy * self.width + lines.gx, lines.last & w.hit[way]

    def of(self, way: int) -> dict[int, int]:
        """What one way does to each of its cells."""
        if not self.beams.ways.used[way]:
            return {}
        _, cells, hit = self._trace(np.array([way]))
        kinds = np.where(hit, OCCUPIED, FREE)
        return dict(zip(cells.tolist(), kinds.tolist(), strict=True))


def _parts(ways: Cells) -> list[Cells]:
    return [ways[i : i + CHUNK] for i in range(0, ways.size, CHUNK)] or [ways]


class Visits(NamedTuple):
    """The ways that cross one cell, and what they do to it; arrays (n,)."""

    beam: Cells
    way: Cells
    kind: Cells


class ChosenWays:
    """All visits of all cells, and what the chosen ones among them draw."""

    def __init__(self, traced: TracedWays, model: UpdateModel) -> None:
        self.traced = traced
        self.ways = traced.beams.ways
        self.model = model
        # NumPy sorts small integers much faster
        small = index_type(traced.width * traced.height)
        order = np.argsort(traced.cell.astype(small), kind="stable")
        self.by_cell = traced.cell[order]
        self.way = traced.way[order]
        self.beam = self.ways.beam[self.way]
        self.kind = np.where(traced.hit, OCCUPIED, FREE)[order]
        self.known: dict[int, Visits] = {}

    def visits(self, cell: int) -> Visits:
        """All ways that cross the cell, in the order of the beams."""
        if cell not in self.known:
            low, high = np.searchsorted(self.by_cell, [cell, cell + 1])
            self.known[cell] = Visits(
                self.beam[low:high], self.way[low:high], self.kind[low:high]
            )
        return self.known[cell]

    def value(self, cell: int, chosen: Cells) -> float:
        """The log-odds of one cell, with the way that is chosen for each beam."""
        visits = self.visits(cell)
        mine = chosen[visits.beam] == visits.way
        value, free, occupied, least, most = self.model
        for kind in visits.kind[mine].tolist():
            value += free if kind == FREE else occupied
            if value > most:
                value = most
            elif value < least:
                value = least
        return value

    def values(self, cells: Cells, chosen: Cells) -> Array:
        """The same of many cells, in ascending order; the j-th updates of all of them are made at once."""
        start, free, occupied, least, most = self.model
        first = np.searchsorted(self.by_cell, cells)
        count = np.searchsorted(self.by_cell, cells + 1) - first
        slot = np.repeat(np.arange(cells.size), count)
        place = np.arange(slot.size) + np.repeat(
            first - (np.cumsum(count) - count), count
        )
        mine = chosen[self.beam[place]] == self.way[place]
        slot, place = slot[mine], place[mine]
        steps = np.where(self.kind[place] == FREE, free, occupied)
        count = np.bincount(slot, minlength=cells.size)
        first = np.cumsum(count) - count
        most_first = np.argsort(-count, kind="stable")
        first, count = first[most_first], count[most_first]
        values = np.full(cells.size, start)
        rounds = int(count[0]) if count.size else 0
        reached = np.searchsorted(-count, -np.arange(rounds), side="left")
        for j, n in enumerate(reached.tolist()):
            values[:n] = np.clip(
                values[:n] + steps[first[:n] + j], least, most
            )
        found = np.empty(cells.size)
        found[most_first] = values
        return found

    def beams_that_differ(
        self, cells: Cells, chosen: Cells, others: Cells
    ) -> Cells:
        """The beams that do something else to one of the cells with the one choice of ways than with the other."""
        here = np.flatnonzero(np.isin(self.by_cell, cells))
        beam, way, kind = self.beam[here], self.way[here], self.kind[here]
        done = kind * (chosen[beam] == way) - kind * (others[beam] == way)
        size = self.traced.width * self.traced.height
        each, visit = np.unique(
            beam * size + self.by_cell[here], return_inverse=True
        )
        change = np.zeros(each.size, dtype=np.int64)
        np.add.at(change, visit, done)
        return np.unique(each[change != 0] // size)
