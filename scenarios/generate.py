"""Write the scenario files of this folder: python scenarios/generate.py

Each scenario has a reason, which stands in its first line. A test holds the
files to this program.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import numpy as np

from occgrid.lesson import lesson_poses, lesson_settings, lesson_world
from occgrid.noise import add_range_noise, normal_deviate
from occgrid.portable_math import cos, sin
from occgrid.world import Pose

FOLDER = Path(__file__).parent

# Found by trying offsets: with it, no beam of the lesson starts or ends within
# 1e-6 m of a cell edge, noise-free or with seed 0.
OFFSET_X, OFFSET_Y = -11.0329, -9.0406


def lesson() -> str:
    """The lesson, every number as the built-in one computes it."""
    return _lesson(
        "The lesson: an ellipse driven in a box with two inner walls. "
        "All its walls lie on cell edges.",
        lesson_settings().origin_x,
        lesson_settings().origin_y,
    )


def lesson_offset() -> str:
    """The lesson on a grid that no endpoint comes near the edges of."""
    return _lesson(
        "The lesson's world on a shifted grid: no beam ends within 1e-6 m "
        "of a cell edge.",
        OFFSET_X,
        OFFSET_Y,
    )


def one_beam() -> str:
    """A single beam whose cells can be counted on paper."""
    return _text(
        "One beam to check by hand: free (1,1) (2,1) (3,2) (4,2), "
        "occupied (5,3).",
        _grid(8, 5, 1.0, 0.0, 0.0, 10.0),
        [_beam_to(Pose(1.5, 1.5, 0.0), 4, 2)],
    )


def octants() -> str:
    """Lines in every direction, those with ties among them."""
    steps = [
        (7, 3),  # an ordinary slope
        (9, 1),
        (2, 1),  # a tie at every second step
        (4, 2),
        (8, 4),
        (6, 3),
        (10, 5),
        (6, 6),  # the diagonal
        (9, 0),  # an axis
        (0, 0),  # the robot's own cell
    ]
    targets: dict[tuple[int, int], None] = {}
    for dx, dy in steps:
        for a, b in ((dx, dy), (dy, dx)):
            for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
                targets[sx * a, sy * b] = None
    return _text(
        "All eight octants, both axes, the diagonals, and lines that are "
        "halfway between two cells at every second step.",
        _grid(21, 21, 1.0, -10.5, -10.5, 20.0),
        [_beam_to(Pose(0.0, 0.0, 0.0), dx, dy) for dx, dy in targets],
    )


def outside() -> str:
    """The robot and the beams' ends outside the grid."""
    beams = [
        _beam_to(Pose(1.1, 2.3, 0.0), 3.0, 0.4),  # from the left, ends inside
        _beam_to(Pose(1.1, 2.3, 0.0), 9.0, 0.9),  # from the left right through
        _beam_to(Pose(1.2, 3.1, 0.0), 1.9, 1.5),  # cuts the upper left corner
        _beam_to(Pose(1.2, 2.2, 0.0), 1.7, -2.1),  # cuts the lower left one
        _beam_to(
            Pose(8.3, 4.7, 0.0), -2.2, -1.3
        ),  # from beyond the far corner
        _beam_to(Pose(4.6, 0.3, 0.0), 0.2, 7.0),  # from below, upwards through
        _beam_to(Pose(4.6, 5.9, 0.0), -0.9, -1.7),  # from above, ends inside
        _beam_to(Pose(1.1, 0.4, 0.0), 8.0, 0.1),  # passes below
        _beam_to(Pose(0.3, 3.3, 0.0), 0.8, 4.0),  # passes on the left
        _beam_to(Pose(4.4, 2.4, 0.0), 4.8, 0.3),  # from inside to the outside
        _beam_to(Pose(4.4, 2.4, 0.0), -2.6, 0.2),  # ends just left of the grid
        _beam_to(Pose(4.4, 2.4, 0.0), 0.3, -1.6),  # ends just below the grid
        _beam_to(
            Pose(1.8, 0.8, 0.0), 0.1, 0.1
        ),  # stays outside, near a corner
        "POSE 1.3 0.6 0.7",  # a simulated scan from outside
    ]
    return _text(
        "The robot outside the grid: rays that enter, leave, cross a corner "
        "and miss.",
        [
            *_grid(10, 6, 0.5, 2.0, 1.0, 6.0),
            *_params(beams=61),
            "WALL 5.2 0.4 5.2 3.6",
        ],
        beams,
    )


