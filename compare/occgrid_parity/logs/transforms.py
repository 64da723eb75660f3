"""A tree of frames whose transforms change with time, as ROS publishes them.

Only what is still needed is held: a log of hours takes the memory of seconds.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
"""x, y, z, w; of length 1."""


class Transform(NamedTuple):
    """Where a child frame stands in its parent: metres, and a turn."""

    translation: Vector
    rotation: Quaternion


IDENTITY = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


class When(Enum):
    """Where a time lies among the samples of a transform."""

    BEFORE = "before the first transform"
    WITHIN = "within"
    AFTER = "after the last transform"


def unit(rotation: Quaternion) -> Quaternion | None:
    """The quaternion at length 1; None where it has no direction."""
    length = math.sqrt(sum(part * part for part in rotation))
    if not 1e-6 < length < math.inf:
        return None
    x, y, z, w = rotation
    return x / length, y / length, z / length, w / length


def turned(rotation: Quaternion, vector: Vector) -> Vector:
    """The vector after the turn."""
    x, y, z, w = rotation
    vx, vy, vz = vector
    # twice the cross product of the quaternion's vector with v
    tx, ty, tz = (
        2 * (y * vz - z * vy),
        2 * (z * vx - x * vz),
        2 * (x * vy - y * vx),
    )
    return (
        vx + w * tx + (y * tz - z * ty),
        vy + w * ty + (z * tx - x * tz),
        vz + w * tz + (x * ty - y * tx),
    )


def composed(outer: Transform, inner: Transform) -> Transform:
    """The inner frame's place in the outer one's parent."""
    (ox, oy, oz), (px, py, pz) = (
        outer.translation,
        turned(outer.rotation, inner.translation),
    )
    ax, ay, az, aw = outer.rotation
    bx, by, bz, bw = inner.rotation
    rotation = (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )
    return Transform((ox + px, oy + py, oz + pz), unit(rotation) or rotation)


def between(first: Transform, second: Transform, share: float) -> Transform:
    """A share of the way from one to the other: along a line, and by the shorter turn at constant speed."""
    if share == 0.0:
        return first
    a, b = first.rotation, second.rotation
    dot = sum(p * q for p, q in zip(a, b, strict=True))
    sign = -1.0 if dot < 0 else 1.0
    angle = math.acos(min(abs(dot), 1.0))
    if angle < 1e-6:
        of_first, of_second = 1.0 - share, share
    else:
        of_first = math.sin((1.0 - share) * angle) / math.sin(angle)
        of_second = math.sin(share * angle) / math.sin(angle)
    x, y, z, w = (
        of_first * p + sign * of_second * q for p, q in zip(a, b, strict=True)
    )
    tx, ty, tz = (
        p + share * (q - p)
        for p, q in zip(first.translation, second.translation, strict=True)
    )
    return Transform((tx, ty, tz), unit((x, y, z, w)) or a)


class Samples:
    """One transform over time. A static one holds at all times."""

    def __init__(self) -> None:
        self.static: Transform | None = None
        self.times: list[int] = []
        self.transforms: list[Transform] = []

    def add(self, time: int, transform: Transform) -> None:
        """Takes in a sample, late ones too; of two for one time the first counts."""
        place = bisect_left(self.times, time)
        if place == len(self.times) or self.times[place] != time:
            self.times.insert(place, time)
            self.transforms.insert(place, transform)

    def when(self, time: int) -> When:
        """Where that time lies."""
        if self.static is not None:
            return When.WITHIN
        if not self.times or self.times[-1] < time:
            return When.AFTER
        return When.BEFORE if time < self.times[0] else When.WITHIN

    def at(self, time: int) -> Transform:
        """The transform at a time within the samples."""
        if self.static is not None:
            return self.static
        after = bisect_left(self.times, time)
        if self.times[after] == time:
            return self.transforms[after]
        start, end = self.times[after - 1], self.times[after]
        share = (time - start) / (end - start)
        return between(
            self.transforms[after - 1], self.transforms[after], share
        )

    def forget_before(self, time: int) -> None:
        """Drops what is not needed for that time and later."""
        needless = bisect_right(self.times, time) - 1
        if needless > 64:  # now and then, not at every call
            del self.times[:needless]
            del self.transforms[:needless]


class FrameTree:
    """Frames by name, each in its parent."""

    def __init__(self) -> None:
        self.parents: dict[str, str] = {}
        self.edges: dict[tuple[str, str], Samples] = {}

    def add(
        self,
        parent: str,
        child: str,
        time: int,
        transform: Transform,
        static: bool = False,
    ) -> None:
        """Takes in a transform."""
        self.connect(parent, child)
        samples = self.edges.setdefault((parent, child), Samples())
        if static:
            samples.static = transform
        else:
            samples.add(time, transform)

    def connect(self, parent: str, child: str) -> bool:
        """Notes that one frame stands in the other; whether that is new."""
        if self.parents.get(child) == parent:
            return False
        self.parents[child] = parent
        return True

    def chain(self, frame: str, root: str) -> list[tuple[str, str]] | None:
        """The edges from the root down to the frame; None where it does not stand in the root."""
        found: list[tuple[str, str]] = []
        while frame != root:
            parent = self.parents.get(frame)
            if parent is None or len(found) > len(self.parents):
                return None
            found.append((parent, frame))
            frame = parent
        return found[::-1]

    def when(self, chain: Sequence[tuple[str, str]], time: int) -> When:
        """Whether all edges have samples around a time: BEFORE counts before AFTER."""
        answer = When.WITHIN
        for edge in chain:
            one = self.edges[edge].when(time) if edge in self.edges else None
            if one is When.BEFORE:
                return When.BEFORE
            if one is not When.WITHIN:
                answer = When.AFTER
        return answer

    def at(self, chain: Sequence[tuple[str, str]], time: int) -> Transform:
        """The frame's place in the root, at a time that is WITHIN."""
        place = IDENTITY
        for edge in chain:
            place = composed(place, self.edges[edge].at(time))
        return place

    def forget_before(self, time: int) -> None:
        """Drops what is not needed for that time and later."""
        for samples in self.edges.values():
            samples.forget_before(time)
