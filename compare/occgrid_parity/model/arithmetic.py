"""sin, cos, exp and log: the contract's, or those of the machine at hand."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.noise import philox4x32
from occgrid_parity.model.array_types import Array

Function = Callable[[Array], Array]

TWO_PI = 6.283185307179586
U = 2.0**-52
"""One unit in the last place of 1."""


@dataclass(frozen=True)
class Arithmetic:
    """Four functions of arrays (n,)."""

    sin: Function
    cos: Function
    exp: Function
    log: Function


MANY = 1000


def _directions(beam: bytes, numbers: Arithmetic) -> tuple[Array, Array]:
    angles = np.frombuffer(beam, dtype=np.float64)
    found = numbers.cos(angles), numbers.sin(angles)
    for values in found:
        values.setflags(write=False)
    return found


# a beam takes 24 bytes
_directions_of_few = functools.lru_cache(4096)(_directions)
_directions_of_many = functools.lru_cache(128)(_directions)


def directions(beam: Array, numbers: Arithmetic) -> tuple[Array, Array]:
    """Cosines and sines of directions (n,); kept, since most mistakes have the same beams."""
    kept = _directions_of_few if beam.size < MANY else _directions_of_many
    return kept(beam.tobytes(), numbers)


def _each(function: Callable[[float], float]) -> Function:
    """A function of one number, applied to each."""

    def of_array(values: Array) -> Array:
        flat = map(function, values.reshape(-1).tolist())
        found = np.fromiter(flat, np.float64, values.size)
        return found.reshape(values.shape)

    return of_array


PORTABLE = Arithmetic(
    portable_math.sin, portable_math.cos, portable_math.exp, portable_math.log
)
PLATFORM = Arithmetic(
    _each(math.sin), _each(math.cos), _each(math.exp), _each(math.log)
)


def uniforms(
    seed: int,
    scans: npt.ArrayLike,
    beams: npt.ArrayLike,
    part: float = 0.5,
) -> tuple[Array, Array, Array, Array]:
    """The four words of each beam's noise as numbers between 0 and 1, (n,) each; a word w is (w + part) / 2^32.

    One of scans and beams may be a single number.
    """
    scan, beam = np.broadcast_arrays(
        np.asarray(scans, dtype=np.uint64), np.asarray(beams, dtype=np.uint64)
    )
    zero = np.zeros_like(beam)
    counter = np.stack([scan, beam, zero, zero])
    words = philox4x32(counter, (seed, 0)).astype(np.float64)
    first, second, third, fourth = (words + part) / 4294967296.0
    return first, second, third, fourth


def box_muller(u1: Array, u2: Array, numbers: Arithmetic) -> Array:
    """A normal deviate from two uniform ones."""
    return np.sqrt(-2.0 * numbers.log(u1)) * numbers.cos(TWO_PI * u2)


def normal_deviate(
    seed: int, scans: npt.ArrayLike, beams: npt.ArrayLike, numbers: Arithmetic
) -> Array:
    """SPEC.md section 3.3."""
    u1, u2, _, _ = uniforms(seed, scans, beams)
    return box_muller(u1, u2, numbers)
