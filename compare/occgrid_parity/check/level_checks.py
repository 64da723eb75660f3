"""Grades the levels of a check, each apart from the others."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence

from occgrid_parity.check.bad_input import check_bad_input
from occgrid_parity.check.check_options import Options
from occgrid_parity.check.function_levels import check_function
from occgrid_parity.check.grey import grey_or_unasked
from occgrid_parity.check.levels import (
    ADDED,
    BAD_INPUT,
    FILE,
    FIRST_LOOK,
    ORIENTATION,
    RUNS,
    LevelRuns,
    case_for,
    chosen_runs,
    level_runs,
)
from occgrid_parity.check.own_numbers import (
    check_added,
    check_log_odds,
    check_rounding,
)
from occgrid_parity.check.program_maps import ComparedMap, NoMap, ProgramMaps
from occgrid_parity.check.verdict import CaseResult, Level, LevelStatus
from occgrid_parity.check.yaml_level import check_yaml
from occgrid_parity.explain.other_lessons import other_lesson
from occgrid_parity.explain.symmetry import (
    SYMMETRIES,
    is_upright,
    orientation,
)
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

NO_START = ("not found", "not executable")
COSTLY = ("hang", "forks", "too much memory", "too much output")
MOST_COSTLY = 2  # such runs, then no more maps are asked for


class LevelChecks:
    """The levels of one check.

    ``levels`` is their record, ``differing`` the first map that differs, and ``failed_run`` the first scenario of which
    there is no map. ``other_lesson`` says which lesson a program draws in place of the right one, if that is known.
    ``misread`` says that maps have another size than the scenario's because they are turned or transposed.
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
        self.failed_run: tuple[Case, Mode] | None = None
        self.misread = False
        self.other_lesson = ""
        self.costly = 0
        self.cannot_start = False
        self.no_picture = False

    def check_all(self) -> None:
        """Every level that the program can be asked."""
        case, mode = next(plan.runs[0] for plan in self.plans if plan.runs)
        self._check_first(case, mode)
        first = [case]
        if self.runner.reads_scenarios and not self.only_chosen:
            first = [case_for(self.runner, name) for name in FIRST_LOOK]
        self._check_orientation(first, mode)
        self._check_own_numbers(first, mode)
        for plan in self.plans:
            self._add_level(plan)
        if self.only_chosen:
            return
        self.levels.append(check_yaml(self.maps.compared.values()))
        self._add_bad_input()
        for function in self.runner.functions:
            self.levels.append(check_function(self.runner, function))

    def _is_other_lesson(self, found: ComparedMap) -> bool:
        """Whether a program that has the lesson built in draws another lesson, exactly; then its map is upright."""
        if found.case.is_file:
            return False
        self.other_lesson = other_lesson(found.observed, found.mode)
        return bool(self.other_lesson)

    def _compare(self, case: Case, mode: Mode) -> ComparedMap:
        """The program's map. Raises NoMap, also where asking once more makes no sense."""
        if self.cannot_start or self.costly >= MOST_COSTLY:
            raise NoMap("", "not run: see above")
        try:
            return self.maps.compare(case, mode)
        except NoMap as failed:
            self.costly += failed.word in COSTLY
            self.cannot_start |= failed.word in NO_START
            if self.failed_run is None and failed.word:
                self.failed_run = case, mode
            raise

    def _check_first(self, case: Case, mode: Mode) -> None:
        """It runs, and its file is a picture of the right size."""
        try:
            self._compare(case, mode)
        except NoMap as failed:
            outcome = self.maps.run(case, mode)
            if not outcome.ran:
                self.no_picture = True
                self._add(RUNS, "failed", failed.word, failed.message)
                self._add(FILE, "grey", "", "there is no file to look at")
                return
            self._add(RUNS, "passed")
            if self._is_turned(case, mode):
                self.misread = True
                self._add(FILE, "passed")
                return
            self.no_picture = True
            message = f"your file is wrong, which says nothing about your mapping: {failed.message}"
            self._add(FILE, "failed", failed.word, message)
            return
        self._add(RUNS, "passed")
        self._add(FILE, "passed")

    def _is_turned(self, case: Case, mode: Mode) -> bool:
        """Whether a map of a wrong size is the reference's, turned or transposed."""
        observed = self.maps.run(case, mode).observed
        return observed is not None and bool(orientation(observed, case, mode))

    def _check_orientation(self, cases: Sequence[Case], mode: Mode) -> None:
        """The map is not the reference's turned, flipped or transposed.

        Where it is, the other levels look at the map turned back, so that this costs one level only.
        """
        upright: bool | None = None  # as the last of the cases tells
        for case in cases:
            try:
                found: ComparedMap | None = self._compare(case, mode)
            except NoMap:
                found = None
            observed = self.maps.outcomes.get((case.digest, mode))
            if observed is None or observed.observed is None:
                continue
            if found is not None and found.compared.status != "differs":
                upright = True
                continue
            names = orientation(observed.observed, case, mode)
            if names:
                self._fail_orientation(names, case, found)
                return
            if found is not None:
                upright = self._is_other_lesson(found) or is_upright(
                    observed.observed, case, mode
                )
        if upright:
            self._add(ORIENTATION, "passed")
        elif upright is None:
            self._add(ORIENTATION, "grey", "", "there is no map to look at")
        else:
            message = "your map is too far from the reference to tell which way up it is"
            self._add(ORIENTATION, "grey", "", message)

    def _fail_orientation(
        self, names: Sequence[str], case: Case, found: ComparedMap | None
    ) -> None:
        message = f"your map of {case.name} is {' and '.join(names)}"
        self.differing = self.differing or found
        if len(names) == 1:
            self.maps.turn_back(SYMMETRIES[names[0]])
            message += "; the other levels look at your maps turned back"
        self._add(ORIENTATION, "failed", "orientation", message)

    def _check_own_numbers(self, cases: Sequence[Case], mode: Mode) -> None:
        """The program's probabilities, how it rounds grey values, and how it writes its log-odds."""
        for check in (check_added, check_rounding, check_log_odds):
            first: list[ComparedMap] = []
            for case in cases:
                with contextlib.suppress(NoMap):
                    first.append(self._compare(case, mode))
            if check is check_added and self.other_lesson:
                level = Level(*ADDED, "passed")  # it draws that lesson exactly
            else:
                level = check(self.maps, first)
            self.levels.append(level)
            differing = [x for x in first if x.compared.status == "differs"]
            if level.status == "failed" and differing:
                self.differing = self.differing or differing[0]

    def _add_level(self, plan: LevelRuns) -> None:
        """One level: every map must be the reference's, or differ only by rounding."""
        if not plan.runs:
            self.levels.append(Level(plan.name, plan.title, "not checked"))
            return
        name = (plan.name, plan.title)
        results: list[CaseResult] = []
        worst: LevelStatus = "identical"
        said: list[str] = []
        wrong: list[str] = []
        for case, mode in plan.runs:
            try:
                found = self._compare(case, mode)
            except NoMap as failed:
                grey = self.no_picture or not failed.word
                status: LevelStatus = "grey" if grey else "failed"
                if wrong:
                    continue
                self._add(name, status, failed.word, failed.message, results)
                return
            results.append(found.result)
            closeness = found.compared.status
            message = f"{case.name}, {mode.name}: {found.result.message}"
            if closeness == "differs":
                self.differing = self.differing or found
                wrong.append(message)
                continue
            if found.result.message != "identical":
                said.append(message)
            if closeness == "edges" or (
                closeness == "halves" and worst == "identical"
            ):
                worst = closeness
        if wrong:
            self._add(name, "failed", "differs", "; ".join(wrong), results)
        else:
            self._add(name, worst, "", "; ".join(said), results)

    def _add_bad_input(self) -> None:
        if not self.runner.reads_scenarios or self.no_picture or self.costly:
            why = "the program draws no map of a right scenario, so a refusal says nothing"
            self.levels.append(
                grey_or_unasked(self.runner, *BAD_INPUT, why=why)
            )
            return
        level, runs = check_bad_input(self.runner)
        self.maps.runs += runs
        self.levels.append(level)

    def _add(
        self,
        name: tuple[str, str],
        status: LevelStatus,
        word: str = "",
        message: str = "",
        cases: Sequence[CaseResult] = (),
    ) -> None:
        """Records a level."""
        self.levels.append(
            Level(*name, status, word, message=message, cases=list(cases))
        )
