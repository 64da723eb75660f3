"""Whether a map is exactly that of another lesson: other poses, walls that are missing.

A program that reads no scenario has the lesson's poses and walls in its own text, and can have them wrong. Each way to
get them wrong that is listed here is a scenario, so the reference draws its map, and a program's map is compared with
it as with that of the lesson itself.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from occgrid.lesson import lesson_poses
from occgrid.portable_math import cos, pi, sin
from occgrid.world import Pose
from occgrid_parity.explain.closeness import compare_with_reference
from occgrid_parity.explain.scan_choice import but_for
from occgrid_parity.explain.shorter_scenarios import Shortener
from occgrid_parity.explain.wrong_cells import wrong_cells
from occgrid_parity.model.array_types import Array
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import LESSON, Case, built_in
from occgrid_parity.suite.modes import Mode

SCANS = len(lesson_poses())
QUARTER = pi / 2.0
MUCH_NEARER = 8


class OtherLesson(NamedTuple):
    """A lesson that is not the right one; ``words`` go on from "your map is exactly the reference's"."""

    case: Case
    words: str


def _poses(
    ang: Array,
    heading: Array | float | None = None,
    semi_axes: tuple[float, float] = (6.0, 4.0),
    centre: float = -6.0,
) -> list[Pose]:
    """Poses on the lesson's ellipse (n,), as SPEC.md section 4 computes them."""
    a, b = semi_axes
    x, y = centre + a * cos(ang), 0.0 + b * sin(ang)
    return _listed(x, y, ang + QUARTER if heading is None else heading)


def _swapped(ang: Array) -> list[Pose]:
    x, y = -6.0 + 6.0 * sin(ang), 0.0 + 4.0 * cos(ang)
    return _listed(x, y, ang + QUARTER)


def _listed(x: Array, y: Array, theta: Array | float) -> list[Pose]:
    columns = np.broadcast_arrays(x, y, theta)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return [Pose(*row) for row in rows]


def _ang(t: Array, scans: float = SCANS) -> Array:
    return (2.0 * pi) * (t / scans)


OTHER_POSES: tuple[tuple[str, Callable[[Array], list[Pose]]], ...] = (
    (
        "with every pose one step late: t from 1 to 120 (it should be 0 to 119; where t counts from 1, ang has t - 1)",
        lambda t: _poses(_ang(t + 1)),
    ),
    (
        "with ang = 2 pi t / (T - 1), so that the last pose is the first again (it should be 2 pi t / T)",
        lambda t: _poses(_ang(t, SCANS - 1)),
    ),
    (
        "with every scan taken from the first pose (divided as whole numbers, t / T is always 0)",
        lambda t: _poses(0.0 * t),
    ),
    (
        "with the heading ang (it should be ang + pi/2)",
        lambda t: _poses(_ang(t), _ang(t)),
    ),
    (
        "with the heading ang - pi/2 (it should be ang + pi/2)",
        lambda t: _poses(_ang(t), _ang(t) - QUARTER),
    ),
    (
        "with every heading one step late (that of t + 1)",
        lambda t: _poses(_ang(t), _ang(t + 1) + QUARTER),
    ),
    (
        "with every heading one step early (that of t - 1)",
        lambda t: _poses(_ang(t), _ang(t - 1) + QUARTER),
    ),
    (
        "with the same heading, pi/2, for every scan (it should be ang + pi/2)",
        lambda t: _poses(_ang(t), QUARTER),
    ),
    (
        "with the ellipse's semi-axes swapped (6 m belong to x, 4 m to y)",
        lambda t: _poses(_ang(t), semi_axes=(4.0, 6.0)),
    ),
    (
        "with a circle of radius 6 m (the ellipse has 4 m in y)",
        lambda t: _poses(_ang(t), semi_axes=(6.0, 6.0)),
    ),
    (
        "with a circle of radius 4 m (the ellipse has 6 m in x)",
        lambda t: _poses(_ang(t), semi_axes=(4.0, 4.0)),
    ),
    (
        "with the ellipse around (0, 0) (its centre is (-6, 0))",
        lambda t: _poses(_ang(t), centre=0.0),
    ),
    (
        "with the ellipse around (6, 0) (its centre is (-6, 0))",
        lambda t: _poses(_ang(t), centre=6.0),
    ),
    (
        "with y = -4 sin(ang) (it should be +4 sin(ang))",
        lambda t: _poses(_ang(t), semi_axes=(6.0, -4.0)),
    ),
    ("with sin and cos swapped in the poses", lambda t: _swapped(_ang(t))),
)
ONCE_MORE = (
    "with the first pose once more at the end: 121 scans (t should stop at 119: t < T, not t <= T)",
    _poses(_ang(np.arange(SCANS + 1.0))),
)


@functools.cache
def other_lessons() -> tuple[OtherLesson, ...]:
    """All of them."""
    lesson = built_in()
    head = Shortener(lesson).head
    walls = [line for line in head if line.startswith(b"WALL")]
    poses = lesson_poses()
    found = [OtherLesson(_case(head, ONCE_MORE[1]), ONCE_MORE[0])]
    for words, poses_of in OTHER_POSES:
        drawn = poses_of(np.arange(float(SCANS)))
        found.append(OtherLesson(_case(head, drawn), words))
    missing = [
        *(([wall], f"without the wall {_ends(wall)}") for wall in walls),
        (walls[:4], "without the four outer walls"),
        (walls[4:], "without the two inner walls"),
    ]
    for left_out, words in missing:
        rest = [line for line in head if line not in left_out]
        found.append(OtherLesson(_case(rest, poses), words))
    return tuple(found)


def _ends(wall: bytes) -> str:
    x0, y0, x1, y1 = wall.decode("ascii").split()[1:]
    return f"from ({x0}, {y0}) to ({x1}, {y1})"


def _case(head: Iterable[bytes], poses: Iterable[Pose]) -> Case:
    lines = [
        f"POSE {pose.x!r} {pose.y!r} {pose.theta!r}\n".encode()
        for pose in poses
    ]
    return Case(LESSON, b"".join([*head, *lines]), is_file=False)


def other_lesson(observed: Observed, mode: Mode) -> str:
    """Which other lesson the map is that of; empty where it is none that is listed.

    Only the one that comes nearest is compared: with the right one, a map differs in a few cells, by rounding. Where no
    choice of roundings is found that gives all of these cells, the map must at least be much nearer to it than to the
    lesson itself.
    """
    lesson = built_in()
    world = world_of(lesson)
    if observed.pixels.shape != (world.settings.height, world.settings.width):
        return ""
    most = wrong = wrong_cells(observed, lesson, mode)
    nearest: OtherLesson | None = None
    for other in other_lessons():
        found = wrong_cells(observed, other.case, mode, enough=wrong)
        if found < wrong:
            wrong, nearest = found, other
    if nearest is None:
        return ""
    compared = compare_with_reference(
        observed, nearest.case, mode, own_poses=True
    )
    if compared.status != "differs":
        return f"{nearest.words}{but_for(compared)}"
    if compared.together or wrong * MUCH_NEARER > most:
        return ""
    return f"{nearest.words}, but for {wrong} cells at cell edges, each of which rounding alone could change"
