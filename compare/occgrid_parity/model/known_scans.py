"""The scans of a world with their ranges: those that are simulated are computed many at a time.

One call of NumPy for 181 beams costs as much as the arithmetic of thousands. The Python port's function takes the poses
of many scans as well as one, so the ranges are the port's in every bit.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from occgrid.noise import add_range_noise
from occgrid.sensor import Scan, beam_angles
from occgrid.world import Pose, simulate_lidar_scan
from occgrid_parity.model.array_types import Array
from occgrid_parity.model.worlds import World

BEAMS_AT_ONCE = 1 << 15


def known_scans(world: World, seed: int | None) -> list[Scan]:
    """All scans, with noise where there is a seed."""
    s = world.settings
    poses = [scan for scan in world.scans if not isinstance(scan, Scan)]
    angles = beam_angles(s.fov, s.beams)
    simulated = iter(_ranges(world, poses, angles))
    found = []
    for number, scan in enumerate(world.scans):
        if isinstance(scan, Scan):
            found.append(scan)
            continue
        ranges = next(simulated)
        if seed is not None:
            ranges = add_range_noise(
                ranges, s.noise_std, seed, number, s.max_range
            )
        found.append(Scan(scan, angles, ranges))
    return found


def _ranges(world: World, poses: Sequence[Pose], angles: Array) -> list[Array]:
    """Ranges (n,) along the bearings from each pose."""
    found: list[Array] = []
    many = max(1, BEAMS_AT_ONCE // angles.size)
    for first in range(0, len(poses), many):
        part = np.array(poses[first : first + many])
        x, y, theta = part.T[:, :, None]
        ranges = simulate_lidar_scan(
            Pose(x, y, theta), world.walls, angles, world.settings.max_range
        )
        # without a wall there is one row for all
        found.extend(np.broadcast_to(ranges, (len(part), angles.size)))
    return found
