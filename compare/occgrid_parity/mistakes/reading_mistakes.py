"""Mistakes in reading recorded scans and parameters (SPEC.md sections 2.3, 5.2 and 5.3)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import ClassVar

import numpy as np

from occgrid.portable_math import pi
from occgrid.sensor import Scan
from occgrid_parity.model.array_types import Array, Mask
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.suite.cases import Case

FIELDS = "SPEC.md section 5.3"


def _with_lines(
    case: Case, keyword: bytes, change: Callable[[list[bytes]], list[bytes]]
) -> Case:
    """The scenario with the fields of some lines changed."""
    lines = case.data.splitlines(keepends=True)
    for number, line in enumerate(lines):
        fields = line.split()
        if fields[:1] == [keyword]:
            lines[number] = b" ".join(change(fields)) + b"\n"
    return Case(case.name, b"".join(lines), case.is_file)


class OdometryForPose(Mapper):
    name = "odometry-for-pose"
    title = "the odometry fields of a FLASER line are taken for the pose"
    lesson = (
        "After the ranges come two poses: first the laser's, corrected, then the raw odometry. The scan was taken from "
        "the first one."
    )
    where = FIELDS

    @classmethod
    def reads(cls, case: Case) -> Case:
        def change(fields: list[bytes]) -> list[bytes]:
            first = 2 + int(fields[1])
            odometry = fields[first + 3 : first + 6]
            return [*fields[:first], *odometry, *fields[first + 3 :]]

        return _with_lines(case, b"FLASER", change)


class RobotForLaser(Mapper):
    name = "robot-pose-for-laser"
    title = "the robot's pose of a ROBOTLASER1 line is taken for the laser's"
    lesson = (
        "After the remissions come two poses: first the laser's, then the robot's. Beams start at the laser, which is "
        "mounted somewhere on the robot."
    )
    where = FIELDS

    @classmethod
    def reads(cls, case: Case) -> Case:
        def change(fields: list[bytes]) -> list[bytes]:
            beams = int(fields[8])
            first = 10 + beams + int(fields[9 + beams])
            robot = fields[first + 3 : first + 6]
            return [*fields[:first], *robot, *fields[first + 3 :]]

        return _with_lines(case, b"ROBOTLASER1", change)


class _FlaserStep(Mapper):
    """A FLASER line with other bearings, written as a ROBOTLASER1 line."""

    @classmethod
    def step(cls, beams: int) -> float:
        raise NotImplementedError

    @classmethod
    def reads(cls, case: Case) -> Case:
        def change(fields: list[bytes]) -> list[bytes]:
            beams = int(fields[1])
            ranges = fields[2 : 2 + beams]
            pose = fields[2 + beams : 5 + beams]
            step = repr(cls.step(beams)).encode()
            head = [b"ROBOTLASER1", b"0", repr(-(pi / 2.0)).encode(), b"0"]
            return [
                *head,
                step,
                *[b"0"] * 3,
                fields[1],
                *ranges,
                b"0",
                *pose,
                *[b"0"] * 11,
            ]

        return _with_lines(case, b"FLASER", change)


class FlaserStepFromCount(_FlaserStep):
    name = "flaser-step-n-minus-1"
    title = "the bearings of every FLASER line go over half a turn with n - 1 steps"
    lesson = (
        "FLASER does not say its bearings; the count tells the laser. With 180 beams the step is one degree, with 360 "
        "half a degree, with 400 and 401 a quarter of one."
    )
    where = FIELDS

    @classmethod
    def step(cls, beams: int) -> float:
        return 0.0 if beams == 1 else pi / (beams - 1.0)


class FlaserStepOfN(_FlaserStep):
    name = "flaser-step-n"
    title = (
        "the bearings of every FLASER line go over half a turn with n steps"
    )
    lesson = (
        "n beams have n - 1 gaps between them. FLASER's step is pi / 180 for 180 and 181 beams, pi / 360 for 360 and "
        "361, pi / 720 for 400 and 401, else pi / (n - 1)."
    )
    where = FIELDS

    @classmethod
    def step(cls, beams: int) -> float:
        return pi / beams


class InfinityIgnored(Mapper):
    name = "infinity-ignored"
    title = "an infinite range is ignored"
    lesson = (
        "Many drivers write inf where a beam met nothing: it is a range above the maximum, so no return. JavaScript's "
        "parseFloat makes NaN of it, which is ignored."
    )
    where = "SPEC.md section 2.3"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        z, hit, used = super().read(ranges)
        return z, hit, used & ~np.isinf(ranges)


class LeastRangeForAll(Mapper):
    name = "min-range-for-all"
    title = "min_range holds for simulated ranges, too"
    lesson = (
        "Recorded ranges below min_range are echoes of the robot itself, and are ignored. Simulated ranges have none, "
        "so min_range does not apply to them."
    )
    where = "SPEC.md section 2.3"

    def scans(self) -> Iterator[Scan]:
        for scan in super().scans():
            near = scan.ranges < self.settings.min_range
            yield Scan(
                scan.pose, scan.angles, np.where(near, np.nan, scan.ranges)
            )


class _Unread(Mapper):
    """A parameter that is not read, so that its default stands."""

    parameter: ClassVar[bytes]
    where = "SPEC.md section 5.2"

    @classmethod
    def reads(cls, case: Case) -> Case:
        lines = [
            line
            for line in case.data.splitlines(keepends=True)
            if line.split()[:2] != [b"PARAM", b"occgrid_" + cls.parameter]
        ]
        return Case(case.name, b"".join(lines), case.is_file)


class LeastRangeUnread(_Unread):
    name = "min-range-unread"
    title = "occgrid_min_range is not read"
    lesson = "Recorded ranges below min_range are ignored. Without the parameter it is 0, and no range is below it."
    parameter = b"min_range"


class FieldOfViewUnread(_Unread):
    name = "fov-unread"
    title = "occgrid_fov is not read: simulated scans cover half a turn"
    lesson = "The bearings of a simulated scan go from -fov / 2 to +fov / 2. Half a turn is only the default."
    parameter = b"fov"


class BeamsUnread(_Unread):
    name = "beams-unread"
    title = "occgrid_beams is not read: simulated scans have 181 beams"
    lesson = "A simulated scan has as many beams as the scenario says. 181 is only the default."
    parameter = b"beams"


class PriorUnread(_Unread):
    name = "p0-unread"
    title = "occgrid_p0 is not read: the prior is one half"
    lesson = "Cells start at logit(p0), and each update subtracts it. One half is only the default."
    parameter = b"p0"


class OccupiedUnread(_Unread):
    name = "p-occ-unread"
    title = "occgrid_p_occ is not read: it is 0.75"
    lesson = (
        "A hit adds logit(p_occ) - logit(p0), with the p_occ of the scenario."
    )
    parameter = b"p_occ"


class FreeUnread(_Unread):
    name = "p-free-unread"
    title = "occgrid_p_free is not read: it is 0.30"
    lesson = "A crossing adds logit(p_free) - logit(p0), with the p_free of the scenario."
    parameter = b"p_free"


class NoiseUnread(_Unread):
    name = "noise-std-unread"
    title = "occgrid_noise_std is not read: it is 0.02"
    lesson = "The noise's standard deviation is that of the scenario, in metres. 0.02 is only the default."
    parameter = b"noise_std"


MISTAKES: tuple[type[Mapper], ...] = (
    OdometryForPose,
    RobotForLaser,
    FlaserStepFromCount,
    FlaserStepOfN,
    InfinityIgnored,
    LeastRangeForAll,
    LeastRangeUnread,
    FieldOfViewUnread,
    BeamsUnread,
    PriorUnread,
    OccupiedUnread,
    FreeUnread,
    NoiseUnread,
)
