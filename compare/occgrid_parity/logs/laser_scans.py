"""A ROS LaserScan as a ROBOTLASER1 line, which every port reads."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from occgrid.scenario import MAX_BEAMS
from occgrid.sensor import Scan
from occgrid.world import Pose
from occgrid_parity.logs.conversion import Entry
from occgrid_parity.logs.transforms import Transform, turned

MOST_TILT = math.radians(10)
LARGEST_COORDINATE = 1e7
LARGEST_ANGLE = 1e6


class LaserPose(NamedTuple):
    """A laser in the plane: x, y, heading, whether it hangs upside down, and its tilt out of the plane."""

    x: float
    y: float
    theta: float
    upside_down: bool
    tilt: float


def laser_pose(place: Transform) -> LaserPose:
    """The laser's pose seen from above."""
    ahead = turned(place.rotation, (1.0, 0.0, 0.0))
    up = turned(place.rotation, (0.0, 0.0, 1.0))
    return LaserPose(
        place.translation[0],
        place.translation[1],
        math.atan2(ahead[1], ahead[0]),
        up[2] < 0.0,
        math.acos(min(abs(up[2]), 1.0)),
    )


def is_usable(message: Any) -> bool:
    """Whether the beams of a scan can be told: there are some, and their bearings are numbers."""
    bearings = (message.angle_min, message.angle_increment)
    return 0 < len(message.ranges) <= MAX_BEAMS and all(
        abs(value) < LARGEST_ANGLE for value in bearings
    )


def readings(message: Any) -> npt.NDArray[np.float32]:
    """The ranges, with NaN for what is no measurement (REP 117).

    Plus infinity means that nothing was there, and stays. Minus infinity means too near to be measured.
    Numbers outside range_min .. range_max are none, as the message's definition says.
    """
    found = np.array(message.ranges, dtype=np.float32)
    low, high = message.range_min, message.range_max
    if low > 0.0:
        found[found < np.float32(low)] = np.nan
    if high > 0.0:
        found[np.isfinite(found) & (found > np.float32(high))] = np.nan
    found[found < 0.0] = np.nan
    return found


def entry_of(message: Any, pose: LaserPose, seconds: str) -> Entry:
    """The scan, and its line. Single precision is written with the fewest digits that mean it.

    Seen from above, the beams of a laser that hangs upside down run clockwise.
    """
    sign = -1.0 if pose.upside_down else 1.0
    start = sign * shortest(message.angle_min)
    step = sign * shortest(message.angle_increment)
    ranges = readings(message)
    texts = ranges.astype(np.str_)
    n = ranges.size
    where = f"{pose.x!r} {pose.y!r} {pose.theta!r}"
    line = (
        f"ROBOTLASER1 0 {start!r} {step * (n - 1)!r} {step!r} {shortest(message.range_max)!r} 0 0 "
        f"{n} {' '.join(texts)} 0 {where} {where} 0 0 0 0 0 {seconds} - {seconds}"
    )
    angles = start + np.arange(n, dtype=np.float64) * step
    scan = Scan(
        Pose(pose.x, pose.y, pose.theta), angles, texts.astype(np.float64)
    )
    return Entry(line.encode("ascii"), scan)


def shortest(value: float) -> float:
    """The double whose decimal is the shortest that means this single-precision number."""
    return float(str(np.float32(value)))
