"""The switch: the lesson drawn with another library's sin, cos and log, and with its angles written another way."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from occgrid import portable_math, sensor
from occgrid.fast import update_grid_from_scans
from occgrid.lesson import lesson_settings, lesson_world
from occgrid.map_writer import pixel
from occgrid.portable_math import pi
from occgrid.sensor import Scan
from occgrid.world import Pose, simulate_lidar_scan
from occgrid_handouts.lesson_run import Beams, lesson_beams
from occgrid_handouts.platform_math import Measured
from occgrid_handouts.writings import Writing

Array = npt.NDArray[np.float64]
Function = Callable[[npt.ArrayLike], Array]
Endpoints = tuple[Array, Array]


@dataclass(frozen=True)
class Drawn:
    """The lesson as one program draws it."""

    name: str
    log_odds: Array
    pixels: npt.NDArray[np.int64]
    beams: Beams


def lesson_arguments(
    writings: Sequence[Writing], log_odds: Array
) -> dict[str, Array]:
    """Every argument of sin, cos, exp and log in the lesson, noise-free."""
    angles = np.unique(np.concatenate([w.angles() for w in writings]))
    settings = lesson_settings()
    given = (settings.p0, settings.p_occ, settings.p_free)
    return {
        "sin": angles,
        "cos": angles,
        "exp": np.unique(-np.abs(log_odds)),
        "log": np.array([p / (1.0 - p) for p in given]),
    }


def draw(
    name: str,
    writing: Writing,
    measured: Measured | None = None,
    arguments: Mapping[str, Array] | None = None,
    only: Sequence[str] = ("sin", "cos", "log"),
    fused: bool = False,
) -> Drawn:
    """Maps the lesson noise-free.

    With ``measured``, its functions named in ``only`` take the place of portable_math's; ``arguments`` is where it was
    measured. ``fused`` rounds once where the contract multiplies and adds in the beams' ends.
    """
    own = {}
    if measured is not None and arguments is not None:
        own = {
            function: looked_up(
                arguments[function], measured.results[function]
            )
            for function in only
        }
    settings, walls = lesson_settings(), lesson_world()
    ends = {"beam_endpoints": _fused_ends} if fused else {}
    with swapped(portable_math, own), swapped(sensor, ends):
        scans = []
        for turn in writing.turns.tolist():
            x = -6.0 + 6.0 * float(portable_math.cos(turn))
            y = 0.0 + 4.0 * float(portable_math.sin(turn))
            pose = Pose(x, y, turn + pi / 2.0)
            ranges = simulate_lidar_scan(
                pose, walls, writing.bearings, settings.max_range
            )
            scans.append(Scan(pose, writing.bearings, ranges))
        grid = settings.new_grid()
        update_grid_from_scans(
            grid, scans, settings.max_range, settings.no_return
        )
        beams = lesson_beams(scans)
    return Drawn(name, grid.log_odds, pixel(grid.log_odds), beams)


def looked_up(arguments: Array, results: Array) -> Function:
    """A function that knows its results at some arguments (sorted), and fails at any other."""
    order = np.argsort(arguments)
    known, values = arguments[order], results[order]

    def function(x: npt.ArrayLike) -> Array:
        x = np.asarray(x, dtype=np.float64)
        at = np.minimum(np.searchsorted(known, x), known.size - 1)
        if not np.array_equal(known[at], x):
            raise KeyError("an argument that was not measured")
        return np.asarray(values[at])

    return function


@contextmanager
def swapped(module: object, own: Mapping[str, object]) -> Iterator[None]:
    """A module with some of its names swapped, as long as this lasts."""
    kept = {name: getattr(module, name) for name in own}
    try:
        for name, function in own.items():
            setattr(module, name, function)
        yield
    finally:
        for name, function in kept.items():
            setattr(module, name, function)


def _fused_ends(
    x: Array, y: Array, theta: Array, angles: Array, z: Array
) -> Endpoints:
    """beam_endpoints with one rounding where there are two, as a fused multiply-add has it."""
    beam = theta + angles
    cosine, sine = portable_math.cos(beam), portable_math.sin(beam)
    return _multiply_add(z, cosine, x), _multiply_add(z, sine, y)


def _multiply_add(a: Array, b: Array, c: Array) -> Array:
    exact = [
        Fraction(p) * Fraction(q) + Fraction(r)
        for p, q, r in zip(a.tolist(), b.tolist(), c.tolist(), strict=True)
    ]
    return np.array(list(map(float, exact)))