def no_return(kind: str) -> str:
    """Ranges at, near and above the maximum, infinite and not a number."""
    ranges = [
        "2.3", "4", "3.9999999999", "3.99999999999999", "4.0000001", "81.91",
        "inf", "+Infinity", "nan", "NaN", "-nan", "0", "1e400", "3.2",
    ]  # fmt: skip
    words = {
        "free": "their beams are free up to the maximum range",
        "ignore": "their beams are ignored",
    }
    poses = (Pose(4.03, 3.07, 0.2), Pose(5.51, 3.56, 2.9))
    return _text(
        f"Beams without return: {words[kind]}. NaN is ignored in any case.",
        [
            *_grid(40, 30, 0.25, -0.5, -0.75, 4.0),
            *_params(no_return=kind, beams=37, fov=6.0, noise_std=0.1),
            "WALL 6.5 1 6.5 5.5",
        ],
        [
            *(_robotlaser1(p, -1.7, 0.26, ranges) for p in poses),
            "POSE 3.4 2.6 0.3",
        ],
    )


def saturate() -> str:
    """Both clamps reached, and left again."""
    ranges = [f"{1.55 + 0.07 * i:.2f}" for i in range(9)]
    near = Pose(1.13, 1.61, 0.05)
    far = Pose(0.72, 1.58, 0.05)
    scans = [
        *[_robotlaser1(near, -0.6, 0.15, ranges)] * 9,
        *[_robotlaser1(far, -0.6, 0.15, ["3.1"] * 9)] * 5,
        *[_robotlaser1(near, -0.6, 0.15, ranges)] * 3,
    ]
    return _text(
        "Repeated evidence that reaches both clamps, then the opposite "
        "evidence, then the first again.",
        [*_grid(20, 16, 0.25, 0.0, 0.0, 5.0), *_params(l_min=-1.7, l_max=2.9)],
        scans,
    )


def clamp_order() -> str:
    """Beams that hit and cross one cell in one scan, at both clamps; more evidence than a clamp lets count."""
    hit, cross = ["3"] * 2, ["6"] * 2
    rows = [
        [hit, hit, ["3", "6"]],
        [hit, hit, ["6", "3"]],
        [hit, hit, cross, cross],
        [cross, cross, cross, hit, hit],
        [cross, cross, cross, ["3", "6"]],
        [cross, cross, cross, ["6", "3"]],
    ]
    scans = [
        _robotlaser1(Pose(0.5, row + 0.5, 0.0), -0.01, 0.02, ranges)
        for row, evidence in enumerate(rows)
        for ranges in evidence
    ]
    return _text(
        "Both clamps, with a hit and a crossing of the same cell in one scan: the order of the beams decides.",
        [*_grid(8, 6, 1.0, 0.0, 0.0, 7.0), *_params(l_min=-3, l_max=2)],
        scans,
    )


def prior() -> str:
    """A prior that is not one half."""
    ranges = [f"{0.8 + 0.31 * (i % 5):.2f}" for i in range(12)]
    return _text(
        "A prior of 0.3: it is where every cell starts, and every update "
        "subtracts it.",
        [
            *_grid(24, 18, 0.2, -2.4, -1.8, 3.0),
            *_params(p0=0.3, p_occ=0.85, p_free=0.12, l_min=-4.5, l_max=3.5),
        ],
        [
            _robotlaser1(Pose(0.07, 0.04, 0.3), -3.0, 0.5, ranges),
            _robotlaser1(Pose(-0.55, 0.37, 2.3), -3.0, 0.5, ranges),
        ],
    )


def asymmetric() -> str:
    """A world with no symmetry at all."""
    return _text(
        "Different width, height and origin, and a world without symmetry: "
        "no flipped, turned or shifted map can pass.",
        [
            *_grid(61, 37, 0.15, -1.37, 2.21, 5.5),
            *_params(fov=4.2, beams=83, noise_std=0.03),
            "WALL -1.1 2.4 7.4 2.9",
            "WALL 7.4 2.9 6.8 7.1",
            "WALL 6.8 7.1 2.2 7.5",
            "WALL -1.1 2.4 -0.7 5.2",
            "WALL 2.9 4.1 4.4 4.1",
            "WALL 4.4 4.1 4.4 5.3",
        ],
        [
            "POSE 0.31 3.43 0.4",
            "POSE 1.24 4.12 1.1",
            "POSE 2.17 5.71 -0.3",
            "POSE 5.58 5.92 -2.2",
            "POSE 6.03 3.64 9.8",
            "POSE 3.62 3.33 -7.1",
        ],
    )


def flaser() -> str:
    """The step between beams is known by their count."""
    scans = []
    for i, n in enumerate((180, 181, 360, 361, 400, 401, 7, 2, 1)):
        pose = Pose(0.3 * i - 1.23, 0.17 * i - 0.61, 0.7 * i)
        scans.append(_flaser(pose, _wavy(n, 9.0)))
    return _text(
        "FLASER scans of 180, 181, 360, 361, 400, 401, 7, 2 and 1 beams: "
        "the count tells the step.",
        _grid(100, 90, 0.1, -5.03, -4.47, 8.0),
        scans,
    )


