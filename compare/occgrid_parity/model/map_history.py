"""The map after each scan, as the Python port draws it."""

from __future__ import annotations

from collections.abc import Iterator

from occgrid.fast import update_grid_from_scans
from occgrid.grid import OccupancyGrid
from occgrid.mapper import simulated_scans
from occgrid.scenario import Scenario


def maps_after_scans(
    scenario: Scenario, seed: int | None
) -> Iterator[OccupancyGrid]:
    """The grid after each scan; it is the same grid, and changes with the next.

    Without a seed, free of noise. Raises ScenarioError where a scan breaks a rule.
    """
    settings = scenario.settings
    grid = settings.new_grid()
    for scan in simulated_scans(scenario, seed):
        update_grid_from_scans(
            grid, [scan], settings.max_range, settings.no_return
        )
        yield grid
