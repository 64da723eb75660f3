"""All mistakes, by name."""

from __future__ import annotations

from occgrid_parity.mistakes import (
    beam_mistakes,
    grid_mistakes,
    model_mistakes,
    noise_mistakes,
    reading_mistakes,
)
from occgrid_parity.model.mapper_steps import Mapper

MISTAKES: dict[str, type[Mapper]] = {
    mistake.name: mistake
    for group in (
        grid_mistakes.MISTAKES,
        beam_mistakes.MISTAKES,
        reading_mistakes.MISTAKES,
        model_mistakes.MISTAKES,
        noise_mistakes.MISTAKES,
    )
    for mistake in group
}


def only_noise(mistake: type[Mapper]) -> bool:
    """Whether the mistake changes nothing but steps that are not taken without a seed."""
    return mistake in noise_mistakes.MISTAKES
