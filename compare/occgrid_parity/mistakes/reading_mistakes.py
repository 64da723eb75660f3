"""Mistakes in reading recorded scans (SPEC.md section 5.3)."""

from __future__ import annotations

from collections.abc import Callable

from occgrid.portable_math import pi
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


MISTAKES: tuple[type[Mapper], ...] = (
    OdometryForPose,
    RobotForLaser,
    FlaserStepFromCount,
    FlaserStepOfN,
)
