"""The lesson, built in (lesson section 6): a robot drives an ellipse in a box with two inner walls."""

from __future__ import annotations

from occgrid import portable_math
from occgrid.portable_math import pi
from occgrid.scenario import Scenario, Settings
from occgrid.world import (
    Pose,
    Segment,
    add_horizontal_wall,
    add_vertical_wall,
    build_box_world,
)


# [snippet: lesson-settings]
def lesson_settings() -> Settings:
    """Grid, inverse sensor model and simulated sensor of the lesson."""
    return Settings(
        width=220,
        height=180,
        resolution=0.1,
        origin_x=-11.0,
        origin_y=-9.0,
        max_range=10.0,
        p0=0.5,
        p_occ=0.75,
        p_free=0.30,
        l_min=-8.0,
        l_max=8.0,
        no_return="free",
        fov=pi,
        beams=181,
        noise_std=0.02,
    )


# [/snippet]


# [snippet: lesson-world]
def lesson_world() -> list[Segment]:
    """A box of 20 m x 16 m, a vertical and a horizontal wall in it."""
    walls = build_box_world(-10.0, -8.0, 10.0, 8.0)
    walls.append(add_vertical_wall(0.0, -6.0, 6.0))
    walls.append(add_horizontal_wall(2.0, -8.0, -2.0))
    return walls


# [/snippet]


# [snippet: lesson-poses]
def lesson_poses() -> list[Pose]:
    """120 poses on an ellipse, the heading along it."""
    poses = []
    for t in range(120):
        ang = (2.0 * pi) * (t / 120.0)
        x = -6.0 + 6.0 * float(portable_math.cos(ang))
        y = 0.0 + 4.0 * float(portable_math.sin(ang))
        poses.append(Pose(x, y, ang + pi / 2.0))
    return poses


# [/snippet]


def lesson_scenario() -> Scenario:
    """The lesson as a scenario, named ``lesson``."""
    return Scenario(
        "lesson", lesson_settings(), lesson_world(), lesson_poses()
    )
