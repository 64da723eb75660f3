"""class.toml: what the instructor decides counts, and what cannot be understood is said with file and key."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from occgrid_parity.check.levels import LEVELS
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.course.class_run import ClassPlan, ClassRun
from occgrid_parity.course.class_store import SUBMISSIONS
from occgrid_parity.course.rules import RulesError, read_rules
from occgrid_parity.course.submission_task import Wanted
from occgrid_parity.course.submitted_program import submitted_program
from occgrid_parity.ports.port_file import PortError
from occgrid_parity.processes.limits import Limits
from occgrid_parity.processes.progress import Silent
from occgrid_parity.suite.cases import Case, scenario_folder

from ..check_helpers import PROGRAMS
from ..conftest import ROOT

RUN = ["perl", "lesson.pl", "{mode}", "--out", "{out}", "{scenario}"]


def rules_file(folder: Path, text: str) -> Path:
    file = folder / "class.toml"
    file.write_text(text)
    return file


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sandbox = 'perhaps'", "sandbox: invalid enum value 'perhaps'"),
        ("sand = 1", "unknown key sand"),
        ("[limits]\nsecond = 3", "unknown key limits.second"),
        ("[limits]\nseconds = 'x'", "limits.seconds: expected a number, got a text"),
        ("[limits]\nseconds = 0", "limits.seconds: expected a number > 0"),
        ("[program]\nrun = 'x'", "program.run: expected a list"),
        ("[program]\nrun = []", "program.run: expected a list that is not empty"),
        ("[program]\nallow = ['x']", "program.allow: x is not a key"),
        ("[program]\nreadable = ['x']", "program.readable: x must be the full"),
        ("[check]\nseeds = [-1]", "check.seeds[0]: expected a whole number >= 0"),
        ("[check]\nhidden = ['x']", "check.hidden: there is no file x"),
        ("[check]\nsuite = false", "check.suite: without it"),
        ("[points]\nprior = -1", "points.prior: expected a number >= 0"),
        ("[points]\nprior = nan", "points.prior: expected a number >= 0"),
        ("= 3", "Invalid statement (at line 1, column 1)"),
    ],
)  # fmt: skip
def test_errors_name_file_and_key(
    tmp_path: Path, text: str, said: str
) -> None:
    file = rules_file(tmp_path, text)
    with pytest.raises(RulesError) as error:
        read_rules(file)
    assert str(error.value).startswith(f"{file}: {said}")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", ["class.toml", "class-with-comments.toml"])
def test_the_examples_can_be_read(name: str) -> None:
    rules = read_rules(ROOT / "docs" / name)
    levels = {plan.name for plan in LEVELS}
    own = {
        "runs",
        "file",
        "orientation",
        "added",
        "rounding",
        "log-odds",
        "seeds",
        "yaml",
        "bad-input",
    }
    assert set(rules.points) <= levels | own
    assert not rules.points or levels <= set(rules.points)


def test_the_instructors_command_goes_before_the_students(
    tmp_path: Path,
) -> None:
    rules = read_rules(rules_file(tmp_path, f"[program]\nrun = {RUN}\n"))
    place = tmp_path / "student"
    place.mkdir()
    (place / "port.toml").write_text(
        'run = ["cat", "golden"]\nbuild = [["make"]]\n'
    )
    program, notes = submitted_program(place, rules.program, None)
    assert program.command == tuple(RUN)
    assert program.build == ()
    assert [note.split()[0] for note in notes] == ["run", "build"]


def test_only_the_allowed_keys_count(tmp_path: Path) -> None:
    place = tmp_path / "student"
    place.mkdir()
    (place / "port.toml").write_text(
        'run = ["x", "{scenario}"]\nbuild = [["make"]]\ntimeout = 900\nbuild_timeout = 900\n'
    )
    text = "[program]\nallow = ['run']\n"
    rules = read_rules(rules_file(tmp_path, text))
    program, notes = submitted_program(place, rules.program, None)
    assert (program.build, program.timeout) == ((), 60)
    words = [note.split()[0] for note in notes]
    assert words == ["build", "timeout", "build_timeout"]
    text = "[program]\nallow = ['build']\n"
    rules = read_rules(rules_file(tmp_path, text))
    with pytest.raises(PortError, match="neither gives it nor allows it"):
        submitted_program(place, rules.program, None)


def checked(folder: Path, rules: str) -> Verdict:
    """The verdict on one submission that forgets the prior, on the scenarios of the rules."""
    place = folder / "in" / "one"
    place.mkdir(parents=True)
    for name in ("lesson.awk", "lesson.pl"):
        (place / name).write_bytes((PROGRAMS / name).read_bytes())
    read = read_rules(rules_file(folder / "in", rules))

    def cases(names: Sequence[str]) -> list[Case]:
        return [
            Case(Path(n).stem, (folder / "in" / n).read_bytes()) for n in names
        ]

    wanted = Wanted(
        read,
        Limits(),
        30,
        "none",
        timeout=30,
        own=cases(read.check.scenarios),
        hidden=cases(read.check.hidden),
    )
    plan = ClassPlan(folder / "in", folder / "out", wanted, jobs=1)
    return ClassRun(plan, Silent()).check()[0].verdict


def test_hidden_scenarios_are_hidden(tmp_path: Path) -> None:
    place = tmp_path / "in"
    place.mkdir()
    for name, new in (("one-beam", "shown"), ("prior", "secret")):
        data = (scenario_folder() / f"{name}.log").read_bytes()
        (place / f"{new}.log").write_bytes(data)
    run = ["awk", "-f", "lesson.awk", "-v", "bug=prior", "{scenario}"]
    verdict = checked(
        tmp_path,
        f"[program]\nrun = {run}\n[check]\nsuite = false\n"
        "scenarios = ['shown.log']\nhidden = ['secret.log']\n[points]\nshown = 2\nsecret = 3\n",
    )
    statuses = {level.name: level.status for level in verdict.levels}
    assert statuses["shown"] == "identical", verdict.levels
    assert statuses["secret"] == "failed"
    assert verdict.overall == "differs"
    kept = tmp_path / "out" / SUBMISSIONS / "one"
    feedback = (kept / "feedback.txt").read_text()
    assert "2 of 5 points" in feedback
    assert "hidden scenario 1" in feedback
    assert "secret" not in feedback
    assert "cells" not in feedback
    row = (tmp_path / "out" / "summary.csv").read_text().splitlines()
    assert "level: secret" in row[0]
