"""check.html fed with pictures by programs whose formulas are as right as the contract's, and with scans left out."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from harness_parts import Mapper, arithmetic, full_words, world
from pages_in_browser import Open
from test_check import open_check, verdict, write_pgm

from occgrid.sensor import Scan
from occgrid.world import Pose

Values = npt.NDArray[np.float64]
Cells = npt.NDArray[np.int64]


class Lesson(Mapper):
    """The lesson's program as somebody else writes it, with poses of its own."""

    left_out = -1

    def angles(self) -> list[float]:
        return [2.0 * math.pi * t / 120 for t in range(120)]

    def position(self, angle: float) -> tuple[float, float]:
        x, y = self.numbers.cos, self.numbers.sin
        one = np.array([angle])
        return -6.0 + 6.0 * float(x(one)[0]), 4.0 * float(y(one)[0])

    def scans(self) -> Iterator[Scan]:
        bearings = self.bearings()
        for number, angle in enumerate(self.angles()):
            pose = Pose(*self.position(angle), angle + math.pi / 2.0)
            if number != self.left_out:
                yield Scan(pose, bearings, self.simulate(pose, bearings))


class AddedHeadings(Lesson):
    def angles(self) -> list[float]:
        angles, angle = [], 0.0
        for _ in range(120):
            angles.append(angle)
            angle += 2.0 * math.pi / 120.0
        return angles


class Rotated(Lesson):
    def endpoint(
        self, pose: Pose, beam: Values, z: Values
    ) -> tuple[Values, Values]:
        # the heading and the bearing of each beam
        heading = np.broadcast_to(pose.theta, beam.shape)
        bearings = np.resize(self.bearings(), beam.shape)
        c, s = self.numbers.cos(heading), self.numbers.sin(heading)
        cos, sin = self.numbers.cos(bearings), self.numbers.sin(bearings)
        return (
            pose.x + z * (c * cos - s * sin),
            pose.y + z * (s * cos + c * sin),
        )


class Wrapped(Lesson):
    def beam(self, theta: float, angles: Values) -> Values:
        return np.fmod(theta + angles, 2.0 * math.pi)


class Scaled(Lesson):
    def to_grid(self, x: Values, y: Values) -> tuple[Cells, Cells]:
        gx, gy = np.floor(x * 10.0 + 110.0), np.floor(y * 10.0 + 90.0)
        return gx.astype(np.int64), gy.astype(np.int64)


def picture(
    program: type[Mapper], numbers: arithmetic.Arithmetic
) -> npt.NDArray[np.int64]:
    return program(world("lesson"), None, numbers).draw().pixels


def formulas(words: str) -> str:
    """Those that a verdict names."""
    named = re.search(r"as right as [^(]+ \((.*)\)", words)
    return named[1] if named else ""


@pytest.mark.parametrize(
    ("program", "named"),
    [
        (AddedHeadings, "the robot's angle on the ellipse: added up"),
        (Rotated, "directions of beams on the map: a rotation matrix"),
        (Wrapped, "the remainder of heading + bearing by 2 pi"),
    ],
)
def test_other_formulas_are_right_and_are_named_as_in_the_full_check(
    open_page: Open, tmp_path: Path, program: type[Mapper], named: str
) -> None:
    page = open_check(open_page)
    pixels = picture(program, arithmetic.PORTABLE)
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "edges"
    assert "only at cell edges" in words
    assert named in formulas(words)
    assert formulas(words) == formulas(full_words("lesson", pixels))
    # with the sines of another library, too
    pixels = picture(program, arithmetic.PLATFORM)
    status, words = verdict(page, write_pgm(tmp_path / "b.pgm", pixels))
    assert status == "edges", words


def test_a_formula_that_is_right_on_the_lesson_only_is_not_called_as_right(
    open_page: Open, tmp_path: Path
) -> None:
    pixels = picture(Scaled, arithmetic.PORTABLE)
    page = open_check(open_page)
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "edges"
    for said in (words, full_words("lesson", pixels)):
        assert "cells: x / resolution - origin / resolution" in said
        assert "as right as" not in said
        assert "write (x - origin) / resolution" in said


@pytest.mark.parametrize("scan", [50, 105])
def test_a_scan_that_is_left_out_is_no_rounding(
    open_page: Open, tmp_path: Path, scan: int
) -> None:
    class Shorter(Lesson):
        left_out = scan

    page = open_check(open_page)
    for numbers in (arithmetic.PORTABLE, arithmetic.PLATFORM):
        pixels = picture(Shorter, numbers)
        status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
        assert status == "differs"
        assert re.search(
            rf"without scan {scan}\b", full_words("lesson", pixels)
        )
        if numbers is arithmetic.PORTABLE:
            assert f"without scan {scan + 1} (scan {scan} if the" in words
