"""The mapping loop: scan after scan into the grid (the lesson's first flow chart)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from occgrid.grid import OccupancyGrid
from occgrid.noise import add_range_noise
from occgrid.scenario import Scenario
from occgrid.sensor import Scan, beam_angles, update_grid_from_scans
from occgrid.world import Pose, simulate_lidar_scan

# beams that are traced together; bounds the memory, whatever the log
BATCH_BEAMS = 8192


# [snippet: map-scenario]
def map_scenario(
    scenario: Scenario,
    seed: int | None,
    after_scan: Callable[[int, OccupancyGrid], None] | None = None,
) -> OccupancyGrid:
    """Map all scans of a scenario; without a seed, free of noise.

    after_scan(number, grid) is called after each scan, if given.
    """
    settings = scenario.settings
    grid = settings.new_grid()
    batch: list[Scan] = []
    beams = 0
    for number, scan in enumerate(simulated_scans(scenario, seed)):
        batch.append(scan)
        beams += scan.angles.size
        if beams >= BATCH_BEAMS or after_scan is not None:
            update_grid_from_scans(
                grid, batch, settings.max_range, settings.no_return
            )
            batch, beams = [], 0
        if after_scan is not None:
            after_scan(number, grid)
    if batch:
        update_grid_from_scans(
            grid, batch, settings.max_range, settings.no_return
        )
    return grid


def simulated_scans(scenario: Scenario, seed: int | None) -> Iterator[Scan]:
    """The scans of a scenario; a bare pose is simulated, with noise."""
    settings = scenario.settings
    angles = beam_angles(settings.fov, settings.beams)
    for number, scan in enumerate(scenario.scans):
        if isinstance(scan, Pose):
            ranges = simulate_lidar_scan(
                scan, scenario.walls, angles, settings.max_range
            )
            if seed is not None:
                ranges = add_range_noise(
                    ranges,
                    settings.noise_std,
                    seed,
                    number,
                    settings.max_range,
                )
            yield Scan(scan, angles, ranges)
        else:
            yield scan


# [/snippet]
