"""Draws maps with planted mistakes, and rules most of them out without drawing much.

Mistakes that leave the beams alone share the beams' cells, which take the most time, and those that leave the update
alone, too, share the log-odds. In a large map a mistake is first held against the square with the most wrong cells, for
which only the beams near it are traced. That is exact: cells do not depend on each other.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from typing import NamedTuple, TypeVar

import numpy as np

from occgrid.sensor import Scan
from occgrid_parity.explain.closeness import Closeness, differing, grey_levels
from occgrid_parity.model.arithmetic import Arithmetic
from occgrid_parity.model.array_types import Array
from occgrid_parity.model.mapper_steps import (
    Drawn,
    Mapper,
    ScanEnds,
    Traced,
    Window,
)
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

T = TypeVar("T")

LARGE = 10_000  # cells of a map of which a square is drawn first
SQUARE = 16  # cells along a side
FAR = 0.1  # share of the square that no other sines and cosines can change
ROUNDINGS = 1000  # additions that a cell's log-odds may have behind them

# the steps that decide where beams start and end: mistakes in others share these
AIMING = (
    "bearings",
    "simulate",
    "simulated",
    "parallel",
    "deviate",
    "noisy",
    "clip_range",
    "scans",
    "read",
    "beam",
    "endpoint",
    "index",
    "to_grid",
    "kept",
    "ends",
    "beams",
)
# those that decide which cells are updated, and how
TRACING = (*AIMING, "lines", "evidence", "within_scan", "batches")
# those that make log-odds of the updates
UPDATING = (
    "logit",
    "start",
    "steps",
    "clamp",
    "updated",
    "finish",
    "place",
    "apply",
    "log_odds",
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


Shared = tuple[object, ...]
"""What a map, or a step on the way to it, depends on."""


@dataclass
class MistakenMaps:
    """Compares mistakes with maps; what it has found out about a mistake, and what it has drawn on the way, is kept."""

    beams: dict[Shared, list[ScanEnds]] = field(default_factory=dict)
    updates: dict[Shared, list[Traced]] = field(default_factory=dict)
    log_odds: dict[Shared, Array] = field(default_factory=dict)
    far: set[str] = field(default_factory=set)
    lock: threading.Lock = field(default_factory=threading.Lock)
    making: dict[Shared, threading.Lock] = field(default_factory=dict)

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
            share = self._wrong_in_square(mapper, one)
            if share > FAR:
                self.far.add(mistake.name)
            if share:
                return False
        drawn = mapper.drawn(self._log_odds(mapper, one))
        DRAWN[_key(mistake, one, numbers)] = _digests(drawn)
        if not _same_shape(drawn, one.observed):
            return False
        if not differing(one.observed, drawn).any():
            return True
        return halves and _only_halves(one.observed, drawn)

    def _log_odds(
        self, mapper: Mapper, one: Evidence, window: Window | None = None
    ) -> Array:
        """The log-odds of a map, or of a window of it; those of a map are kept where the updates are the contract's."""

        def make() -> Array:
            whole = mapper.log_odds(self._updates(mapper, one, window))
            if window is None:
                return whole
            left, bottom, right, top = window
            return whole[bottom:top, left:right].copy()

        if window is None and _overrides(mapper, TRACING):
            return make()
        key = (*_shared(mapper, one, TRACING, window), *_own(mapper, UPDATING))
        return self._once(self.log_odds, key, make)

    def _updates(
        self, mapper: Mapper, one: Evidence, window: Window | None
    ) -> Iterable[Traced]:
        """The updates of a window, or of a map; those of a map are kept where the mistake has the contract's."""
        if window is None and _overrides(mapper, TRACING):
            return mapper.batches(beams=self._beams(mapper, one))
        return self._once(
            self.updates,
            _shared(mapper, one, TRACING, window),
            lambda: _joined(mapper.batches(window, self._beams(mapper, one))),
        )

    def _beams(self, mapper: Mapper, one: Evidence) -> Iterable[ScanEnds]:
        """The beams of all scans; kept where they are the contract's."""
        if _overrides(mapper, AIMING):
            return mapper.beams()
        key = _shared(mapper, one, AIMING)
        return self._once(self.beams, key, lambda: list(mapper.beams()))

    def _once(
        self, known: dict[Shared, T], key: Shared, make: Callable[[], T]
    ) -> T:
        """What is kept under a key; the thread that asks first makes it, and others wait for it."""
        with self.lock:
            making = self.making.setdefault(
                (id(known), *key), threading.Lock()
            )
        with making:
            if key not in known:
                known[key] = make()
            return known[key]

    def _wrong_in_square(self, mapper: Mapper, one: Evidence) -> float:
        """Of the cells in the square with the most wrong ones, the share that the mistake does not draw.

        0 where the mistake exchanges cells, so that the square cannot be drawn alone.
        """
        if _overrides(mapper, ARRANGING):
            return 0.0
        s = mapper.settings
        if one.observed.pixels.shape != (s.height, s.width):
            return 1.0
        w = one.window
        rows, columns = slice(w.bottom, w.top), slice(w.left, w.right)
        values = self._log_odds(mapper, one, w).reshape(-1)
        pixels = mapper.pixel(mapper.probability(values))
        wrong = pixels != one.observed.pixels[::-1][rows, columns].reshape(-1)
        if one.observed.log_odds is not None:
            own = one.observed.log_odds[rows, columns].reshape(-1)
            wrong |= own != values
        return float(wrong.mean())


def _joined(updates: Iterable[Traced]) -> list[Traced]:
    """The same updates, all at once."""
    parts = list(updates)
    if len(parts) < 2:
        return parts
    return [Traced(*map(np.concatenate, zip(*parts, strict=True)))]


def _overrides(mapper: Mapper, steps: Iterable[str]) -> bool:
    """Whether a mistake lies in one of the steps."""
    return _own(mapper, steps) != [getattr(Mapper, step) for step in steps]


def _shared(
    mapper: Mapper,
    one: Evidence,
    steps: Iterable[str],
    window: Window | None = None,
) -> Shared:
    """What some steps on the way to a map, or to a window of it, depend on."""
    world = _content(mapper.reads(one.case))
    own = _own(mapper, steps)
    return world, one.mode, id(mapper.numbers), window, *own


@functools.lru_cache(256)
def _content(case: Case) -> Shared:
    """What tells worlds apart, however their files are written."""
    settings, walls, scans = world_of(case)
    if any(isinstance(scan, Scan) for scan in scans):
        return (case.digest,)
    return settings, *walls, *scans


def _own(mapper: Mapper, steps: Iterable[str]) -> Sequence[object]:
    return [getattr(type(mapper), step) for step in steps]


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
