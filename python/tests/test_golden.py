"""The golden results, after every scan, by the printed path and by the fast one."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from occgrid.fast import update_grid_from_scans
from occgrid.grid import OccupancyGrid
from occgrid.map_writer import map_pgm
from occgrid.mapper import simulated_scans
from occgrid.scenario import read_scenario
from occgrid.sensor import update_grid_from_scan

SCENARIOS = Path(__file__).parents[2] / "scenarios"


def sha256(grid: OccupancyGrid) -> str:
    return hashlib.sha256(grid.log_odds.astype("<f8").tobytes()).hexdigest()


@pytest.mark.parametrize("path", ["plain", "fast"])
@pytest.mark.parametrize("mode", ["noise-free", "seed-0"])
@pytest.mark.parametrize(
    "name", [file.stem for file in sorted(SCENARIOS.glob("*.log"))]
)
def test_golden(name: str, mode: str, path: str) -> None:
    golden = SCENARIOS / "golden" / f"{name}.{mode}"
    lines = golden.with_name(f"{golden.name}.sha256").read_text().splitlines()
    expected = [line for line in lines if line.startswith("scan ")]
    seed = None if mode == "noise-free" else 0
    found = []
    with read_scenario(SCENARIOS / f"{name}.log") as scenario:
        settings = scenario.settings
        grid = settings.new_grid()
        limits = settings.max_range, settings.no_return
        for number, scan in enumerate(simulated_scans(scenario, seed)):
            if path == "plain":
                update_grid_from_scan(grid, scan, *limits)
            else:
                update_grid_from_scans(grid, [scan], *limits)
            found.append(f"scan {number} {sha256(grid)}")
    assert found == expected
    picture = golden.with_name(f"{golden.name}.pgm").read_text()
    assert "".join(map_pgm(grid)) == picture
