"""Draws maps with planted mistakes, and rules most of them out without drawing much.

Mistakes that leave the beams alone share the beams' cells, which take the most time. In a large map a mistake is first
held against the square with the most wrong cells, for which only the beams near it are traced. That is exact: cells do
not depend on each other.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from typing import NamedTuple

import numpy as np

from occgrid_parity.explain.closeness import Closeness, differing, grey_levels
from occgrid_parity.model.arithmetic import Arithmetic
from occgrid_parity.model.mapper_steps import (
    Drawn,
    Mapper,
    Traced,
    Window,
)
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

LARGE = 10_000  # cells of a map of which a square is drawn first
SQUARE = 16  # cells along a side
FAR = 0.1  # share of the square that no other sines and cosines can change
ROUNDINGS = 1000  # additions that a cell's log-odds may have behind them

# the steps that decide which cells are updated, and how: mistakes in others share them
TRACING = (
    "reads",
    "bearings",
    "simulate",
    "deviate",
    "noisy",
    "clip_range",
    "scans",
    "read",
    "beam",
    "endpoint",
    "index",
    "to_grid",
    "lines",
    "evidence",
    "kept",
    "ends",
    "within_scan",
    "batches",
)
# those that decide where a cell lies in the files
ARRANGING = ("place", "file_order", "picture", "arrange")


class Digests(NamedTuple):
    """What tells maps apart: a hash of the pixels and their shape, and one of the bits of the log-odds."""

    pixels: bytes
    log_odds: bytes


DRAWN: dict[tuple[type[Mapper], str, str, int], Digests] = {}
"""The maps that mistakes draw, by mistake, scenario, mode and arithmetic: the same for every program."""


@dataclass(frozen=True)
class Evidence:
    """A map that the program has drawn."""

    case: Case
    mode: Mode
    observed: Observed
    status: Closeness

    @property
    def title(self) -> str:
        return f"{self.case.name}, {self.mode.name}"

    @functools.cached_property
    def is_conditioned(self) -> bool:
        """Whether rounding decides no beam of it."""
        own_poses = not self.case.is_file
        beams = beams_of(world_of(self.case), self.mode.seed, own_poses)
        return beams.undecided.size == 0

    @functools.cached_property
    def window(self) -> Window:
        """The square of the grid in which most cells are not the reference's."""
        drawn = reference_map(self.case, self.mode)
        height, width = drawn.log_odds.shape
        wrong = np.zeros(
            (-(-height // SQUARE) * SQUARE, -(-width // SQUARE) * SQUARE)
        )
        wrong[:height, :width] = differing(self.observed, drawn)
        counts = wrong.reshape(
            wrong.shape[0] // SQUARE, SQUARE, -1, SQUARE
        ).sum(axis=(1, 3))
        row, column = np.unravel_index(counts.argmax(), counts.shape)
        left, bottom = int(column) * SQUARE, int(row) * SQUARE
        return Window(
            left,
            bottom,
            min(left + SQUARE, width),
            min(bottom + SQUARE, height),
        )


@dataclass
class MistakenMaps:
    """Compares mistakes with maps; what it has found out about a mistake and what it has traced is kept."""

    shared: dict[tuple[int, str], list[Traced]] = field(default_factory=dict)
    far: set[str] = field(default_factory=set)
    lock: threading.Lock = field(default_factory=threading.Lock)

    def draws_all(
        self,
        mistake: type[Mapper],
        maps: Sequence[Evidence],
        numbers: Arithmetic,
        halves: bool = False,
    ) -> bool:
        """Whether the mistake draws every one of the maps."""
        if mistake.name in self.far:
            return False
        return all(
            self.draws(mistake, one, numbers, halves)
            for one in sorted(maps, key=lambda one: one.observed.pixels.size)
        )

    def draws(
        self,
        mistake: type[Mapper],
        one: Evidence,
        numbers: Arithmetic,
        halves: bool = False,
    ) -> bool:
        """Whether the mistake draws a map, in every pixel, and in every bit of the log-odds if there are any.

        With ``halves``, grey values halfway between two levels may be on the other side.
        """
        known = None if halves else DRAWN.get(_key(mistake, one, numbers))
        if known is not None:
            return known == _digests(one.observed, known)
        mapper = mistake.of(one.case, one.mode.seed, numbers)
        s = mapper.settings
        if s.width * s.height >= LARGE and not halves:
            share = self._wrong_in_square(mapper, one, numbers)
            if share > FAR:
                self.far.add(mistake.name)
            if share:
                return False
        drawn = mapper.draw(self._batches(mapper, one, numbers))
        DRAWN[_key(mistake, one, numbers)] = _digests(drawn)
        if not _same_shape(drawn, one.observed):
            return False
        if not differing(one.observed, drawn).any():
            return True
        return halves and _only_halves(one.observed, drawn)

    def _batches(
        self,
        mapper: Mapper,
        one: Evidence,
        numbers: Arithmetic,
        window: Window | None = None,
    ) -> Iterable[Traced]:
        """The updates of a map, or of a window of it; kept where the mistake has the contract's."""
        kind = type(mapper)
        if any(_overrides(kind, step) for step in TRACING):
            return mapper.batches(window)
        key = (id(numbers), f"{one.case.digest} {one.mode.name} {window}")
        with self.lock:
            if key not in self.shared:
                self.shared[key] = list(mapper.batches(window))
            return self.shared[key]

    def _wrong_in_square(
        self, mapper: Mapper, one: Evidence, numbers: Arithmetic
    ) -> float:
        """Of the cells in the square with the most wrong ones, the share that the mistake does not draw.

        0 where the mistake exchanges cells, so that the square cannot be drawn alone.
        """
        if any(_overrides(type(mapper), step) for step in ARRANGING):
            return 0.0
        s = mapper.settings
        if one.observed.pixels.shape != (s.height, s.width):
            return 1.0
        w = one.window
        values = mapper.values(w, self._batches(mapper, one, numbers, w))
        rows, columns = slice(w.bottom, w.top), slice(w.left, w.right)
        pixels = mapper.pixel(mapper.probability(values))
        wrong = pixels != one.observed.pixels[::-1][rows, columns].reshape(-1)
        if one.observed.log_odds is not None:
            own = one.observed.log_odds[rows, columns].reshape(-1)
            wrong |= own != values
        return float(wrong.mean())


def _overrides(kind: type[Mapper], step: str) -> bool:
    """Whether a mistake lies in a step."""
    own, contract = getattr(kind, step), getattr(Mapper, step)
    return getattr(own, "__func__", own) is not getattr(
        contract, "__func__", contract
    )


def _key(
    mistake: type[Mapper], one: Evidence, numbers: Arithmetic
) -> tuple[type[Mapper], str, str, int]:
    return mistake, one.case.digest, one.mode.name, id(numbers)


def _digests(drawn: Drawn | Observed, other: Digests | None = None) -> Digests:
    """Of a map without log-odds, the hash of these is that of the other map."""
    shape = str(drawn.pixels.shape).encode()
    pixels = np.ascontiguousarray(drawn.pixels, dtype=np.int64)
    if drawn.log_odds is not None:
        own = np.ascontiguousarray(drawn.log_odds, dtype=np.float64)
        turned = str(own.shape).encode()
        log_odds = sha256(turned + own.tobytes()).digest()
    else:
        assert other is not None
        log_odds = other.log_odds
    return Digests(sha256(shape + pixels.tobytes()).digest(), log_odds)


def _same_shape(drawn: Drawn, observed: Observed) -> bool:
    if drawn.pixels.shape != observed.pixels.shape:
        return False
    if observed.log_odds is None:
        return True
    return drawn.log_odds.shape == observed.log_odds.shape


def _only_halves(observed: Observed, drawn: Drawn) -> bool:
    """Whether all differences are grey values halfway between two levels, by the mistaken map's own log-odds."""
    low, high = grey_levels(drawn.log_odds, ROUNDINGS)
    wrong = observed.pixels != drawn.pixels
    # a picture that is turned or flipped is not matched here
    upright = (
        (drawn.pixels[::-1] >= low) & (drawn.pixels[::-1] <= high)
    ).all()
    either = (
        (observed.pixels[::-1] == low) | (observed.pixels[::-1] == high)
    ).all()
    return bool(
        wrong.any() and upright and either and observed.log_odds is None
    )
