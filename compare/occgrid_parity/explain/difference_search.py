"""The search: prefixes of scans (1, 2, 4, ..., then halving), then beams of the scan that was found."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple, Protocol

from occgrid_parity.explain.closeness import Compared
from occgrid_parity.explain.shorter_scenarios import Shortener
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

MOST_LINES = 50_000


WHOLE_SCAN = (
    "each beam of this scan is right with its bearing written out in the pose, so look at how you compute the bearings "
    "(start, step, count), or at what the beams of one scan do to each other"
)
CUT_SCAN = (
    "each beam of this scan is right when the scan is cut, so look at how the line is read: the fields that a "
    "shorter scan writes anew, and the bearings (start, step, count)"
)
DIFFERS_WHOLE = (
    "the scan's beams are wrong one by one, too, but in another way than together, so look at how you compute the "
    "bearings (start, step, count), or at what the beams of one scan do to each other"
)


class Trial(NamedTuple):
    """A run on a shortened scenario: the map, how it compares, and whether that counts as different."""

    case: Case
    observed: Observed
    compared: Compared
    differs: bool


Try = Callable[[Case], Trial]
"""Runs the program and compares; raises SearchFailed where it draws no map."""


class SearchFailed(Exception):
    """The program draws no map of a shortened scenario, so the search ends; the text says how it failed."""


@dataclass(frozen=True)
class Found:
    """What the search found.

    ``trial`` shows the difference, and ``prefix`` does with whole scans, as they are in the file; ``prefixes`` are all
    trials of the first scans, by their number. ``before`` is the trial just before, where there is one. ``beam`` is
    None where the beam cannot be told by running, and ``why`` says why. ``single``: the trial is of that one beam
    alone.
    """

    scan: int
    beam: int | None
    trial: Trial
    before: Trial | None
    single: bool = False
    why: str = ""
    prefix: Trial | None = None
    prefixes: Mapping[int, Trial] = field(default_factory=dict)


class Guess(Protocol):
    """Which scan and beam may be the ones, as the wrong cells of a trial tell; they are tried first."""

    def scan(self, trial: Trial) -> int:
        """The first scan that updates a wrong cell."""

    def beam(self, scan: int, trial: Trial) -> int:
        """The first beam of a scan that does."""


def search(
    case: Case, mode: Mode, whole: Trial, attempt: Try, guess: Guess
) -> Found:
    """The first scan and beam of a difference that the ``whole`` scenario shows.

    "First" is this: after the scan (beam) before it the maps are the same, after it they are not. A later scan can
    make maps the same again, so the number of scans is doubled before it is halved.
    """
    shortener = Shortener(case)
    prefixes: dict[int, Trial] = {}

    def prefix(scans: int) -> Trial:
        prefixes[scans] = attempt(shortener.prefix(scans))
        return prefixes[scans]

    span = _Span(len(shortener.scan_lines), whole)
    span.try_around(guess.scan(whole), prefix)
    span.double(prefix)
    first = span.halve(prefix)
    found = _in_scan(shortener, mode, *first, attempt, guess)
    return replace(found, prefix=first[1], prefixes=prefixes)


def _in_scan(
    shortener: Shortener,
    mode: Mode,
    scan: int,
    trial: Trial,
    before: Trial | None,
    attempt: Try,
    guess: Guess,
) -> Found:
    """The first beam of the scan after which the maps differ; ``trial`` and ``before`` are those of whole scans."""
    if mode.seed is not None and shortener.is_simulated(scan):
        why = "noise depends on the numbers of scan and beam, so a simulated scan cannot be cut"
        return Found(scan, None, trial, before, why=why)
    history = False
    if scan > 0:
        alone = attempt(shortener.alone(scan))
        history = not alone.differs
        if not history:
            trial, before = alone, None
    beams = shortener.beams_in(scan)
    cut = _Beams(shortener, scan, history, attempt)
    if cut.lines() > MOST_LINES:
        why = f"the {scan} scans before it would have to be cut into {cut.lines()} beams"
        return Found(scan, None, trial, before, why=why)
    if beams > 1 or history or shortener.is_simulated(scan):
        cut_whole = cut.attempt(beams)
        if not cut_whole.differs:
            why = WHOLE_SCAN if shortener.is_simulated(scan) else CUT_SCAN
            return Found(scan, None, trial, before, why=why)
        if not _same(cut_whole, trial):
            why = DIFFERS_WHOLE
            return Found(scan, None, trial, before, why=why)
        trial = cut_whole
    beam, trial, before = cut.first(trial, guess.beam(scan, trial))
    if trial.case.data == shortener.beam(scan, beam).data:
        return Found(scan, beam, trial, before, single=True)
    single = attempt(shortener.beam(scan, beam))
    if single.differs:
        return Found(scan, beam, single, None, single=True)
    return Found(scan, beam, trial, before)


def _same(one: Trial, other: Trial) -> bool:
    """Whether the program drew the same map twice."""
    first, second = one.observed, other.observed
    same = bool((first.pixels == second.pixels).all())
    if first.log_odds is None or second.log_odds is None:
        return same
    return same and first.log_odds.tobytes() == second.log_odds.tobytes()


class _Span:
    """Of so many parts, the first after which the maps differ: it is one of those from ``same`` to ``differs``."""

    def __init__(self, count: int, whole: Trial) -> None:
        self.same = 0
        self.before: Trial | None = None
        self.differs = count
        self.after = whole

    def take(self, parts: int, trial: Trial) -> None:
        """Narrows the span by what so many parts have shown."""
        if trial.differs:
            self.differs, self.after = parts, trial
        else:
            self.same, self.before = parts, trial

    def try_around(self, guess: int, attempt: Callable[[int], Trial]) -> None:
        """Tries the parts up to a guess, and those before it."""
        for parts in (guess + 1, guess):
            if self.same < parts < self.differs:
                self.take(parts, attempt(parts))

    def double(self, attempt: Callable[[int], Trial]) -> None:
        """Goes up in steps that double, until the maps differ."""
        first, step = self.same, 1
        while first + step < self.differs:
            self.take(first + step, attempt(first + step))
            step *= 2

    def halve(
        self, attempt: Callable[[int], Trial]
    ) -> tuple[int, Trial, Trial | None]:
        """The last part of the shortest that differs; the trials after it and before it."""
        while self.differs - self.same > 1:
            middle = (self.same + self.differs) // 2
            self.take(middle, attempt(middle))
        return self.differs - 1, self.after, self.before


class _Beams:
    """Trials of the first beams of one scan."""

    def __init__(
        self, shortener: Shortener, scan: int, history: bool, attempt: Try
    ) -> None:
        self.shortener = shortener
        self.scan = scan
        self.history = history
        self.run = attempt

    def lines(self) -> int:
        """How many lines the cut scenario has at the most."""
        if not (self.history and self.shortener.is_simulated(self.scan)):
            return self.scan + 1
        return sum(map(self.shortener.beams_in, range(self.scan + 1)))

    def attempt(self, count: int) -> Trial:
        return self.run(self.shortener.beams(self.scan, count, self.history))

    def first(
        self, whole: Trial, guess: int
    ) -> tuple[int, Trial, Trial | None]:
        """The first beam after which the maps differ; the trials after it and before it."""
        span = _Span(self.shortener.beams_in(self.scan), whole)
        span.try_around(guess, self.attempt)
        return span.halve(self.attempt)
