"""The wheel beside others: its names are its own, and both are of use after either was installed."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from ..conftest import ROOT
from .conftest import Installed, build_wheel

pytestmark = pytest.mark.long

PROJECT = """
[build-system]
requires = ["hatchling"]
build-backend = "hatchling.build"

[project]
name = "owner-of-parity"
version = "3.2.1"

[project.scripts]
parity = "parity:main"

[tool.hatch.build.targets.wheel]
only-include = ["parity.py"]
"""
MODULE = """
def main():
    print("the other package")
"""


def other_wheel(folder: Path) -> Path:
    """A distribution that owns the module and the command ``parity``."""
    source = folder / "source"
    source.mkdir()
    (source / "pyproject.toml").write_text(PROJECT)
    (source / "parity.py").write_text(MODULE)
    return build_wheel(source, folder / "dist")


def test_the_wheel_has_two_packages_and_two_commands(tmp_path: Path) -> None:
    with zipfile.ZipFile(build_wheel(ROOT, tmp_path / "dist")) as wheel:
        names = wheel.namelist()
        (entries,) = (n for n in names if n.endswith("entry_points.txt"))
        commands = wheel.read(entries).decode().splitlines()
    tops = {name.split("/")[0] for name in names}
    info = {top for top in tops if top.endswith(".dist-info")}
    assert tops - info == {"occgrid", "occgrid_parity"}
    assert {line.split(" = ")[0] for line in commands if " = " in line} == {
        "occgrid",
        "occgrid-parity",
    }


def test_beside_another_package_called_parity(
    installed: Installed, tmp_path: Path
) -> None:
    """Both commands and both modules work, and this one still does when the other has gone."""
    pip = ["python", "-m", "pip", "--disable-pip-version-check", "-q"]
    wheel = str(other_wheel(tmp_path))
    ended = installed.run(*pip, "install", "--no-deps", wheel)
    assert ended.returncode == 0, ended.stderr
    try:
        assert installed.run("parity").stdout == "the other package\n"
        own = installed.run("occgrid-parity", "--version")
        assert own.stdout.startswith("occgrid-parity ")
        module = installed.run("python", "-m", "occgrid_parity", "--version")
        assert module.stdout == own.stdout
        import_both = "import parity, occgrid_parity; print(parity.__file__)"
        ended = installed.run("python", "-I", "-c", import_both)
        assert (ended.returncode, ended.stderr) == (0, "")
        assert ended.stdout.endswith("parity.py\n")
    finally:
        ended = installed.run(*pip, "uninstall", "-y", "owner-of-parity")
    assert ended.returncode == 0, ended.stderr
    assert installed.run("occgrid-parity", "--version").returncode == 0
