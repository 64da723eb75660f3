"""The students' zip files: each is complete, and its programs run in an empty folder."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest

from built_handouts import Handouts, needs
from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario
from occgrid_handouts.building import EXTRAS
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.notebook import run_notebook
from occgrid_handouts.packages import SCENARIO
from occgrid_handouts.page_tree import read_page
from occgrid_handouts.platform_math import search_path, wolfram_command
from occgrid_handouts.port_maps import count_differing, read_log_odds
from occgrid_handouts.project import ROOT

# nbformat has no types
READ: Any = nbformat.read
V4: Any = nbformat.v4


def unpacked(handouts: Handouts, language: str, folder: Path) -> Path:
    """The package in an empty folder."""
    name = f"occupancy-grid-{language}"
    with zipfile.ZipFile(handouts.folder / f"student/{name}.zip") as archive:
        archive.extractall(folder)
    assert [path.name for path in folder.iterdir()] == [name]
    return folder / name


def run(folder: Path, *command: str) -> str:
    """Standard output of a command that must succeed."""
    environment = {
        **os.environ,
        "PATH": search_path(),
        "DISPLAY": "",
        "PYTHONPATH": "",
    }
    done = subprocess.run(
        command,
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=900,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def check_one_beam(folder: Path) -> None:
    """The map that the package's program has drawn is the reference's."""
    with read_scenario(ROOT / SCENARIO) as scenario:
        expected = map_scenario(scenario, None).log_odds
    found = read_log_odds(folder / "maps" / "one-beam.logodds")
    assert count_differing(found, np.asarray(expected)) == 0


@pytest.mark.parametrize("language", [one.id for one in LANGUAGES])
def test_package_is_complete(
    handouts: Handouts, language: str, tmp_path: Path
) -> None:
    folder = unpacked(handouts, language, tmp_path)
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*")}
    expected = {"handout.pdf", "handout.html", "README.txt", SCENARIO}
    if language in EXTRAS:
        expected.add(EXTRAS[language][0])
    if not handouts.missing:
        expected |= {"play.html", "check.html"}
    assert expected <= names
    page = read_page((folder / "handout.html").read_text(encoding="utf-8"))
    for element in page.walk():
        target = element.attributes.get("href", "")
        if element.tag == "a" and not re.match(r"#|https://doi\.org/", target):
            assert (folder / target.partition("#")[0]).is_file(), target
    readme = (folder / "README.txt").read_text(encoding="utf-8")
    for word in re.findall(r"^(\S+\.\w+|\w+/) ", readme, re.MULTILINE):
        assert (folder / word).exists(), word


def test_notebook_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    folder = unpacked(handouts, "python", tmp_path)
    notebook = READ(folder / "python.ipynb", as_version=4)
    notebook.cells.append(
        V4.new_code_cell("import occgrid; print(occgrid.__file__)")
    )
    run_notebook(notebook, folder)
    (output,) = notebook.cells[-1].outputs
    assert output.text.startswith(str(folder))


def test_script_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    octave = needs("octave", "octave-cli")
    folder = unpacked(handouts, "matlab", tmp_path)
    said = run(folder, octave, "--norc", "--quiet", "matlab_handout.m")
    assert "+1.0986" in said and "cells are unsure" in said


def test_wolfram_notebook_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    """Its input cells as a script; NotebookDirectory needs a front end. The cells of the whole lesson take long."""
    needs("woxi", wolfram_command()[0])
    folder = unpacked(handouts, "mathematica", tmp_path)
    text = (folder / "mathematica.nb").read_text(encoding="ascii")
    cells = re.findall(
        r'Cell\[BoxData\["((?:\\.|[^"\\])*)"\], "Input"\]', text
    )
    assert len(cells) == 6
    code = "\n".join(
        cell.replace("\\n", "\n").replace('\\"', '"').replace("\\\\", "\\")
        for cell in cells
        if "LessonScenario" not in cell
    )
    script = folder / "cells.wls"
    script.write_text(code.replace("NotebookDirectory[]", f'"{folder}"'))
    said = run(folder, *wolfram_command(), str(script))
    assert "::" not in said
    assert "{110, 90}" in said and "1.09861228866810" in said


def test_cpp_project_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    cmake = needs("cmake", "cmake")
    folder = unpacked(handouts, "cpp", tmp_path)
    run(folder, cmake, "-S", "cpp", "-B", "build", "-DCMAKE_BUILD_TYPE=Debug")
    run(folder, cmake, "--build", "build")
    run(folder, "build/occgrid", "--plain", "--out", "maps", SCENARIO)
    check_one_beam(folder)


def test_java_program_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    javac = needs("openjdk-17-jdk-headless", "javac")
    folder = unpacked(handouts, "java", tmp_path)
    sources = [
        path.relative_to(folder).as_posix() for path in folder.rglob("*.java")
    ]
    run(folder, javac, "-d", "classes", *sources)
    words = ["--plain", "--out", "maps", SCENARIO]
    run(folder, "java", "-cp", "classes", "occgrid.Main", *words)
    check_one_beam(folder)


def test_python_program_runs_in_an_empty_folder(
    handouts: Handouts, tmp_path: Path
) -> None:
    folder = unpacked(handouts, "python", tmp_path)
    words = ["--plain", "--out", "../maps", f"../{SCENARIO}"]
    run(folder / "python", sys.executable, "-m", "occgrid", *words)
    check_one_beam(folder)
