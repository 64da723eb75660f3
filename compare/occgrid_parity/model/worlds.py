"""What a scenario holds, read as a whole."""

from __future__ import annotations

import functools
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from occgrid.scenario import Settings, read_scenario
from occgrid.sensor import Scan
from occgrid.world import Pose, Segment
from occgrid_parity.suite.cases import Case


class World(NamedTuple):
    """What a scenario file holds."""

    settings: Settings
    walls: Sequence[Segment]
    scans: Sequence[Pose | Scan]


def read_world(path: str | Path) -> World:
    """The whole scenario in memory. Raises occgrid.scenario.ScenarioError where it breaks a rule."""
    with read_scenario(path) as scenario:
        return World(scenario.settings, scenario.walls, list(scenario.scans))


KEPT = 64


@functools.lru_cache(KEPT)
def world_of(case: Case) -> World:
    """The scenario, read. Raises occgrid.scenario.ScenarioError where it breaks a rule."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{case.name}.log"
        path.write_bytes(case.data)
        return read_world(path)
