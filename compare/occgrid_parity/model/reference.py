"""What the reference, the Python port, draws."""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path

import numpy as np

from occgrid.grid import OccupancyGrid
from occgrid.mapper import map_scenario
from occgrid.scenario import Scenario, read_scenario
from occgrid_parity.model.mapper_steps import Drawn, World
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenario_text import Case

KEPT = 64
KEPT_CELLS = 1_000_000


@functools.lru_cache(KEPT)
def world_of(case: Case) -> World:
    """The scenario, read. Raises occgrid.scenario.ScenarioError where it breaks a rule."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{case.name}.log"
        path.write_bytes(case.data)
        with read_scenario(path) as scenario:
            return World(
                scenario.settings, scenario.walls, list(scenario.scans)
            )


def reference_map(case: Case, mode: Mode) -> Drawn:
    """The map of the Python port."""
    settings = world_of(case).settings
    if settings.width * settings.height > KEPT_CELLS:
        return _draw(case, mode)
    return _draw_once(case, mode)


def _draw(case: Case, mode: Mode) -> Drawn:
    world = world_of(case)
    scenario = Scenario(
        case.name, world.settings, list(world.walls), iter(world.scans)
    )
    grid = map_scenario(scenario, mode.seed)
    return Drawn(grid.log_odds, picture(grid))


_draw_once = functools.lru_cache(KEPT)(_draw)


def picture(grid: OccupancyGrid) -> np.ndarray:
    """Pixels in the file's order (SPEC.md section 2.6)."""
    pixels = np.floor((1.0 - grid.probability_grid()) * 255.0 + 0.5)
    return pixels.astype(np.int64)[::-1]
