"""world: ray casting against exact cases and an independent geometry library."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from occgrid import portable_math
from occgrid.world import (
    Pose,
    Segment,
    add_horizontal_wall,
    add_vertical_wall,
    build_box_world,
    ray_segment_intersection,
    simulate_lidar_scan,
)

WALL = Segment(2.0, -1.0, 2.0, 1.0)


def distance(rdx: float, rdy: float, wall: Segment = WALL) -> float:
    (t,) = ray_segment_intersection(
        0.0, 0.0, np.array([rdx]), np.array([rdy]), wall
    )
    return float(t)


def one_by_one(
    pose: Pose, walls: list[Segment], angles: list[float], z_max: float
) -> list[float]:
    ranges = []
    for angle in angles:
        a = pose.theta + angle
        rdx, rdy = float(portable_math.cos(a)), float(portable_math.sin(a))
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


def test_ray_segment_intersection() -> None:
    assert distance(1.0, 0.0) == 2.0
    assert distance(0.8, 0.4) == 2.5  # the wall's upper end
    assert distance(0.8, 0.41) == math.inf  # just above it
    assert distance(-1.0, 0.0) == math.inf  # behind
    assert distance(0.0, 1.0) == math.inf  # parallel
    assert distance(1.0, 0.0, Segment(0.0, -1.0, 0.0, 1.0)) == 0.0  # on it
    assert distance(1.0, 0.0, Segment(3.0, 0.0, 3.0, 0.0)) == math.inf


def test_walls() -> None:
    box = build_box_world(-1.0, -2.0, 3.0, 4.0)
    assert [wall[:2] for wall in box] == [(-1, -2), (3, -2), (3, 4), (-1, 4)]
    assert all(box[i][2:] == box[(i + 1) % 4][:2] for i in range(4))
    assert add_vertical_wall(1.0, 2.0, 3.0) == (1.0, 2.0, 1.0, 3.0)
    assert add_horizontal_wall(1.0, 2.0, 3.0) == (2.0, 1.0, 3.0, 1.0)


@pytest.mark.parametrize("seed", range(4))
def test_ranges_against_shapely(seed: int) -> None:
    rng = np.random.default_rng(seed)
    walls = [Segment(*rng.uniform(-8.0, 8.0, 4)) for _ in range(12)]
    lines = shapely.MultiLineString(
        [[(w.x0, w.y0), (w.x1, w.y1)] for w in walls]
    )
    pose = Pose(*rng.uniform(-3.0, 3.0, 3))
    angles = np.linspace(-3.0, 3.0, 200)
    z_max = 4.0
    ranges = simulate_lidar_scan(pose, walls, angles, z_max)
    here = shapely.Point(pose.x, pose.y)
    hits = 0
    for angle, z in zip(angles, ranges, strict=True):
        a = pose.theta + angle
        end = (pose.x + z_max * math.cos(a), pose.y + z_max * math.sin(a))
        met = shapely.LineString([here, end]).intersection(lines)
        expected = z_max if met.is_empty else here.distance(met)
        # 1e-9 m: shapely computes the meeting point by another formula
        assert z == pytest.approx(expected, abs=1e-9)
        hits += not met.is_empty
    assert 20 < hits < 200  # both kinds were tried


def test_array_code_is_the_plain_loop() -> None:
    rng = np.random.default_rng(9)
    for _ in range(20):
        walls = [Segment(*rng.uniform(-8.0, 8.0, 4)) for _ in range(6)]
        pose = Pose(*rng.uniform(-4.0, 4.0, 3))
        angles = rng.uniform(-4.0, 4.0, 50)
        ranges = simulate_lidar_scan(pose, walls, angles, 7.0)
        looped = one_by_one(pose, walls, angles.tolist(), 7.0)
        assert ranges.tobytes() == np.array(looped).tobytes()


def test_no_walls() -> None:
    ranges = simulate_lidar_scan(Pose(0.0, 0.0, 0.0), [], np.zeros(3), 5.0)
    assert ranges.tolist() == [5.0, 5.0, 5.0]
