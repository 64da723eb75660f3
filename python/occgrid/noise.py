"""Range noise that depends on nothing but the seed, the scan and the beam (SPEC.md section 3.3)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.portable_math import Array, pi

Words = npt.NDArray[np.uint64]


# [snippet: philox]
PHILOX_M0, PHILOX_M1 = np.uint64(0xD2511F53), np.uint64(0xCD9E8D57)
PHILOX_W0, PHILOX_W1 = 0x9E3779B9, 0xBB67AE85
LOW_WORD = np.uint64(0xFFFFFFFF)
WORD_BITS = np.uint64(32)


def philox4x32(counter: Words, key: tuple[int, int]) -> Words:
    """Philox4x32-10 (Salmon et al. 2011): four random words per counter.

    counter: (4, n) words below 2**32, a column each; key: two words.
    Returns (4, n) words below 2**32.
    """
    c0, c1, c2, c3 = counter
    k0, k1 = key
    for _ in range(10):
        product0 = PHILOX_M0 * c0
        product1 = PHILOX_M1 * c2
        c0 = (product1 >> WORD_BITS) ^ c1 ^ np.uint64(k0)
        c1 = product1 & LOW_WORD
        c2 = (product0 >> WORD_BITS) ^ c3 ^ np.uint64(k1)
        c3 = product0 & LOW_WORD
        k0 = (k0 + PHILOX_W0) & 0xFFFFFFFF
        k1 = (k1 + PHILOX_W1) & 0xFFFFFFFF
    return np.stack([c0, c1, c2, c3])


# [/snippet]


# [snippet: normal-deviate]
def normal_deviate(seed: int, scan: int, beam: npt.ArrayLike) -> Array:
    """Standard normal deviates (Box and Muller 1958) of a scan's beams.

    seed: 0 to 2**32 - 1; scan, beam: their numbers, from 0; beam (n,).
    Returns (n,).
    """
    c1 = np.asarray(beam, dtype=np.uint64)
    zero = np.zeros_like(c1)
    counter = np.stack([zero + np.uint64(scan), c1, zero, zero])
    w0, w1, _, _ = philox4x32(counter, (seed, 0)).astype(np.float64)
    u1 = (w0 + 0.5) / 4294967296.0
    u2 = (w1 + 0.5) / 4294967296.0
    radius = np.sqrt(-2.0 * portable_math.log(u1))
    return radius * portable_math.cos((2.0 * pi) * u2)


# [/snippet]


# [snippet: range-noise]
def add_range_noise(
    ranges: Array, noise_std: float, seed: int, scan: int, z_max: float
) -> Array:
    """Simulated ranges (n,) in metres with noise, within [0, z_max].

    A beam that met no wall gets noise too, as in the lesson.
    """
    deviates = normal_deviate(seed, scan, np.arange(ranges.size))
    noisy = ranges + noise_std * deviates
    return np.clip(noisy, 0.0, z_max)


# [/snippet]
