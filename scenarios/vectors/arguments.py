"""The arguments of the vectors: edges, ties and neighbours, then a few random ones.

Rows are in the order of the file's input columns. Random ones have a fixed seed.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from decimal import Decimal, getcontext
from fractions import Fraction

from definitions import P_HIGH, P_LOW, philox
from exact import (
    HALF_PI,
    INFINITY,
    NAN,
    PI,
    add,
    beside,
    double,
    mul,
    nearest,
    sub,
)

getcontext().prec = 80
EXACT_PI = Fraction(
    "3.14159265358979323846264338327950288419716939937510582097494459230781640"
)
EXACT_LN2 = Fraction(Decimal(2).ln())

SMALLEST = 5e-324
LARGEST_SUBNORMAL = double(0x000FFFFFFFFFFFFF)
SMALLEST_NORMAL = double(0x0010000000000000)
LARGEST = double(0x7FEFFFFFFFFFFFFF)
SPECIAL = [
    0.0,
    SMALLEST,
    LARGEST_SUBNORMAL,
    SMALLEST_NORMAL,
    LARGEST,
    INFINITY,
]

# the double that lies nearest to a multiple of pi/2, among all doubles
NEAREST_TO_PI_HALVES = mul(6381956970095103.0, 2.0**797)
EAST, NORTH = 10_000_000.0, -10_000_000.0  # the limits of a coordinate
LONGEST = 1 << 20  # the steps of the longest line


def _both_signs(values: Iterable[float]) -> list[float]:
    return [signed for value in values for signed in (value, -value)]


def _without_twins(values: Iterable[float]) -> list[float]:
    """The values in their order, each once; 0 and -0 are two."""
    return list({repr(value): value for value in values}.values())


def _around_words(words: Iterable[int]) -> list[float]:
    """First and last double with each upper word, and the ones outside."""
    found = []
    for word in words:
        first, after = word << 32, (word + 1) << 32
        found += [double(b) for b in (first - 1, first, after - 1, after)]
    return found


# --- portable_math ---------------------------------------------------------

# Found by search: the last bit of one coefficient of the polynomials decides
# the last bit of the result.
LAST_BIT_OF_SIN = "0x1.08cedc92a88e8p-1 0x1.2873f164d24b6p-1"
LAST_BIT_OF_COS = "0x1.94d5c83b60c77p-1 0x1.97103bfd4dba0p-1"
LAST_BIT_OF_EXP = "0x1.0b4b32fdd78fep-2 -0x1.44df5589806a0p-2"
LAST_BIT_OF_LOG = "0x1.6d73c9ffe11bcp+0 0x1.924b06d2c5a07p+0"
# ... and these show borders of log's formulas that lie elsewhere
BORDERS_OF_LOG = (
    "0x1.6a09b37559fbbp-1 0x1.851cafd1fb5e1p+997 0x0.141436fa421eep-1022 "
    "0x0.016dea8a0f23ep-1022"
)


def _doubles(text: str) -> list[float]:
    return [float.fromhex(word) for word in text.split()]


def angles() -> list[float]:
    """For sin and cos: branches of section 9.1 and 9.2, multiples of pi/2."""
    source = random.Random(1)
    values = _both_signs([*SPECIAL, *beside(2.0**-27), 2.0**-26, 0.1])
    values.append(NAN)
    words = [0x3FD33333, 0x3FE90000, 0x3FE921FB, 0x3FF921FB, 0x4002D97C]
    values += _both_signs(_around_words([*words, 0x413921FB]))
    for k in range(1, 35):  # section 9.1 has a table of the first 32
        near = beside(nearest(k * EXACT_PI / 2))
        values += near if k % 2 else [-value for value in near]
    for k in (1000, 2**19, 2**20 - 1, 2**20, 2**20 + 1, 10**9, 2**40, 2**52):
        values.append(nearest(k * EXACT_PI / 2))
        values.append(-nearest(k * EXACT_PI / 4))
    values += [1e6, -1e6, 1e11, 2.0**53, 1e22, -1e300, 2.0**1023]
    values += _both_signs([NEAREST_TO_PI_HALVES])
    values += [source.uniform(-7, 7) for _ in range(24)]
    values += [
        math.ldexp(source.uniform(-2, 2), e) for e in range(1, 1000, 49)
    ]
    # every digit of 2/pi that a double can meet, and one, two and three
    # digits of the angle
    for i, e in enumerate(range(24, 1024, 11)):
        bits = (24, 48, 53)[i % 3]
        digits = source.getrandbits(bits - 1) | 1 << (bits - 1)
        values.append((-1) ** i * math.ldexp(digits, e - bits))
    values += _doubles(LAST_BIT_OF_SIN) + _doubles(LAST_BIT_OF_COS)
    return _without_twins(values)


def exponents() -> list[float]:
    """For exp: multiples of ln 2 and the halves between them, overflow, underflow."""
    source = random.Random(2)
    values = _both_signs([*SPECIAL, *beside(2.0**-28), 2.0**-27, 1.0])
    values.append(NAN)
    words = [0x3E300000, 0x3FD62E42, 0x3FF0A2B2]
    values += _both_signs(_around_words(words))
    for k in range(1, 13):
        values += beside(nearest(k * EXACT_LN2))
        values += beside(-nearest((2 * k + 1) * EXACT_LN2 / 2))
        values.append(-nearest(k * EXACT_LN2))
        values.append(nearest((2 * k + 1) * EXACT_LN2 / 2))
    for k in (100, 1000, 1021, 1022, 1023, 1024, -1021, -1022, -1023, -1074):
        values.append(nearest(k * EXACT_LN2))
    values += beside(double(0x40862E42FEFA39EF), 2)  # the last that is finite
    values += beside(double(0xC0874910D52D3051), 2)  # the last that is not 0
    values += [-708.5, -720.25, -744.0, -745.0, 8.0, -8.0, 1000.0, -1000.0]
    values += [source.uniform(-20, 20) for _ in range(40)]
    values += [source.uniform(-745, 709) for _ in range(20)]
    values += _doubles(LAST_BIT_OF_EXP)
    return _without_twins(values)


def logarithm_arguments() -> list[float]:
    """For log: around 1 and powers of 2, the branches of section 9.4, odds."""
    source = random.Random(3)
    values = [*_both_signs(SPECIAL), NAN, -1.0, -0.5]
    values += beside(1.0, 3)
    for edge in (1.0 + 2.0**-20, 1.0 - 2.0**-20, 1.0 - 2.0**-21):
        values += beside(edge)
    for exponent in (0x3FE, 0x3FF, 0x400):
        for fraction in (0x6147A, 0x6A09C, 0x6B851):
            values += _around_words([exponent << 20 | fraction])
    for k in (-1074, -1073, -1050, -1023, -1022, -1000, -100, -30, -2, -1):
        values += [2.0**k, 3.0 * 2.0 ** (k - 1) if k > -1074 else 1e-320]
    for k in (1, 2, 10, 53, 500, 1023):
        values += beside(2.0**k)
    for percent in range(5, 100, 5):
        p = percent / 100
        values.append(p / (1 - p))
    values += [P_LOW, 1 / P_LOW, 0.5 / 4294967296.0]
    values += [(source.getrandbits(32) + 0.5) / 2.0**32 for _ in range(40)]
    values += [
        math.ldexp(source.uniform(1, 2), e) for e in range(-1020, 1020, 60)
    ]
    values += _doubles(LAST_BIT_OF_LOG) + _doubles(BORDERS_OF_LOG)
    return _without_twins(values)


# --- the grid --------------------------------------------------------------


def probabilities() -> list[float]:
    """For logit: the clamps of p, one half, round ones, random ones."""
    source = random.Random(4)
    values = [0.0, 1.0, 1e-300, 1e-12, sub(1.0, 2.0**-53)]
    for edge in (P_LOW, P_HIGH, 0.5):
        values += beside(edge, 3)
    values += [percent / 100 for percent in range(1, 100)]
    values += [1 / 3, 2 / 3, 0.196, 0.999, 0.9999999, 1e-6, 2e-9]
    values += [source.random() for _ in range(40)]
    return _without_twins(values)


def log_odds() -> list[float]:
    """For sigmoid: 0, the clamps that a scenario may set, multiples of ln 2."""
    source = random.Random(5)
    sizes = [0.0, SMALLEST, 1e-300, *beside(2.0**-28), 2.0**-53, 1e-9, 0.1]
    sizes += [1.0, *beside(8.0), 20.0, *beside(37.0), 100.0, 700.0, 709.0]
    sizes += [710.0, 720.0, 744.0, *beside(745.0), 746.0, 999.0, 1000.0]
    sizes += [nearest(k * EXACT_LN2 / 2) for k in range(1, 24)]
    sizes += [source.uniform(0, 10) for _ in range(30)]
    return _without_twins(_both_signs(sizes))


def pixel_log_odds() -> list[float]:
    """For pixel: where one pixel value becomes the next, and around it.

    That is where 1 - p = (n - 1/2) / 255, so at the logarithm of p / (1 - p).
    """
    values = [0.0, -0.0, 8.0, -8.0, 1000.0, -1000.0, 1e-300, -1e-300]
    values += [add(k, 0.0) / 4 for k in range(-24, 25)]
    for n in [1, 2, 3, *range(8, 249, 8), 127, 128, 129, 253, 254, 255]:
        free = Fraction(2 * n - 1, 510)
        odds = (1 - free) / free
        quotient = Decimal(odds.numerator) / Decimal(odds.denominator)
        values += beside(nearest(Fraction(quotient.ln())), 2)
    return _without_twins(values)


def points() -> list[tuple[float, float, float, float, float]]:
    """For world_to_grid: resolution, origin_x, origin_y, x, y."""
    source = random.Random(6)
    rows = []
    for resolution, origin_x, origin_y in (
        (0.1, -11.0, -9.0),
        (0.1, -11.0329, -9.0406),
        (0.05, 0.0, -0.05),
        (0.3, 0.1, -0.7),
        (1.0, 0.0, 0.0),
        (0.001, 4_000_000.0, EAST),
        (0.001, NORTH, 31.25),
        (1000.0, NORTH, EAST),
    ):
        for k in (0, 1, 7, 110, 179):  # corners of cells, and just beside
            x = add(origin_x, mul(float(k), resolution))
            y = add(origin_y, mul(float(k + 3), resolution))
            near_x, near_y = beside(x), beside(y)
            for x, y in zip(near_x, reversed(near_y), strict=True):
                rows.append((resolution, origin_x, origin_y, x, y))
        rows.append((resolution, origin_x, origin_y, EAST, NORTH))
        rows.append((resolution, origin_x, origin_y, NORTH, EAST))
        for _ in range(6):
            x, y = (source.uniform(-30, 30) for _ in range(2))
            rows.append((resolution, origin_x, origin_y, x, y))
    for x, y in (
        (-1e-300, 1e-300),
        (SMALLEST, -SMALLEST),
        (-LARGEST_SUBNORMAL, -SMALLEST_NORMAL),
        (0.0, -0.0),
    ):
        rows.append((0.001, 0.0, 0.0, x, y))
        rows.append((1000.0, 0.0, 0.0, x, y))
        rows.append((0.1, EAST, NORTH, x, y))
    return rows


def updates() -> list[tuple[float, float, float, float, float, str]]:
    """For update_cell: p0, p_occ, p_free, l_min, l_max and the updates."""
    source = random.Random(7)
    models = [
        (0.5, 0.75, 0.3, -8.0, 8.0),  # the lesson's
        (0.5, 0.8, 0.2, -8.0, 8.0),
        (0.5, 0.7, 0.4, -2.0, 3.5),
        (0.7, 0.75, 0.3, -8.0, 8.0),  # a prior that is not one half
        (0.15, 0.6, 0.05, -5.0, 5.0),
        (0.5, 0.3, 0.75, -8.0, 8.0),  # signs reversed
        (0.4, 0.4, 0.4, -1.0, 1.0),  # nothing is learned
        (0.5, 0.9999999999, 1e-10, -1000.0, 1000.0),  # beyond both limits of p
        (0.5, 0.9, 0.1, 0.0, 2.0),  # the prior at a clamp
        (0.5, 0.9, 0.1, -2.0, 0.0),
        (0.9, 0.95, 0.91, 1.0, 3.0),  # every value positive
        (0.5, 0.99, 0.01, -0.001, 0.001),  # each update a clamp
    ]
    words = ["o", "f", "of", "fo", "ffffo", "ooooof", "ofofofofof"]
    words += ["o" * 40 + "f" * 7, "f" * 40 + "o" * 7, "o" * 9, "f" * 30]
    rows = [(*model, word) for model in models for word in words]
    for _ in range(60):
        model = source.choice(models)
        n = source.randint(3, 60)
        rows.append((*model, "".join(source.choice("off") for _ in range(n))))
    return rows


# --- lines -----------------------------------------------------------------


def lines() -> list[tuple[int, int, int, int]]:
    """For bresenham: all short ones, ties in all octants, a few long ones."""
    source = random.Random(8)
    rows = [
        (2, 5, 2 + dx, 5 + dy) for dx in range(-3, 4) for dy in range(-3, 4)
    ]
    for dx, dy in ((8, 4), (9, 3), (7, 5), (6, 0), (11, 10), (12, 1), (10, 2)):
        for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            rows.append((-4, 3, -4 + sx * dx, 3 + sy * dy))
            rows.append((4, -3, 4 + sx * dy, -3 + sy * dx))
    for _ in range(60):
        x, y = source.randint(-100, 100), source.randint(-100, 100)
        dx, dy = source.randint(-25, 25), source.randint(-25, 25)
        rows.append((x, y, x + dx, y + dy))
    for far in (2**31 - 3, -(2**31) - 3, 2 * 10**10, -2 * 10**10):
        rows.append((far, -far, far + 9, 4 - far))
        rows.append((-far, far, -far - 3, far - 6))
    rows += [
        (0, 0, 300, 200),
        (10, -7, -150, 293),
        (0, 0, -999, 1),
        (5, 5, 5, -995),
    ]
    return list(dict.fromkeys(rows))


def clipped_lines() -> list[tuple[int, int, int, int, int, int]]:
    """For clip_ray: lines within, into, out of, across and past a grid."""
    source = random.Random(9)
    width, height = 8, 5
    rows = [
        (2, 2, 2, 2, width, height),  # one cell, inside
        (8, 2, 8, 2, width, height),  # one cell, outside
        (-1, -1, -1, -1, width, height),
        (0, 0, 7, 4, width, height),  # corner to corner
        (7, 4, 0, 0, width, height),
        (3, 1, 6, 2, width, height),  # within
        (3, 1, 30, 2, width, height),  # out of each side
        (3, 1, -20, 2, width, height),
        (3, 1, 4, 40, width, height),
        (3, 1, 2, -40, width, height),
        (30, 2, 3, 1, width, height),  # in from each side
        (-20, 2, 3, 1, width, height),
        (4, 40, 3, 1, width, height),
        (2, -40, 3, 1, width, height),
        (-10, 2, 20, 3, width, height),  # across
        (4, 30, 3, -30, width, height),
        (-3, -3, 12, 12, width, height),
        (-10, 0, 20, 0, width, height),  # along an edge, and past it
        (-10, -1, 20, -1, width, height),
        (-10, 4, 20, 4, width, height),
        (-10, 5, 20, 5, width, height),
        (0, -9, 0, 9, width, height),
        (-1, -9, -1, 9, width, height),
        (7, 9, 7, -9, width, height),
        (8, 9, 8, -9, width, height),
        (-5, 0, 5, -10, width, height),  # past a corner
        (-4, 4, 0, 0, width, height),
        (-1, 1, 1, -1, width, height),
        (7, 5, 8, 4, width, height),
        (5, 7, 10, 2, width, height),
        (-6, 8, 4, 3, width, height),
        (3, -1, 4, -50, width, height),  # beside it and away from it
        (9, 3, 60, 4, width, height),
        (0, 0, 9, 4, 1, 1),  # a grid of one cell
        (-2, -1, 2, 1, 1, 1),
        (-2, -1, 2, 2, 1, 1),
        (-9, 0, 9, 0, 1, 1),
        (-7, 0, 999, 0, 25_000_000, 1),  # the widest and the highest grid
        (0, 999, 0, -9, 1, 25_000_000),
    ]
    for dx, dy in (  # the longest lines, in every direction
        (LONGEST, 0),
        (LONGEST, 1),
        (LONGEST, LONGEST // 2),
        (LONGEST, LONGEST - 1),
        (LONGEST, LONGEST),
    ):
        rows.append(
            (
                -LONGEST // 2,
                -dy // 2,
                dx - LONGEST // 2,
                dy - dy // 2,
                3000,
                3000,
            )
        )
        rows.append(
            (dy // 2, LONGEST // 2, dy // 2 - dy, LONGEST // 2 - dx, 900, 2000)
        )
        rows.append((dx, dy, 0, 0, 1_000_000, 25))
    for far in (2**31, 2 * 10**10, -2 * 10**10):  # far from the grid
        rows.append((far, far, far + 12, far - 7, 4000, 3000))
    rows.append((2**31 - 9, 4, 2**31 + 9, 4, 25_000_000, 1))
    for _ in range(60):  # ties: the one extent is half of the other
        x, y = source.randint(-9, 16), source.randint(-9, 13)
        half = source.randint(-9, 9)
        rows.append(
            (
                x,
                y,
                x + 2 * half,
                y + source.choice((-half, half)),
                width,
                height,
            )
        )
    for _ in range(120):
        x, y = source.randint(-14, 22), source.randint(-14, 19)
        rows.append(
            (
                x,
                y,
                x + source.randint(-24, 24),
                y + source.randint(-24, 24),
                width,
                height,
            )
        )
    return list(dict.fromkeys(rows))


# --- the sensor ------------------------------------------------------------


def flaser_beams() -> list[tuple[int, int]]:
    """For flaser_angles: n_beams and beam."""
    rows = []
    for n in (1, 2, 3, 4, 90, 179, 180, 181, 182, 359, 360, 361, 362, 399,
              400, 401, 402, 541, 682, 720, 721, 1081, 99_999, 100_000):  # fmt: skip
        beams = {0, 1, 2, 3, 7, n // 3, n // 2, n - 3, n - 2, n - 1, 90, 180}
        rows += [(n, beam) for beam in sorted(beams) if 0 <= beam < n]
    return rows


def ranges() -> list[tuple[float, float, str]]:
    """For read_ranges: range, z_max, no_return."""
    rows = []
    # from 8192 on a double's neighbour is farther than 1e-12
    for z_max in (0.001, 1.0, 10.0, 81.91, 4095.9, 5000.0, 8192.0, 10_000.0):
        edge = sub(z_max, 1e-12)
        values = [0.0, 1e-300, z_max / 2, *beside(edge), *beside(z_max)]
        values += [z_max + 1, LARGEST, INFINITY, NAN]
        for value in _without_twins(values):
            rows += [(value, z_max, "free"), (value, z_max, "ignore")]
    return rows


def beams() -> list[tuple[float, float, float, float, float]]:
    """For beam_endpoints: x, y, theta, angle, z."""
    source = random.Random(10)
    rows = []
    for quarter in range(-4, 5):  # along the axes, and between them
        theta = mul(float(quarter), HALF_PI)
        rows.append((0.0, 0.0, theta, 0.0, 10.0))
        rows.append((-6.0, 4.0, theta, HALF_PI, 8.0))
        rows.append((0.5, 0.5, 0.0, theta, 1.0))
        rows.append((1.5, -2.5, theta, PI / 4, 2.5))
    for theta, angle in (  # a sum that rounds, that cancels, and large ones
        (1e6, 1e-9),
        (-1e6, 1e6),
        (PI, -PI),
        (PI, nearest(EXACT_PI - Fraction(PI))),
        (0.1, 0.2),
        (1e6, 1e6),
        (-1e6, 1e11),
        (1647099.0, 0.25),
        (3.0, 99999e6),
    ):
        rows += [(1.0, 2.0, theta, angle, z) for z in (1.0, 9.75, 10_000.0)]
    for z in (0.0, 1e-300, SMALLEST, 1e-16, 9.999999999999, 10_000.0):
        rows += [(0.0, 0.0, 0.75, 0.5, z), (-3.0, 1e-17, 2.0, 2.5, z)]
        rows += [(EAST, NORTH, -1.25, 0.3, z), (NORTH, EAST, HALF_PI, 0.0, z)]
    for t in range(0, 120, 5):  # the lesson's poses and bearings
        turn = mul(2 * PI, t / 120)
        angle = add(-HALF_PI, mul(PI, float(t)) / 180)
        rows.append((-6.0, t / 30 - 2, add(turn, HALF_PI), angle, 10.0))
    for _ in range(60):
        x, y = (source.uniform(-50, 50) for _ in range(2))
        theta, angle = source.uniform(-7, 7), source.uniform(-2, 2)
        rows.append((x, y, theta, angle, source.uniform(0, 30)))
    return rows


# --- the noise -------------------------------------------------------------


def philox_words() -> list[tuple[int, int, int, int, int, int]]:
    """For philox: the published ones, as the noise uses it, random ones."""
    source = random.Random(11)
    full = 0xFFFFFFFF
    rows = [
        (0, 0, 0, 0, 0, 0),
        (full, full, full, full, full, full),
        (
            0x243F6A88,
            0x85A308D3,
            0x13198A2E,
            0x03707344,
            0xA4093822,
            0x299F31D0,
        ),
    ]
    for place in range(6):
        for word in (1, 0x80000000, full):
            rows.append(tuple(word if i == place else 0 for i in range(6)))  # type: ignore[arg-type]
    rows += [
        (scan, beam, 0, 0, 7, 0) for scan in range(6) for beam in range(6)
    ]
    for _ in range(140):
        rows.append(tuple(source.getrandbits(32) for _ in range(6)))  # type: ignore[arg-type]
    return rows


def deviates() -> list[tuple[int, int, int]]:
    """For normal_deviate: seed, scan, beam.

    Among the deviates of two seeds, those whose words are the smallest and
    the largest: there log and cos are at their limits.
    """
    source = random.Random(12)
    full = 0xFFFFFFFF
    rows = [(0, scan, beam) for scan in range(5) for beam in range(8)]
    rows += [(7, 119, beam) for beam in (0, 1, 90, 179, 180)]
    rows += [(seed, 3, 4) for seed in (1, 2**31 - 1, 2**31, full)]
    rows += [(42, scan, 4) for scan in (2**16, 2**31 - 1, 2**31, full)]
    rows += [(42, 3, beam) for beam in (255, 65_536, 99_999)]
    tried = [
        (seed, s, b) for seed in (0, 7) for s in range(60) for b in range(181)
    ]
    drawn = {row: philox((*row[1:], 0, 0), (row[0], 0)) for row in tried}
    by_first = sorted(tried, key=lambda row: drawn[row][0])
    by_second = sorted(tried, key=lambda row: drawn[row][1])
    for ordered in (by_first, by_second):
        rows += ordered[:5] + ordered[-5:]
    by_quarter = sorted(
        tried, key=lambda row: abs(drawn[row][1] % 2**31 - 2**30)
    )
    rows += by_quarter[:5]  # the cosine is nearly 0
    for _ in range(100):
        rows.append(
            (
                source.getrandbits(32),
                source.randrange(5000),
                source.randrange(1000),
            )
        )
    return rows
