"""Other formulas that right programs use, and the cells in which beams start and end with them.

The contract fixes one formula for each step. A program may take another one that is as right: it may add up its
headings, count bearings in degrees, or turn beams by a rotation matrix. The last bits of its coordinates then differ,
and a beam that ends on a cell edge may end on the other side.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from occgrid_parity.model.arithmetic import PLATFORM, PORTABLE, Arithmetic
from occgrid_parity.model.array_types import Array

PI = math.pi
TURN = 2.0 * PI


class Formulas(NamedTuple):
    """One formula for each step, as a key of its table (CHOICES); these are the contract's."""

    heading: str = "2 pi (t / n)"
    bearing: str = "-fov / 2 + (fov i) / (n - 1)"
    seen: str = "heading + bearing"
    drawn: str = "heading + bearing"
    distance: str = "a quotient of cross products"
    cell: str = "(x - origin) / resolution"
    functions: str = "the reference's"


def added_up(first: Array, step: float, count: int) -> Array:
    """first, first + step, first + step + step, ...: (..., count) for each of the first ones (..., 1)."""
    steps = np.full((*first.shape[:-1], count - 1), step)
    return np.add.accumulate(np.concatenate([first, steps], axis=-1), axis=-1)


HEADINGS: Mapping[str, Callable[[Array], Array]] = {
    "2 pi (t / n)": lambda t: TURN * (t / t.size),
    "(2 pi t) / n": lambda t: TURN * t / t.size,
    "t (2 pi / n)": lambda t: t * (TURN / t.size),
    "added up": lambda t: added_up(np.zeros(1), TURN / t.size, t.size),
    "degrees, times pi, over 180": lambda t: (360.0 / t.size * t) * PI / 180.0,
    "degrees, times pi / 180": lambda t: (360.0 / t.size * t) * (PI / 180.0),
}
"""The lesson's angles on its ellipse, of the numbers t of the scans (n,)."""


def _degrees(fov: float, i: Array) -> Array:
    wide = math.degrees(fov)
    return -wide / 2.0 + i * (wide / (i.size - 1.0))


BEARINGS: Mapping[str, Callable[[float, Array], Array]] = {
    "-fov / 2 + (fov i) / (n - 1)": lambda fov, i: (
        -fov / 2.0 + fov * i / (i.size - 1.0)
    ),
    "-fov / 2 + i (fov / (n - 1))": lambda fov, i: (
        -fov / 2.0 + i * (fov / (i.size - 1.0))
    ),
    "-fov / 2 + fov (i / (n - 1))": lambda fov, i: (
        -fov / 2.0 + fov * (i / (i.size - 1.0))
    ),
    "added up": lambda fov, i: added_up(
        np.full(1, -fov / 2.0), fov / (i.size - 1.0), i.size
    ),
    "degrees, times pi, over 180": lambda fov, i: _degrees(fov, i) * PI / 180,
    "degrees, times pi / 180": lambda fov, i: _degrees(fov, i) * (PI / 180.0),
    "(i - (n - 1) / 2) (fov / (n - 1))": lambda fov, i: (
        (i - (i.size - 1.0) / 2.0) * (fov / (i.size - 1.0))
    ),
    "(i / (n - 1) - 1 / 2) fov": lambda fov, i: (
        (i / (i.size - 1.0) - 0.5) * fov
    ),
}
"""Bearings of simulated beams, of the field of view and the numbers i of the beams (n,), n > 1."""


class Fan(NamedTuple):
    """The headings of scans (scans, 1) and the bearings of their beams (1 or scans, n), in radians."""

    theta: Array
    angles: Array
    numbers: Arithmetic

    def of(self, direction: Array) -> tuple[Array, Array]:
        """Cosines and sines."""
        return self.numbers.cos(direction), self.numbers.sin(direction)

    @property
    def sum(self) -> Array:
        return self.theta + self.angles


def _above(angle: Array) -> Array:
    """Less a whole turn where it is more than half a turn."""
    return np.where(angle > PI, angle - TURN, angle)


