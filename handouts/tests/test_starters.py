"""Starters, in every language: each stage says what is missing, and is right with its solution."""

from __future__ import annotations

import csv
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from built_handouts import needs
from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario
from occgrid_handouts.class_rules import class_rules, rules_name
from occgrid_handouts.exercises import EXERCISES, native_name, not_written
from occgrid_handouts.function_bodies import CutError, without_body
from occgrid_handouts.languages import BY_ID, LANGUAGES
from occgrid_handouts.port_maps import count_differing, read_log_odds
from occgrid_handouts.project import ROOT
from occgrid_handouts.snippets import read_snippets
from occgrid_handouts.starters import Stage, make_stages, starter_functions
from occgrid_parity.check.levels import FILE, LEVELS, ORIENTATION, RUNS
from occgrid_parity.check.starter import starter_lines
from occgrid_parity.course.rules import read_rules
from occgrid_parity.ports.building import build_port
from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.processes.process_group import run_process

# the lesson takes an interpreter of the Wolfram Language a minute
SCENARIOS = ("one-beam", "octants", "outside", "prior")
TOOLS = {
    "python": ("python3", "python3"),
    "cpp": ("g++ cmake libeigen3-dev", "cmake"),
    "java": ("openjdk-17-jdk-headless", "javac"),
    "matlab": ("octave", "octave-cli"),
    "mathematica": ("woxi", "woxi"),
}


def write_stage(stage: Stage, folder: Path) -> Port:
    """A stage as a student unpacks it; files that are there and the same keep their date."""
    for name, content in stage.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_bytes() != content:
            path.write_bytes(content)
    return read_port(folder / "port.toml")


def map_with(port: Port, scenario: str, work: Path) -> tuple[int | None, str]:
    """Exit status and standard error of one run; its files are in the folder ``out``."""
    shutil.rmtree(work, ignore_errors=True)
    (work / "out").mkdir(parents=True)
    file = str(ROOT / "scenarios" / f"{scenario}.log")
    finished = run_process(
        port.command(
            port.run,
            mode=["--noise-free"],
            out=work / "out",
            scenario=file,
            scenarios=[file],
        ),
        cwd=work,
        stdout=work / "stdout",
        stderr=work / "stderr",
        time_limit=10 * port.timeout,
    )
    return finished.exit_status, finished.stderr.read_text()


@pytest.mark.long
@pytest.mark.parametrize("language", sorted(BY_ID))
def test_every_stage(language: str, tmp_path: Path) -> None:
    """Without its functions it fails with the right words; with its solution its maps are the reference's."""
    needs(*TOOLS[language])
    needs("patch", "patch")
    snippets = read_snippets(ROOT, BY_ID[language])
    # one folder for all stages, so that a compiler works only on what has changed
    folder = tmp_path / "exercise"
    for stage in make_stages(ROOT, BY_ID[language]):
        port = write_stage(stage, folder)
        assert not build_port(port, tmp_path / "logs").problem
        functions = starter_functions(
            BY_ID[language], snippets, stage.exercise
        )
        names = [native_name(language, f.name) for f in functions]
        status, said = map_with(port, "one-beam", tmp_path / "run")
        assert status == 1
        # only the first function that the program comes to is missing to it
        expected = [not_written(stage.exercise, name) for name in names]
        assert any(text in said for text in expected), said
        assert not list((tmp_path / "run" / "out").iterdir())
        patch = subprocess.run(
            ["patch", "-p1", "--silent"],
            cwd=folder,
            input=stage.patch,
            text=True,
            capture_output=True,
        )
        assert patch.returncode == 0, patch.stdout
        assert "is not written yet" not in "".join(
            (folder / name).read_text()
            for name in stage.files
            if (folder / name).suffix != ".txt" and "ritten" not in name
        )
        assert not build_port(port, tmp_path / "logs").problem
        for scenario in SCENARIOS:
            assert differing(port, scenario, tmp_path / "run") == 0


def differing(port: Port, scenario: str, work: Path) -> int:
    """Cells in which the program's map differs from the reference."""
    status, said = map_with(port, scenario, work)
    assert status == 0, said
    with read_scenario(ROOT / "scenarios" / f"{scenario}.log") as read:
        expected = map_scenario(read, None).log_odds
    (file,) = (work / "out").glob("**/*.logodds")
    return count_differing(read_log_odds(file), np.asarray(expected))


