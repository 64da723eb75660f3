"""A scenario's files are written whole or not at all, and an error names the file that is meant (SPEC section 7)."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.formats.map_files import SUFFIXES
from occgrid_parity.ports.declaration import Port

from .conftest import ROOT
from .port_runs import each_port, files, run_port

SCENARIO = ROOT / "scenarios" / "one-beam.log"
LONGEST = 255
"""Bytes in a file's name, on every file system that the tests know."""


@each_port
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_target_that_is_a_folder_keeps_all_files_from_being_written(
    need: Callable[[str], Port], tmp_path: Path, suffix: str, name: str
) -> None:
    """DIR is printed as it was given, but for slashes at its end."""
    out = tmp_path / "o" / "q"
    (out / f"one-beam{suffix}").mkdir(parents=True)
    other = next(other for other in SUFFIXES if other != suffix)
    (out / f"one-beam{other}").write_text("of yesterday")
    finished = run_port(need(name), tmp_path, "--out", "./o//q//", SCENARIO)
    said = finished.stderr.read_text()
    assert (finished.exit_status, said) == (
        1,
        f"./o//q/one-beam{suffix}: cannot be written\n",
    )
    assert files(out) == sorted([f"one-beam{suffix}", f"one-beam{other}"])
    assert (out / f"one-beam{other}").read_text() == "of yesterday"


@each_port
def test_so_does_a_link_to_a_folder(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """A link to a file is replaced by the map, and the file stays."""
    out = tmp_path / "o"
    out.mkdir()
    other = tmp_path / "other"
    other.write_text("of yesterday")
    (out / "one-beam.pgm").symlink_to(other)
    link = out / "one-beam.logodds"
    link.symlink_to(tmp_path)
    port = need(name)
    finished = run_port(port, tmp_path, "--out", "o", SCENARIO)
    said = finished.stderr.read_text()
    assert (finished.exit_status, said) == (
        1,
        "o/one-beam.logodds: cannot be written\n",
    )
    assert files(out) == ["one-beam.logodds", "one-beam.pgm"]
    link.unlink()
    finished = run_port(port, tmp_path, "--out", "o", SCENARIO)
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    assert not (out / "one-beam.pgm").is_symlink()
    assert other.read_text() == "of yesterday"


@each_port
def test_a_name_may_be_as_long_as_its_files_names_may_be(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    longest = "n" * (LONGEST - len(".logodds"))
    scenario = tmp_path / f"{longest}.log"
    scenario.write_bytes(SCENARIO.read_bytes())
    finished = run_port(need(name), tmp_path, "--out", "o", scenario)
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    assert files(tmp_path / "o") == sorted(longest + s for s in SUFFIXES)


@each_port
def test_a_name_that_is_too_long_for_one_file_leaves_none(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """.pgm and .yaml would fit, .logodds does not."""
    longer = "n" * (LONGEST - len(".logodds") + 1)
    scenario = tmp_path / f"{longer}.log"
    scenario.write_bytes(SCENARIO.read_bytes())
    finished = run_port(need(name), tmp_path, "--out", "o", scenario)
    assert (finished.exit_status, finished.stderr.read_text()) == (
        1,
        f"o/{longer}.logodds: cannot be written\n",
    )
    assert files(tmp_path / "o") == []


@each_port
def test_removes_temporary_files_of_runs_that_were_killed_yesterday(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """Only those of the contract's form, and only when they are more than 24 hours old."""
    out = tmp_path / "o"
    out.mkdir()
    hours = {
        ".occgrid-killed-1.part": 25,
        ".occgrid-running-1.part": 23,
        ".occgrid-a_b.part": 25,
        f".occgrid-{'a' * 41}.part": 25,
        ".occgrid-a.part.txt": 25,
        "occgrid-a.part": 25,
    }
    for file, age in hours.items():
        (out / file).write_text("P2\n")
        then = time.time() - 3600 * age
        os.utime(out / file, (then, then))
    (out / ".occgrid-folder.part").mkdir()
    os.utime(out / ".occgrid-folder.part", (0, 0))
    finished = run_port(need(name), tmp_path, "--out", "o", SCENARIO)
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    maps = [f"one-beam{suffix}" for suffix in SUFFIXES]
    kept = [*list(hours)[1:], ".occgrid-folder.part"]
    assert files(out) == sorted([*maps, *kept])
