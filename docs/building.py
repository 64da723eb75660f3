"""Writes the laser log of a simulated building, for docs/real-logs.md: `python docs/building.py building.clf`.

Offices along a corridor, with furniture, a hall with columns, and windows: a laser sees through glass, and reads
81.91 m where nothing comes back, as SICK's scanners do.
"""

from __future__ import annotations

import itertools
import math
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from occgrid.sensor import flaser_angles
from occgrid.world import Pose, Segment, build_box_world, simulate_lidar_scan

NO_RETURN = 81.91
BEAMS = 361
SEED = 9
NOISE = 0.01
STEP = 0.15
"""Metres between two scans."""

WIDTH, DEPTH = 34.0, 17.0
CORRIDOR = 7.4, 9.6
ROOM = 4.25
DOOR = 1.0
WINDOW = 0.9
HALL = 25.5


def along_x(y: float, *ends: float) -> list[Segment]:
    """Walls on a line of constant y, from each first end to each second one."""
    pairs = zip(ends[::2], ends[1::2], strict=True)
    return [Segment(x0, y, x1, y) for x0, x1 in pairs]


def along_y(x: float, *ends: float) -> list[Segment]:
    """Walls on a line of constant x."""
    pairs = zip(ends[::2], ends[1::2], strict=True)
    return [Segment(x, y0, x, y1) for y0, y1 in pairs]


def outer_walls() -> list[Segment]:
    """The shell of the building, with a window in the middle of each office."""
    ends = [0.0]
    for room in range(int(HALL / ROOM)):
        middle = (room + 0.5) * ROOM
        ends += [middle - WINDOW / 2, middle + WINDOW / 2]
    ends.append(WIDTH)
    return [
        *along_x(0.0, *ends),
        *along_x(DEPTH, *ends),
        *along_y(0.0, 0.0, 8.0, 9.0, DEPTH),
        *along_y(WIDTH, 0.0, 3.5, 6.5, 10.5, 13.5, DEPTH),
    ]


def inner_walls() -> list[Segment]:
    """The corridor with the doors of the offices, the walls between these, and the hall's wall."""
    low, high = CORRIDOR
    walls = along_y(HALL, 0.0, low, high, DEPTH)
    for room in range(int(HALL / ROOM)):
        left = room * ROOM
        door = left + (0.7 if room % 2 else ROOM - 0.7 - DOOR)
        for y in CORRIDOR:
            walls += along_x(y, left, door, door + DOOR, left + ROOM)
        if room:
            walls += along_y(left, 0.0, low, high, DEPTH)
    return walls


def furniture() -> list[Segment]:
    """A desk and a cupboard in each office, columns in the hall."""
    things: list[Segment] = []
    for room in range(int(HALL / ROOM)):
        left = room * ROOM
        for y in (1.3, DEPTH - 2.1):
            desk = left + (0.3 if room % 2 else 2.4)
            things += build_box_world(desk, y, desk + 1.5, y + 0.75)
        cupboard = left + (3.3 if room % 2 else 0.4)
        things += build_box_world(cupboard, 4.6, cupboard + 0.5, 5.4)
    for x in (28.0, 31.5):
        for y in (4.0, 8.5, 13.0):
            things += build_box_world(x - 0.25, y - 0.25, x + 0.25, y + 0.25)
    return things


def corners() -> Iterator[tuple[float, float]]:
    """The way of the robot: into every office and back, then around the columns."""
    middle = (CORRIDOR[0] + CORRIDOR[1]) / 2
    yield 0.8, middle
    for room in range(int(HALL / ROOM)):
        left = room * ROOM
        door = left + (0.7 if room % 2 else ROOM - 0.7 - DOOR) + DOOR / 2
        yield door, middle
        yield door, 6.3
        yield left + 2.2, 3.4
        yield door, 6.3
        yield door, 10.8
        yield left + 2.2, 13.4
        yield door, 10.8
        yield door, middle
    yield from ((26.7, middle), (26.7, 2.0), (29.8, 2.0), (29.8, 15.0))
    yield from ((33.0, 15.0), (33.0, 2.0), (29.8, 2.0), (26.7, middle))


def poses() -> Iterator[Pose]:
    """Poses along that way, looking ahead; on the spot the robot turns in steps of 20 degrees."""
    way = list(corners())
    heading = 0.0
    for (x0, y0), (x1, y1) in itertools.pairwise(way):
        ahead = math.atan2(y1 - y0, x1 - x0)
        turn = math.remainder(ahead - heading, 2 * math.pi)
        turns = math.ceil(abs(turn) / math.radians(20))
        for k in range(turns):
            yield Pose(x0, y0, heading + turn * k / turns)
        heading += turn
        steps = math.ceil(math.hypot(x1 - x0, y1 - y0) / STEP)
        for k in range(steps):
            share = k / steps
            yield Pose(x0 + share * (x1 - x0), y0 + share * (y1 - y0), heading)


def log_lines() -> Iterator[str]:
    """The log, line by line."""
    walls = [*outer_walls(), *inner_walls(), *furniture()]
    noise = np.random.default_rng(SEED)
    angles = flaser_angles(BEAMS)
    yield "# CARMEN log of a simulated building"
    for number, pose in enumerate(poses()):
        true = simulate_lidar_scan(pose, walls, angles, NO_RETURN)
        ranges = np.where(
            true < NO_RETURN, true + noise.normal(0, NOISE, BEAMS), NO_RETURN
        )
        texts = " ".join(f"{value:.2f}" for value in ranges)
        place = f"{pose.x:.4f} {pose.y:.4f} {pose.theta:.5f}"
        time = f"{number / 5:.1f}"
        yield f"ODOM {place} 0.75 0 0 {time} robot {time}"
        yield f"FLASER {BEAMS} {texts} {place} {place} {time} robot {time}"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python docs/building.py FILE")
    Path(sys.argv[1]).write_text("\n".join(log_lines()) + "\n")
