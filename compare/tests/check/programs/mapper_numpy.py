"""A mapper for the lesson with NumPy, which updates all beams of a scan at once; the lesson is all that it knows.

usage: mapper_numpy.py BUG OUT         (without noise; BUG is a name, none for a right map)
"""

import sys
from pathlib import Path

import numpy as np

bug, out = sys.argv[1:]
W, H, RES, OX, OY, ZMAX = 220, 180, 0.1, -11.0, -9.0, 10.0
WALLS = np.array([
    (-10, -8, 10, -8), (10, -8, 10, 8), (10, 8, -10, 8), (-10, 8, -10, -8), (0, -6, 0, 6), (-8, 2, -2, 2),
], dtype=float)  # fmt: skip


def logit(p):
    return np.log(p / (1 - p))


def cast(x, y, angles):
    dx, dy = np.cos(angles)[:, None], np.sin(angles)[:, None]
    x0, y0, x1, y1 = WALLS.T
    sx, sy, qx, qy = x1 - x0, y1 - y0, x0 - x, y0 - y
    rxs = dx * sy - dy * sx
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (qx * sy - qy * sx) / rxs
        u = (qx * dy - qy * dx) / rxs
    meets = (np.abs(rxs) >= 1e-12) & (t >= 0) & (u >= 0) & (u <= 1)
    return np.minimum(np.where(meets, t, np.inf).min(axis=1), ZMAX)


def line(gx0, gy0, gx1, gy1):
    a = max(abs(gx1 - gx0), abs(gy1 - gy0))
    b = min(abs(gx1 - gx0), abs(gy1 - gy0))
    k = np.arange(a + 1)
    minor = (2 * k * b + a - 1) // max(2 * a, 1)
    if bug == "linspace":
        minor = np.rint(np.linspace(0, b, a + 1)).astype(int)
    sx, sy = (1 if gx0 < gx1 else -1), (1 if gy0 < gy1 else -1)
    along = abs(gx1 - gx0) >= abs(gy1 - gy0)
    dx, dy = (k, minor) if along else (minor, k)
    return gx0 + sx * dx, gy0 + sy * dy


log_odds = np.zeros((H, W))
occ, free = logit(0.75), logit(0.3)
bearings = np.linspace(-np.pi / 2, np.pi / 2, 181)
for t in range(120):
    ang = 2 * np.pi * (t / 120)
    x, y, theta = -6 + 6 * np.cos(ang), 4 * np.sin(ang), ang + np.pi / 2
    ranges = cast(x, y, theta + bearings)
    if bug == "noise":
        ranges = np.clip(ranges + np.random.normal(0, 0.02, 181), 0, ZMAX)
    if bug == "own-noise":
        noise = np.random.default_rng(t).normal(0, 0.02, 181)
        ranges = np.clip(ranges + noise, 0, ZMAX)
    step = np.zeros((H, W))
    gx0, gy0 = int(np.floor((x - OX) / RES)), int(np.floor((y - OY) / RES))
    for a, z in zip(theta + bearings, ranges, strict=True):
        gx1 = int(np.floor((x + z * np.cos(a) - OX) / RES))
        gy1 = int(np.floor((y + z * np.sin(a) - OY) / RES))
        gx, gy = line(gx0, gy0, gx1, gy1)
        hit = z < ZMAX - 1e-12
        d = np.full(gx.size, free)
        if hit:
            d[-1] = occ
        inside = (gx >= 0) & (gx < W) & (gy >= 0) & (gy < H)
        if bug == "fancy-index":  # adds once for each cell, in the whole scan
            step[gy[inside], gx[inside]] = d[inside]
        else:
            gx, gy, d = gx[inside], gy[inside], d[inside]
            log_odds[gy, gx] = np.clip(log_odds[gy, gx] + d, -8, 8)
    if bug == "fancy-index":
        log_odds = np.clip(log_odds + step, -8, 8)
p = 1 / (1 + np.exp(-log_odds))
pixels = np.floor((1 - p) * 255 + 0.5).astype(int)[::-1]
if bug == "index-error":
    print(pixels[H, W])
rows = [" ".join(map(str, row)) for row in pixels.tolist()]
Path(out, "lesson.pgm").write_text(
    "\n".join(["P2", f"{W} {H}", "255", *rows]) + "\n"
)
