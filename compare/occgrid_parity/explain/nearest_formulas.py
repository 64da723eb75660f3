"""Where a right program puts its beams: the right formulas whose map is nearest to a program's."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from occgrid_parity.explain.chosen_ways import ChosenWays
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.beam_ways import ways_of_ends
from occgrid_parity.model.right_ends import RightEnds
from occgrid_parity.model.right_formulas import CHOICES, DIRECTIONS, Formulas

Fits = Callable[[Cells, Array], Mask]
"""fits(cells, values): in which cells the program's value is this one."""

STARTS = (Formulas(), Formulas(functions="this machine's"))
ROUNDS = 2


class NearestFormulas:
    """Takes one other formula after the other, as long as that brings the map nearer to the program's.

    ``chosen`` is the way of each beam with the nearest formulas, ``open`` the cells in which the map is not the
    program's then.
    """

    def __init__(
        self, ends: RightEnds, ways: ChosenWays, fits: Fits, touched: Cells
    ) -> None:
        self.ends = ends
        self.ways = ways
        self.fits = fits
        self.touched = touched
        self.formulas = STARTS[0]
        self.chosen = np.flatnonzero(ways.ways.contract)
        self.open = self.misfits(touched, self.chosen)
        # the cells that were wrong with one of the formulas taken: the quick look is at these alone
        self.watched = self.open
        self._search()

    def _search(self) -> None:
        for start in STARTS[1:]:
            self._try(start)
        for _ in range(ROUNDS):
            before = self.open.size
            for formulas in _others(self):
                if not self.open.size:
                    return
                self._try(formulas)
            if self.open.size == before:
                return

    def _try(self, formulas: Formulas) -> None:
        """Takes these formulas if the map is nearer with them."""
        chosen = ways_of_ends(self.ways.ways, self.ends.of(formulas))
        if self.misfits(self.watched, chosen).size >= self.open.size:
            return
        found = self.misfits(self.touched, chosen)
        self.watched = np.union1d(self.watched, found)
        if found.size < self.open.size:
            self.formulas, self.chosen, self.open = formulas, chosen, found

    def misfits(self, cells: Cells, chosen: Cells) -> Cells:
        """Which of the cells are not the program's."""
        return cells[~self.fits(cells, self.ways.values(cells, chosen))]

    def crossing(self, cell: int) -> Cells:
        """The beams that update a cell with the nearest formulas."""
        visits = self.ways.visits(cell)
        mine = self.chosen[visits.beam] == visits.way
        beams: Cells = visits.beam[mine]
        return beams


def _others(nearest: NearestFormulas) -> Iterator[Formulas]:
    """The formulas taken, with another one for a single step, or for the directions of rays and beams together."""
    for step, names in CHOICES.items():
        if step == "seen":
            for name in DIRECTIONS:
                yield nearest.formulas._replace(seen=name, drawn=name)
        for name in names:
            if name != getattr(nearest.formulas, step):
                yield nearest.formulas._replace(**{step: name})
