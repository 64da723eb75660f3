"""All mistakes, by name."""

from __future__ import annotations

from occgrid_parity.mistakes import (
    beam_mistakes,
    grid_mistakes,
    model_mistakes,
    noise_mistakes,
)
from occgrid_parity.model.mapper_steps import Mapper

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
