"""Goes through the levels of a check, until one fails."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NoReturn

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.levels import (
    FILE,
    ORIENTATION,
    ORIENTED,
    RUNS,
    LevelRuns,
    case_for,
    chosen_runs,
    level_runs,
)
from occgrid_parity.check.program_maps import ComparedMap, NoMap, ProgramMaps
from occgrid_parity.check.verdict import CaseResult, Level, LevelStatus
from occgrid_parity.explain.symmetry import orientation
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode


class LevelFailed(Exception):
    """A level has failed, which ends the check; its text is the summary."""


class LevelChecks:
    """The levels of one check.

    ``levels`` is their record. ``differing`` is the map that made one fail, if it was a map; ``misread`` says that the
    map has another size than the scenario's because it is turned or transposed.
    """

    def __init__(self, maps: ProgramMaps, options: Options) -> None:
        self.maps = maps
        self.runner = maps.runner
        self.only_chosen = bool(options.cases)
        self.plans = (
            chosen_runs(self.runner, options.cases, options.modes)
            if self.only_chosen
            else level_runs(self.runner)
        )
        self.levels: list[Level] = []
        self.differing: ComparedMap | None = None
        self.misread = False

    def check_all(self) -> None:
        """Every level in turn. Raises LevelFailed at the first that fails; the others are not reached."""
        case, mode = next(plan.runs[0] for plan in self.plans if plan.runs)
        try:
            self._check_first(case, mode)
            self._check_orientation(case, mode)
            for plan in self.plans:
                self._check_level(plan)
        finally:
            self._add_missing_levels()

    def _check_first(self, case: Case, mode: Mode) -> None:
        """It runs, and its file is a picture of the right size."""
        outcome = self.maps.run(case, mode)
        if not outcome.ran:
            self._fail(*RUNS, outcome.word, f"{case.name}: {outcome.message}")
        self._add(*RUNS, "passed")
        try:
            self.maps.compare(case, mode)
        except NoMap as failed:
            if outcome.observed is not None:
                names = orientation(outcome.observed, case, mode)
                if names:
                    self.misread = True
                    self._add(*FILE, "passed")
                    self._fail_orientation(names, case)
            message = f"your file is wrong, not your mapping: {failed.message}"
            self._fail(*FILE, failed.word, message)
        self._add(*FILE, "passed")

    def _check_orientation(self, first: Case, mode: Mode) -> None:
        """The map is not the reference's turned, flipped or transposed."""
        cases = [first]
        if self.runner.reads_scenarios and not self.only_chosen:
            cases = [case_for(self.runner, name) for name in ORIENTED]
        open_question = False
        for case in cases:
            try:
                found = self.maps.compare(case, mode)
            except NoMap as failed:
                self._fail(*ORIENTATION, failed.word, failed.message)
            if found.compared.status != "differs":
                continue
            names = orientation(found.observed, case, mode)
            if names:
                self.differing = found
                self._fail_orientation(names, case)
            open_question = True
        if open_question:
            message = "the map is none of the eight symmetries of the reference: it differs otherwise"
            self._add(*ORIENTATION, "not checked", message)
        else:
            self._add(*ORIENTATION, "passed")

    def _fail_orientation(self, names: Sequence[str], case: Case) -> NoReturn:
        message = f"your map of {case.name} is {' and '.join(names)}"
        self._fail(*ORIENTATION, "orientation", message)

    def _check_level(self, plan: LevelRuns) -> None:
        """One level: every map must be the reference's, or differ only by rounding."""
        if not plan.runs:
            self._add(plan.name, plan.title, "not checked")
            return
        results: list[CaseResult] = []
        worst: LevelStatus = "identical"
        said: list[str] = []
        for case, mode in plan.runs:
            try:
                found = self.maps.compare(case, mode)
            except NoMap as failed:
                self._fail(
                    plan.name,
                    plan.title,
                    failed.word,
                    failed.message,
                    results,
                )
            results.append(found.result)
            status = found.compared.status
            message = f"{case.name}, {mode.name}: {found.result.message}"
            if status == "differs":
                self.differing = found
                self._fail(plan.name, plan.title, "differs", message, results)
            if found.result.message != "identical":
                said.append(message)
            if status == "edges" or (
                status == "halves" and worst == "identical"
            ):
                worst = status
        self._add(plan.name, plan.title, worst, "; ".join(said), results)

    def _add(
        self,
        name: str,
        title: str,
        status: LevelStatus,
        message: str = "",
        cases: Sequence[CaseResult] = (),
    ) -> None:
        """Records a level."""
        self.levels.append(
            Level(name, title, status, message=message, cases=list(cases))
        )

    def _fail(
        self,
        name: str,
        title: str,
        word: str,
        message: str,
        cases: Sequence[CaseResult] = (),
    ) -> NoReturn:
        """Records the level that ends the check, and ends it."""
        self.levels.append(
            Level(name, title, "failed", word, message, list(cases))
        )
        raise LevelFailed(f"{word}: {message}")

    def _add_missing_levels(self) -> None:
        """The levels that were not reached."""
        known = {level.name for level in self.levels}
        titles = [RUNS, FILE, ORIENTATION]
        titles += [(plan.name, plan.title) for plan in self.plans]
        for name, title in titles:
            if name not in known:
                self._add(name, title, "grey")