def robotlaser1() -> str:
    """Start, step and pose come from the line."""
    scans = []
    for i, n in enumerate((180, 181, 360, 361, 541, 5, 1)):
        pose = Pose(2.2 - 0.41 * i, 0.23 * i - 0.87, 100.0 - 3.1 * i)
        start = -1.570796 - 0.2 * i
        step = 0.017453 if n < 200 else 0.008727
        remissions = n if i % 2 else 0
        scans.append(
            _robotlaser1(pose, start, step, _wavy(n, 9.0), remissions)
        )
    return _text(
        "ROBOTLASER1 scans of 180, 181, 360, 361, 541, 5 and 1 beams, with "
        "and without remissions; headings are not wrapped.",
        _grid(100, 90, 0.1, -4.43, -5.06, 8.0),
        scans,
    )


def mixed() -> str:
    """Simulated and recorded scans in turn; where the file says two poses, they are far apart."""
    scans = []
    for k in range(4):
        pose = Pose(0.31 + 0.4 * k, 0.27 * k - 0.4, 0.37 * k)
        odometry = Pose(pose.x - 0.83, pose.y + 0.61, pose.theta + 0.9)
        ranges = _wavy(9 + k, 3.1)
        scans += [
            _pose(pose),
            _flaser(pose, ranges, odometry=odometry, host="#3"),
            _robotlaser1(pose, -1.1, 0.27, ranges, robot=odometry),
        ]
    return _text(
        "Simulated and recorded scans in turn: only the simulated ones get noise, and all count. The poses of FLASER's "
        "odometry and of ROBOTLASER1's robot are not the laser's.",
        [
            *_grid(41, 33, 0.2, -3.05, -3.33, 4.0),
            *_params(fov=4.4, beams=23, noise_std=0.25),
            "WALL -2.1 -2 3.3 -1.7",
            "WALL 3.3 -1.7 2.9 2.4",
        ],
        scans,
    )


def powers() -> str:
    """Odds that are powers of 2: log-odds that exp reduces to nearly nothing."""
    third = 1.0 / 3.0
    return _text(
        "Odds that are powers of 2, and bounds beyond 10: exp must scale what it has reduced to almost 0.",
        [
            *_grid(12, 9, 1.0, 0.0, 0.0, 20.0),
            *_params(p_occ=1.0 - third, p_free=third, l_min=-30.0, l_max=14.0),
        ],
        [
            _beam_to(Pose(1.5, 1.5, 0.0), 2.0 + k % 8, float(k % 3))
            for k in range(60)
        ]
        + [_beam_to(Pose(1.5, 5.5, 0.0), 3.0, 0.0)] * 25
        + [_beam_to(Pose(1.5, 5.5, 0.0), 6.0, 0.0)] * 16,
    )


def formats() -> str:
    """All that the file format allows, with CRLF line ends."""
    lines = [
        "# Everything the file format allows: tabs, CRLF, blank lines, "
        "comments, other programs' lines, all forms of numbers.",
        "#a comment without a space, and one with other letters: é µ",
        "",
        "   \t ",
        "PARAM robot_width 0.5 nohost 0",
        "PARAM",
        "PARAM laser_front_laser_resolution 1.0",
        "PARAM occgrid_width 0024 # columns",
        "\tPARAM\toccgrid_height   18\t#rows",
        "PARAM occgrid_resolution +.25",
        "PARAM occgrid_origin_x -3.e0",
        "PARAM occgrid_origin_y -22500000000000000000000e-22 # -2.25",
        "PARAM occgrid_max_range 0.45E+1",
        "PARAM occgrid_p_occ 7.0000000000000000000000000000000000000001e-1",
        "PARAM occgrid_noise_std 1e-400",
        "SYNC logger 0.1",
        "ODOM 0.1 0.2 0.3 0 0 0 0.5 host 0.5",
        "WALL 1.5 -2e0 15E-1 2. # a wall",
        "NEFF 27.3",
        "POSE -0 1e-320 0.0000000000000000000000000000000001 # at rest",
        "unknown_keyword \"quoted\" 'text' {1: 2}",
        "FLASER 3 1.25 0.9 1.75 0.21 0.13 0.4 0 0 0 99.5 host 1.5",
        "",
        "ROBOTLASER1 0 -0.5 1 .5 80 0.01 0 3 1.1 inf 1.3 2 0 0 "
        "0.33 0.17 -0.2 0.33 0.17 -0.2 0 0 0 0 0 12.5 host 0.5  ",
        "POSE\t0.6\t0.4\t3.5",
        "# the last line has no end",
        "POSE 0.1 0.4 -3.5",
    ]
    return "\r\n".join(lines)


