"""The contract once more, as plain loops over floats: slow, and with nothing to get wrong.

The tests hold the array code to it, bit for bit.
"""

from __future__ import annotations

import math

from occgrid import portable_math
from occgrid.grid import OccupancyGrid
from occgrid.world import Pose, Segment


def sin(x: float) -> float:
    return float(portable_math.sin(x))


def cos(x: float) -> float:
    return float(portable_math.cos(x))


def bresenham(gx0: int, gy0: int, gx1: int, gy1: int) -> list[tuple[int, int]]:
    """The definition: SPEC.md section 2.4."""
    dx, dy = abs(gx1 - gx0), abs(gy1 - gy0)
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    err = dx - dy
    gx, gy = gx0, gy0
    cells = []
    while True:
        cells.append((gx, gy))
        if (gx, gy) == (gx1, gy1):
            return cells
        e2 = 2 * err
        if e2 > -dy:
            err -= dy
            gx += sx
        if e2 < dx:
            err += dx
            gy += sy


def simulate_lidar_scan(
    pose: Pose, walls: list[Segment], angles: list[float], z_max: float
) -> list[float]:
    ranges = []
    for angle in angles:
        a = pose.theta + angle
        rdx, rdy = cos(a), sin(a)
        best = z_max
        for x0, y0, x1, y1 in walls:
            sx, sy = x1 - x0, y1 - y0
            rxs = rdx * sy - rdy * sx
            if abs(rxs) < 1e-12:
                continue
            qpx, qpy = x0 - pose.x, y0 - pose.y
            t = (qpx * sy - qpy * sx) / rxs
            u = (qpx * rdy - qpy * rdx) / rxs
            if t >= 0 and 0 <= u <= 1 and t <= z_max and t < best:
                best = t
        ranges.append(best)
    return ranges


def update_grid_from_scan(
    grid: OccupancyGrid,
    pose: Pose,
    angles: list[float],
    ranges: list[float],
    z_max: float,
    no_return: str = "free",
) -> None:
    spec = grid.spec
    gx0 = math.floor((pose.x - spec.origin_x) / spec.resolution)
    gy0 = math.floor((pose.y - spec.origin_y) / spec.resolution)
    for angle, r in zip(angles, ranges, strict=True):
        if math.isnan(r):
            continue
        hit = r < z_max - 1e-12
        if not hit and no_return == "ignore":
            continue
        z = r if hit else z_max
        a = pose.theta + angle
        gx1 = math.floor(
            ((pose.x + z * cos(a)) - spec.origin_x) / spec.resolution
        )
        gy1 = math.floor(
            ((pose.y + z * sin(a)) - spec.origin_y) / spec.resolution
        )
        cells = bresenham(gx0, gy0, gx1, gy1)
        for gx, gy in cells[:-1] if hit else cells:
            grid.update_cell(gx, gy, grid.l_free)
        if hit:
            grid.update_cell(*cells[-1], grid.l_occ)
