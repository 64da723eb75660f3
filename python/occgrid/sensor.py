"""The range sensor: bearings, what a range means, and the update of the grid (lesson section 4)."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np

from occgrid import portable_math
from occgrid.grid import OccupancyGrid
from occgrid.portable_math import Array, Mask, pi
from occgrid.ray import bresenham
from occgrid.world import Pose

NoReturn = Literal["free", "ignore"]


class Scan(NamedTuple):
    """One scan: the sensor's pose, bearings (n,) in radians from its heading, ranges (n,) in metres."""

    pose: Pose
    angles: Array
    ranges: Array


# [snippet: beam-angles]
def beam_angles(fov: float, n_beams: int) -> Array:
    """Bearings (n_beams,) of a simulated scan over ``fov`` radians."""
    if n_beams == 1:
        return np.zeros(1)
    i = np.arange(n_beams, dtype=np.float64)
    return -(fov / 2.0) + (fov * i) / (n_beams - 1.0)


# [/snippet]


# [snippet: flaser-angles]
def flaser_angles(n_beams: int) -> Array:
    """Bearings (n_beams,) of a FLASER scan: its step is known by its count."""
    if n_beams in (180, 181):
        step = pi / 180.0
    elif n_beams in (360, 361):
        step = pi / 360.0
    elif n_beams in (400, 401):
        step = pi / 720.0
    elif n_beams > 1:
        step = pi / (n_beams - 1.0)
    else:
        step = 0.0
    return -(pi / 2.0) + np.arange(n_beams, dtype=np.float64) * step


# [/snippet]


# [snippet: read-ranges]
def read_ranges(
    ranges: Array, z_max: float, no_return: NoReturn
) -> tuple[Array, Mask, Mask]:
    """What ranges (n,) in metres mean: distance z, hit, used; each (n,).

    NaN is ignored. At z_max or beyond nothing was hit (Problem 3): the
    beam is free up to z_max, or ignored.
    """
    hit = ranges < z_max - 1e-12
    z = np.where(hit, ranges, z_max)
    used = hit if no_return == "ignore" else ~np.isnan(ranges)
    return z, hit, used


# [/snippet]


# [snippet: beam-endpoints]
def beam_endpoints(pose: Pose, angles: Array, z: Array) -> tuple[Array, Array]:
    """World points (n,), metres, where beams of length z end.

    All beams start at one pose; x, y and theta may also be arrays (n,),
    a pose for each beam.
    """
    a = pose.theta + angles
    ex = pose.x + z * portable_math.cos(a)
    ey = pose.y + z * portable_math.sin(a)
    return ex, ey


# [/snippet]


# [snippet: update-grid-from-scan]
def update_grid_from_scan(
    grid: OccupancyGrid,
    scan: Scan,
    z_max: float,
    no_return: NoReturn = "free",
) -> None:
    """The inverse sensor model: free along each beam, occupied at its hit."""
    z, hit, used = read_ranges(scan.ranges, z_max, no_return)
    ex, ey = beam_endpoints(scan.pose, scan.angles, z)
    gx0, gy0 = grid.world_to_grid(scan.pose.x, scan.pose.y)
    gx1, gy1 = grid.world_to_grid(ex, ey)
    for i in np.flatnonzero(used):
        gx, gy = bresenham(gx0, gy0, gx1[i], gy1[i])
        n_free = gx.size - 1 if hit[i] else gx.size  # the cells before a hit
        grid.update_cells(gx[:n_free], gy[:n_free], grid.l_free)
        if hit[i]:
            grid.update_cell(gx1[i], gy1[i], grid.l_occ)


# [/snippet]
