"""What the reference, the Python port, draws."""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np

from occgrid.fast import map_scenario_fast
from occgrid.grid import OccupancyGrid
from occgrid.scenario import Scenario, Settings
from occgrid.sensor import Scan
from occgrid_parity.formats.log_odds import hash_log_odds
from occgrid_parity.model.known_scans import known_scans
from occgrid_parity.model.mapper_steps import Drawn
from occgrid_parity.model.worlds import KEPT, world_of
from occgrid_parity.suite.cases import Case, case, scenario_folder
from occgrid_parity.suite.golden import read_golden
from occgrid_parity.suite.modes import Mode

KEPT_CELLS = 1_000_000


def reference_map(case: Case, mode: Mode) -> Drawn:
    """The map of the Python port."""
    case = replace(case, is_file=True)  # the lesson as a file is the lesson
    settings = world_of(case).settings
    if settings.width * settings.height > KEPT_CELLS:
        return _draw(case, mode)
    return _draw_once(case, mode)


def _draw(case: Case, mode: Mode, rows: int | None = None) -> Drawn:
    world = world_of(case)
    settings = world.settings
    scans = known_scans(world, mode.seed)
    if rows is not None:
        settings = replace(settings, height=rows)
        scans = [_low_beams(scan, settings) for scan in scans]
    scenario = Scenario(case.name, settings, list(world.walls), scans)
    grid = map_scenario_fast(scenario, None)
    return Drawn(grid.log_odds, picture(grid))


def _low_beams(scan: Scan, settings: Settings) -> Scan:
    """The beams of a scan that come below the top of a grid, and perhaps others."""
    pose, angles, ranges = scan
    rise = np.fmin(ranges, settings.max_range) * np.sin(pose.theta + angles)
    top = settings.origin_y + settings.height * settings.resolution
    low = ~(pose.y + np.minimum(rise, 0.0) > top + settings.resolution)
    return Scan(pose, angles[low], ranges[low])


_draw_once = functools.lru_cache(KEPT)(_draw)


def lowest_rows(case: Case, mode: Mode, rows: int) -> Drawn:
    """The rows of the map with the smallest y, which take less time than all of them."""
    case = replace(case, is_file=True)
    if world_of(case).settings.width * rows > KEPT_CELLS:
        return _draw(case, mode, rows)
    return _draw_rows_once(case, mode, rows)


_draw_rows_once = functools.lru_cache(KEPT)(_draw)


def picture(grid: OccupancyGrid) -> np.ndarray:
    """Pixels in the file's order (SPEC.md section 2.6)."""
    pixels = np.floor((1.0 - grid.probability_grid()) * 255.0 + 0.5)
    return pixels.astype(np.int64)[::-1]


def golden_problem(name: str, mode: Mode) -> str | None:
    """Why the reference on this machine is not the committed result; None where it is, or none is committed.

    The Python port is the reference of every check, so it is held to the results that came with it first.
    """
    folder = scenario_folder() / "golden"
    golden = read_golden(folder, name, mode)
    if golden is None:
        return None
    drawn = reference_map(case(name), mode)
    if hash_log_odds(drawn.log_odds) == golden.scans[-1]:
        return None
    return (
        f"the Python port's map of {name} ({mode.name}) is not the committed one: nothing can be checked on this "
        "machine"
    )
