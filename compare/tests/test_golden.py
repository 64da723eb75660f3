"""Golden results are written by one command, and a change of them is explained."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from occgrid_parity.commands.app import app
from occgrid_parity.suite.golden import read_golden
from occgrid_parity.suite.modes import DEFAULT_MODES, NOISE_FREE, Mode
from occgrid_parity.suite.scenarios import scenario_files

SCENARIO = """PARAM occgrid_width 8
PARAM occgrid_height 5
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 20
PARAM occgrid_beams 5
PARAM occgrid_noise_std 1
WALL 7.5 0 7.5 5
POSE 1.5 1.5 0
POSE 2.5 2.5 0.5
POSE 3.5 2.5 1
"""


@pytest.fixture
def small_root(tmp_path: Path) -> Path:
    """A repository with one small scenario."""
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "scenarios" / "small.log").write_text(SCENARIO)
    return tmp_path


def golden(root: Path, *arguments: str) -> tuple[int, list[str]]:
    result = CliRunner().invoke(
        app, ["golden", "--root", str(root), *arguments]
    )
    return result.exit_code, result.output.splitlines()


def test_writes_and_then_agrees(small_root: Path) -> None:
    assert golden(small_root) == (
        1,
        ["small, noise-free: is not there", "small, seed-0: is not there"],
    )
    assert golden(small_root, "--write")[0] == 0
    same = [
        f"small, {mode.name}: 3 scans as committed" for mode in DEFAULT_MODES
    ]
    assert golden(small_root) == (0, same)
    folder = small_root / "scenarios" / "golden"
    lines = (folder / "small.seed-0.sha256").read_text().splitlines()
    assert [line.split()[:2] for line in lines] == [
        ["scan", str(s)] for s in range(3)
    ]
    picture = (folder / "small.noise-free.pgm").read_text()
    assert picture.startswith("P2\n8 5\n255\n")
    assert picture.endswith("\n")
    free, noisy = (
        read_golden(folder, "small", mode) for mode in DEFAULT_MODES
    )
    assert free is not None
    assert noisy is not None
    assert free.scans[-1] != noisy.scans[-1]


def test_shows_what_changed_and_writes_only_that(small_root: Path) -> None:
    golden(small_root, "--write")
    log = small_root / "scenarios" / "small.log"
    log.write_text(SCENARIO.replace("POSE 3.5 2.5 1", "POSE 3.5 2.5 -1"))
    folder = small_root / "scenarios" / "golden"
    before = {path: path.read_bytes() for path in folder.iterdir()}
    status, lines = golden(small_root)
    assert status == 1
    assert lines[0].startswith(
        "small, noise-free: the log-odds differ after 1 of 3 scans, "
        "first after scan 2; "
    )
    assert " of 40 pixels differ, first at gx=" in lines[0]
    assert {path: path.read_bytes() for path in folder.iterdir()} == before
    status, lines = golden(small_root, "--write")
    assert status == 0
    assert lines[1].startswith("small, seed-0: written: the log-odds differ")
    assert golden(small_root)[0] == 0


def test_a_golden_result_without_scenario_is_a_stray(small_root: Path) -> None:
    golden(small_root, "--write")
    folder = small_root / "scenarios" / "golden"
    (folder / "gone.seed-0.pgm").write_text("P2\n")
    status, lines = golden(small_root)
    assert (status, lines[-1]) == (
        1,
        "gone.seed-0.pgm: belongs to no scenario",
    )
    assert golden(small_root, "--write")[0] == 0
    assert not (folder / "gone.seed-0.pgm").exists()


def test_a_broken_golden_file_is_named(small_root: Path) -> None:
    golden(small_root, "--write")
    path = small_root / "scenarios" / "golden" / "small.seed-0.pgm"
    path.write_text("P2\n8 5\n255\n1\n")
    status, lines = golden(small_root)
    assert status == 1
    assert (
        lines[1]
        == "small, seed-0: small.seed-0.pgm: line 4: 1 pixels, expected 8"
    )


def test_a_broken_scenario_is_named(small_root: Path) -> None:
    log = small_root / "scenarios" / "small.log"
    log.write_text(SCENARIO + "POSE 1 2\n")
    assert golden(small_root) == (
        1,
        [f"{log}:13: POSE takes 3 values, found 2"],
    )


@pytest.mark.parametrize("mode", DEFAULT_MODES, ids=lambda mode: mode.name)
def test_every_scenario_has_a_golden_result(root: Path, mode: Mode) -> None:
    folder = root / "scenarios" / "golden"
    names = [scenario.map for scenario in scenario_files(root)]
    missing = [
        name for name in names if read_golden(folder, name, mode) is None
    ]
    assert names
    assert missing == [], "occgrid-parity golden --write"


def test_noise_changes_only_what_is_simulated(root: Path) -> None:
    """Recorded scans get no noise: their two golden results are the same."""
    folder = root / "scenarios" / "golden"
    for scenario in scenario_files(root):
        assert scenario.path is not None
        text = scenario.path.read_text()
        free = read_golden(folder, scenario.map, NOISE_FREE)
        noisy = read_golden(folder, scenario.map, Mode(0))
        assert free is not None, "occgrid-parity golden --write"
        assert noisy is not None, "occgrid-parity golden --write"
        if "\nPOSE" not in text:
            assert list(free.scans) == list(noisy.scans), scenario.name
