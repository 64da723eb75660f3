"""All mistakes, by name."""

from __future__ import annotations

from occgrid.scenario import read_scenario
from occgrid_parity.mistakes import (
    beam_mistakes,
    grid_mistakes,
    model_mistakes,
    noise_mistakes,
)
from occgrid_parity.model.mapper_steps import Mapper, World

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


NOISE_STEPS = ("deviate", "noisy", "clip_range")


def only_noise(mistake: type[Mapper]) -> bool:
    """Whether the mistake changes nothing but steps that are not taken without a seed."""
    changed = {k for k, v in vars(mistake).items() if callable(v)}
    return bool(changed) and changed <= set(NOISE_STEPS)


def read_world(path: str) -> World:
    """The whole scenario in memory. Raises occgrid.scenario.ScenarioError where it breaks a rule."""
    with read_scenario(path) as scenario:
        return World(scenario.settings, scenario.walls, list(scenario.scans))
