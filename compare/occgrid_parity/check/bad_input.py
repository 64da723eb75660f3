"""The level about scenarios that break a rule: the program must end with an error and name the line."""

from __future__ import annotations

import re

from occgrid_parity.check.levels import BAD_INPUT
from occgrid_parity.check.verdict import Level
from occgrid_parity.check.wording import listed
from occgrid_parity.processes.limits import LOST
from occgrid_parity.programs.runner import Outcome, Runner
from occgrid_parity.suite.cases import Case, scenario_folder

# one of a kind each: a number, a limit, a count, a missing parameter, a range, the order of lines
BAD = (
    "number-word",
    "limit-p_occ-1",
    "count-pose-2",
    "missing-width",
    "flaser-range-negative",
    "place-param-after-pose",
)
PYTHON = re.compile(r'^\s+File "[^"]*", line [0-9]+.*$', re.M)


def check_bad_input(runner: Runner) -> tuple[Level, int]:
    """The level, and how many runs it took."""
    wrong: dict[str, list[str]] = {}
    cases = bad_cases()
    for case, line in cases:
        outcome = runner.run(case, runner.plain_mode)
        if outcome.word == LOST:
            level = Level(*BAD_INPUT, "failed", LOST, outcome.message)
            return level, len(cases)
        problem = _problem(outcome, case.name, line)
        if problem:
            wrong.setdefault(problem, []).append(f"{case.name}.log")
    if not wrong:
        return Level(*BAD_INPUT, "passed"), len(cases)
    count = sum(map(len, wrong.values()))
    said = [f"{listed(files)}: {problem}" for problem, files in wrong.items()]
    message = (
        f"{count} of {len(cases)} scenarios that break a rule are not refused as SPEC.md section 8 says (an exit "
        f"status that is not 0, and FILE:LINE: REASON on standard error). {'; '.join(said)}"
    )
    word = "bad input"
    return Level(*BAD_INPUT, "failed", word, message), len(cases)


def bad_cases() -> list[tuple[Case, int]]:
    """The wrong scenarios, and the line in which each is wrong."""
    folder = scenario_folder() / "bad"
    expected = {}
    for text in (folder / "expected.txt").read_text("ascii").splitlines():
        file, line, _ = text.split(":", 2)
        expected[file] = int(line)
    return [
        (Case(name, (folder / f"{name}.log").read_bytes()), expected[file])
        for name in BAD
        for file in [f"{name}.log"]
    ]


def _problem(outcome: Outcome, name: str, line: int) -> str:
    """What is wrong with how a program has refused a scenario; empty where nothing is."""
    if outcome.status == 0:
        return "it ends with status 0, as if nothing were wrong"
    if outcome.status is None or outcome.status < 0:
        return f"{outcome.word} ({outcome.message})"
    printed = PYTHON.sub("", outcome.printed)
    if re.search(rf"{re.escape(name)}\.log:{line}\b", printed):
        return ""
    if re.search(rf"\bline {line}\b", printed, re.I):
        return ""
    return (
        f"it ends with an error that does not name line {line}, which is wrong"
    )
