"""Doubles: their bits, and arithmetic on them that rounds once.

Sums, products, quotients and roots are computed without error, as fractions,
and rounded to a double at the end. So no processor, compiler or library has
a say in a vector. Python rounds a fraction correctly, to nearest, ties to even.
"""

from __future__ import annotations

import math
import struct
from fractions import Fraction

PI = 3.141592653589793
TWO_PI = 6.283185307179586
HALF_PI = 1.5707963267948966
INFINITY = math.inf
NAN = math.nan

# 53 bits of a root and as many more that no tie can hide among
ROOT_BITS = 160


def bits_of(value: float) -> int:
    """The double's 64 bits as a whole number; every NaN has the same."""
    if math.isnan(value):
        return 0x7FF8000000000000
    return int(struct.unpack(">Q", struct.pack(">d", value))[0])


def double(bits: int) -> float:
    """The double with these 64 bits."""
    return float(struct.unpack(">d", struct.pack(">Q", bits))[0])


def hexadecimal(value: float) -> str:
    """The double as it stands in a file of vectors."""
    return f"{bits_of(value):016x}"


def beside(value: float, ulps: int = 1) -> list[float]:
    """The double and its neighbours, in ascending order."""
    below, above = [value], [value]
    for _ in range(ulps):
        below.append(math.nextafter(below[-1], -INFINITY))
        above.append(math.nextafter(above[-1], INFINITY))
    return [*reversed(below[1:]), *above]


def nearest(exact: Fraction) -> float:
    """The double nearest to a number."""
    return exact.numerator / exact.denominator


def add(x: float, y: float) -> float:
    """x + y. A sum that is zero has the sign that IEEE 754 gives it."""
    exact = Fraction(x) + Fraction(y)
    if exact:
        return nearest(exact)
    both_negative = math.copysign(1, x) == math.copysign(1, y) == -1
    return -0.0 if both_negative else 0.0


def sub(x: float, y: float) -> float:
    """x - y."""
    return add(x, -y)


def mul(x: float, y: float) -> float:
    """x * y. A product that is zero keeps the sign of its factors."""
    size = nearest(abs(Fraction(x) * Fraction(y)))
    return math.copysign(size, math.copysign(1, x) * math.copysign(1, y))


def div(x: float, y: float) -> float:
    """x / y, for a y that is not zero."""
    size = nearest(abs(Fraction(x) / Fraction(y)))
    return math.copysign(size, math.copysign(1, x) * math.copysign(1, y))


def root(x: float) -> float:
    """The square root of an x that is not negative."""
    scaled = Fraction(x) * 4**ROOT_BITS
    below = math.isqrt(math.floor(scaled))
    # a root that is not exact lies between two whole numbers: half of one more is as good as all its digits
    exact = below * below == scaled
    return nearest(Fraction(2 * below + (not exact), 2 * 2**ROOT_BITS))
