"""All mistakes, by name."""

from __future__ import annotations

from occgrid.scenario import read_scenario
from parity.mistakes import (
    beam_mistakes,
    grid_mistakes,
    model_mistakes,
    noise_mistakes,
)
from parity.mistakes.mapper import Mapper, World

MISTAKES: dict[str, type[Mapper]] = {
    mistake.name: mistake
    for group in (
        grid_mistakes.MISTAKES,
        beam_mistakes.MISTAKES,
        model_mistakes.MISTAKES,
        noise_mistakes.MISTAKES,
    )
    for mistake in group
}


def read_world(path: str) -> World:
    """The whole scenario in memory. Raises occgrid.scenario.ScenarioError where it breaks a rule."""
    with read_scenario(path) as scenario:
        return World(scenario.settings, scenario.walls, list(scenario.scans))
