"""Holds a program's map against the reference: identical, on the other side of an edge, or different.

Nothing here is a tolerance. Each cell that is not the same must be one of these, or the map differs:

- its grey value lies halfway between two levels (178.5, 52.5), so that the last bit of exp or log decides the level;
- undecided beams (occgrid_parity.model.rounding) touch it, and one choice of sides for all beams gives exactly the
  program's value in this cell and in all others;
- with a log-odds file: all values are those of the same updates with the program's own logit(p_occ) and logit(p_free),
  which are at most a few units in the last place off the contract's, since its logarithm is another one.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from occgrid.grid import sigmoid
from occgrid.sensor import Scan
from occgrid_parity.explain.chosen_ways import (
    ChosenWays,
    TracedWays,
    UpdateModel,
)
from occgrid_parity.explain.edge_sides import Distance, SideSearch
from occgrid_parity.explain.left_out import left_out
from occgrid_parity.explain.nearest_formulas import NearestFormulas
from occgrid_parity.formats.log_odds import bits
from occgrid_parity.model.arithmetic import U
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.mapper_steps import Drawn, Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.right_ends import RightEnds
from occgrid_parity.model.right_formulas import Formulas
from occgrid_parity.model.rounding import Beams, beams_of
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

Closeness = Literal["identical", "halves", "edges", "differs"]

STEP_ULPS = 8
LAST_BITS = (
    1e-9  # other steps are looked for only where some value is off by less
)
MOST_CELLS = 4000  # that are looked at
MOST_OPEN = (
    500  # cells that rounding can leave, with the nearest right formulas
)


@dataclass(frozen=True)
class Compared:
    """How a map compares.

    ``wrong`` (height, width), smallest y first, are the cells that are not the same; ``unexplained`` those of them
    that no rounding explains. ``edge_beams`` count the beams of all scans, ``steps`` are the program's own (free,
    occupied) where they are not the contract's. ``formulas`` are those with which the reference draws the program's map
    in every cell, where they are known (occgrid_parity.model.right_formulas). ``together`` is False where each cell
    alone could come from rounding but no choice of sides for all beams was found. ``left_out`` is what right formulas
    must leave out to draw the map, as ``without scan 50``.
    """

    status: Closeness
    wrong: Mask = field(repr=False)
    unexplained: Mask = field(repr=False)
    edge_beams: tuple[int, ...] = ()
    halves: int = 0
    steps: tuple[float, float] | None = None
    formulas: Formulas | None = None
    log_odds: bool = False
    beams: Beams | None = field(default=None, repr=False)
    together: bool = True
    left_out: str = ""


def compare_with_reference(
    observed: Observed, case: Case, mode: Mode, own_poses: bool = False
) -> Compared:
    """Compares a map of the right size with the reference."""
    drawn = reference_map(case, mode)
    wrong = differing(observed, drawn)
    none = np.zeros_like(wrong)
    given = observed.log_odds is not None
    if not wrong.any():
        return Compared("identical", wrong, none, log_odds=given)
    world = world_of(case)
    if _only_halves(observed, drawn, world):
        count = int(np.count_nonzero(observed.pixels != drawn.pixels))
        return Compared("halves", wrong, none, halves=count, log_odds=given)
    return _Search(observed, world, mode, own_poses, drawn, wrong).result()


def differing(observed: Observed, drawn: Drawn) -> Mask:
    """The cells whose pixel or log-odds are not the same."""
    wrong: Mask = (observed.pixels != drawn.pixels)[::-1]
    if observed.log_odds is not None:
        wrong = wrong | (bits(observed.log_odds) != bits(drawn.log_odds))
    return wrong


def _only_halves(observed: Observed, drawn: Drawn, world: World) -> bool:
    """Whether every cell that is not the same has a grey value halfway between two levels, and the right log-odds."""
    own = observed.log_odds
    if own is not None and (bits(own) != bits(drawn.log_odds)).any():
        return False
    wrong = observed.pixels != drawn.pixels
    beams = sum(
        one.ranges.size if isinstance(one, Scan) else world.settings.beams
        for one in world.scans
    )
    low, high = grey_levels(drawn.log_odds[::-1][wrong], beams)
    pixels = observed.pixels[wrong]
    return bool(((pixels == low) | (pixels == high)).all())


class _Search:
    """Looks for an explanation of every cell that is not the same."""

    def __init__(
        self,
        observed: Observed,
        world: World,
        mode: Mode,
        own_poses: bool,
        drawn: Drawn,
        wrong: Mask,
    ) -> None:
        self.observed = observed
        self.world = world
        self.mode = mode
        self.own_poses = own_poses
        self.drawn = drawn
        self.wrong = wrong
        self.given = observed.log_odds is not None
        self.pixels = observed.pixels[::-1].reshape(-1)
        self.beams = beams_of(world, mode.seed, own_poses)
        self.blur = _blur(self.beams.scan.size)
        mapper = Mapper(world, mode.seed)
        self.start, (self.free, self.occupied) = mapper.l0, mapper.steps()
        self.steps: tuple[float, float] | None = None
        self.formulas: Formulas | None = None
        self.left_out = ""

    def result(self) -> Compared:
        if self.given:
            self.take_own_steps()
        expected = self.drawn.log_odds.reshape(-1)
        same = np.ones(expected.shape, dtype=bool)
        if self.observed.log_odds is not None:
            found = self.observed.log_odds
            same = (bits(found) == bits(self.drawn.log_odds)).reshape(-1)
        touched = self.touched()
        low, high = grey_levels(expected, self.beams.scan.size)
        level = (self.pixels == low) | (self.pixels == high)
        open_cells = ~(same & level)
        unexplained = open_cells & ~touched
        edge_beams: list[int] = []
        together = True
        todo = np.flatnonzero(open_cells & touched)
        if unexplained.any() or todo.size > MOST_CELLS:
            unexplained |= open_cells
        elif todo.size:
            edge_beams = self.turned_beams(np.flatnonzero(touched))
            together = bool(edge_beams)
            if not together:
                unexplained |= open_cells
        halves = int(
            np.count_nonzero(same & level & (self.pixels != _levels(expected)))
        )
        status: Closeness = "identical"
        if unexplained.any():
            status = "differs"
        elif edge_beams:
            status = "edges"
        elif halves:
            status = "halves"
        return Compared(
            status,
            self.wrong,
            unexplained.reshape(self.wrong.shape),
            tuple(edge_beams),
            halves,
            self.steps,
            self.formulas,
            self.given,
            self.beams,
            together,
            self.left_out,
        )

    @functools.cached_property
    def traced(self) -> TracedWays:
        """The cells of all beams."""
        s = self.world.settings
        every = np.arange(self.beams.ways.beam.size)
        return TracedWays(self.beams, s.width, s.height, every)

    def touched(self) -> Mask:
        """The cells that an undecided beam can touch, flat."""
        s = self.world.settings
        undecided = np.zeros(self.beams.scan.size, dtype=bool)
        undecided[self.beams.undecided] = True
        ways = undecided[self.beams.ways.beam]
        if np.count_nonzero(ways) < ways.size // 2:
            some = np.flatnonzero(ways)
            cells = TracedWays(self.beams, s.width, s.height, some).cell
        else:  # all are traced sooner or later
            cells = self.traced.cell[ways[self.traced.way]]
        touched = np.zeros(s.width * s.height, dtype=bool)
        touched[cells] = True
        return touched

    def turned_beams(self, touched: Cells) -> list[int]:
        """Beams that go another way than the contract's, so that all cells are the program's; empty if none were found.

        Only those are named that change a cell in which the two maps differ.
        """
        ways = ChosenWays(self.traced, self.model())
        ends = RightEnds(
            self.world, self.mode.seed, self.beams, self.own_poses
        )
        nearest = NearestFormulas(ends, ways, self.fits, touched)
        chosen = nearest.chosen
        if nearest.open.size:
            search = SideSearch(ways, chosen, nearest.open, self.distance())
            found = nearest.open.size <= MOST_OPEN and search.solve()
            # one beam that is turned is as simple as a scan that is missing
            if not found or len(search.turned) > 1:
                self.left_out = left_out(nearest, self.beams)
            if not found or self.left_out:
                return []
            chosen = search.chosen
        else:
            self.formulas = nearest.formulas
        cells = np.flatnonzero(self.wrong)
        contract = np.flatnonzero(self.beams.ways.contract)
        turned = ways.beams_that_differ(cells, chosen, contract)
        return list(map(int, turned))

    def fits(self, cells: Cells, values: Array) -> Mask:
        """In which cells these log-odds are the program's."""
        grey, pixels = _grey(values), self.pixels[cells]
        same: Mask = pixels == np.floor(grey - self.blur)
        same |= pixels == np.floor(grey + self.blur)
        if self.observed.log_odds is not None:
            same &= values == self.observed.log_odds.reshape(-1)[cells]
        return same

    def model(self) -> UpdateModel:
        s = self.world.settings
        return UpdateModel(
            self.start, self.free, self.occupied, s.l_min, s.l_max
        )

    def distance(self) -> Distance:
        """How far the program's cells are from values."""
        pixels, blur = self.pixels.tolist(), self.blur
        found = self.observed.log_odds
        log_odds = None if found is None else found.reshape(-1).tolist()

        def off(cell: int, value: float) -> float:
            pixel = pixels[cell]
            grey = _grey_of(value)
            low, high = math.floor(grey - blur), math.floor(grey + blur)
            fits = pixel in (low, high)
            if log_odds is None:
                return 0.0 if fits else max(abs(grey - 0.5 - pixel), 1e-6)
            if fits and value == log_odds[cell]:
                return 0.0
            return max(abs(value - log_odds[cell]), 1e-6)

        return off

    def take_own_steps(self) -> None:
        """If the program's logarithm is another one: its steps, and the reference's map with them."""
        assert self.observed.log_odds is not None
        found = self.observed.log_odds.reshape(-1)
        off = np.abs(found - self.drawn.log_odds.reshape(-1))
        if not ((off > 0.0) & (off < LAST_BITS)).any():
            return
        traced = self.traced
        mine = self.beams.ways.contract[traced.way]
        counts = np.bincount(traced.cell[mine], minlength=found.size)
        hit = np.bincount(traced.cell[mine & traced.hit], minlength=found.size)
        free = _most_common(found[(counts == 1) & (hit == 0)])
        occupied = _most_common(found[(counts == 1) & (hit == 1)])
        start = _most_common(found[counts == 0])
        starts = [self.start] if start is None else [start]
        if abs(starts[0] - self.start) > STEP_ULPS * U:
            return
        best = int(np.count_nonzero(self.wrong))
        for f in _steps(starts[0], free, self.free):
            for o in _steps(starts[0], occupied, self.occupied):
                if (starts[0], f, o) == (self.start, self.free, self.occupied):
                    continue
                if best == 0:
                    break
                drawn = _WithSteps(
                    self.world, self.mode.seed, starts[0], f, o
                ).draw()
                count = int(np.count_nonzero(differing(self.observed, drawn)))
                if count < best:
                    best, self.drawn, self.steps = count, drawn, (f, o)
        if self.steps is not None:
            self.start = starts[0]
            self.free, self.occupied = self.steps


