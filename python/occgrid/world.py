"""The simulated world: walls, ray casting, range scans (lesson section 6)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from occgrid import portable_math
from occgrid.portable_math import Array


class Pose(NamedTuple):
    """Where the robot (or its laser) stands: metres and radians."""

    x: float
    y: float
    theta: float


class Segment(NamedTuple):
    """A wall from (x0, y0) to (x1, y1), metres."""

    x0: float
    y0: float
    x1: float
    y1: float


# [snippet: box-world]
def build_box_world(
    xmin: float, ymin: float, xmax: float, ymax: float
) -> list[Segment]:
    """The four walls of a rectangle, counterclockwise from the lower one."""
    return [
        Segment(xmin, ymin, xmax, ymin),
        Segment(xmax, ymin, xmax, ymax),
        Segment(xmax, ymax, xmin, ymax),
        Segment(xmin, ymax, xmin, ymin),
    ]


def add_vertical_wall(x: float, y0: float, y1: float) -> Segment:
    """A wall along y."""
    return Segment(x, y0, x, y1)


def add_horizontal_wall(y: float, x0: float, x1: float) -> Segment:
    """A wall along x."""
    return Segment(x0, y, x1, y)


# [/snippet]


# [snippet: ray-segment-intersection]
def ray_segment_intersection(
    rx: float, ry: float, rdx: Array, rdy: Array, wall: Segment
) -> Array:
    """Distances at which rays from one point meet a wall.

    rx, ry: the point, metres; rdx, rdy: directions, (n,).
    Returns (n,) metres; infinity where a ray is parallel or misses.
    """
    sx, sy = wall.x1 - wall.x0, wall.y1 - wall.y0
    rxs = rdx * sy - rdy * sx
    parallel = np.abs(rxs) < 1e-12
    rxs = np.where(parallel, 1.0, rxs)
    qpx, qpy = wall.x0 - rx, wall.y0 - ry
    t = (qpx * sy - qpy * sx) / rxs
    u = (qpx * rdy - qpy * rdx) / rxs
    meets = ~parallel & (t >= 0.0) & (u >= 0.0) & (u <= 1.0)
    return np.where(meets, t, np.inf)


# [/snippet]


# [snippet: simulate-lidar-scan]
def simulate_lidar_scan(
    pose: Pose, walls: Sequence[Segment], angles: Array, z_max: float
) -> Array:
    """Ranges (n,) in metres along bearings ``angles`` (n,) from a pose.

    A beam that meets no wall within z_max reads z_max.
    """
    beam = pose.theta + angles
    rdx, rdy = portable_math.cos(beam), portable_math.sin(beam)
    nearest = np.full(angles.shape, np.inf)
    for wall in walls:
        t = ray_segment_intersection(pose.x, pose.y, rdx, rdy, wall)
        nearest = np.minimum(nearest, t)
    return np.where(nearest <= z_max, nearest, z_max)


# [/snippet]
