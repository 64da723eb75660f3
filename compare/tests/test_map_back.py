"""A map goes back to ROS: .yaml and .pgm load by the published rules, read with yaml-cpp, as Nav2 reads them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from occgrid.grid import GridSpec, OccupancyGrid, sigmoid
from occgrid.map_writer import write_map
from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario

from .bags import write_bag
from .map_loading import load_map
from .test_bags import Mount, convert, drive, scenario_of


def check_cells(
    grid: OccupancyGrid, spec: GridSpec, cells: np.ndarray
) -> None:
    """What was never seen is unknown, what is clearly a wall or free is that; a grey level lies in between."""
    assert spec == grid.spec
    level = 1 / 255
    evidence = sigmoid(grid.log_odds - grid.l0)
    assert (cells[grid.log_odds == grid.l0] == -1).all()
    p = sigmoid(grid.log_odds)
    limits = [sigmoid(grid.l0 + np.log(q / (1 - q))) for q in (0.65, 0.196)]
    occupied, free = p > limits[0] + level, p < limits[1] - level
    assert occupied.sum() > 100
    assert free.sum() > 1000
    assert (cells[occupied] == 100).all()
    assert (cells[free] == 0).all()
    assert (evidence[cells == 100] > 0.5).all()
    assert (evidence[cells == 0] < 0.5).all()


@pytest.mark.parametrize("p0", ["0.5", "0.4"])
def test_the_map_of_a_bag_loads(
    tmp_path: Path, map_loader: Path, p0: str
) -> None:
    log = write_bag(tmp_path / "drive", "mcap", lambda m: drive(m, Mount()))
    status, text = convert(log, "--p0", p0)
    assert status == 0, text
    with read_scenario(scenario_of(log)) as scenario:
        grid = map_scenario(scenario, None)
    write_map(tmp_path, "a map", grid)
    spec, cells = load_map(map_loader, tmp_path / "a map.yaml")
    check_cells(grid, spec, cells)
    # the wall at x = 5.11, seen from the robot's side, stands where the world has it
    column = int((5.11 - spec.origin_x) / spec.resolution)
    row = int((0.5 - spec.origin_y) / spec.resolution)
    assert cells[row, column - 1 : column + 1].max() == 100
    assert (cells[row, column - 8 : column - 2] == 0).all()
