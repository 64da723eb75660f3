"""One choice of sides for all undecided beams that draws a program's map: the proof that rounding explains it.

That each cell alone can come about is not enough: a beam that ends on the one side of an edge cannot end on the other
side, too. The search starts where the nearest right formulas put the beams
(occgrid_parity.explain.nearest_formulas), and turns one beam after the other until every cell is the program's, the
best turn first. Each turn must bring the map nearer to the program's, and there is an end to trying: a choice that is
found is a proof, that none is found is not.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from occgrid_parity.explain.cell_histories import CellHistories
from occgrid_parity.explain.chosen_ways import NOTHING, ChosenWays
from occgrid_parity.model.array_types import Cells

Distance = Callable[[int, float], float]
"""distance(cell, value): how far the program's value is from it; 0 where the value is the program's."""

ROUNDED_UP = 1.0 + 1e-9  # a sum is not below another one by rounding alone
MOST_TRIES = 300  # and as many for each 10 cells that are open


class Turn(NamedTuple):
    """Another way for one beam, and how much nearer that brings the map."""

    gain: float
    beam: int
    way: int


class Step(NamedTuple):
    """A turn that was made: the way before it, what is left to try in its place."""

    beam: int
    before: int
    left: list[Turn]


class SideSearch:
    """The search; ``chosen`` is the way of each beam, ``turned`` those of the beams that it has turned."""

    def __init__(
        self, ways: ChosenWays, chosen: Cells, wrong: Cells, distance: Distance
    ) -> None:
        self.ways = ways
        self.chosen = chosen.copy()
        self.distance = distance
        beams = ways.traced.beams.scan.size
        self.first = np.searchsorted(ways.ways.beam, np.arange(beams + 1))
        self.turned: dict[int, int] = {}
        self.effects: dict[int, dict[int, int]] = {}
        self.histories = CellHistories(ways, self.chosen)
        self.open = {cell: self.off(cell) for cell in wrong.tolist()}
        self.tries = 0

    def solve(self) -> bool:
        """Whether a choice was found that draws the program's map."""
        most = MOST_TRIES + MOST_TRIES * len(self.open) // 10
        steps: list[Step] = []
        turns = self.turns() if self.open else []
        while self.open:
            if turns and self.tries < most:
                turn = turns.pop(0)
                before = int(self.chosen[turn.beam])
                steps.append(Step(turn.beam, before, turns))
                self.turned[turn.beam] = turn.way
                self.apply(turn.beam, turn.way)
                turns = self.turns() if self.open else []
            elif steps:
                beam, before, turns = steps.pop()
                self.apply(beam, before)
                del self.turned[beam]
            else:
                return False
        return True

    def turns(self) -> list[Turn]:
        """Turns that change one of the open cells, the best first."""
        cell = min(self.open)
        found: list[Turn] = []
        for beam in np.unique(self.ways.visits(cell).beam).tolist():
            start, end = int(self.first[beam]), int(self.first[beam + 1])
            if end - start == 1 or beam in self.turned:
                continue
            current = self.effect(int(self.chosen[beam])).get(cell, NOTHING)
            for way in range(start, end):
                if self.effect(way).get(cell, NOTHING) != current:
                    gain = self.gain(beam, way)
                    if gain < 0.0:
                        found.append(Turn(gain, beam, way))
        return sorted(found)

    def effect(self, way: int) -> dict[int, int]:
        if way not in self.effects:
            self.effects[way] = self.ways.traced.of(way)
        return self.effects[way]

    def changed(self, beam: int, way: int) -> list[int]:
        """The cells to which the way does something else than the beam's present one."""
        now, then = self.effect(int(self.chosen[beam])), self.effect(way)
        return [
            c for c in now.keys() | then.keys() if now.get(c) != then.get(c)
        ]

    def gain(self, beam: int, way: int) -> float:
        """How much farther the map is after the turn; below 0 where it is nearer, else this much or more."""
        self.tries += 1
        cells = self.changed(beam, way)
        before = sum(self.open.get(cell, 0.0) for cell in cells)
        effect = self.effect(way)
        enough = before * ROUNDED_UP
        after: list[float] = []
        for cell in cells:
            kind = effect.get(cell, NOTHING)
            value = self.histories.value(cell, beam, kind)
            after.append(self.distance(cell, value))
            enough -= after[-1]
            if enough < 0.0:  # no cell can make up for it
                break
        return sum(after) - before

    def apply(self, beam: int, way: int) -> None:
        """Turns a beam, and sees which cells are open now."""
        cells = self.changed(beam, way)
        self.chosen[beam] = way
        for cell in cells:
            self.histories.forget(cell)
            self.open[cell] = self.off(cell)
            if not self.open[cell]:
                del self.open[cell]

    def off(self, cell: int) -> float:
        """How far the cell is from the program's value, with the ways chosen now."""
        return self.distance(cell, self.ways.value(cell, self.chosen))
