"""One choice of sides for all undecided beams that draws a program's map: the proof that rounding explains it.

That each cell alone can come about is not enough: a beam that ends on the one side of an edge cannot end on the other
side, too. So beams are turned one after the other until every cell is the program's, the best turn first. A turn must
bring the map nearer to the program's, but for a few, and there is an end to trying: a choice that is found is a proof,
that none is found is not.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from occgrid_parity.model.array_types import Cells, Mask
from occgrid_parity.model.line_cells import contract_lines
from occgrid_parity.model.rounding import Beams

Distance = Callable[[int, float], float]
"""distance(cell, value): how far the program's value is from it; 0 where the value is the program's."""

NOTHING, FREE, OCCUPIED = 0, 1, 2

CHUNK = 4096
MOST_TRIES = 600  # and as many for each 10 cells that are open
ASIDE = (0, 2)  # turns that may bring the map no nearer


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


def _index_type(
    cells: int,
) -> type[np.signedinteger] | type[np.unsignedinteger]:
    """The smallest type of integers that numbers so many cells."""
    return np.uint16 if cells <= 1 << 16 else np.int64


def _parts(ways: Cells) -> list[Cells]:
    return [ways[i : i + CHUNK] for i in range(0, ways.size, CHUNK)] or [ways]


class Visits(NamedTuple):
    """The ways that cross one cell, and what they do to it; arrays (n,)."""

    beam: Cells
    way: Cells
    kind: Cells


class Turn(NamedTuple):
    """Another way for one beam, and how much nearer that brings the map."""

    gain: float
    beam: int
    way: int


class Step(NamedTuple):
    """A turn that was made: the way before it, what is left to try in its place."""

    beam: int
    before: int
    aside: int
    left: list[Turn]


class SideSearch:
    """The search; ``turned`` is the way of each beam that is not on the contract's side."""

    def __init__(
        self,
        traced: TracedWays,
        model: UpdateModel,
        wrong: Cells,
        distance: Distance,
    ) -> None:
        self.traced = traced
        self.model = model
        self.distance = distance
        ways = traced.beams.ways
        self.chosen = np.flatnonzero(ways.contract)  # the way of each beam
        self.first = np.searchsorted(
            ways.beam, np.arange(traced.beams.scan.size + 1)
        )
        # NumPy sorts small integers much faster
        small = _index_type(traced.width * traced.height)
        order = np.argsort(traced.cell.astype(small), kind="stable")
        self.by_cell = traced.cell[order]
        self.way = traced.way[order]
        self.beam = ways.beam[self.way]
        self.kind = np.where(traced.hit, OCCUPIED, FREE)[order]
        self.turned: dict[int, int] = {}
        self.effects: dict[int, dict[int, int]] = {}
        self.known: dict[int, Visits] = {}
        self.open = {cell: self.off(cell) for cell in wrong.tolist()}
        self.tries = 0

    def solve(self) -> bool:
        """Whether a choice was found that draws the program's map."""
        return any(self.solve_with(aside) for aside in ASIDE)

    def solve_with(self, aside: int) -> bool:
        """The same with so many turns that bring the map no nearer."""
        self.tries = 0
        most = MOST_TRIES + MOST_TRIES * len(self.open) // 10
        steps: list[Step] = []
        turns = self.turns(aside)
        while self.open:
            if turns and self.tries < most:
                turn = turns.pop(0)
                steps.append(
                    Step(turn.beam, int(self.chosen[turn.beam]), aside, turns)
                )
                aside -= turn.gain >= 0.0
                self.turned[turn.beam] = turn.way
                self.apply(turn.beam, turn.way)
                turns = self.turns(aside) if self.open else []
            elif steps:
                beam, before, aside, turns = steps.pop()
                self.apply(beam, before)
                del self.turned[beam]
            else:
                return False
        return True

    def visits(self, cell: int) -> Visits:
        """All ways that cross the cell, in the order of the beams."""
        if cell not in self.known:
            low, high = np.searchsorted(self.by_cell, [cell, cell + 1])
            self.known[cell] = Visits(
                self.beam[low:high], self.way[low:high], self.kind[low:high]
            )
        return self.known[cell]

    def turns(self, aside: int) -> list[Turn]:
        """Turns that change one of the open cells, the best first."""
        cell = min(self.open)
        found: list[Turn] = []
        for beam in np.unique(self.visits(cell).beam).tolist():
            start, end = int(self.first[beam]), int(self.first[beam + 1])
            if end - start == 1 or beam in self.turned:
                continue
            current = self.effect(int(self.chosen[beam])).get(cell, NOTHING)
            for way in range(start, end):
                if self.effect(way).get(cell, NOTHING) != current:
                    gain = self.gain(beam, way)
                    if gain < 0.0 or aside > 0:
                        found.append(Turn(gain, beam, way))
        return sorted(found)

    def effect(self, way: int) -> dict[int, int]:
        if way not in self.effects:
            self.effects[way] = self.traced.of(way)
        return self.effects[way]

    def changed(self, beam: int, way: int) -> list[int]:
        """The cells to which the way does something else than the beam's present one."""
        now, then = self.effect(int(self.chosen[beam])), self.effect(way)
        return [
            c for c in now.keys() | then.keys() if now.get(c) != then.get(c)
        ]

    def gain(self, beam: int, way: int) -> float:
        """How much farther the map is after the turn; below 0 where it is nearer."""
        self.tries += 1
        cells = self.changed(beam, way)
        before = sum(self.open.get(cell, 0.0) for cell in cells)
        present = int(self.chosen[beam])
        self.chosen[beam] = way
        after = sum(map(self.off, cells))
        self.chosen[beam] = present
        return after - before

    def apply(self, beam: int, way: int) -> None:
        """Turns a beam, and sees which cells are open now."""
        cells = self.changed(beam, way)
        self.chosen[beam] = way
        for cell in cells:
            self.open[cell] = self.off(cell)
            if not self.open[cell]:
                del self.open[cell]

    def off(self, cell: int) -> float:
        """How far the cell is from the program's value, with the ways chosen now."""
        visits = self.visits(cell)
        mine = self.chosen[visits.beam] == visits.way
        start, free, occupied, least, most = self.model
        value = start
        for kind in visits.kind[mine].tolist():
            value += free if kind == FREE else occupied
            if value > most:
                value = most
            elif value < least:
                value = least
        return self.distance(cell, value)