def odometry() -> str:
    """Each recorded line holds two poses, and only one of them counts."""
    laser = [Pose(-1.1, 0.4, 0.3), Pose(0.7, -0.6, -1.9), Pose(0.2, 1.1, 2.8)]
    robot = [Pose(0.9, -1.3, 1.2), Pose(-0.8, 0.5, 0.4), Pose(1.3, 0.3, -2.2)]
    scans = []
    for i, (here, there) in enumerate(zip(laser, robot, strict=True)):
        scans.append(_flaser(here, _wavy(7 + i, 2.4), odometry=there))
        scans.append(
            _robotlaser1(
                here, -1.2, 0.3, _wavy(9 + i, 2.4), remissions=i, robot=there
            )
        )
    return _text(
        "FLASER's pose is not its odometry, and ROBOTLASER1's laser does not "
        "stand where the robot does.",
        _grid(30, 26, 0.2, -3.07, -2.63, 3.0),
        scans,
    )


def hash_fields() -> str:
    """A number sign begins a comment in some lines and is a field in others."""
    pose = [*map(_number, Pose(0.4, 0.3, 0.9))]
    ranges = _wavy(5, 2.0)
    tail = ["#", "0.1", "0.2", "7.5", "#host", "0"]
    flaser = " ".join(["FLASER", "5", *ranges, *pose, *tail])
    head = ["#4", "-0.8", "#fov", "0.4", "#", "0.01", "0", "5"]
    tail = [*pose, "#", "0", "0", "0", "0", "0", "0", "0", "7.5", "#host", "0"]
    robotlaser1 = " ".join(
        ["ROBOTLASER1", *head, *ranges, "2", "#1", "#2", *tail]
    )
    return _text(
        "A field that begins with # ends PARAM, WALL and POSE lines; in "
        "FLASER and ROBOTLASER1 lines it is a field like any other.",
        [
            *_grid(20, 16, 0.25, -2.03, -1.52, 3.0),
            *_params(beams=9),
            "WALL 2.1 -1 2.1 1.7 #5 the right one",
        ],
        [flaser, "POSE 0.2 -0.3 0.4 # a simulated scan", robotlaser1],
    )


def powers_of_two() -> str:
    """Odds of 4 and 1/4, so that exp's argument is a multiple of ln 2."""
    return _model(
        "Odds that are powers of two: p_occ 0.8 and p_free 0.2.",
        p_occ=0.8,
        p_free=0.2,
    )


def near_even() -> str:
    """Evidence so weak that log's argument is next to 1."""
    return _model(
        "Evidence next to none: p_occ 0.5000001, p_free 0.4999998.",
        p_occ=0.5000001,
        p_free=0.4999998,
    )


def sure() -> str:
    """Log-odds of six, three updates of which leave the limits of most programs."""
    return _model(
        "Strong evidence between limits that are far out: a cell that was hit "
        "often stays occupied for long.",
        p_occ=0.999,
        p_free=0.003,
        l_min=-40.0,
        l_max=30.0,
        p0=0.4,
    )


def beyond_sure() -> str:
    """Probabilities that logit does not tell from 1e-9 and 1 - 1e-9."""
    return _model(
        "Probabilities beyond 1e-9 and 1 - 1e-9 count as these.",
        p_occ=1.0 - 2.0**-53,  # the largest that is allowed
        p_free=1e-12,
        l_min=-1000.0,
        l_max=1000.0,
    )


def upward() -> str:
    """A beam that passes makes a cell likelier to be occupied."""
    return _model(
        "p_free above p0: free cells rise too, up to the upper clamp.",
        p0=0.35,
        p_occ=0.9,
        p_free=0.6,
        l_min=-2.0,
        l_max=2.5,
    )


def backward() -> str:
    """A hit makes a cell likelier to be free; what is passed stays as it is."""
    return _model(
        "p_occ below p0: hits lower a cell, down to the lower clamp; p_free "
        "is p0, so that passing changes nothing.",
        p0=0.6,
        p_occ=0.2,
        p_free=0.6,
        l_min=-2.0,
        l_max=2.5,
    )


def min_range() -> str:
    """Recorded ranges below the least, at it and above; simulated ones too."""
    least, most = 0.7, 4.0
    ranges = [
        "0", "0.3", repr(math.nextafter(least, 0.0)), "0.7",
        repr(math.nextafter(least, 1.0)), "1.3", "nan", "2.9", "inf",
        repr(math.nextafter(most - 1e-12, 0.0)), repr(most - 1e-12),
        repr(math.nextafter(most - 1e-12, 9.0)), "4",
    ]  # fmt: skip
    return _text(
        "min_range: recorded ranges below it are ignored, simulated ones are "
        "not; and ranges at the limit of a hit.",
        [
            *_grid(36, 30, 0.25, -4.6, -3.8, most),
            *_params(min_range=least, beams=21, fov=5.0, noise_std=0.2),
            "WALL 0.4 -2 0.5 2.5",
        ],
        [
            _robotlaser1(Pose(0.11, -0.17, 0.4), -2.4, 0.41, ranges),
            _flaser(Pose(-0.34, 0.23, 1.7), ranges),
            "POSE 0.1 0.2 0.3",
        ],
    )


