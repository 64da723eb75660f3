"""Draws maps with planted mistakes, and rules most of them out without drawing much.

Mistakes that leave the beams alone share the beams' cells, which take the most time. Of a large map a mistake is first
held against every sixteenth cell, which is exact: cells do not depend on each other.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from typing import NamedTuple

import numpy as np

from occgrid_parity.explain.closeness import Closeness, differing, grey_levels
from occgrid_parity.explain.shorter_scenarios import Shortener
from occgrid_parity.model.arithmetic import Arithmetic
from occgrid_parity.model.array_types import Mask
from occgrid_parity.model.mapper_steps import Drawn, Mapper, Traced
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

LARGE = 10_000  # cells of a map of which a sample is drawn first
SAMPLE = 16
FEW_SCANS = 8
FAR = 0.1  # share of the sample that no other sines and cosines can change
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
    "trace",
    "within_scan",
    "batches",
)


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
        beams = beams_of(world_of(self.case), self.mode.seed)
        return beams.undecided.size == 0


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
        batches = self._batches(mapper, one, numbers)
        s = mapper.settings
        if s.width * s.height >= LARGE and not halves:
            if not self._shows(mistake, one):
                self.far.add(mistake.name)
                return False
            wrong, cells = self._sampled(mapper, one, batches)
            if wrong > FAR * cells:
                self.far.add(mistake.name)
            if wrong:
                return False
        drawn = mapper.draw(batches)
        DRAWN[_key(mistake, one, numbers)] = _digests(drawn)
        if not _same_shape(drawn, one.observed):
            return False
        if not differing(one.observed, drawn).any():
            return True
        return halves and _only_halves(one.observed, drawn)

    def _batches(
        self, mapper: Mapper, one: Evidence, numbers: Arithmetic
    ) -> list[Traced] | None:
        """The updates of a map, if the mistake has the contract's."""
        kind = type(mapper)
        if any(
            getattr(kind, step) is not getattr(Mapper, step)
            for step in TRACING
            if step != "reads"
        ):
            return None
        if kind.reads.__func__ is not Mapper.reads.__func__:  # type: ignore[attr-defined]
            return None
        key = (id(numbers), f"{one.case.digest} {one.mode.name}")
        with self.lock:
            if key not in self.shared:
                self.shared[key] = list(mapper.batches())
            return self.shared[key]

    def _shows(self, mistake: type[Mapper], one: Evidence) -> bool:
        """Whether a map is wrong in one of the cells that the mistake changes in a few of the scans.

        A map that is right in all of them has not this mistake. Saying so too often can only keep a cause from
        being named.
        """
        few = self._few_scans(one)
        if few is None:
            return True
        right = reference_map(few, one.mode)
        drawn = mistake.of(few, one.mode.seed).draw()
        if not _same_shape(drawn, one.observed):
            return False
        changed = drawn.pixels != right.pixels
        whole = reference_map(one.case, one.mode)
        if drawn.pixels.shape != whole.pixels.shape or not changed.any():
            return True
        wrong = one.observed.pixels != whole.pixels
        return bool((changed & wrong).any())

    def _few_scans(self, one: Evidence) -> Case | None:
        """A scenario with a few of the scans; None where noise goes by their numbers or there are few already."""
        shortener = Shortener(one.case)
        count = len(shortener.scan_lines)
        if one.mode.seed is not None or count < 4 * FEW_SCANS:
            return None
        return shortener.some(range(0, count, count // FEW_SCANS))

    def _sampled(
        self, mapper: Mapper, one: Evidence, batches: list[Traced] | None
    ) -> tuple[int, int]:
        """Of a sample of the cells that are not as at the start, how many are wrong; and how many there are."""
        s = mapper.settings
        sample: Mask = np.arange(s.width * s.height) % (SAMPLE + 1) == 0
        drawn = mapper.draw(batches, sample)
        if not _same_shape(drawn, one.observed):
            return 1, 1
        square = sample.reshape(s.height, s.width)
        there = mapper.arrange(square.astype(np.int64)) == 1
        wrong = there & (drawn.pixels != one.observed.pixels)
        unknown = np.bincount(drawn.pixels.reshape(-1)).argmax()
        cells = there & (
            (drawn.pixels != unknown) | (one.observed.pixels != unknown)
        )
        count = int(np.count_nonzero(wrong))
        if one.observed.log_odds is not None and not count:
            mask = mapper.file_order(square.astype(np.float64)) == 1.0
            same = drawn.log_odds == one.observed.log_odds
            count = int((~same & mask).any())
        return count, int(np.count_nonzero(cells))


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
