"""Whether a map is the reference's of other scans: the first 119, all but the first, every other, in reverse order."""

from __future__ import annotations

import numpy as np

from occgrid.map_writer import pixel
from occgrid.scenario import Scenario
from occgrid_parity.explain.closeness import (
    MOST_OPEN,
    Compared,
    compare_with_reference,
)
from occgrid_parity.explain.shorter_scenarios import Shortener
from occgrid_parity.explain.wrong_cells import count_wrong, wrong_cells
from occgrid_parity.model.known_scans import known_scans
from occgrid_parity.model.map_history import maps_after_scans
from occgrid_parity.model.mapper_steps import Drawn
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

LEAST_SCANS = 3
NEAREST = 2  # of those that come nearer, how many are compared cell by cell


def chosen_scans(
    observed: Observed, case: Case, mode: Mode, one_missing: bool = True
) -> str:
    """Which scans the map shows, in words that follow "exactly the reference's"; empty where it is no such map.

    A seed's noise goes by the number of the scan, so there only the first scans are looked at. ``one_missing`` is False
    where it is known that more than one scan must be missing.
    """
    shortener = Shortener(case)
    count = len(shortener.scan_lines)
    if count < LEAST_SCANS:
        return ""
    first = _first_scans(observed, case, mode)
    tried = [(shortener.prefix(first), f"after {first} of {count} scans")]
    if mode.seed is None:
        every = list(range(count))
        tried += [
            (shortener.some(scans), words) for scans, words in _choices(every)
        ]
    if not one_missing:
        tried = [
            (shorter, words)
            for shorter, words in tried
            if len(world_of(shorter).scans) != count - 1
        ]
    most = wrong_cells(observed, case, mode)
    # a map that comes no nearer, or not near enough for rounding, need not be looked at
    limit = min(most, MOST_OPEN + 1)
    near = [
        (wrong, shorter, words)
        for shorter, words in tried
        if (wrong := wrong_cells(observed, shorter, mode, limit)) < limit
    ]
    for _, shorter, words in sorted(near, key=lambda one: one[0])[:NEAREST]:
        compared = compare_with_reference(
            observed, shorter, mode, own_poses=not case.is_file
        )
        if compared.status != "differs":
            return words + but_for(compared)
    return ""


def _choices(every: list[int]) -> list[tuple[list[int], str]]:
    """Which scans a program can map, and in which order, in place of all of them in the order of the file."""
    last = every[-1]
    return [
        (every[1:], "without the first scan"),
        (every[::2], "of every other scan (0, 2, 4, ...)"),
        (every[1::2], "of every other scan (1, 3, 5, ...)"),
        ([*every, last], "with the last scan twice"),
        ([*every, 0], "with the first scan once more at the end"),
        ([*every[1:], 0], "with the first scan after all others"),
        ([last, *every[:-1]], "with the last scan before all others"),
        (every[::-1], "with the scans in reverse order"),
        (every[:0:-1], "without the first scan, and in reverse order"),
        (every[-2::-1], "without the last scan, and in reverse order"),
        (every[1:-1], "without the first and the last scan"),
    ]


def but_for(compared: Compared) -> str:
    """What rounding adds to the statement that a map is exactly another one's."""
    if compared.status == "edges":
        return ", but for beams that end on a cell edge"
    return ""


def _first_scans(observed: Observed, case: Case, mode: Mode) -> int:
    """After how many scans, but not all of them, the reference is nearest to the map."""
    world = world_of(case)
    scans = known_scans(world, mode.seed)
    scenario = Scenario(case.name, world.settings, list(world.walls), scans)
    wrong: list[int] = []
    log_odds = world.settings.new_grid().log_odds
    pixels = pixel(log_odds)
    for grid in maps_after_scans(scenario, None):
        changed = grid.log_odds != log_odds
        log_odds[changed] = grid.log_odds[changed]
        pixels[changed] = pixel(log_odds[changed])
        wrong.append(count_wrong(observed, Drawn(log_odds, pixels[::-1])))
    return int(np.argmin(wrong[:-1])) + 1
