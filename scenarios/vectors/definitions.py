"""The contract's functions, by the sections of SPEC.md, from exact arithmetic.

Each takes a list of argument rows and gives a list of result rows, so that
StrictMath is asked once for all of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from exact import HALF_PI, PI, TWO_PI, add, div, mul, root, sub
from strict_math import strict_math

P_LOW = 1e-9
P_HIGH = sub(1.0, 1e-9)


def logit(ps: Sequence[float]) -> list[float]:
    """Section 2.2: log(q / (1 - q)) of p clamped to [1e-9, 1 - 1e-9]."""
    clamped = [min(max(p, P_LOW), P_HIGH) for p in ps]
    return strict_math("log", [div(q, sub(1.0, q)) for q in clamped])


def sigmoid(log_odds: Sequence[float]) -> list[float]:
    """Section 2.2, in the form whose exp cannot overflow."""
    zs = strict_math("exp", [-abs(value) for value in log_odds])
    return [
        div(1.0, add(1.0, z)) if value >= 0 else div(z, add(1.0, z))
        for value, z in zip(log_odds, zs, strict=True)
    ]


def pixel(log_odds: Sequence[float]) -> list[int]:
    """Section 2.6: floor((1 - sigmoid) * 255 + 0.5)."""
    return [
        math.floor(add(mul(sub(1.0, p), 255.0), 0.5))
        for p in sigmoid(log_odds)
    ]


def world_to_grid(
    resolution: float, origin_x: float, origin_y: float, x: float, y: float
) -> tuple[int, int]:
    """Section 2.1: floor((x - origin) / resolution) along each axis."""
    gx = math.floor(div(sub(x, origin_x), resolution))
    gy = math.floor(div(sub(y, origin_y), resolution))
    return gx, gy


def bresenham(
    gx0: int, gy0: int, gx1: int, gy1: int
) -> Iterator[tuple[int, int]]:
    """Section 2.4: the cells of the line, by the walk with its error term."""
    dx, dy = abs(gx1 - gx0), abs(gy1 - gy0)
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    err, gx, gy = dx - dy, gx0, gy0
    while True:
        yield gx, gy
        if gx == gx1 and gy == gy1:
            return
        e2 = 2 * err
        if e2 > -dy:
            err, gx = err - dy, gx + sx
        if e2 < dx:
            err, gy = err + dx, gy + sy


def clip_ray(
    gx0: int, gy0: int, gx1: int, gy1: int, width: int, height: int
) -> tuple[int, int]:
    """The first and the last step of the line that lie in the grid.

    Found by walking the whole line; (0, -1) where no cell of it is inside.
    """
    first, last = 0, -1
    for k, (gx, gy) in enumerate(bresenham(gx0, gy0, gx1, gy1)):
        if 0 <= gx < width and 0 <= gy < height:
            if last < 0:
                first = k
            assert last < 0 or last == k - 1  # a line enters a grid once
            last = k
    return first, last


def flaser_angle(n_beams: int, beam: int) -> float:
    """Section 5.3: the bearing of a beam of a FLASER line."""
    if n_beams == 1:
        step = 0.0
    elif n_beams in (180, 181):
        step = div(PI, 180.0)
    elif n_beams in (360, 361):
        step = div(PI, 360.0)
    elif n_beams in (400, 401):
        step = div(PI, 720.0)
    else:
        step = div(PI, n_beams - 1.0)
    return add(-HALF_PI, mul(float(beam), step))


def read_range(
    value: float, z_max: float, no_return: str
) -> tuple[float, int, int]:
    """Section 2.3: the distance z, whether it is a hit, whether it is used."""
    hit = value < sub(z_max, 1e-12)
    z = value if hit else z_max
    used = hit or (no_return == "free" and not math.isnan(value))
    return z, int(hit), int(used)


def beam_endpoints(
    rows: Sequence[tuple[float, float, float, float, float]],
) -> list[tuple[float, float]]:
    """Section 2.3: (x + z * cos(a), y + z * sin(a)) with a = theta + angle."""
    bearings = [add(theta, angle) for _, _, theta, angle, _ in rows]
    cosines = strict_math("cos", bearings)
    sines = strict_math("sin", bearings)
    return [
        (add(x, mul(z, cosine)), add(y, mul(z, sine)))
        for (x, y, _, _, z), cosine, sine in zip(
            rows, cosines, sines, strict=True
        )
    ]


def update_cell(
    rows: Sequence[tuple[float, float, float, float, float, str]],
) -> list[float]:
    """Section 2.2: a cell from its prior through updates o (occupied) and f (free)."""
    ps = sorted({p for row in rows for p in row[:3]})
    log_odds_of = dict(zip(ps, logit(ps), strict=True))
    results = []
    for p0, p_occ, p_free, l_min, l_max, updates in rows:
        value = log_odds_of[p0]
        delta = {
            "o": sub(log_odds_of[p_occ], value),
            "f": sub(log_odds_of[p_free], value),
        }
        for update in updates:
            value = add(value, delta[update])
            if value > l_max:
                value = l_max
            elif value < l_min:
                value = l_min
        results.append(value)
    return results


def philox(
    counter: tuple[int, int, int, int], key: tuple[int, int]
) -> tuple[int, int, int, int]:
    """Section 3.3: Philox4x32-10 on whole numbers below 2^32."""
    c0, c1, c2, c3 = counter
    k0, k1 = key
    word = 0xFFFFFFFF
    for _ in range(10):
        product2, product0 = 0xCD9E8D57 * c2, 0xD2511F53 * c0
        c0, c1, c2, c3 = (
            (product2 >> 32) ^ c1 ^ k0,
            product2 & word,
            (product0 >> 32) ^ c3 ^ k1,
            product0 & word,
        )
        k0, k1 = (k0 + 0x9E3779B9) & word, (k1 + 0xBB67AE85) & word
    return c0, c1, c2, c3


def normal_deviate(rows: Sequence[tuple[int, int, int]]) -> list[float]:
    """Section 3.3: the deviate of each (seed, scan, beam)."""
    words = [
        philox((scan, beam, 0, 0), (seed, 0)) for seed, scan, beam in rows
    ]
    u1 = [div(add(float(w0), 0.5), 4294967296.0) for w0, _, _, _ in words]
    u2 = [div(add(float(w1), 0.5), 4294967296.0) for _, w1, _, _ in words]
    logs = strict_math("log", u1)
    cosines = strict_math("cos", [mul(TWO_PI, u) for u in u2])
    return [
        mul(root(mul(-2.0, log)), cosine)
        for log, cosine in zip(logs, cosines, strict=True)
    ]