@pytest.mark.long
def test_check_says_what_is_missing_and_what_is_wrong(tmp_path: Path) -> None:
    stage = make_stages(ROOT, BY_ID["python"])[3]
    write_stage(stage, tmp_path)
    lines = starter_lines(tmp_path / "port.toml")
    assert lines[0] == "exercise 4: One scan"
    assert lines[1:] == [
        "  read_ranges: not written yet",
        "  beam_endpoints: not written yet",
        "  update_grid_from_scan: not written yet",
    ]
    subprocess.run(
        ["patch", "-p1", "--silent"],
        cwd=tmp_path,
        input=stage.patch,
        text=True,
        check=True,
    )
    lines = starter_lines(tmp_path / "port.toml")
    assert lines[1].startswith("  read_ranges: right in all ")
    assert lines[2].startswith("  beam_endpoints: right in all ")
    sensor = tmp_path / "occgrid" / "sensor.py"
    text = sensor.read_text()
    assert "z_max - 1e-12" in text
    sensor.write_text(text.replace("z_max - 1e-12", "z_max + 1e-12"))
    wrong = starter_lines(tmp_path / "port.toml")[1]
    assert wrong.startswith("  read_ranges: wrong in ")
    first = "read_ranges(range 0.000999999999, z_max 0.001, no_return free)"
    assert f"the first: {first} should be 0.001 0 1; yours is " in wrong


def test_every_exercise_has_its_functions_in_every_language() -> None:
    for language in LANGUAGES:
        snippets = read_snippets(ROOT, language)
        for exercise in EXERCISES:
            found = starter_functions(language, snippets, exercise)
            missing = {f.name for f in exercise.functions} - {
                f.name for f in found
            }
            # C++ and Java update one cell after another
            assert missing <= {"update_cells"}
            assert "update_cells" not in missing or language.id in (
                "cpp",
                "java",
            )


def test_function_that_is_not_there_is_refused() -> None:
    for language in LANGUAGES:
        with pytest.raises(CutError, match="no function absent"):
            without_body(language.id, "x = 1\n", "absent", "", "")


def test_rules_of_a_class_can_be_read(tmp_path: Path) -> None:
    known = {level for level, _ in (RUNS, FILE, ORIENTATION)}
    known |= {level.name for level in LEVELS}
    for language in LANGUAGES:
        for exercise in EXERCISES:
            path = tmp_path / rules_name(exercise)
            path.write_text(class_rules(language, exercise))
            rules = read_rules(path)
            assert rules.program.run is not None
            assert set(rules.points) <= known
            assert sum(rules.points.values()) == 10


@pytest.mark.long
def test_class_of_a_starter_and_its_solution(tmp_path: Path) -> None:
    """Behind a wall where there is one: all points for the solution, and none for what has not been written."""
    needs(*TOOLS["java"])
    language, submissions = BY_ID["java"], tmp_path / "submissions"
    stage = make_stages(ROOT, language)[2]
    for name in ("unwritten", "solved"):
        write_stage(stage, submissions / name)
    subprocess.run(
        ["patch", "-p1", "--silent"],
        cwd=submissions / "solved",
        input=stage.patch,
        text=True,
        check=True,
    )
    rules = tmp_path / rules_name(stage.exercise)
    rules.write_text(class_rules(language, stage.exercise))
    command = [
        str(Path(sys.executable).with_name("occgrid-parity")),
        *("check", "--class", str(submissions), "--rules", str(rules)),
        *("--sandbox", "auto"),
    ]
    done = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True
    )
    summary = tmp_path / "occgrid-parity-check" / "summary.csv"
    assert summary.is_file(), done.stdout + done.stderr
    with summary.open(newline="") as file:
        rows = {row["submission"]: row for row in csv.DictReader(file)}
    marks = {
        name: (float(row["points"]), float(row["maximum"]))
        for name, row in rows.items()
    }
    assert marks == {"unwritten": (0.0, 10.0), "solved": (10.0, 10.0)}
