"""Programs with other formulas that are as right as the contract's lose nothing; those that leave out a scan do."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import pytest

from occgrid.sensor import Scan
from occgrid.world import Pose
from occgrid_parity.check.wording import compared_words
from occgrid_parity.explain.closeness import Compared, compare_with_reference
from occgrid_parity.explain.other_lessons import other_lesson
from occgrid_parity.model.arithmetic import PLATFORM
from occgrid_parity.model.beam_ways import ways_of_ends
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.right_ends import RightEnds
from occgrid_parity.model.right_formulas import (
    CHOICES,
    FUNCTIONS,
    Formulas,
    other_formulas,
)
from occgrid_parity.model.rounding import Beams, beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case, built_in, case
from occgrid_parity.suite.modes import NOISE_FREE

NAMES = (
    "built-in lesson",
    "lesson",
    "formats",
    "asymmetric",
    "mixed",
    "tips",
    "slanting",
    "wall-ends",
)


def ends_of(name: str, seed: int | None) -> tuple[RightEnds, Beams]:
    own_poses = name == "built-in lesson"
    world = world_of(built_in() if own_poses else case(name))
    beams = beams_of(world, seed, own_poses)
    return RightEnds(world, seed, beams, own_poses), beams


@pytest.mark.parametrize("seed", [None, 0])
@pytest.mark.parametrize("name", NAMES)
def test_the_contracts_formulas_put_beams_where_the_contract_does(
    name: str, seed: int | None
) -> None:
    ends, beams = ends_of(name, seed)
    found = ends.of(Formulas())
    ways = beams.ways
    mine = ways.contract & ways.used
    for column, cells in found._asdict().items():
        assert (getattr(ways, column)[mine] == cells[ways.beam[mine]]).all()


@pytest.mark.parametrize("functions", FUNCTIONS)
@pytest.mark.parametrize("step", CHOICES)
@pytest.mark.parametrize("name", NAMES)
def test_every_formula_puts_every_beam_on_one_of_its_ways(
    name: str, step: str, functions: str
) -> None:
    """What may differ by rounding holds for each of them: they are right."""
    ends, beams = ends_of(name, 0)
    ways = beams.ways
    for formula in CHOICES[step]:
        formulas = Formulas(functions=functions)._replace(**{step: formula})
        found = ends.of(formulas)
        chosen = ways_of_ends(ways, found)
        for column, cells in found._asdict().items():
            same = getattr(ways, column)[chosen] == cells
            assert same[beams.used].all(), (formula, column)


class Lesson(Mapper):
    """The lesson's program as somebody else writes it: its own poses, the machine's functions."""

    def angles(self) -> list[float]:
        return [2.0 * math.pi * t / 120 for t in range(120)]

    def scans(self) -> Iterator[Scan]:
        bearings = self.bearings()
        for a in self.angles():
            x, y = -6.0 + 6.0 * math.cos(a), 4.0 * math.sin(a)
            pose = Pose(x, y, a + math.pi / 2.0)
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
        self, pose: Pose, beam: np.ndarray, z: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
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
    def beam(self, theta: float, angles: np.ndarray) -> np.ndarray:
        return np.fmod(theta + angles, 2.0 * math.pi)


class RotatedAndAdded(Rotated, AddedHeadings):
    pass


class FromTheFirst(Lesson):
    def bearings(self) -> np.ndarray:
        bearings, bearing = [], -math.pi / 2.0
        for _ in range(181):
            bearings.append(bearing)
            bearing += math.pi / 180.0
        return np.array(bearings)


class Scaled(Lesson):
    """Coordinates in cells first, then the grid's corner."""

    def to_grid(
        self, x: np.ndarray, y: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        gx, gy = np.floor(x * 10.0 + 110.0), np.floor(y * 10.0 + 90.0)
        return gx.astype(np.int64), gy.astype(np.int64)


def compared_lesson(program: type[Lesson]) -> Compared:
    one: Case = built_in()
    drawn = program(world_of(one), None, PLATFORM).draw()
    observed = Observed(drawn.pixels.astype(np.uint16), None, "")
    return compare_with_reference(observed, one, NOISE_FREE, own_poses=True)


@pytest.mark.parametrize(
    ("program", "named"),
    [
        (Lesson, ""),
        (AddedHeadings, "the robot's angle on the ellipse: added up"),
        (Rotated, "directions of beams on the map: a rotation matrix"),
        (Wrapped, "the remainder of heading + bearing by 2 pi"),
        (RotatedAndAdded, "directions of beams on the map: a rotation matrix"),
        (FromTheFirst, "bearings: added up"),
    ],
)
def test_a_right_program_with_other_formulas_is_right_and_they_are_named(
    program: type[Lesson], named: str
) -> None:
    compared = compared_lesson(program)
    assert compared.status == "edges"
    assert compared.formulas is not None
    assert named in "; ".join(other_formulas(compared.formulas))
    assert named in compared_words(compared)
    assert compared.edge_beams


def test_a_formula_that_is_right_on_the_lesson_only_is_not_called_as_right() -> (
    None
):
    """On scenarios with poses on an edge it is the mistake index-by-difference."""
    compared = compared_lesson(Scaled)
    assert compared.status == "edges"
    words = compared_words(compared)
    assert "cells: x / resolution - origin / resolution" in words
    assert "as right as" not in words
    assert "write (x - origin) / resolution" in words


def without(program: type[Lesson], scan: int, beam: int) -> type[Lesson]:
    """The program that leaves out a scan, and a beam of every scan; none where the number is negative."""

    class Shorter(program):  # type: ignore[misc, valid-type]
        def scans(self) -> Iterator[Scan]:
            for number, (pose, angles, ranges) in enumerate(super().scans()):
                ranges = np.where(np.arange(181) == beam, np.nan, ranges)
                if number != scan:
                    yield Scan(pose, angles, ranges)

    return Shorter


@pytest.mark.parametrize(
    ("scan", "words"),
    [
        (0, "without the first scan"),
        (10, "without scan 10"),
        (50, "without scan 50"),
        (105, "without scan 105"),
        (119, "after 119 of 120 scans"),
    ],
)
def test_no_rounding_explains_a_scan_that_is_left_out(
    scan: int, words: str
) -> None:
    """In scans 50 and 105, beams could be turned one by one so that the map is the same."""
    compared = compared_lesson(without(Lesson, scan, -1))
    assert compared.status == "differs"
    assert compared.left_out == words
    assert compared_words(compared).endswith(
        f"this is exactly the reference's map {words}"
    )


class OneMore(Lesson):
    def angles(self) -> list[float]:
        return [2.0 * math.pi * t / 120 for t in range(121)]


def test_a_scan_too_many_is_compared_with_poses_that_are_not_the_lessons() -> (
    None
):
    """Where a program's poses are others, no formula for them is known, and none is looked for."""
    drawn = OneMore(world_of(built_in()), None, PLATFORM).draw()
    observed = Observed(drawn.pixels.astype(np.uint16), None, "")
    assert "121 scans" in other_lesson(observed, NOISE_FREE)


@pytest.mark.parametrize("beam", [0, 90, 180])
def test_nor_a_beam_of_every_scan(beam: int) -> None:
    compared = compared_lesson(without(AddedHeadings, -1, beam))
    assert compared.status == "differs"


@pytest.mark.parametrize("scan", [1, 20])
def test_a_scan_that_changes_no_pixel_cannot_be_missed(scan: int) -> None:
    whole, shorter = (
        program(world_of(built_in()), None, PLATFORM).draw()
        for program in (Lesson, without(Lesson, scan, -1))
    )
    assert (whole.pixels == shorter.pixels).all()
