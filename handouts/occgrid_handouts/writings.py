"""The lesson's angles, as one writes them in one language or another."""

from __future__ import annotations

import math
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.lesson import lesson_settings
from occgrid.portable_math import pi
from occgrid.sensor import beam_angles
from occgrid_handouts.platform_math import search_path

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Writing:
    """Bearings (181,) of a scan and turns (120,) along the ellipse, radians."""

    name: str
    bearings: Array
    turns: Array

    def angles(self) -> Array:
        """Every angle whose sine and cosine the lesson asks for."""
        directions = (self.turns + pi / 2.0)[:, None] + self.bearings
        return np.unique(np.concatenate([self.turns, directions.ravel()]))


def contract_writing() -> Writing:
    """-fov/2 + fov*i/(n-1) and 2*pi*(t/120), as in C++ and Java."""
    settings = lesson_settings()
    turns = [(2.0 * pi) * (t / 120.0) for t in range(120)]
    bearings = beam_angles(settings.fov, settings.beams)
    return Writing("contract", bearings, np.array(turns))


def numpy_writing() -> Writing:
    """np.linspace, which is start + i*step."""
    fov = math.radians(180.0)
    bearings = np.linspace(-fov / 2.0, fov / 2.0, 181)
    return Writing("numpy", bearings, contract_writing().turns)


def octave_writing(programs: Path) -> Writing | None:
    """Octave's linspace and 2*pi*(t-1)/120; None where Octave is missing."""
    octave = shutil.which("octave-cli", path=search_path())
    if octave is None:
        return None
    done = subprocess.run(
        [octave, "--norc", "-q", str(programs / "lesson_angles.m")],
        capture_output=True,
        text=True,
        check=True,
    )
    values = np.array(list(map(float, done.stdout.split())))
    return Writing("octave", values[:181], values[181:])
