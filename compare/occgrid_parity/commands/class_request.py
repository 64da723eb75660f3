"""What the options of ``occgrid-parity check --class`` and the class's own rules ask for together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.check.levels import FILE, LEVELS, ORIENTATION, RUNS
from occgrid_parity.commands.check_request import CheckRequest
from occgrid_parity.course.gradebook import Roster, read_roster
from occgrid_parity.course.rules import (
    NO_RULES,
    RULES,
    Rules,
    RulesError,
    read_rules,
)
from occgrid_parity.course.submission_task import SEEDED, Wanted
from occgrid_parity.model.worlds import world_of
from occgrid_parity.processes.cluster import Cluster
from occgrid_parity.processes.limits import MEBI, Limits
from occgrid_parity.processes.wall import Sandbox, find_wall
from occgrid_parity.suite.cases import Case, case_from

BUILD_SECONDS = 300.0


@dataclass(frozen=True)
class ClassRequest:
    """A class to check; ``rules_text`` says which file rules."""

    out: Path
    report: Path | None
    jobs: int
    wanted: Wanted
    rules_text: str
    roster: Roster | None = None
    cluster: Cluster | None = None


def class_request(
    folder: Path,
    request: CheckRequest,
    rules_file: Path | None,
    sandbox: Sandbox | None,
    build_timeout: float | None,
    roster: Path | None = None,
    scheduler: str | None = None,
) -> ClassRequest:
    """Puts options and rules together; an option goes before the same rule.

    Raises RulesError, RosterError, OSError or occgrid.scenario.ScenarioError where a file cannot be used,
    occgrid_parity.processes.wall.NoWall where a wall is required and does not work, and
    occgrid_parity.processes.cluster.NoCluster where there is none.
    """
    file = rules_file or folder / RULES
    is_there = rules_file is not None or file.exists()
    rules = read_rules(file) if is_there else NO_RULES
    own = _cases(file, rules.check.scenarios)
    hidden = _cases(file, rules.check.hidden)
    _check_names(file, rules, [*own, *hidden])
    given, limits = rules.limits, request.limits
    wanted = Wanted(
        rules=rules,
        limits=Limits(
            limits.seconds,
            given.output_mib * MEBI if given.output_mib else limits.output,
            given.memory_mib * MEBI if given.memory_mib else limits.memory,
            given.processes or limits.processes,
        ),
        build_seconds=build_timeout or given.build_seconds or BUILD_SECONDS,
        sandbox=sandbox or rules.sandbox or "auto",
        timeout=request.timeout or given.seconds,
        cases=request.cases,
        modes=request.modes,
        own=own,
        hidden=hidden,
        explain=request.explain and rules.check.explain,
        gradescope=_name(request.outputs.gradescope),
        junit=_name(request.outputs.junit),
    )
    wall = find_wall(wanted.sandbox)
    text = (
        f"rules: {file}"
        if is_there
        else f"rules: none ({file} is not there); each submission's port.toml says how it is built and run"
    )
    walled = (
        "wall: bubblewrap"
        if wall.works
        else f"wall: none around the programs ({wall.reason})"
    )
    return ClassRequest(
        request.outputs.folder,
        request.outputs.report,
        request.jobs,
        wanted,
        f"{text}\n{walled}",
        None if roster is None else read_roster(roster),
        None if scheduler is None else Cluster(scheduler),
    )


def _name(file: Path | None) -> str:
    """The name of a file that each submission gets, in its own folder."""
    return "" if file is None else file.name


def _cases(file: Path, names: Sequence[str]) -> list[Case]:
    found = [case_from(file.parent / name) for name in names]
    for case in found:
        world_of(case)
    return found


def _check_names(file: Path, rules: Rules, cases: list[Case]) -> None:
    """Raises RulesError where two levels have one name, or points are for a level that is not there."""
    names = [RUNS[0], FILE[0], ORIENTATION[0], SEEDED[0]]
    names += [plan.name for plan in LEVELS]
    for case in cases:
        if case.name in names:
            raise RulesError(
                f"{file}: check.scenarios, check.hidden: there is a level {case.name} already; rename the file"
            )
        names.append(case.name)
    for level in rules.points:
        if level not in names:
            raise RulesError(
                f"{file}: points.{level}: there is no such level ({', '.join(names)})"
            )
