"""What the tests share: the ports, built once, and fake ports."""

from __future__ import annotations

import json
import os
import pickle
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest
from filelock import FileLock

from occgrid_parity.ports.building import Built, build_ports
from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.ports.finding import find_ports
from occgrid_parity.processes.progress import Silent
from occgrid_parity.suite.repository import find_root

from .reported import Ran, run_and_report

T = TypeVar("T")
ROOT = find_root(Path(__file__).parent)
PORTS = find_ports(ROOT)
WORKERS = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
JOBS = 2 if WORKERS == 1 else 1
"""Processes at a time in one worker: two cores are busy already where there are several workers."""
REAL_LOGS = "test_real_logs.py"


def require_all() -> bool:
    """Whether nothing may be skipped."""
    return os.environ.get("PARITY_REQUIRE_ALL", "") not in ("", "0")


def unavailable(reason: str) -> None:
    """Skips the test for that reason, or fails where nothing may be skipped."""
    if require_all():
        pytest.fail(f"PARITY_REQUIRE_ALL: {reason}", pytrace=False)
    pytest.skip(reason)


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter,
) -> None:
    """Says in one line whether the tests on real laser logs ran."""
    counts = {
        outcome: sum(
            getattr(report, "nodeid", "")
            .partition("::")[0]
            .endswith(REAL_LOGS)
            for report in terminalreporter.stats.get(outcome, [])
        )
        for outcome in ("passed", "failed", "error", "skipped")
    }
    ran = sum(counts.values()) - counts["skipped"]
    if ran:
        said = ", ".join(f"{n} {word}" for word, n in counts.items() if n)
        terminalreporter.write_line(f"real laser logs: {said}")
    elif counts["skipped"]:
        terminalreporter.write_line(
            f"real laser logs: none of {counts['skipped']} tests ran; OCCGRID_DATA names the folder of the logs"
        )


def once(
    folders: pytest.TempPathFactory, name: str, make: Callable[[], T]
) -> T:
    """What ``make`` gives, made by the first worker that needs it and read by the others."""
    if WORKERS == 1:
        return make()
    shared = folders.getbasetemp().parent
    kept = shared / f"{name}.pickle"
    with FileLock(shared / f"{name}.lock"):
        if not kept.is_file():
            made = make()
            kept.write_bytes(pickle.dumps(made))
            return made
        found: T = pickle.loads(kept.read_bytes())
        return found


@pytest.fixture(scope="session")
def root() -> Path:
    """The repository."""
    return ROOT


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Built]:
    """Every port, built, by its name: once, whatever the number of workers."""

    def build() -> list[Built]:
        logs = tmp_path_factory.mktemp("builds")
        return build_ports(PORTS, logs, JOBS, Silent())

    return {b.port.name: b for b in once(tmp_path_factory, "builds", build)}


@pytest.fixture(scope="session")
def ready(built: dict[str, Built]) -> list[Port]:
    """The ports that can run here."""
    return [b.port for b in built.values() if not b.problem]


@pytest.fixture(scope="session")
def need(built: dict[str, Built]) -> Callable[[str], Port]:
    """``need(name)``: the port, ready to run; skips or fails the test otherwise."""

    def check(name: str) -> Port:
        if built[name].skipped:
            unavailable(f"{name}: {built[name].problem}")
        if built[name].problem:
            pytest.fail(f"{name}: {built[name].problem}", pytrace=False)
        return built[name].port

    return check


@pytest.fixture(scope="session")
def map_loader(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The program that loads a map, for ``map_loading.load_map``."""
    if shutil.which("g++") is None:
        unavailable("no g++: install g++")
    program = tmp_path_factory.mktemp("loader") / "map_loader"
    source = Path(__file__).with_name("map_loader.cpp")
    header = subprocess.run(
        ["g++", "-E", "-x", "c++", "-"],
        input="#include <yaml-cpp/yaml.h>\n",
        text=True,
        capture_output=True,
        check=False,
    )
    if header.returncode != 0:
        unavailable("no yaml-cpp: install libyaml-cpp-dev")
    command = ["g++", "-std=c++17", "-O1", str(source), "-o", str(program)]
    subprocess.run([*command, "-lyaml-cpp"], check=True)
    return program


FAKE = """
import os, pathlib, signal, subprocess, sys, time

arguments = sys.argv[1:]
mode = arguments.pop(0)
if mode == "--seed":
    mode += arguments.pop(0)
out = pathlib.Path(arguments[arguments.index("--out") + 1])
arguments = arguments[arguments.index("--out") + 2:]
files = [pathlib.Path(file) for file in arguments] or [pathlib.Path("lesson.log")]


def pgm(rows):
    lines = [" ".join(map(str, row)) for row in reversed(rows)]
    return f"P2\\n{len(rows[0])} {len(rows)}\\n255\\n" + "\\n".join(lines) + "\\n"


def logodds(rows):
    lines = [" ".join(map(repr, row)) for row in rows]
    return f"# logodds {len(rows[0])} {len(rows)}\\n" + "\\n".join(lines) + "\\n"


def write(name, pixels=((128, 255), (0, 128), (7, 8)),
          values=((0.0, -3.5), (8.0, 0.1), (1.5, 0.25)), yaml=None):
    (out / f"{name}.pgm").write_text(pgm(pixels))
    (out / f"{name}.logodds").write_text(logodds(values))
    (out / f"{name}.yaml").write_text(yaml or f"image: {name}.pgm\\nnegate: 0\\n")

"""
WELL = """
for file in files:
    write(file.stem)
"""


@pytest.fixture
def fake_root(tmp_path: Path) -> Path:
    """A repository with scenarios a, b and c and a fake port python that is well."""
    (tmp_path / "SPEC.md").write_text("")
    (tmp_path / "scenarios" / "golden").mkdir(parents=True)
    for name in "abc":
        (tmp_path / "scenarios" / f"{name}.log").write_text("POSE 0 0 0\n")
    make_fake(tmp_path, "python", WELL)
    return tmp_path


def make_fake(
    root: Path,
    name: str,
    body: str = WELL,
    extra: str = "",
    timeout: float = 100,
) -> Port:
    """Declares a fake port whose program is FAKE and then ``body``."""
    folder = root / name
    folder.mkdir()
    (folder / "program.py").write_text(FAKE + textwrap.dedent(body))
    run = [
        sys.executable,
        "{port}/program.py",
        "{mode}",
        "--out",
        "{out}",
        "{scenarios}",
    ]
    (folder / "port.toml").write_text(
        f'name = "{name}"\nlanguage = "fake"\nrun = {json.dumps(run)}\n'
        f"timeout = {timeout}\n{extra}"
    )
    return read_port(folder / "port.toml")


@pytest.fixture
def fake(fake_root: Path) -> Callable[..., Port]:
    """``fake(name, body, extra="", timeout=100)`` makes a fake port in fake_root."""

    def make(
        name: str, body: str = WELL, extra: str = "", timeout: float = 100
    ) -> Port:
        return make_fake(fake_root, name, body, extra, timeout)

    return make


@pytest.fixture(scope="session")
def ran(tmp_path_factory: pytest.TempPathFactory) -> Ran:
    """A run to report on."""
    return run_and_report(
        tmp_path_factory.mktemp("ports"), tmp_path_factory.mktemp("run")
    )