def noise_clamp() -> str:
    """So much noise that ranges leave [0, max_range] at both ends."""
    return _text(
        "Noise of three metres at walls one metre away: ranges are clamped to "
        "0 and to max_range.",
        [
            *_grid(30, 26, 0.3, -4.45, -3.86, 3.5),
            *_params(beams=31, fov=6.0, noise_std=3.0),
            "WALL 1.1 -2 1.1 2",
            "WALL -1.2 -2 -0.9 2.2",
        ],
        ["POSE 0.1 0.2 0.3", "POSE -0.2 0.1 1.9"],
    )


def wall_ends() -> str:
    """One beam along x for each row, and a wall that it just meets or misses."""
    ulp_less = math.nextafter(1e-12, 0.0)
    walls = [
        (3.5, 0.5, 3.5, 0.9),  # begins on the ray
        (4.5, 1.1, 4.5, 1.5),  # ends on it
        (5.5, math.nextafter(2.5, 3.0), 5.5, 2.9),  # begins just above it
        (6.5, 3.1, 6.5, math.nextafter(3.5, 3.0)),  # ends just below it
        (0.5, 4.2, 0.5, 4.8),  # the robot stands on it
        (math.nextafter(0.5, 0.0), 5.2, 0.5, 5.8),  # or just beyond it
        (2.5, 6.5, 5.5, 6.5),  # along the ray: parallel, so not seen
        (7.5, 7.9, 7.5, 7.5),  # ends on the ray, from above
        (8.5, 8.2, 8.5, 8.8),  # at max_range
        (math.nextafter(8.5, 9.0), 9.2, 8.5, 9.8),  # leans across it
        (4.5, 0.0, 4.5, 1e-12),  # just not parallel
        (4.5, 11.0, 4.5, 11.5),  # three at one ray: the nearest counts
        (2.5, 11.5, 2.5, 11.6),
        (6.5, 11.4, 6.5, 11.6),
        (6.5, 0.0, 6.5, math.nextafter(0.25, 0.0)),  # u is one ulp above 1
    ]
    head = [
        *_grid(10, 12, 1.0, 0.0, 0.0, 8.0),
        *_params(beams=1, fov=2.0),
        *(" ".join(["WALL", *map(_number, wall)]) for wall in walls),
        " ".join(["WALL", *map(_number, (2.5, 0.0, 2.5, ulp_less))]),
    ]
    rows = [f"POSE 0.5 {row}.5 0" for row in range(12)]
    return _text(
        "One beam in each row, at a wall that begins or ends on it, just "
        "misses it, is parallel or nearly so.",
        head,
        [*rows, "POSE 0.5 0 0", "POSE 0.5 0.25 0"],
    )


def slanting() -> str:
    """Walls that a beam meets at the smallest angles."""
    walls, poses = [], []
    for row, rise in enumerate((5e-4, 5e-7, 5e-10, -5e-4, -5e-7, -5e-10)):
        y = row + 1.5
        walls.append((2.5, y - rise / 2, 6.5, y + rise / 2))
        poses.append(f"POSE 0.5 {y} 0")
    return _text(
        "Walls nearly along a beam, which rise by 0.0005 m to 5e-10 m over 4 m: it meets each in the middle of a cell.",
        [
            *_grid(10, 9, 1.0, 0.0, 0.0, 8.0),
            *_params(beams=3, noise_std=0.1),
            *(" ".join(["WALL", *map(_number, wall)]) for wall in walls),
        ],
        poses,
    )


def tips() -> str:
    """Walls that begin or end exactly on a beam, in numbers that leave nothing to rounding."""
    walls = [
        (3.5, 1.5, 3.5, 1.75),
        (4.5, 2.25, 4.5, 2.5),
        (5.5, 3.75, 5.5, 3.5),
        (6.5, 4.5, 6.5, 4.25),
    ]
    return _text(
        "Walls of which one end lies exactly on a beam: the beam meets them.",
        [
            *_grid(10, 7, 1.0, 0.0, 0.0, 8.0),
            *_params(beams=3, noise_std=0.1),
            *(" ".join(["WALL", *map(_number, wall)]) for wall in walls),
        ],
        [f"POSE 0.5 {row}.5 0" for row in range(1, 5)],
    )


def at_a_clamp(low: float, high: float) -> str:
    """The prior is one of the clamps itself."""
    which = "lower" if low == 0.0 else "upper"
    return _model(
        f"The prior is exactly the {which} clamp: evidence towards it changes nothing, other evidence does.",
        p0=0.5,
        l_min=low,
        l_max=high,
    )


