"""A whole check: every level graded, then what is seen, where the maps first differ, and why."""

from __future__ import annotations

import time
from dataclasses import dataclass, field

from occgrid_parity.check import wording
from occgrid_parity.check.check_options import Options
from occgrid_parity.check.explanation import Explanation
from occgrid_parity.check.failed_run import keep_failed_run
from occgrid_parity.check.level_checks import LevelChecks
from occgrid_parity.check.levels import ADDED, LOG_ODDS, ROUNDING
from occgrid_parity.check.program_maps import ProgramMaps
from occgrid_parity.check.summary import failure, not_checked, success
from occgrid_parity.check.two_runs import unsteady
from occgrid_parity.check.verdict import SCHEMA, Overall, Verdict
from occgrid_parity.explain.cause import find_halves_cause
from occgrid_parity.explain.findings import Cause, FirstDifference
from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.explain.scan_choice import chosen_scans
from occgrid_parity.explain.seen import observations
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.runner import Runner
from occgrid_parity.suite.cases import LESSON


@dataclass(frozen=True)
class Conclusion:
    """What the levels and the explanation say together."""

    overall: Overall
    summary: str
    difference: FirstDifference | None = None
    cause: Cause | None = None
    seen: list[str] = field(default_factory=list)


def check(runner: Runner, options: Options | None = None) -> Verdict:
    """Checks a program.

    Raises occgrid_parity.processes.process_group.Stopped when the runner is asked to stop.
    """
    options = options or Options()
    started = time.monotonic()
    maps = ProgramMaps(runner)
    checks = LevelChecks(maps, options)
    checks.check_all()
    if options.on_map is not None:
        for one in maps.compared.values():
            options.on_map(one)
    wrong = any(level.counts and not level.good for level in checks.levels)
    if wrong:
        conclusion = _after_failure(checks, options)
    else:
        conclusion = _after_success(checks, options)
    if checks.failed_run is not None:
        keep_failed_run(maps, *checks.failed_run, options.save)
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
        not_checked=not_checked(runner, compared, checks.levels),
        notes=maps.notes,
        observations=conclusion.seen,
    )


def _evidence(maps: ProgramMaps) -> list[Evidence]:
    return [
        Evidence(one.case, one.mode, one.drawn, one.compared.status)
        for one in maps.compared.values()
    ]


def _after_failure(checks: LevelChecks, options: Options) -> Conclusion:
    """Explains the first map that differs, if there is one."""
    maps, differing = checks.maps, checks.differing
    summary = failure(checks.levels)
    lost = {x.name for x in checks.levels if x.counts and not x.good}
    if lost == {ROUNDING[0]}:
        return _after_wrong_rounding(checks, options, summary)
    if differing is None and not checks.misread:
        return Conclusion("failed", summary)
    if not options.explain:
        return Conclusion("differs", summary)
    if differing is not None:
        twice = unsteady(maps, differing.case, differing.mode, differing.drawn)
        if twice:
            _think_of_own_noise(maps)
            return Conclusion("differs", twice, seen=[twice])
    if checks.other_lesson:
        scans = [wording.maps_of_scans(checks.other_lesson, [LESSON])]
        summary = scans[0]
    else:
        scans = _scans_seen(maps)
    seen = observations(_evidence(maps), maps.runner.reads_scenarios) + scans
    explanation = Explanation(maps, options, checks.misread)
    difference = None
    if differing is not None:
        difference = explanation.first_difference(differing)
    told = scans and not maps.runner.reads_scenarios
    if told:  # that is the cause, and a map has one only
        return Conclusion("differs", summary, difference, seen=seen)
    cause: Cause | None = explanation.cause()
    assert cause is not None
    if not cause.candidates and not seen:
        _think_of_own_noise(maps)
    # scans that are missing, or these levels, say all that there is to say
    if not cause.candidates and (scans or lost <= {ADDED[0], LOG_ODDS[0]}):
        cause = None
    return Conclusion("differs", summary, difference, cause, seen)


def _think_of_own_noise(maps: ProgramMaps) -> None:
    """A program that cannot be asked for a map without noise may add noise of its own."""
    if not (maps.runner.reads_scenarios or maps.runner.takes_seeds):
        maps.note(wording.OWN_NOISE)


def _scans_seen(maps: ProgramMaps) -> list[str]:
    """Whether the maps with the most scans among those that differ show only some of them.

    A seed's noise goes by the number of the scan, so maps with noise are looked at only where there are no others.
    """
    wrong = [
        one
        for one in maps.compared.values()
        if one.compared.status == "differs"
        and len(world_of(one.case).scans) > 2
    ]
    looked = [one for one in wrong if one.mode.seed is None] or wrong
    said: dict[str, list[str]] = {}
    # one map alone can be that of fewer scans by chance
    for one in [*looked[:3], *looked[3:][-1:]]:
        compared = one.compared
        # where each cell alone could be rounding, a single scan has been looked for
        words = compared.left_out or chosen_scans(
            one.observed, one.case, one.mode, one_missing=compared.together
        )
        if not words:
            return []
        said.setdefault(words, []).append(one.case.name)
    return [wording.maps_of_scans(*entry) for entry in said.items()]


def _after_wrong_rounding(
    checks: LevelChecks, options: Options, summary: str
) -> Conclusion:
    """The maps are right but for grey values halfway between two levels, and no last bit explains these."""
    if not options.explain:
        return Conclusion("differs", summary)
    evidence = _evidence(checks.maps)
    seen = observations(evidence, checks.runner.reads_scenarios)
    found = find_halves_cause(evidence)
    cause = found if found.candidates else None
    return Conclusion("differs", summary, cause=cause, seen=seen)


def _after_success(checks: LevelChecks, options: Options) -> Conclusion:
    """All levels passed, yet a mistake in rounding can look like last bits: it is told, and costs nothing."""
    maps = checks.maps
    seen = observations(_evidence(maps), maps.runner.reads_scenarios)
    rounded = [one for one in maps.compared.values() if one.compared.halves]
    halves = sum(one.compared.halves for one in rounded)
    overall, summary = success(checks.levels, halves)
    if rounded and options.explain:
        found = find_halves_cause(_evidence(maps))
        seen += [wording.like_rounding(one) for one in found.candidates]
    return Conclusion(overall, summary, seen=seen)