def _arctangent(fan: Fan) -> tuple[Array, Array]:
    cos, sin = fan.of(fan.sum)
    pairs = zip(
        sin.reshape(-1).tolist(), cos.reshape(-1).tolist(), strict=True
    )
    angle = np.array([math.atan2(s, c) for s, c in pairs])
    return fan.of(angle.reshape(cos.shape))


def _rotation(fan: Fan) -> tuple[Array, Array]:
    c, s = fan.of(fan.theta)
    cos, sin = fan.of(fan.angles)
    return c * cos - s * sin, s * cos + c * sin


def _from_first(fan: Fan) -> tuple[Array, Array]:
    first = fan.angles[..., :1]
    return fan.of((fan.theta + first) + (fan.angles - first))


def _added_from_first(fan: Fan) -> tuple[Array, Array]:
    n = fan.angles.shape[-1]
    if n == 1:
        return fan.of(fan.sum)
    wide = float(fan.angles[0, -1]) - float(fan.angles[0, 0])
    first = fan.theta + fan.angles[..., :1]
    return fan.of(added_up(first, wide / (n - 1.0), n))


Directions = Callable[[Fan], tuple[Array, Array]]

DIRECTIONS: Mapping[str, Directions] = {
    "heading + bearing": lambda fan: fan.of(fan.sum),
    "the remainder of heading + bearing by 2 pi": lambda fan: fan.of(
        np.fmod(fan.sum, TURN)
    ),
    "the positive remainder of heading + bearing by 2 pi": lambda fan: fan.of(
        np.mod(fan.sum, TURN)
    ),
    "atan2 of the sine and cosine of heading + bearing": _arctangent,
    "heading + bearing, less 2 pi where above pi": lambda fan: fan.of(
        _above(fan.sum)
    ),
    "heading, less 2 pi where above pi, + bearing": lambda fan: fan.of(
        _above(fan.theta) + fan.angles
    ),
    "a rotation matrix": _rotation,
    "the first beam's direction + i steps": _from_first,
    "the first beam's direction, and steps added up": _added_from_first,
}
"""Cosine and sine of the directions of beams in the world."""

TURNED_POINTS = "ends turned by a rotation matrix"
"""Ends in the robot's frame that are turned as points: for the beams on the map only."""

DISTANCES = (
    "a quotient of cross products",
    "along x or y",
    "a share of the maximum range",
)
"""How the distance to a wall is found: by the quotient of cross products; along x or y where the wall is parallel to
the other; as the share of a ray that is as long as the maximum range."""

CELLS: Mapping[str, Callable[[Array, float, float], Array]] = {
    "(x - origin) / resolution": lambda v, o, r: np.floor((v - o) / r),
    "x / resolution - origin / resolution": lambda v, o, r: np.floor(
        v / r - o / r
    ),
}
"""The cell of a coordinate v, of the grid's origin o and resolution r.

The difference of quotients is as right as the quotient only for coordinates with rounding errors of their own. A pose
from a file has none: exactly on a cell edge, the difference can give the cell beside it, which is the mistake
index-by-difference.
A product with 1 / resolution draws nothing else on the lesson's grid, where that is exactly 10.
"""

FUNCTIONS: Mapping[str, Arithmetic] = {
    "the reference's": PORTABLE,
    "this machine's": PLATFORM,
}

CHOICES: Mapping[str, tuple[str, ...]] = {
    "heading": tuple(HEADINGS),
    "bearing": tuple(BEARINGS),
    "seen": tuple(DIRECTIONS),
    "drawn": (*DIRECTIONS, TURNED_POINTS),
    "distance": DISTANCES,
    "cell": tuple(CELLS),
    "functions": tuple(FUNCTIONS),
}
"""The formulas of each step."""

STEPS: Mapping[str, str] = {
    "heading": "the robot's angle on the ellipse",
    "bearing": "bearings",
    "seen": "directions in which ranges are simulated",
    "drawn": "directions of beams on the map",
    "distance": "distance to a wall",
    "cell": "cells",
    "functions": "sine and cosine",
}
"""What each formula computes."""


def other_formulas(formulas: Formulas) -> list[str]:
    """Those that are not the contract's, as ``bearings: added up``."""
    contract = Formulas()._asdict()
    return [
        f"{STEPS[step]}: {name}"
        for step, name in formulas._asdict().items()
        if name != contract[step]
    ]