def low_limits() -> str:
    """Every parameter at its lower limit."""
    return _text(
        "The least that the parameters can be, on a grid of one cell.",
        [
            *_grid(1, 1, 0.001, -1e7, -1e7, 0.001),
            *_params(min_range=0.0, p0=0.5, l_min=-1000.0, l_max=1000.0),
            *_params(fov=0.0, beams=1, noise_std=0.0),
            "WALL -1e7 -1e7 -10000000 10000000",
        ],
        [
            "POSE -1e7 -10000000 -1e6",
            _flaser(Pose(-1e7, -1e7, -1e6), ["0"]),
            _robotlaser1(Pose(-1e7, -1e7, -1e6), -1e6, -1e6, ["0", "9e9"]),
        ],
    )


def high_limits() -> str:
    """Parameters at their upper limits."""
    return _text(
        "The most that the parameters can be, but for the number of cells and "
        "beams.",
        [
            *_grid(7, 5, 1000.0, 1e7, 1e7, 10000.0),
            *_params(l_min=-1000.0, l_max=1000.0),
            *_params(fov=6.283185307179586, beams=12, noise_std=1000.0),
            "WALL 10000000 -10000000 1e7 1e7",
        ],
        [
            "POSE 10000000 1e7 1e6",
            _flaser(Pose(1e7, 1e7, 1e6), ["3000", "4500", "2000"]),
            _robotlaser1(Pose(1e7, 1e7, 1e6), 1e6, 1e6, ["3300"] * 5),
        ],
    )


def fine_grid() -> str:
    """As many cells in max_range as there may be, and most beams of a POSE."""
    return _text(
        "max_range is 1000000 cells, beams 100000 (of which no scan makes "
        "use), and an origin that nine decimals write as zero.",
        [
            *_grid(9, 7, 0.001, -4e-10, -0.0035, 1000.0),
            *_params(beams=100000),
        ],
        [
            _robotlaser1(
                Pose(0.0045, 0.0004, 0.3), -3.0, 0.9, ["0.003", "0.0061"] * 3
            )
        ],
    )


def beside() -> str:
    """Nothing happens to the grid, in no scan."""
    return _text(
        "A grid of one cell that no beam touches: beams that pass beside it "
        "and ranges that are ignored.",
        _grid(1, 1, 1.0, 0.0, 0.0, 5.0),
        [
            _beam_to(Pose(2.5, 2.5, 0.0), 1.0, 1.0),
            _robotlaser1(Pose(0.5, 0.5, 0.0), 0.0, 0.1, ["nan"] * 3),
            _beam_to(Pose(-1.5, 1.4, 0.0), 4.0, 0.1),
        ],
    )


def two_cells() -> str:
    """Hits in the second cell of a grid, the first left alone or passed."""
    return _text(
        "A grid of two cells: a beam that ends in the second, one beside "
        "them, and two that cross both.",
        _grid(2, 1, 1.0, 0.0, 0.0, 5.0),
        [
            _beam_to(Pose(1.4, 0.5, 0.0), 0.1, 0.1),
            _beam_to(Pose(2.5, 2.5, 0.0), 1.0, 1.0),
            _beam_to(Pose(-1.5, 0.4, 0.0), 5.0, 0.1),
            _beam_to(Pose(3.4, 0.5, 0.0), -2.0, 0.1),
            _beam_to(Pose(1.4, 2.5, 0.0), 0.1, -4.0),
        ],
    )


def many_beams() -> str:
    """A scan of more beams than the programs take at once."""
    return _text(
        "Simulated scans of 9001 beams each.",
        [
            *_grid(16, 12, 0.25, -2.13, -1.37, 1.5),
            *_params(beams=9001, fov=6.0, noise_std=0.1),
            "WALL 1.1 -1.3 0.9 1.4",
        ],
        ["POSE 0.1 0.2 0.3", "POSE -0.8 0.4 2.2"],
    )


def large_angles() -> str:
    """Bearings of millions of radians."""
    ranges = ["nan"] * 2000
    for i in range(0, 2000, 61):
        ranges[i] = f"{1.1 + 0.9 * (i * 37 % 101) / 100:.2f}"
    return _text(
        "ROBOTLASER1 with start and step of a million radians.",
        _grid(30, 26, 0.2, -3.07, -2.63, 3.0),
        [
            _robotlaser1(Pose(0.2, 0.1, 1e6), 1e6, 1e6, _wavy(40, 2.8)),
            _robotlaser1(Pose(-0.3, 0.2, -1e6), -1e6, -1e6, _wavy(40, 2.8)),
            _robotlaser1(Pose(0.1, -0.4, 7.0), 654321.0, 1e6, ranges),
        ],
    )


