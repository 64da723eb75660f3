"""The search: prefixes of scans (1, 2, 4, ..., then halving), then beams of the scan that was found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

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

    ``trial`` shows the difference, and ``prefix`` does with whole scans, as they are in the file. ``before`` is the
    trial just before, where there is one. ``beam`` is None where the beam cannot be told by running, and ``why`` says
    why. ``single``: the trial is of that one beam alone.
    """

    scan: int
    beam: int | None
    trial: Trial
    before: Trial | None
    single: bool = False
    why: str = ""
    prefix: Trial | None = None


def search(
    case: Case, mode: Mode, whole: Trial, attempt: Try, guess: int = 0
) -> Found:
    """The first scan and beam of a difference that the ``whole`` scenario shows.

    "First" is this: after the scan (beam) before it the maps are the same, after it they are not. A later beam can
    make maps the same again, so the number of scans is doubled before it is halved. ``guess`` is a scan that may be the
    one: it is tried first, which saves most runs where it is.
    """
    shortener = Shortener(case)
    first = _first_scan(shortener, whole, attempt, guess)
    found = _in_scan(shortener, mode, *first, attempt)
    return replace(found, prefix=first[1])


def _in_scan(
    shortener: Shortener,
    mode: Mode,
    scan: int,
    trial: Trial,
    before: Trial | None,
    attempt: Try,
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
    beam, trial, before = cut.first(trial)
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


def _first_scan(
    shortener: Shortener, whole: Trial, attempt: Try, guess: int
) -> tuple[int, Trial, Trial | None]:
    """The first scan after which the maps differ; the trials after it and before it."""
    count = len(shortener.scan_lines)
    same, before = 0, None
    differs, after = count, whole
    rung = 1
    if 0 < guess < count - 1:
        trial = attempt(shortener.prefix(guess + 1))
        if trial.differs:
            earlier = attempt(shortener.prefix(guess))
            if not earlier.differs:
                return guess, trial, earlier
            differs, after = guess, earlier
    while rung < differs:
        trial = attempt(shortener.prefix(rung))
        if trial.differs:
            differs, after = rung, trial
            break
        same, before = rung, trial
        rung *= 2
    while differs - same > 1:
        middle = (same + differs) // 2
        trial = attempt(shortener.prefix(middle))
        if trial.differs:
            differs, after = middle, trial
        else:
            same, before = middle, trial
    return differs - 1, after, before


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

    def first(self, whole: Trial) -> tuple[int, Trial, Trial | None]:
        """The first beam after which the maps differ; the trials after it and before it."""
        same, before = 0, None
        differs, after = self.shortener.beams_in(self.scan), whole
        while differs - same > 1:
            middle = (same + differs) // 2
            trial = self.attempt(middle)
            if trial.differs:
                differs, after = middle, trial
            else:
                same, before = middle, trial
        return differs - 1, after, before
