"""The levels of a check: each looks at one thing and is graded apart from the others.

They are in order, so that the first that fails is the clearest to tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from occgrid_parity.programs.runner import Runner
from occgrid_parity.suite.cases import LESSON, TWIN, Case, built_in, case
from occgrid_parity.suite.modes import Mode

SEEDS = (Mode(0), Mode(1))


@dataclass(frozen=True)
class LevelPlan:
    """Scenarios that are mapped without noise, or with that of SEEDS where the level is about noise.

    ``explains``: where a level has failed, they are mapped for the search of the cause; so they are quick to map.
    """

    name: str
    title: str
    scenarios: tuple[str, ...]
    noisy: bool = False
    explains: bool = True


RUNS = ("runs", "it runs")
FILE = ("file", "its file is a picture of the right size")
YAML = ("yaml", "the YAML beside the map")
BAD_INPUT = ("bad-input", "scenarios that break a rule")
ORIENTATION = ("orientation", "orientation (the eight symmetries)")
ADDED = ("added", "how much a hit and a crossing add (p_occ, p_free)")
ROUNDING = ("rounding", "how grey values are rounded")
LOG_ODDS = ("log-odds", "how the log-odds file writes its numbers")
FIRST_LOOK = ("one-beam", "asymmetric")
"""What tells orientation, probabilities, rounding and the form of the log-odds, before any other level."""

LEVELS = (
    LevelPlan("one-beam", "one beam", ("one-beam",)),
    LevelPlan("octants", "lines in all octants", ("octants",)),
    LevelPlan(
        "no-return",
        "beams without return",
        ("no-return-free", "no-return-ignore"),
    ),
    LevelPlan("clamping", "clamping", ("saturate", "clamp-order")),
    LevelPlan("prior", "a prior that is not one half", ("prior",)),
    LevelPlan("outside", "outside the grid", ("outside",)),
    LevelPlan(
        "simulated", "simulated scans", ("asymmetric", "slanting", "tips")
    ),
    LevelPlan("recorded", "recorded scans", ("flaser", "robotlaser1")),
    LevelPlan(
        "mixed",
        "simulated and recorded scans together",
        ("mixed", "min-range"),
    ),
    LevelPlan("powers", "odds that are powers of 2", ("powers",)),
    LevelPlan(
        "formats",
        "all that the file format allows",
        ("formats", "wall-ends"),
        explains=False,
    ),
    LevelPlan("twin", "the well-conditioned lesson", (TWIN,), explains=False),
    LevelPlan("lesson", "the lesson", (LESSON,), explains=False),
    LevelPlan(
        "noise",
        "seeded noise",
        ("asymmetric", "noise-half", "noise-clamp", TWIN, LESSON),
        noisy=True,
    ),
    LevelPlan(
        "mixed-noise", "noise on simulated scans only", ("mixed",), noisy=True
    ),
)

EVIDENCE = tuple(
    dict.fromkeys(
        name
        for plan in LEVELS
        if plan.explains and not plan.noisy
        for name in plan.scenarios
    )
)
"""For the search of the cause: together they tell the mistakes apart."""


class LevelRuns(NamedTuple):
    """A level of one program, with the scenarios and modes to map; none where it cannot be checked."""

    name: str
    title: str
    runs: list[tuple[Case, Mode]]


def case_for(runner: Runner, name: str) -> Case:
    """A scenario of the suite; the lesson as it is built in for a program that has only that."""
    return case(name) if runner.reads_scenarios else built_in()


def level_runs(runner: Runner) -> list[LevelRuns]:
    """The levels of a program."""
    levels = []
    for plan in LEVELS:
        modes = SEEDS if plan.noisy else (runner.plain_mode,)
        names = plan.scenarios
        if not runner.reads_scenarios:
            names = tuple(name for name in names if name == LESSON)
        if plan.noisy and not runner.takes_seeds:
            names = ()
        runs = [
            (case_for(runner, name), mode) for name in names for mode in modes
        ]
        levels.append(LevelRuns(plan.name, plan.title, runs))
    return levels


def titles(runner: Runner) -> dict[str, str]:
    """Every level of a program and its title, in order."""
    known = dict([RUNS, FILE, ORIENTATION, ADDED, ROUNDING, LOG_ODDS])
    known |= {plan.name: plan.title for plan in LEVELS}
    known |= dict([YAML, BAD_INPUT])
    return known | {
        probe_level(function): f"the function {function} (shared vectors)"
        for function in runner.functions
    }


def probe_level(function: str) -> str:
    """The name of the level that looks at one function."""
    return f"function-{function.replace('_', '-')}"


def is_asked(runner: Runner, name: str) -> bool:
    """Whether the program can be asked what a level of that name looks at."""
    plans = {plan.name: plan for plan in level_runs(runner)}
    if name in plans:
        return bool(plans[name].runs)
    return name != BAD_INPUT[0] or runner.reads_scenarios


def chosen_runs(
    runner: Runner, cases: Sequence[Case], modes: Sequence[Mode]
) -> list[LevelRuns]:
    """A level for each of these scenarios; without ``modes`` in the program's plain one."""
    return [
        LevelRuns(
            case.name,
            case.name,
            [(case, mode) for mode in modes or (runner.plain_mode,)],
        )
        for case in cases
    ]
