"""A whole check: level after level until one fails, then where and why."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.check import wording
from occgrid_parity.check.levels import (
    EVIDENCE,
    FILE,
    LEVELS,
    ORIENTATION,
    ORIENTED,
    RUNS,
    SEEDS,
    LevelPlan,
)
from occgrid_parity.check.verdict import (
    SCHEMA,
    CaseResult,
    Level,
    LevelStatus,
    Overall,
    Verdict,
)
from occgrid_parity.explain.cause import Evidence, find_cause
from occgrid_parity.explain.closeness import Compared, compare_with_reference
from occgrid_parity.explain.findings import Cause, FirstDifference
from occgrid_parity.explain.first_difference import find_first_difference
from occgrid_parity.explain.symmetry import orientation
from occgrid_parity.model.reference import reference_map
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.programs.runner import Outcome, Runner
from occgrid_parity.suite.cases import LESSON, Case, built_in, case
from occgrid_parity.suite.modes import Mode


@dataclass(frozen=True)
class Options:
    """What to check, and how much to explain.

    With ``cases`` only these scenarios are mapped, in ``modes`` (default: the program's plain one). ``save`` is the
    folder for the minimal scenario of the first difference. ``on_map`` is told of every map that is compared.
    """

    cases: Sequence[Case] = ()
    modes: Sequence[Mode] = ()
    explain: bool = True
    save: Path | None = None
    on_map: Callable[[ComparedMap], None] | None = None


class LevelFailed(Exception):
    """A level that ends the check."""

    def __init__(
        self, word: str, message: str, cases: Sequence[CaseResult] = ()
    ) -> None:
        super().__init__(message)
        self.word = word
        self.message = message
        self.cases = list(cases)


@dataclass(frozen=True)
class ComparedMap:
    """A map and how it compares."""

    case: Case
    mode: Mode
    observed: Observed
    compared: Compared
    seconds: float

    @property
    def result(self) -> CaseResult:
        return wording.case_result(
            self.case.name, self.mode.name, self.compared, self.seconds
        )


def check(runner: Runner, options: Options | None = None) -> Verdict:
    """Checks a program. Raises occgrid_parity.processes.process_group.Stopped when the runner is asked to stop."""
    return _Check(runner, options or Options()).verdict()


class _Check:
    """One check; ``judged`` keeps every map, so that no scenario is run twice."""

    def __init__(self, runner: Runner, options: Options) -> None:
        self.runner = runner
        self.options = options
        self.levels: list[Level] = []
        self.judged: dict[tuple[str, Mode], ComparedMap] = {}
        self.outcomes: dict[tuple[str, Mode], Outcome] = {}
        self.notes: dict[str, None] = {}
        self.runs = 0
        self.seconds = 0.0
        self.failed: ComparedMap | None = None
        self.short: Evidence | None = None
        self.misread = False

    # --- running ---

    def run(self, one: Case, mode: Mode) -> Outcome:
        """The program's map of a scenario; not run again where it was before."""
        key = (one.digest, mode)
        if key not in self.outcomes:
            self.runs += 1
            outcome = self.runner.run(one, mode)
            self.seconds += outcome.seconds
            for note in outcome.notes:
                self.notes[note] = None
            self.outcomes[key] = outcome
        return self.outcomes[key]

    def judge(self, one: Case, mode: Mode) -> ComparedMap:
        """Runs and compares. Raises LevelFailed where there is no map of the right size."""
        key = (one.digest, mode)
        if key in self.judged:
            return self.judged[key]
        outcome = self.run(one, mode)
        if outcome.observed is None:
            raise LevelFailed(outcome.word, f"{one.name}: {outcome.message}")
        observed = outcome.observed
        expected = reference_map(one, mode).pixels.shape
        if observed.pixels.shape != expected:
            raise LevelFailed(
                "wrong size",
                f"{one.name}: {observed.source} is {wording.size(observed.pixels.shape)} pixels, expected "
                f"{wording.size(expected)}",
            )
        compared = compare_with_reference(
            observed, one, mode, own_poses=not one.is_file
        )
        judged = ComparedMap(one, mode, observed, compared, outcome.seconds)
        self.judged[key] = judged
        if self.options.on_map is not None:
            self.options.on_map(judged)
        return judged

    # --- levels ---

    def level(
        self, name: str, title: str, status: LevelStatus, **more: object
    ) -> None:
        self.levels.append(Level(name, title, status, **more))  # type: ignore[arg-type]

    def plans(self) -> list[tuple[LevelPlan, list[tuple[Case, Mode]]]]:
        """The levels of this program, with their runs; none where a level cannot be checked."""
        plain = self.runner.plain_mode
        if self.options.cases:
            modes = self.options.modes or (plain,)
            return [
                (
                    LevelPlan(one.name, one.name, (one.name,)),
                    [(one, mode) for mode in modes],
                )
                for one in self.options.cases
            ]
        plans = []
        for plan in LEVELS:
            modes = SEEDS if plan.noisy else (plain,)
            names = plan.scenarios
            if not self.runner.reads_scenarios:
                names = tuple(name for name in names if name == LESSON)
            if plan.noisy and not self.runner.takes_seeds:
                names = ()
            runs = [
                (self.case(name), mode) for name in names for mode in modes
            ]
            plans.append((plan, runs))
        return plans

    def case(self, name: str) -> Case:
        return case(name) if self.runner.reads_scenarios else built_in()

    def check_levels(self) -> None:
        """Raises LevelFailed at the first level that fails, its own record being made."""
        plans = self.plans()
        first_case, first_mode = next(runs[0] for _, runs in plans if runs)
        self.check_first(first_case, first_mode)
        self.check_orientation(first_case, first_mode)
        for plan, runs in plans:
            self.check_level(plan, runs)

    def check_first(self, one: Case, mode: Mode) -> None:
        """It runs, and its file is a picture of the right size."""
        outcome = self.run(one, mode)
        if not outcome.ran:
            self.fail(
                *RUNS,
                LevelFailed(outcome.word, f"{one.name}: {outcome.message}"),
            )
        self.level(*RUNS, "passed")
        try:
            self.judge(one, mode)
        except LevelFailed as failed:
            if outcome.observed is not None:
                names = orientation(outcome.observed, one, mode)
                if names:
                    self.misread = True
                    self.level(*FILE, "passed")
                    self.fail_orientation(names, one)
            self.fail(
                *FILE,
                LevelFailed(
                    failed.word,
                    f"your file is wrong, not your mapping: {failed.message}",
                ),
            )
        self.level(*FILE, "passed")

    def check_orientation(self, one: Case, mode: Mode) -> None:
        """The map is not the reference's turned, flipped or transposed."""
        cases = [one]
        if self.runner.reads_scenarios and not self.options.cases:
            cases = [self.case(name) for name in ORIENTED]
        open_question = False
        for oriented in cases:
            try:
                judged = self.judge(oriented, mode)
            except LevelFailed as failed:
                self.fail(*ORIENTATION, failed)
            if judged.compared.status != "differs":
                continue
            names = orientation(judged.observed, oriented, mode)
            if names:
                self.failed = judged
                self.fail_orientation(names, oriented)
            open_question = True
        if open_question:
            message = "the map is none of the eight symmetries of the reference: it differs otherwise"
            self.level(*ORIENTATION, "not checked", message=message)
        else:
            self.level(*ORIENTATION, "passed")

    def fail_orientation(self, names: Sequence[str], one: Case) -> None:
        message = f"your map of {one.name} is {' and '.join(names)}"
        self.fail(*ORIENTATION, LevelFailed("orientation", message))

    def check_level(
        self, plan: LevelPlan, runs: Sequence[tuple[Case, Mode]]
    ) -> None:
        """One level: every map must be the reference's, or differ only by rounding."""
        if not runs:
            self.level(plan.name, plan.title, "not checked")
            return
        results: list[CaseResult] = []
        worst: LevelStatus = "identical"
        said: list[str] = []
        for one, mode in runs:
            try:
                judged = self.judge(one, mode)
            except LevelFailed as failed:
                failed.cases = results
                self.fail(plan.name, plan.title, failed)
            results.append(judged.result)
            status = judged.compared.status
            title = f"{one.name}, {mode.name}"
            if status == "differs":
                self.failed = judged
                message = f"{title}: {judged.result.message}"
                self.fail(
                    plan.name,
                    plan.title,
                    LevelFailed("differs", message, results),
                )
            if judged.result.message != "identical":
                said.append(f"{title}: {judged.result.message}")
            if status == "edges" or (
                status == "halves" and worst == "identical"
            ):
                worst = status
        self.level(
            plan.name,
            plan.title,
            worst,
            message="; ".join(said),
            cases=results,
        )

    def fail(self, name: str, title: str, failed: LevelFailed) -> None:
        """Records the level that ends the check, and ends it."""
        self.level(
            name,
            title,
            "failed",
            word=failed.word,
            message=failed.message,
            cases=failed.cases,
        )
        raise failed

    # --- the verdict ---

    def verdict(self) -> Verdict:
        """Levels, then the explanation of what differs."""
        started = time.monotonic()
        cause: Cause | None = None
        difference: FirstDifference | None = None
        try:
            self.check_levels()
        except LevelFailed as failed:
            drew_a_map = self.failed is not None or self.misread
            overall: Overall = "differs" if drew_a_map else "failed"
            summary = f"{failed.word}: {failed.message}"
            if drew_a_map and self.options.explain:
                difference = self.difference(strict=False)
                cause = self.cause()
                if not (cause.candidates or self.can_be_quiet()):
                    self.notes[wording.OWN_NOISE] = None
        else:
            overall, summary = self.success()
            rounded = [j for j in self.judged.values() if j.compared.halves]
            if overall != "identical" and self.options.explain:
                found = find_cause(self.evidence())
                if found.arithmetic and not found.candidates:
                    self.notes[found.message] = None
                elif found.candidates and rounded:
                    cause, overall = found, "differs"
                    self.failed = min(
                        rounded, key=lambda j: j.observed.pixels.size
                    )
                    summary = (
                        "grey values halfway between two levels differ, and they are exactly those of a mistake: "
                        f"{found.candidates[0].title}"
                    )
                    difference = self.difference(strict=True)
        self.add_missing_levels()
        return Verdict(
            schema=SCHEMA,
            program=self.runner.name,
            command=self.runner.words,
            overall=overall,
            summary=summary,
            compared=self.compared(),
            seconds=round(time.monotonic() - started, 3),
            runs=self.runs,
            levels=self.levels,
            first_difference=difference,
            cause=cause,
            not_checked=self.not_checked(),
            notes=list(self.notes),
        )

    def success(self) -> tuple[Overall, str]:
        """Overall and summary where no level has failed."""
        levels = {level.name: level for level in self.levels}
        edges = [
            x.title
            for x in self.levels
            if x.status == "edges" and x.name != "twin"
        ]
        halves = sum(j.compared.halves for j in self.judged.values())
        greys = wording.plural(halves, "grey value")
        but = (
            f" (but for {greys} halfway between two levels, over all maps)"
            if halves
            else ""
        )
        if all(x.status != "edges" for x in self.levels):
            return ("edges" if halves else "identical"), f"identical{but}"
        where = f"on {_list(edges)} it differs only at cell edges"
        twin = levels.get("twin")
        if twin is None or twin.status == "not checked":
            return "edges", f"{where}{but}"
        told = "identical on the well-conditioned scenario"
        if twin.status == "edges":
            told = "identical on the well-conditioned scenario except for beams that pass the end of a wall"
        return "edges", "; ".join([told, *([where] if edges else [])]) + but

    def evidence(self) -> list[Evidence]:
        return [
            Evidence(j.case, j.mode, j.observed, j.compared.status)
            for j in self.judged.values()
        ] + self.misread_evidence()

    def misread_evidence(self) -> list[Evidence]:
        """Maps of another size: they say something of a mistake, too."""
        cases = (
            {one.digest: one for one in map(self.case, EVIDENCE)}
            if self.misread
            else {}
        )
        return [
            Evidence(cases[digest], mode, outcome.observed, "differs")
            for (digest, mode), outcome in self.outcomes.items()
            if outcome.observed is not None
            and (digest, mode) not in self.judged
            and digest in cases
        ]

    def cause(self) -> Cause:
        """More scenarios are mapped, to tell the mistakes apart."""
        if self.runner.reads_scenarios and not self.options.cases:
            for name in EVIDENCE:
                try:
                    self.judge(self.case(name), self.runner.plain_mode)
                except LevelFailed:
                    continue
        return find_cause(self.evidence(), self.short)

    def difference(self, strict: bool) -> FirstDifference | None:
        """Where the map that failed first differs."""
        if self.failed is None:
            return None
        mode = self.failed.mode
        explained = find_first_difference(
            self.runner,
            self.failed.case,
            mode,
            self.failed.observed,
            strict,
            self.options.save,
        )
        self.runs += explained.runs
        if explained.short is not None:
            case, observed, compared, _ = explained.short
            self.short = Evidence(case, mode, observed, compared.status)
        return explained.difference

    def can_be_quiet(self) -> bool:
        """Whether the program can be asked for a map without noise, or for the contract's noise."""
        return self.runner.reads_scenarios or self.runner.takes_seeds

    def add_missing_levels(self) -> None:
        """The levels that were not reached."""
        known = {level.name for level in self.levels}
        titles = [RUNS, FILE, ORIENTATION]
        titles += [(plan.name, plan.title) for plan, _ in self.plans()]
        for name, title in titles:
            if name not in known:
                self.level(name, title, "not reached")

    def compared(self) -> str:
        """What was compared, in words."""
        observed = [o.observed for o in self.outcomes.values() if o.observed]
        if not observed:
            return "nothing"
        with_log_odds = [o for o in observed if o.log_odds is not None]
        if len(with_log_odds) == len(observed):
            return "pixels, and every bit of the log-odds"
        if with_log_odds:
            return f"pixels; log-odds in {len(with_log_odds)} of {len(observed)} maps"
        return "pixels only"

    def not_checked(self) -> list[str]:
        """What this program could not be asked."""
        said = []
        if not self.runner.reads_scenarios:
            said += [wording.LESSON_ONLY, wording.NO_TWIN]
        if not self.runner.takes_seeds:
            said.append(wording.NO_SEED)
        if self.compared() == "pixels only":
            said.append(wording.PIXELS_ONLY)
        return said


def _list(words: Sequence[str]) -> str:
    """``a``, ``a and b``, ``a, b and c``."""
    if len(words) < 2:
        return "".join(words)
    return ", ".join(words[:-1]) + " and " + words[-1]


def broken(runner: Runner, word: str, message: str) -> Verdict:
    """The verdict on a program that could not even be run."""
    level = Level(*RUNS, "failed", word=word, message=message)
    verdict = Verdict(
        SCHEMA,
        runner.name,
        runner.words,
        "failed",
        f"{word}: {message}",
        "nothing",
        0.0,
        0,
        [level],
    )
    return replace(verdict)
