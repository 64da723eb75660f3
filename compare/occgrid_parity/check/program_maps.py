"""The maps of the program that is checked: each is drawn once, and compared once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from occgrid_parity.check import wording
from occgrid_parity.check.verdict import CaseResult
from occgrid_parity.explain.closeness import Compared, compare_with_reference
from occgrid_parity.explain.single_updates import with_parameters
from occgrid_parity.model.reference import reference_map
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.programs.runner import Outcome, Runner
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

Turn = Callable[[Any], Any]
"""Turns an array whose first row is the one with the largest y."""


@dataclass(frozen=True)
class ComparedMap:
    """A map and how it compares.

    ``observed`` is the map that was compared, turned back where the program's maps are turned; ``drawn`` is the map as
    the program drew it. ``own`` are the program's own parameters, with which it is the reference's map.
    """

    case: Case
    mode: Mode
    observed: Observed
    compared: Compared
    seconds: float
    drawn: Observed
    own: Mapping[str, float] = field(default_factory=dict)

    @property
    def result(self) -> CaseResult:
        """The record of the comparison."""
        result = wording.case_result(
            self.case.name, self.mode.name, self.compared, self.seconds
        )
        if not self.own:
            return result
        own = wording.parameters(self.own)
        return replace(result, message=f"{result.message}, with {own}")


class PartialMap(NamedTuple):
    """A map that the program drew of the first scans of a scenario, on the way to the first difference."""

    case: Case
    mode: Mode
    scans: int
    observed: Observed


class NoMap(Exception):
    """There is no map to compare: in a word or two, and at length."""

    def __init__(self, word: str, message: str) -> None:
        super().__init__(message)
        self.word = word
        self.message = message


def turned(observed: Observed, back: Turn) -> Observed:
    """A map with its picture and its log-odds turned."""
    pixels = np.ascontiguousarray(back(observed.pixels))
    if observed.log_odds is None:
        return replace(observed, pixels=pixels)
    log_odds = back(observed.log_odds[::-1])[::-1]
    return replace(
        observed, pixels=pixels, log_odds=np.ascontiguousarray(log_odds)
    )


class ProgramMaps:
    """Draws maps with a program and keeps them, so that no scenario is run twice.

    ``outcomes`` are all runs, ``compared`` the maps that could be compared, ``notes`` what the runs had to say
    beside, and ``runs`` how many there were.
    """

    def __init__(self, runner: Runner) -> None:
        self.runner = runner
        self.outcomes: dict[tuple[str, Mode], Outcome] = {}
        self.compared: dict[tuple[str, Mode], ComparedMap] = {}
        self.notes: list[str] = []
        self.runs = 0
        self.back: Turn | None = None
        self.own: dict[str, float] = {}
        self.only_pixels = False

    def run(self, case: Case, mode: Mode) -> Outcome:
        """The program's map of a scenario, or what went wrong."""
        key = (case.digest, mode)
        if key not in self.outcomes:
            self.runs += 1
            self.outcomes[key] = self.runner.run(case, mode)
            for note in self.outcomes[key].notes:
                self.note(note)
        return self.outcomes[key]

    def note(self, text: str) -> None:
        """Adds a note, if it is not there yet."""
        if text not in self.notes:
            self.notes.append(text)

    def compare(self, case: Case, mode: Mode) -> ComparedMap:
        """Runs and compares. Raises NoMap where there is no map of the right size."""
        key = (case.digest, mode)
        if key not in self.compared:
            self.compared[key] = self._compare(case, mode)
        return self.compared[key]

    def turn_back(self, back: Turn) -> None:
        """From now on, maps are turned with ``back`` before they are compared."""
        self.back = back
        self.compared.clear()

    def take_own_parameters(self, values: dict[str, float]) -> None:
        """From now on, a map may also be that of the scenario with these values of its parameters."""
        self.own = values
        self.compared.clear()

    def leave_log_odds_out(self) -> None:
        """From now on, only pictures are compared."""
        self.only_pixels = True
        self.compared.clear()

    def _compare(self, case: Case, mode: Mode) -> ComparedMap:
        outcome = self.run(case, mode)
        if outcome.observed is None:
            raise NoMap(outcome.word, f"{case.name}: {outcome.message}")
        drawn = outcome.observed
        observed = drawn if self.back is None else turned(drawn, self.back)
        expected = reference_map(case, mode).pixels.shape
        if observed.pixels.shape != expected:
            raise NoMap(
                "wrong size",
                f"{case.name}: {observed.source} is {wording.size(observed.pixels.shape)} pixels, expected "
                f"{wording.size(expected)}",
            )
        if self.only_pixels:
            observed = replace(observed, log_odds=None)
        compared = self._closeness(observed, case, mode)
        own: dict[str, float] = {}
        if self.own and compared.status == "differs":
            other = with_parameters(case, self.own)
            again = self._closeness(observed, other, mode)
            if again.status != "differs":
                compared, own = again, self.own
        if (
            self.back is not None
            and observed.log_odds is not None
            and drawn.log_odds is not None
        ):
            # the picture is turned; the log-odds may be upright, or written column by column
            for log_odds in (drawn.log_odds, drawn.log_odds.T):
                fits = log_odds.shape == observed.pixels.shape
                if compared.status != "differs" or not fits:
                    continue
                other_way = replace(
                    observed, log_odds=np.ascontiguousarray(log_odds)
                )
                again = self._closeness(other_way, case, mode)
                if again.status != "differs":
                    observed, compared = other_way, again
        return ComparedMap(
            case, mode, observed, compared, outcome.seconds, drawn, own
        )

    def _closeness(
        self, observed: Observed, case: Case, mode: Mode
    ) -> Compared:
        return compare_with_reference(
            observed, case, mode, own_poses=not case.is_file
        )

    def what_was_compared(self) -> str:
        """Pixels or log-odds, in words."""
        if self.only_pixels:
            return (
                "pixels; how the log-odds are written has a level of its own"
            )
        observed = [o.observed for o in self.outcomes.values() if o.observed]
        if not observed:
            return "nothing"
        with_log_odds = [o for o in observed if o.log_odds is not None]
        if len(with_log_odds) == len(observed):
            return "pixels, and every bit of the log-odds"
        if with_log_odds:
            return f"pixels; log-odds in {len(with_log_odds)} of {len(observed)} maps"
        return wording.ONLY_PIXELS
