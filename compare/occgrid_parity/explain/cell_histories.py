"""What one beam more, less or otherwise makes of a cell, computed from the beam on and kept.

The search for sides asks the same of the same cells again and again: most of their beams stay where they are.
"""

from __future__ import annotations

from bisect import bisect_left
from typing import NamedTuple

from occgrid_parity.explain.chosen_ways import FREE, NOTHING, ChosenWays
from occgrid_parity.model.array_types import Cells


class History(NamedTuple):
    """The beams that update a cell, in order, what each does, and the log-odds before each and after the last."""

    beams: list[int]
    kinds: list[int]
    values: list[float]


class CellHistories:
    """The log-odds of cells with the ways that are chosen, and with one beam otherwise."""

    def __init__(self, ways: ChosenWays, chosen: Cells) -> None:
        self.ways = ways
        self.chosen = chosen
        self.known: dict[int, History] = {}
        self.asked: dict[int, dict[tuple[int, int], float]] = {}

    def forget(self, cell: int) -> None:
        """To be called when another way is chosen for a beam that touches the cell."""
        self.known.pop(cell, None)
        self.asked.pop(cell, None)

    def value(self, cell: int, beam: int, kind: int) -> float:
        """The cell's log-odds where the beam does this to it."""
        asked = self.asked.setdefault(cell, {})
        if (beam, kind) not in asked:
            asked[beam, kind] = self._value(cell, beam, kind)
        return asked[beam, kind]

    def _value(self, cell: int, beam: int, kind: int) -> float:
        beams, kinds, values = self._history(cell)
        first = bisect_left(beams, beam)
        value = values[first]
        if kind != NOTHING:
            value = self._after(value, kind)
        rest = first + (first < len(beams) and beams[first] == beam)
        for place in range(rest, len(beams)):
            if value == values[place]:  # from here on all is as it was
                return values[-1]
            value = self._after(value, kinds[place])
        return value

    def _history(self, cell: int) -> History:
        if cell not in self.known:
            visits = self.ways.visits(cell)
            mine = self.chosen[visits.beam] == visits.way
            kinds = visits.kind[mine].tolist()
            values = [self.ways.model.start]
            for kind in kinds:
                values.append(self._after(values[-1], kind))
            beams = visits.beam[mine].tolist()
            self.known[cell] = History(beams, kinds, values)
        return self.known[cell]

    def _after(self, value: float, kind: int) -> float:
        _, free, occupied, least, most = self.ways.model
        value += free if kind == FREE else occupied
        return most if value > most else least if value < least else value
