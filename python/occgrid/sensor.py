"""The range sensor: bearings, what a range means, and the update of the grid (lesson section 4)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.grid import OccupancyGrid
from occgrid.ray import trace_rays
from occgrid.world import Pose

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]
NoReturn = Literal["free", "ignore"]

PI = 3.141592653589793

# cells that are held at once: bounds the memory of an update, whatever the scans
MAX_CELLS = 1 << 21


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
        step = PI / 180.0
    elif n_beams in (360, 361):
        step = PI / 360.0
    elif n_beams in (400, 401):
        step = PI / 720.0
    elif n_beams > 1:
        step = PI / (n_beams - 1.0)
    else:
        step = 0.0
    return -(PI / 2.0) + np.arange(n_beams, dtype=np.float64) * step


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
def beam_endpoints(
    x: Array, y: Array, theta: Array, angles: Array, z: Array
) -> tuple[Array, Array]:
    """World points (n,), metres, where beams of length z end."""
    beam = theta + angles
    ex = x + z * portable_math.cos(beam)
    ey = y + z * portable_math.sin(beam)
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
    update_grid_from_scans(grid, [scan], z_max, no_return)


def update_grid_from_scans(
    grid: OccupancyGrid,
    scans: Sequence[Scan],
    z_max: float,
    no_return: NoReturn = "free",
) -> None:
    """update_grid_from_scan for several scans, in order.

    NumPy is quick on long arrays, so the beams of all scans are traced
    together; update_cells keeps the order of the updates of each cell.
    """
    beams = [scan.angles.size for scan in scans]
    x, y, theta = np.repeat([scan.pose for scan in scans], beams, axis=0).T
    angles = np.concatenate([scan.angles for scan in scans])
    ranges = np.concatenate([scan.ranges for scan in scans])

    z, hit, used = read_ranges(ranges, z_max, no_return)
    ex, ey = beam_endpoints(x, y, theta, angles, z)
    gx0, gy0 = grid.world_to_grid(x[used], y[used])
    gx1, gy1 = grid.world_to_grid(ex[used], ey[used])
    hit = hit[used]

    spec = grid.spec
    beams_at_once = max(1, MAX_CELLS // max(spec.width, spec.height))
    for i in range(0, hit.size, beams_at_once):
        part = slice(i, i + beams_at_once)
        ends = gx0[part], gy0[part], gx1[part], gy1[part]
        trace = trace_rays(*ends, spec.width, spec.height)
        occupied = trace.ends & np.repeat(hit[part], trace.counts)
        grid.update_cells(trace.cells, occupied)


# [/snippet]
