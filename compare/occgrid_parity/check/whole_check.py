"""A whole check: level after level until one fails, then where and why."""

from __future__ import annotations

import time
from typing import NamedTuple

from occgrid_parity.check import wording
from occgrid_parity.check.check_options import Options
from occgrid_parity.check.explanation import Explanation
from occgrid_parity.check.level_checks import LevelChecks, LevelFailed
from occgrid_parity.check.program_maps import ProgramMaps
from occgrid_parity.check.summary import not_checked, success
from occgrid_parity.check.verdict import SCHEMA, Overall, Verdict
from occgrid_parity.explain.findings import Cause, FirstDifference
from occgrid_parity.programs.runner import Runner


class Conclusion(NamedTuple):
    """What the levels and the explanation say together."""

    overall: Overall
    summary: str
    difference: FirstDifference | None = None
    cause: Cause | None = None


def check(runner: Runner, options: Options | None = None) -> Verdict:
    """Checks a program.

    Raises occgrid_parity.processes.process_group.Stopped when the runner is asked to stop.
    """
    options = options or Options()
    started = time.monotonic()
    maps = ProgramMaps(runner, options.on_map)
    checks = LevelChecks(maps, options)
    try:
        checks.check_all()
    except LevelFailed as failed:
        conclusion = _after_failure(str(failed), checks, options)
    else:
        conclusion = _after_success(checks, options)
    compared = maps.what_was_compared()
    return Verdict(
        schema=SCHEMA,
        program=runner.name,
        command=runner.words,
        overall=conclusion.overall,
        summary=conclusion.summary,
        compared=compared,
        seconds=round(time.monotonic() - started, 3),
        runs=maps.runs,
        levels=checks.levels,
        first_difference=conclusion.difference,
        cause=conclusion.cause,
        not_checked=not_checked(runner, compared),
        notes=maps.notes,
    )


def _after_failure(
    summary: str, checks: LevelChecks, options: Options
) -> Conclusion:
    """Explains the level that failed, if it was for a map."""
    maps, runner, differing = checks.maps, checks.runner, checks.differing
    if differing is None and not checks.misread:
        return Conclusion("failed", summary)
    if not options.explain:
        return Conclusion("differs", summary)
    explanation = Explanation(maps, options, checks.misread)
    difference = None
    if differing is not None:
        difference = explanation.first_difference(differing, strict=False)
    cause = explanation.cause()
    can_be_quiet = runner.reads_scenarios or runner.takes_seeds
    if not (cause.candidates or can_be_quiet):
        maps.note(wording.OWN_NOISE)
    return Conclusion("differs", summary, difference, cause)


def _after_success(checks: LevelChecks, options: Options) -> Conclusion:
    """All levels passed, yet a mistake can be what looks like rounding of grey values."""
    maps = checks.maps
    rounded = [one for one in maps.compared.values() if one.compared.halves]
    halves = sum(one.compared.halves for one in rounded)
    overall, summary = success(checks.levels, halves)
    if overall == "identical" or not options.explain:
        return Conclusion(overall, summary)
    explanation = Explanation(maps, options, misread=False)
    found = explanation.cause_of_known_maps()
    if found.arithmetic and not found.candidates:
        maps.note(found.message)
    if not (found.candidates and rounded):
        return Conclusion(overall, summary)
    smallest = min(rounded, key=lambda one: one.observed.pixels.size)
    return Conclusion(
        "differs",
        "grey values halfway between two levels differ, and they are exactly those of a mistake: "
        f"{found.candidates[0].title}",
        explanation.first_difference(smallest, strict=True),
        found,
    )
