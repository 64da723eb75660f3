"""lesson: the built-in lesson, its file, and its twin on a shifted grid."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from occgrid.lesson import (
    lesson_poses,
    lesson_scenario,
    lesson_settings,
    lesson_world,
)
from occgrid.mapper import map_scenario, simulated_scans
from occgrid.scenario import Scenario, read_scenario
from occgrid.sensor import beam_endpoints, read_ranges

SCENARIOS = Path(__file__).parents[2] / "scenarios"


@pytest.fixture
def generator() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "generate", SCENARIOS / "generate.py"
    )
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_scenario_files_are_the_generators(generator: ModuleType) -> None:
    files = {file.stem: file.read_bytes() for file in SCENARIOS.glob("*.log")}
    texts = {name: text() for name, text in generator.SCENARIOS.items()}
    assert files == {name: text.encode() for name, text in texts.items()}
    for text in texts.values():
        assert text.startswith("# "), "the first line gives the reason"


def test_the_built_in_lesson_is_the_file() -> None:
    with read_scenario(SCENARIOS / "lesson.log") as scenario:
        assert scenario.settings == lesson_settings()
        assert scenario.walls == lesson_world()
        assert list(scenario.scans) == lesson_poses()


@pytest.mark.parametrize("seed", [None, 0])
def test_both_map_alike(seed: int | None) -> None:
    built_in = map_scenario(lesson_scenario(), seed)
    with read_scenario(SCENARIOS / "lesson.log") as scenario:
        from_file = map_scenario(scenario, seed)
    assert from_file.log_odds.tobytes() == built_in.log_odds.tobytes()


def test_the_trajectory() -> None:
    poses = lesson_poses()
    assert len(poses) == 120
    for t, (x, y, theta) in enumerate(poses):
        ang = 2 * math.pi * t / 120
        assert x == pytest.approx(-6 + 6 * math.cos(ang), abs=1e-14)
        assert y == pytest.approx(4 * math.sin(ang), abs=1e-14)
        assert theta == pytest.approx(ang + math.pi / 2, abs=1e-14)


def edge_distance(scenario: Scenario, seed: int | None) -> float:
    """How near a beam's start or end comes to a cell edge, metres."""
    spec = scenario.settings.new_grid().spec
    nearest = math.inf
    for scan in simulated_scans(scenario, seed):
        z, _, _ = read_ranges(scan.ranges, scenario.settings.max_range, "free")
        ex, ey = beam_endpoints(scan.pose, scan.angles, z)
        for points, origin in (
            (np.append(ex, scan.pose.x), spec.origin_x),
            (np.append(ey, scan.pose.y), spec.origin_y),
        ):
            cells = (points - origin) / spec.resolution
            off = np.abs(cells - np.round(cells)).min() * spec.resolution
            nearest = min(nearest, float(off))
    return nearest


@pytest.mark.parametrize("seed", [None, 0])
def test_only_the_offset_lesson_keeps_off_the_edges(seed: int | None) -> None:
    with read_scenario(SCENARIOS / "lesson-offset.log") as scenario:
        assert edge_distance(scenario, seed) > 1e-6
    if seed is None:
        assert edge_distance(lesson_scenario(), seed) < 1e-12