def corners() -> str:
    """Ends exactly on a corner of the grid, and one unit in the last place beside."""
    scans = []
    for i, (start, n) in enumerate(_angles()):
        a = start + (n - 1) * 1e6
        x, y = -float(cos(a)), -float(sin(a))
        places = [(x, y), (_below(x), y), (x, _below(y))]
        for px, py in places[:1] + places[1 + i % 2 : 2 + i % 2]:
            ranges = ["nan"] * (n - 1) + ["1"]
            scans.append(_robotlaser1(Pose(px, py, 0.0), start, 1e6, ranges))
    return _text(
        "Beams of one metre that end exactly at (0, 0), the corner of the "
        "grid, or one unit in the last place outside.",
        [
            *_grid(3, 3, 0.5, 0.0, 0.0, 3.0),
            *_params(l_min=-1000.0, l_max=1000.0),
        ],
        scans,
    )


def noise_corners() -> str:
    """Noisy ranges that end exactly on the edge of the grid, and one unit in the last place beside."""
    z_max, noise_std = 16.0, 4.0
    scans = []
    for scan in range(60):
        z = add_range_noise(np.array([z_max]), noise_std, 0, scan, z_max)
        x = -float(z[0])
        scans.append(
            f"POSE {_number(x if scan % 4 < 2 else _below(x))} 0.25 0"
        )
    return _text(
        "With the noise of seed 0, the one beam of each scan ends exactly on "
        "the left edge of the grid, or one unit in the last place outside.",
        [
            *_grid(3, 1, 0.5, 0.0, 0.0, z_max),
            *_params(beams=1, noise_std=noise_std),
            *_params(l_min=-1000.0, l_max=1000.0),
        ],
        scans,
    )


def noise_half() -> str:
    """Noisy ranges that end so close to a cell edge that the half in the noise's uniform numbers decides."""
    edge, gap = 6.0, 5e-11
    walls, scans = [], []
    for scan in range(48):
        deviate = float(normal_deviate(scan % 2, scan, np.array([0]))[0])
        end = edge + (gap if scan % 4 < 2 else -gap)
        x = _number(end - deviate)
        walls.append(f"WALL {x} {scan} {x} {scan + 1}")
        scans.append(_pose(Pose(0.25, scan + 0.5, 0.0)))
    return _text(
        "With the noise of seed 0, and of seed 1, one beam in two ends 5e-11 m "
        "beside a cell edge: w + 0.5 in the uniform numbers decides its side.",
        [
            *_grid(12, 48, 1.0, 0.0, 0.0, 12.0),
            *_params(beams=1, noise_std=1.0),
            *walls,
        ],
        scans,
    )


SCENARIOS: dict[str, Callable[[], str]] = {
    "lesson": lesson,
    "lesson-offset": lesson_offset,
    "one-beam": one_beam,
    "octants": octants,
    "outside": outside,
    "no-return-free": lambda: no_return("free"),
    "no-return-ignore": lambda: no_return("ignore"),
    "saturate": saturate,
    "clamp-order": clamp_order,
    "prior": prior,
    "asymmetric": asymmetric,
    "flaser": flaser,
    "robotlaser1": robotlaser1,
    "mixed": mixed,
    "powers": powers,
    "formats": formats,
    "odometry": odometry,
    "hash-fields": hash_fields,
    "powers-of-two": powers_of_two,
    "near-even": near_even,
    "sure": sure,
    "beyond-sure": beyond_sure,
    "upward": upward,
    "backward": backward,
    "min-range": min_range,
    "noise-clamp": noise_clamp,
    "wall-ends": wall_ends,
    "slanting": slanting,
    "tips": tips,
    "at-lower-clamp": lambda: at_a_clamp(0.0, 2.5),
    "at-upper-clamp": lambda: at_a_clamp(-2.5, 0.0),
    "low-limits": low_limits,
    "high-limits": high_limits,
    "fine-grid": fine_grid,
    "beside": beside,
    "two-cells": two_cells,
    "many-beams": many_beams,
    "large-angles": large_angles,
    "corners": corners,
    "noise-corners": noise_corners,
    "noise-half": noise_half,
}


def _lesson(reason: str, origin_x: float, origin_y: float) -> str:
    s = lesson_settings()
    head = [
        *_grid(
            s.width, s.height, s.resolution, origin_x, origin_y, s.max_range
        ),
        *_params(p0=s.p0, p_occ=s.p_occ, p_free=s.p_free),
        *_params(l_min=s.l_min, l_max=s.l_max, no_return=s.no_return),
        *_params(fov=s.fov, beams=s.beams, noise_std=s.noise_std),
        *(" ".join(["WALL", *map(_number, wall)]) for wall in lesson_world()),
    ]
    poses = (_pose(pose) for pose in lesson_poses())
    return _text(reason, head, poses)


def _text(reason: str, head: Sequence[str], scans: Iterable[str]) -> str:
    return "\n".join([f"# {reason}", *head, *scans]) + "\n"