class _WithSteps(Mapper):
    """The contract with other log-odds to start from and to add."""

    def __init__(
        self,
        world: World,
        seed: int | None,
        start: float,
        free: float,
        occupied: float,
    ) -> None:
        super().__init__(world, seed)
        self.own = start, free, occupied

    def start(self) -> float:
        return self.own[0]

    def steps(self) -> tuple[float, float]:
        return self.own[1], self.own[2]


def _most_common(values: Array) -> float | None:
    if not values.size:
        return None
    unique, counts = np.unique(values, return_counts=True)
    return float(unique[np.argmax(counts)])


def _steps(start: float, seen: float | None, contract: float) -> list[float]:
    """The steps near the contract's that lead from the start to the value that was seen after one update."""
    steps = [contract]
    for _ in range(STEP_ULPS):
        least, largest = min(steps), max(steps)
        steps.append(float(np.nextafter(least, -np.inf)))
        steps.append(float(np.nextafter(largest, np.inf)))
    if seen is None:  # no cell tells: try them all
        return steps
    return [step for step in steps if start + step == seen] or [contract]


def _grey(log_odds: Array) -> Array:
    """(1 - p) * 255 + 0.5, in this machine's arithmetic."""
    z = np.exp(-np.abs(log_odds))
    return (1.0 - np.where(log_odds >= 0.0, 1.0, z) / (1.0 + z)) * 255.0 + 0.5


def _grey_of(log_odds: float) -> float:
    """The same of one value."""
    z = math.exp(-abs(log_odds))
    return (1.0 - (1.0 if log_odds >= 0.0 else z) / (1.0 + z)) * 255.0 + 0.5


def _blur(updates: int) -> float:
    """The bound on what rounding does to a grey value after so many updates; a beam updates a cell once at the most.

    Each addition is off by at most 4 u, and a quarter of that reaches p; exp, quotient and product add a few u.
    """
    return 255.0 * (16.0 + 2.0 * updates) * U


def _levels(log_odds: Array) -> Cells:
    """The contract's pixels."""
    return np.floor((1.0 - sigmoid(log_odds)) * 255.0 + 0.5).astype(np.int64)


def grey_levels(log_odds: Array, updates: int) -> tuple[Cells, Cells]:
    """The least and the largest pixel that rounding can make of log-odds with so many updates behind them."""
    grey, blur = _grey(log_odds), _blur(updates)
    low = np.floor(grey - blur).astype(np.int64)
    return low, np.floor(grey + blur).astype(np.int64)
