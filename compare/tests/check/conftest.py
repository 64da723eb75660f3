"""The package as its users have it: a wheel, installed in a virtual environment of its own, without the repository."""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from occgrid_parity.check.verdict import Verdict, from_json

from ..check_helpers import PROGRAMS
from ..conftest import ROOT, unavailable


@dataclass(frozen=True)
class Installed:
    """``bin`` of the environment, and a folder that is outside the repository, with the test's programs in it."""

    bin: Path
    folder: Path

    def run(self, *command: str) -> subprocess.CompletedProcess[str]:
        """A command of the environment. Only the system's own commands are on its PATH."""
        return subprocess.run(
            [str(self.bin / command[0]), *command[1:]],
            cwd=self.folder,
            env={"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8"},
            text=True,
            capture_output=True,
        )

    def check(self, words: str, out: Path, *options: str) -> Verdict:
        """The verdict of ``occgrid-parity check --run words``, whose exit status must be the verdict's."""
        arguments = ["--run", words, "--out", str(out), *options]
        ended = self.run("occgrid-parity", "check", *arguments)
        record = out / "verdict.json"
        assert record.is_file(), ended.stdout + ended.stderr
        verdict = from_json(record.read_text())
        assert ended.returncode == verdict.exit_status, ended.stderr
        assert ended.stdout.startswith(f"{verdict.program}: {verdict.summary}")
        return verdict


@pytest.fixture(scope="session")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """The wheel of this tree, built and installed with what it declares to need."""
    folder = tmp_path_factory.mktemp("installed")
    programs = folder / "programs"
    programs.mkdir()
    for path in PROGRAMS.iterdir():
        if path.suffix in (".pl", ".awk"):
            (programs / path.name).write_bytes(path.read_bytes())
    wheel = build_wheel(ROOT, folder / "dist")
    _run([sys.executable, "-m", "venv", str(folder / "venv")], folder)
    pip = [str(folder / "venv" / "bin" / "python"), "-m", "pip"]
    options = ["--disable-pip-version-check", "-q", "-c"]
    constraints = str(ROOT / "constraints.txt")
    try:
        _run([*pip, "install", *options, constraints, str(wheel)], folder)
    except subprocess.CalledProcessError as error:
        unavailable(f"the wheel cannot be installed: {error.stderr}")
    return Installed(folder / "venv" / "bin", folder)


@pytest.fixture(scope="session")
def mapper(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The C mapper, built."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        unavailable("install gcc")
    target = tmp_path_factory.mktemp("c") / "mapper"
    options = ["-O2", "-ffp-contract=off", "-o", str(target)]
    source = str(PROGRAMS / "mapper.c")
    subprocess.run([str(compiler), *options, source, "-lm"], check=True)
    return target


def build_wheel(source: Path, target: Path) -> Path:
    """Builds the wheel of a source tree into ``target``, a new folder."""
    build = ["-m", "build", "--wheel", "--no-isolation", "-o"]
    _run([sys.executable, *build, str(target), str(source)], target.parent)
    (wheel,) = target.glob("*.whl")
    return wheel


def _run(command: list[str], folder: Path) -> None:
    try:
        subprocess.run(
            command, cwd=folder, check=True, text=True, capture_output=True
        )
    except subprocess.CalledProcessError as error:
        error.add_note(f"{shlex.join(command)}\n{error.stderr}")
        raise