def _grid(
    width: int,
    height: int,
    resolution: float,
    x: float,
    y: float,
    z_max: float,
) -> list[str]:
    return _params(
        width=width,
        height=height,
        resolution=resolution,
        origin_x=x,
        origin_y=y,
        max_range=z_max,
    )


def _params(**values: float | str) -> list[str]:
    return [
        f"PARAM occgrid_{name} {v if isinstance(v, str) else _number(v)}"
        for name, v in values.items()
    ]


def _model(reason: str, **values: float) -> str:
    """Scans that hit the same cells, pass them and hit them again, for an inverse sensor model."""
    near, far = ["1.37", "1.41", "1.44", "1.41", "1.37"], ["2.6"] * 5
    pose = Pose(0.37, 0.61, 0.05)
    scans = [
        _robotlaser1(pose, -0.6, 0.3, ranges)
        for ranges in [near] * 6 + [far] * 9 + [near] * 2
    ]
    return _text(
        reason,
        [*_grid(14, 12, 0.25, 0.0, -0.9, 3.0), *_params(**values)],
        scans,
    )


def _angles() -> list[tuple[float, int]]:
    """Angles as a start and a number of beams a million radians apart, of which the last one is meant.

    They lie in every branch of sin, cos and the reduction: near the limits between these, near multiples of pi/2, in
    between, and beyond 2^20 pi/2.
    """
    near = [
        1e-9, 7.4e-9, 7.5e-9, 0.1, 0.29, 0.3, 0.31, 0.5, 0.77, 0.7812, 0.7813,
        0.7853, 0.7854, 0.79, 1.0, 1.55, math.pi / 2, _below(math.pi / 2),
        1.6, 2.35, 2.36, 3.0, 3.14, math.pi, 4.0, 4.71, 3 * math.pi / 2, 6.28,
        11.0, 22.0, 33.0, 44.0, 51.0, 52.0, 177.5, 355.0, 710.0, 12345.678,
        103993.0, 208341.0, 312689.0, 833719.0, 999999.5,
    ]  # fmt: skip
    turns = [n * (math.pi / 2) for n in (5, 10, 16, 31, 32, 33, 64, 1000)]
    between = [-4.7 + 0.37 * i for i in range(26)]
    far = [
        1146408.0, 4272943.0, 5419351.0, 80143857.0, 165707065.0, 245850922.0,
        1647099.25, 2000000.1, 3333333.3, 17654321.9, 99999999.9, 123456789.1,
    ]  # fmt: skip
    angles = [(a, 1) for a in [*near, *turns, *between, -0.31, -22.0, -355.0]]
    for a in far:
        n = int(a // 1e6)
        angles.append((a - n * 1e6, n + 1))
    return angles


def _below(value: float) -> float:
    """The next double below."""
    return math.nextafter(value, -math.inf)


def _beam_to(pose: Pose, dx: float, dy: float) -> str:
    """A recorded scan of one beam that ends dx, dy metres from the pose."""
    return _robotlaser1(
        pose, math.atan2(dy, dx), 0.0, [_number(math.hypot(dx, dy))]
    )


def _pose(pose: Pose) -> str:
    """A simulated scan."""
    return " ".join(["POSE", *map(_number, pose)])


def _robotlaser1(
    pose: Pose,
    start: float,
    step: float,
    ranges: Sequence[str],
    remissions: int = 0,
    robot: Pose | None = None,
) -> str:
    """``pose`` is the laser's; the robot's is the same where none is given."""
    where = list(map(_number, pose))
    base = list(map(_number, robot or pose))
    head = ["0", _number(start), _number(step * len(ranges)), _number(step)]
    tail = [*where, *base, "0", "0", "0", "0", "0", "0", "host", "0"]
    fields = [*head, "81.91", "0.01", "0", str(len(ranges)), *ranges]
    fields += [
        str(remissions),
        *(str(i % 256) for i in range(remissions)),
        *tail,
    ]
    return " ".join(["ROBOTLASER1", *fields])


def _flaser(
    pose: Pose,
    ranges: Sequence[str],
    odometry: Pose | None = None,
    host: str = "host",
) -> str:
    where = list(map(_number, pose))
    moved = list(map(_number, odometry or pose))
    tail = [*where, *moved, "0", host, "0"]
    return " ".join(["FLASER", str(len(ranges)), *ranges, *tail])


def _wavy(n: int, longest: float) -> list[str]:
    """Ranges as a laser writes them, a few beyond the maximum range."""
    return [
        f"{longest * (0.35 + 0.6 * (i * 37 % 101) / 100):.2f}"
        for i in range(n)
    ]


def _number(value: float) -> str:
    """The shortest decimal that reads back to the same double."""
    return repr(value).removesuffix(".0")


def main() -> None:
    for name, text in SCENARIOS.items():
        (FOLDER / f"{name}.log").write_bytes(text().encode())


if __name__ == "__main__":
    main()
