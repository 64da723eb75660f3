"""The mapping loop: scan after scan into the grid (the lesson's first flow chart)."""

from __future__ import annotations

from collections.abc import Iterator

from occgrid.grid import OccupancyGrid
from occgrid.noise import add_range_noise
from occgrid.scenario import Scenario
from occgrid.sensor import Scan, beam_angles, update_grid_from_scan
from occgrid.world import simulate_lidar_scan


# [snippet: map-scenario]
def map_scenario(scenario: Scenario, seed: int | None) -> OccupancyGrid:
    """Map all scans of a scenario; without a seed, free of noise.

    Raises ScenarioError for a line of its file that breaks a rule.
    """
    settings = scenario.settings
    grid = settings.new_grid()
    for scan in simulated_scans(scenario, seed):
        update_grid_from_scan(
            grid, scan, settings.max_range, settings.no_return
        )
    return grid


def simulated_scans(scenario: Scenario, seed: int | None) -> Iterator[Scan]:
    """The scans of a scenario; a bare pose is simulated, with noise."""
    settings = scenario.settings
    z_max = settings.max_range
    angles = beam_angles(settings.fov, settings.beams)
    for number, scan in enumerate(scenario.scans):
        if isinstance(scan, Scan):
            yield scan
            continue
        ranges = simulate_lidar_scan(scan, scenario.walls, angles, z_max)
        if seed is not None:
            ranges = add_range_noise(
                ranges, settings.noise_std, seed, number, z_max
            )
        yield Scan(scan, angles, ranges)


# [/snippet]
