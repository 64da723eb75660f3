"""Shorter scenarios that map the same beams: the first scans of one, one scan alone, the first beams of a scan.

The contract draws the same bits from them, whatever way they are written:

- a recorded scan cut to its first beams is a ROBOTLASER1 line with fewer ranges, and FLASER's bearings are
  ``-(pi/2) + i * step`` as ROBOTLASER1's are ``start + i * step``; one beam alone has its bearing as start and step 0;
- a simulated beam is a POSE of its own with one beam: its bearing is 0, so its heading is ``theta + angle``, the very
  sum that the whole scan has as the beam's direction.

With a seed that does not hold for simulated scans: their noise depends on the numbers of scan and beam.
"""

from __future__ import annotations

from collections.abc import Sequence

from occgrid.portable_math import pi
from occgrid.sensor import Scan, beam_angles
from occgrid.world import Pose
from occgrid_parity.model.worlds import world_of
from occgrid_parity.suite.cases import Case

SCAN_KEYWORDS = (b"POSE", b"FLASER", b"ROBOTLASER1")
TAIL = "0 0 0 0 0 0 host 0"


class Shortener:
    """A scenario's lines, and shorter scenarios made of them."""

    def __init__(self, case: Case) -> None:
        self.case = case
        self.world = world_of(case)
        self.lines = case.data.splitlines(keepends=True)
        self.scan_lines = [
            number
            for number, line in enumerate(self.lines)
            if line.split()[:1] and line.split()[0] in SCAN_KEYWORDS
        ]
        if len(self.scan_lines) != len(self.world.scans):
            raise AssertionError(f"{case.name}: scans and their lines differ")
        self.head = [
            line
            for line in self.lines[: self.scan_lines[0]]
            if line.split()[:1] == [b"WALL"] or _is_parameter(line)
        ]

    def beams_in(self, scan: int) -> int:
        """How many beams a scan has."""
        one = self.world.scans[scan]
        return (
            one.ranges.size
            if isinstance(one, Scan)
            else self.world.settings.beams
        )

    def is_simulated(self, scan: int) -> bool:
        """Whether the scan is a POSE."""
        return not isinstance(self.world.scans[scan], Scan)

    def prefix(self, scans: int) -> Case:
        """The first scans, every line as it is."""
        last = self.scan_lines[scans - 1]
        return self._case(b"".join(self.lines[: last + 1]))

    def some(self, scans: Sequence[int]) -> Case:
        """Some of the scans, in this order."""
        lines = [self.lines[self.scan_lines[scan]] for scan in scans]
        whole = [line.rstrip(b"\r\n") + b"\n" for line in lines]
        return self._case(b"".join(self.head) + b"".join(whole))

    def alone(self, scan: int) -> Case:
        """One scan in an empty map."""
        line = self.lines[self.scan_lines[scan]]
        return self._case(b"".join(self.head) + line)

    def beams(self, scan: int, count: int, history: bool) -> Case:
        """The first beams of a scan, in an empty map or after the scans before it."""
        before = range(scan) if history else range(0)
        single = self.is_simulated(scan)
        lines: list[str] = []
        for number in before:
            if single and self.is_simulated(number):
                lines += self._single_poses(number, self.beams_in(number))
            else:
                raw = self.lines[self.scan_lines[number]]
                lines.append(raw.decode("ascii").strip())
        if single:
            lines += self._single_poses(scan, count)
        else:
            lines.append(self._cut(scan, count))
        return self._text(lines, one_beam=single)

    def beam(self, scan: int, beam: int) -> Case:
        """One beam in an empty map."""
        one = self.world.scans[scan]
        if not isinstance(one, Scan):
            poses = self._single_poses(scan, beam + 1)[-1:]
            return self._text(poses, one_beam=True)
        line = recorded_line(
            one.pose,
            float(one.angles[beam]),
            0.0,
            [self._range_words(scan)[beam]],
        )
        return self._text([line], one_beam=False)

    def _single_poses(self, scan: int, count: int) -> list[str]:
        pose = self.world.scans[scan]
        assert not isinstance(pose, Scan)
        s = self.world.settings
        angles = beam_angles(s.fov, s.beams)[:count].tolist()
        x, y = _number(pose.x), _number(pose.y)
        return [
            f"POSE {x} {y} {_number(pose.theta + angle)}" for angle in angles
        ]

    def _cut(self, scan: int, count: int) -> str:
        """A recorded scan's first beams."""
        one = self.world.scans[scan]
        assert isinstance(one, Scan)
        fields = self.lines[self.scan_lines[scan]].split()
        if fields[0] == b"ROBOTLASER1":
            start, step = float(fields[2]), float(fields[4])
        else:
            start, step = -(pi / 2.0), flaser_step(one.angles.size)
        words = self._range_words(scan)[:count]
        return recorded_line(one.pose, start, step, words)

    def _range_words(self, scan: int) -> list[str]:
        """The ranges as they stand in the file."""
        one = self.world.scans[scan]
        assert isinstance(one, Scan)
        fields = self.lines[self.scan_lines[scan]].decode("ascii").split()
        first = 9 if fields[0] == "ROBOTLASER1" else 2
        return fields[first : first + one.ranges.size]

    def _text(self, lines: Sequence[str], one_beam: bool) -> Case:
        head = [line.decode("ascii").strip() for line in self.head]
        if one_beam:
            head = [
                line for line in head if line.split()[1] != "occgrid_beams"
            ]
            head.append("PARAM occgrid_beams 1")
        return self._case(("\n".join([*head, *lines]) + "\n").encode("ascii"))

    def _case(self, data: bytes) -> Case:
        return Case(self.case.name, data)


def _is_parameter(line: bytes) -> bool:
    fields = line.split()
    return (
        len(fields) > 1
        and fields[0] == b"PARAM"
        and fields[1].startswith(b"occgrid_")
    )


def recorded_line(
    pose: Pose, start: float, step: float, ranges: Sequence[str]
) -> str:
    """A ROBOTLASER1 line."""
    where = " ".join(_number(value) for value in pose)
    bearing = f"{_number(start)} 0 {_number(step)}"
    n = len(ranges)
    return f"ROBOTLASER1 0 {bearing} 81.91 0.01 0 {n} {' '.join(ranges)} 0 {where} {where} {TAIL}"


def flaser_step(beams: int) -> float:
    """The step between the bearings of a FLASER scan (SPEC.md section 5.3)."""
    steps = {180: 180.0, 181: 180.0, 360: 360.0, 361: 360.0}
    steps |= {400: 720.0, 401: 720.0}
    if beams == 1:
        return 0.0
    return pi / steps.get(beams, beams - 1.0)


def _number(value: float) -> str:
    """The shortest decimal that reads back to the same double."""
    return repr(float(value)).removesuffix(".0")
