"""The recipe for a port in CONTRIBUTING.md, followed in a temporary repository with a toy port."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import pytest

from occgrid_parity.ports.contributing import PAGE, read_table
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.finding import find_ports
from occgrid_parity.ports.probing import FUNCTIONS, run_probe
from occgrid_parity.suite.vectors import RESULTS, read_vectors

from .conftest import ROOT
from .test_parallel_ports import (
    DIFFERENCES,
    MODULES,
    difference,
    wrong_functions,
)

SCENARIO = "one-beam"
FAST, PLAIN = "noise-free", "noise-free-plain"
RUN = [
    *("run", "--port", "toy", "--scenario", SCENARIO),
    *("--mode", FAST, "--mode", PLAIN),
]
PROGRAM = ["env", "PYTHONPATH={port}", "{python}"]
TOY = {
    "name": "toy",
    "language": "a copy of the Python port",
    "build": [["{python}", "-m", "compileall", "-q", "{port}/occgrid"]],
    "run": [
        *PROGRAM,
        *("-m", "occgrid", "{mode}", "--out", "{out}", "{scenarios}"),
    ],
    "version": [*PROGRAM, "-m", "occgrid", "--version"],
    "timeout": 60,
    "probe": [
        *PROGRAM,
        *("{port}/tests/probe.py", "{function}", "{input}", "{output}"),
    ],
}


def copy_port(root: Path, name: str) -> Path:
    """The Python port's sources and probe in a folder of that name."""
    folder = root / name
    shutil.copytree(
        ROOT / "python/occgrid",
        folder / "occgrid",
        ignore=shutil.ignore_patterns("__pycache__"),
    )
    (folder / "tests").mkdir()
    shutil.copy(ROOT / "python/tests/probe.py", folder / "tests")
    return folder


@pytest.fixture(scope="module")
def toy(tmp_path_factory: pytest.TempPathFactory) -> Port:
    """Steps 1 to 3: a folder with a program, its port.toml, its probe, beside the reference."""
    root = tmp_path_factory.mktemp("repository")
    (root / "scenarios" / "golden").mkdir(parents=True)
    for path in (
        "SPEC.md",
        PAGE,
        f"scenarios/{SCENARIO}.log",
        *(
            path.relative_to(ROOT).as_posix()
            for path in ROOT.glob(f"scenarios/golden/{SCENARIO}.*")
        ),
    ):
        shutil.copy(ROOT / path, root / path)
    reference = copy_port(root, "python")
    shutil.copy(ROOT / "python/port.toml", reference)
    folder = copy_port(root, "toy")
    lines = [f"{key} = {json.dumps(value)}" for key, value in TOY.items()]
    needs = '[[needs]]\ncommand = ["no-such-command", "env"]\ninstall = "env"'
    (folder / "port.toml").write_text("\n".join([*lines, needs]))
    return {port.name: port for port in find_ports(root)}["toy"]


def parity(toy: Port, *arguments: str) -> tuple[int, str]:
    """A command of the harness in the temporary repository: its status and what it printed."""
    done = subprocess.run(
        [sys.executable, "-m", "occgrid_parity", *arguments],
        cwd=toy.folder.parent,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout + done.stderr


def test_it_is_built_and_run_without_being_listed(toy: Port) -> None:
    status, printed = parity(toy, "build", "toy")
    assert status == 0, printed
    status, printed = parity(toy, *RUN)
    assert status == 0, printed
    assert re.search(r"\btoy\b", printed)


def test_its_probe_answers(toy: Port, tmp_path: Path) -> None:
    for function in ("exp", "bresenham", "read_ranges"):
        vectors = read_vectors(function)
        found = run_probe(toy, function, vectors.questions[:20], tmp_path)
        assert found == vectors.answers[:20]


def test_its_functions_are_compared(toy: Port) -> None:
    """Step 6: what differs is named until the table has a row for it, and once it has, only what differs then."""
    wrong = [text for m in MODULES for text in wrong_functions(toy, m)]
    assert wrong == [
        "new_grid(settings) is new_grid()",
        "Scenario(name, settings, walls, scans) is "
        "Scenario(name, settings, walls, scans, file)",
    ]
    rows = {
        ("toy", name): difference("toy", name, there)
        for name, there in (
            ("new_grid", "`...()`"),
            ("Scenario", "`...(..., file)`"),
            ("exp", "none"),
        )
    }
    wrong = [
        text
        for module in MODULES
        for text in wrong_functions(toy, module, {**DIFFERENCES, **rows})
    ]
    assert wrong == [
        "exp(x) is as everywhere: its row among the differences goes"
    ]


@pytest.mark.parametrize(
    ("module", "right", "wrong", "mode"),
    [
        ("fast", "grid.l_free - grid.l0", "grid.l_occ - grid.l0", FAST),
        ("sensor", "gx.size - 1 if hit[i] else", "", PLAIN),
    ],
)
def test_the_run_says_which_path_is_wrong(
    toy: Port, module: str, right: str, wrong: str, mode: str
) -> None:
    """A function broken in one path of the toy: the run names the port, the scenario and the mode of that path."""
    path = toy.folder / "occgrid" / f"{module}.py"
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong))
    try:
        status, printed = parity(toy, *RUN)
    finally:
        path.write_text(text)
    assert status == 1, printed
    found = re.findall(r"^toy, (\S+), (\S+): differs$", printed, re.MULTILINE)
    assert found == [(SCENARIO, mode)]


def test_every_key_is_documented() -> None:
    """The tables' keys are those that a declaration may have, and no others."""
    section = (ROOT / PAGE).read_text().split("\n## port.toml\n")[1]
    section = section.partition("\n## ")[0]
    keys = re.findall(r"^\| `(?:\[\[)?([a-z_]+)(?:\]\])?` \|", section, re.M)
    of_the_file = {field.name for field in fields(Port)} - {"folder"}
    assert sorted(keys) == sorted(of_the_file)


def test_every_function_of_the_probe_is_documented() -> None:
    """With the arguments and results of the shared vectors."""
    rows = {
        name: (asked, answered)
        for names, asked, answered in read_table(ROOT, "The probe")
        for name in re.findall(r"\w+", names)
    }
    assert sorted(rows) == sorted(FUNCTIONS) == sorted(RESULTS)
    for name, (asked, answered) in rows.items():
        assert asked.split() == read_vectors(name).arguments, name
        if name != "bresenham":
            assert answered.split() == RESULTS[name], name
