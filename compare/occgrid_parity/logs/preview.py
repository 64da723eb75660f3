"""Draws the map of a scenario, a pixel for each cell, as any port would draw it."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from PIL import Image

from occgrid.fast import map_scenario_fast
from occgrid.map_writer import pixel
from occgrid.scenario import read_scenario

ROWS_OF_CELLS = 1 << 16


def check_picture_name(picture: Path) -> None:
    """Raises ValueError where no picture can have that name."""
    kinds = Image.registered_extensions()
    if kinds.get(picture.suffix.lower()) not in Image.SAVE:
        raise ValueError(
            f"--preview {str(picture)!r}: its ending is no kind of picture; use .png"
        )


def draw_preview(scenario: Path, picture: Path) -> None:
    """Maps the scenario and writes the picture whole or not at all.

    Raises occgrid.scenario.ScenarioError where the scenario breaks a rule, and OSError, its filename the
    picture, where it cannot be written.
    """
    with read_scenario(scenario) as opened:
        grid = map_scenario_fast(opened, None)
    height, width = grid.log_odds.shape
    pixels = np.empty((height, width), dtype=np.uint8)
    rows = max(ROWS_OF_CELLS // width, 1)  # all at once take 17 times the grid
    for low in range(0, height, rows):
        pixels[low : low + rows] = pixel(grid.log_odds[low : low + rows])
    kind = Image.registered_extensions()[picture.suffix.lower()]
    part = picture.with_name(f".{picture.name}.{os.getpid()}.part")
    try:
        Image.fromarray(pixels[::-1]).save(part, format=kind)
        part.replace(picture)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(picture)) from error
    finally:
        part.unlink(missing_ok=True)
