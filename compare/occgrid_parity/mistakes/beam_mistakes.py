"""Mistakes in a beam's direction, its range, and the cells it crosses (lesson section 4)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from occgrid.sensor import Scan
from occgrid.world import Pose
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.line_cells import (
    Lines,
    lines_with,
    reversed_lines,
    straight_lines,
    supercover_lines,
    walked_lines,
)
from occgrid_parity.model.mapper_steps import Mapper

DIRECTION = "section 4, the beam's direction alpha = theta + phi"
MODEL = "section 4, the three cases of the inverse sensor model"
LINE = "section 4 (line traversal) and 6.1 (bresenham)"
MAX_RANGE = "Problem 3, and section 4 (the occupied case needs z < z_max)"


class HeadingIgnored(Mapper):
    name = "heading-ignored"
    title = "the robot's heading is not added to the bearing"
    lesson = "A bearing is relative to the heading; the beam's direction in the world is theta + phi."
    where = DIRECTION

    def beam(self, theta: float, angles: Array) -> Array:
        return 0.0 + angles


class Clockwise(Mapper):
    name = "bearings-clockwise"
    title = "bearings are subtracted from the heading"
    lesson = "Angles grow counterclockwise, bearings too: the direction is theta + phi, not theta - phi."
    where = DIRECTION

    def beam(self, theta: float, angles: Array) -> Array:
        return theta - angles


class RadiansAsDegrees(Mapper):
    name = "radians-as-degrees"
    title = "the direction is taken for degrees"
    lesson = (
        "Headings and bearings are radians already. Converting them from degrees once more makes every direction 57 "
        "times smaller."
    )
    where = "section 6.1 (only the field of view is given in degrees)"

    def beam(self, theta: float, angles: Array) -> Array:
        return (theta + angles) * (np.pi / 180.0)


class DegreesForRadians(Mapper):
    name = "degrees-for-radians"
    title = "the direction is handed to sin and cos in degrees"
    lesson = "sin and cos take radians; headings and bearings are in radians already and must not be converted."
    where = "section 6.1 (math.cos(wa))"

    def beam(self, theta: float, angles: Array) -> Array:
        return (theta + angles) * (180.0 / np.pi)


class SineAndCosineSwapped(Mapper):
    name = "sine-and-cosine-swapped"
    title = "sine and cosine are swapped at the endpoint"
    lesson = "The endpoint is (x + z cos alpha, y + z sin alpha): angle 0 points along x."
    where = "section 4, second flow chart"

    def endpoint(
        self, pose: Pose, beam: Array, z: Array
    ) -> tuple[Array, Array]:
        return (
            pose.x + z * self.numbers.sin(beam),
            pose.y + z * self.numbers.cos(beam),
        )


class LastBearingMissing(Mapper):
    name = "last-bearing-missing"
    title = "the bearings stop one step before the end of the field of view"
    lesson = "n beams have n - 1 gaps between them, so the step is fov / (n - 1) and the last beam points to +fov / 2."
    where = "section 6.1 (linspace over both ends)"

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        i = np.arange(n, dtype=np.float64)
        return -(fov / 2.0) + (fov * i) / n


class BearingsHalfAStepOff(Mapper):
    name = "bearings-half-a-step-off"
    title = (
        "bearings point to the middle of n equal parts of the field of view"
    )
    lesson = "The first beam points to -fov / 2 and the last to +fov / 2, with a step of fov / (n - 1) between them."
    where = "section 6.1 (linspace over both ends)"

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        i = np.arange(n, dtype=np.float64)
        return -(fov / 2.0) + (fov * (i + 0.5)) / n


class BearingsFromZero(Mapper):
    name = "bearings-from-zero"
    title = "bearings go from 0 to the field of view"
    lesson = (
        "Bearings lie on both sides of the heading: from -fov / 2 to +fov / 2."
    )
    where = "section 6.1 (linspace from -fov / 2 to fov / 2)"

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        i = np.arange(n, dtype=np.float64)
        return np.zeros(1) if n == 1 else fov * i / (n - 1.0)


class CoarseParallel(Mapper):
    name = "coarse-parallel-test"
    title = "walls are taken for parallel to a beam too soon: the cross product is compared with more than 1e-12"
    lesson = (
        "A wall is parallel to a beam where the cross product of their directions is below 1e-12. With 1e-9 or more, "
        "a beam passes through a wall that it meets at a very small angle."
    )
    where = "section 6.1 (ray_segment_intersection: abs(rxs) < 1e-12)"

    def parallel(self) -> float:
        return 1e-9


class OneBeamFewer(Mapper):
    name = "one-beam-fewer"
    title = "a simulated scan has one beam less than the scenario says"
    lesson = "n beams include both ends of the field of view: 181 beams for 180 steps of one degree."
    where = "section 6.1 (n_beams)"

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        if n < 3:
            return super().bearings()
        i = np.arange(n - 1, dtype=np.float64)
        return -(fov / 2.0) + (fov * i) / (n - 2.0)


class LastBeamLeftOut(Mapper):
    name = "last-beam-left-out"
    title = "the last beam of every scan is left out"
    lesson = "A scan of n beams has the beams 0 to n - 1: 181 of them from -90 to +90 degrees, both included."
    where = "section 6.1 (n_beams; linspace over both ends)"

    def scans(self) -> Iterator[Scan]:
        for scan in super().scans():
            yield Scan(scan.pose, scan.angles[:-1], scan.ranges[:-1])


class MaxRangeOccupied(Mapper):
    name = "max-range-occupied"
    title = "a beam without return marks its last cell as occupied"
    lesson = (
        "At the maximum range nothing was hit. Marking the end as occupied builds a wall at the sensor's horizon "
        "that is not there."
    )
    where = MAX_RANGE

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        return lines, lines.last.copy()


class NoMargin(Mapper):
    name = "max-range-without-margin"
    title = "a range is a hit up to the maximum range itself"
    lesson = (
        "The lesson's programs compare with z_max - 1e-12, so that a maximum range which lost its last bits is still "
        "no return."
    )
    where = "section 6.1 (update_grid_from_scan: z_max - 1e-12)"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        s = self.settings
        hit = ranges < s.max_range
        z = np.where(hit, ranges, s.max_range)
        used = hit if s.no_return == "ignore" else ~np.isnan(ranges)
        return z, hit, used


class WideMargin(Mapper):
    name = "max-range-wide-margin"
    title = "a range just below the maximum is taken for no return: the margin is more than 1e-12"
    lesson = (
        "A range is a hit below z_max - 1e-12. That margin is for last bits; with 1e-6 or more, hits close to the "
        "maximum range are lost."
    )
    where = "section 6.1 (update_grid_from_scan: z_max - 1e-12)"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        s = self.settings
        hit = ranges < s.max_range - 1e-6
        z = np.where(hit, ranges, s.max_range)
        used = hit if s.no_return == "ignore" else ~np.isnan(ranges)
        return z, hit, used


class EndFromRobotsCell(Mapper):
    name = "end-counted-from-robot-cell"
    title = "the cells to the end are counted from the robot's cell"
    lesson = (
        "The end is a point of the world, and its cell is found like the robot's. Where floor(z cos(a) / r) is added "
        "to the robot's cell, the robot's place within its cell is lost."
    )
    where = "section 4, second flow chart; 6.1 (world_to_grid of ex, ey)"

    def endpoint(
        self, pose: Pose, beam: Array, z: Array
    ) -> tuple[Array, Array]:
        dx, dy = super().endpoint(Pose(0.0, 0.0, 0.0), beam, z)
        r = self.settings.resolution
        x, y = _centre(self, pose)
        return x + np.floor(dx / r) * r, y + np.floor(dy / r) * r


class FromTheCentre(Mapper):
    name = "beam-from-cell-centre"
    title = "beams start at the centre of the robot's cell"
    lesson = "A beam starts where the robot is, not at the centre of the cell it stands in: its end moves by as much."
    where = "section 4, second flow chart"

    def endpoint(
        self, pose: Pose, beam: Array, z: Array
    ) -> tuple[Array, Array]:
        dx, dy = super().endpoint(Pose(0.0, 0.0, 0.0), beam, z)
        x, y = _centre(self, pose)
        return x + dx, y + dy


def _centre(mapper: Mapper, pose: Pose) -> tuple[Array, Array]:
    """Of the cell in which the robot stands; a number for each beam where the pose has arrays."""
    s = mapper.settings
    gx, gy = mapper.to_grid(np.asarray(pose.x), np.asarray(pose.y))
    return (
        s.origin_x + (gx.astype(np.float64) + 0.5) * s.resolution,
        s.origin_y + (gy.astype(np.float64) + 0.5) * s.resolution,
    )


class NoReturnNotFreed(Mapper):
    name = "no-return-not-freed"
    title = "a beam without return frees no cells"
    lesson = (
        "A beam that met nothing has crossed free space up to the maximum range: all its cells are free, the last "
        "one too."
    )
    where = "Problem 3, and section 6.1 (free_cells are all cells if there is no hit)"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        z, hit, _ = super().read(ranges)
        return z, hit, hit


class NoReturnAlwaysFreed(Mapper):
    name = "no-return-ignore-unknown"
    title = "no_return ignore is not heeded"
    lesson = "The lesson frees a beam without return; a scenario may ask for the beam to be ignored instead."
    where = "Problem 3; SPEC.md section 2.3"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        z, hit, _ = super().read(ranges)
        return z, hit, ~np.isnan(ranges)


class NoReturnEndNotFreed(Mapper):
    name = "no-return-end-not-freed"
    title = "a beam without return does not free its last cell"
    lesson = "Without a hit, all cells of the beam are free, the last one too; only a hit keeps its last cell apart."
    where = "section 6.1 (free_cells)"

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        chosen = ~lines.last | hit[lines.beam]
        return super().evidence(lines.where(chosen), hit)


class NotANumberIsNoReturn(Mapper):
    name = "nan-is-no-return"
    title = "a range that is not a number counts as no return"
    lesson = "NaN says nothing about the beam, not even that it met nothing: it is ignored."
    where = "SPEC.md section 2.3"

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        z, hit, used = super().read(ranges)
        used = (
            hit if self.settings.no_return == "ignore" else np.ones_like(hit)
        )
        return z, hit, used


class HitAlsoFree(Mapper):
    name = "hit-also-free"
    title = "the cell of the hit is counted free, too"
    lesson = (
        "Cells before the hit are free, the cell of the hit is occupied: each cell of a beam gets one update. Freeing "
        "the whole line first takes back most of the evidence for the wall."
    )
    where = MODEL

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        twice = lines.last & hit[lines.beam]
        index = np.repeat(np.arange(twice.size), np.where(twice, 2, 1))
        first = np.diff(index, prepend=-1) > 0
        return lines.where(index), twice[index] & ~first


class LastCellMissed(Mapper):
    name = "last-cell-missed"
    title = "the last cell of the line is missed"
    lesson = (
        "The line includes both ends. Without the last cell no hit is ever marked and a beam without return is one "
        "cell short."
    )
    where = LINE

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        lines = lines.where(~lines.last)
        return lines, np.zeros(lines.gx.shape, dtype=bool)


class HitOneCellShort(Mapper):
    name = "hit-one-cell-short"
    title = "the line stops one cell short, and that cell is taken for the hit"
    lesson = "The line includes both ends, and its last cell is the one that the beam ends in."
    where = LINE

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        lines = lines.where(~lines.last)
        last = np.diff(lines.beam, append=-1) != 0
        return lines, last & hit[lines.beam]


class StartNotFreed(Mapper):
    name = "robot-cell-not-freed"
    title = "the robot's own cell is left out"
    lesson = "The line includes both ends, so the robot's own cell is freed by each beam that ends elsewhere."
    where = LINE

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        first = np.diff(lines.beam, prepend=-1) != 0
        return super().evidence(lines.where(~first | lines.last), hit)


class TiesUp(Mapper):
    name = "ties-up"
    title = "a tie in Bresenham's line goes to the next cell"
    lesson = (
        "Where the line passes exactly between two cells, the lesson's loop stays: it steps aside only when e2 < dx "
        "or e2 > -dy, both strictly."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        def minor(k: Cells, a: Cells, b: Cells) -> Cells:
            return (2 * k * b + a) // (2 * a)

        return lines_with(minor, gx0, gy0, gx1, gy1)


class TiesOnBothSides(Mapper):
    name = "ties-with-equality"
    title = "Bresenham's loop steps at equality (e2 >= -dy, e2 <= dx)"
    lesson = "The lesson's loop has e2 > -dy and e2 < dx, both strictly; equality decides where ties go."
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        def step(e2: Cells, dx: Cells, dy: Cells) -> tuple[Mask, Mask]:
            return e2 >= -dy, e2 <= dx

        return walked_lines(step, gx0, gy0, gx1, gy1)


class TiesAtEqualityInX(Mapper):
    name = "ties-with-equality-in-x"
    title = "Bresenham's loop steps along x at equality (e2 >= -dy)"
    lesson = "The lesson's loop has e2 > -dy and e2 < dx, both strictly; equality decides where ties go."
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        def step(e2: Cells, dx: Cells, dy: Cells) -> tuple[Mask, Mask]:
            return e2 >= -dy, e2 < dx

        return walked_lines(step, gx0, gy0, gx1, gy1)


class TiesAtEqualityInY(Mapper):
    name = "ties-with-equality-in-y"
    title = "Bresenham's loop steps along y at equality (e2 <= dx)"
    lesson = "The lesson's loop has e2 > -dy and e2 < dx, both strictly; equality decides where ties go."
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        def step(e2: Cells, dx: Cells, dy: Cells) -> tuple[Mask, Mask]:
            return e2 > -dy, e2 <= dx

        return walked_lines(step, gx0, gy0, gx1, gy1)


class RealLine(Mapper):
    name = "rounded-line"
    title = "the line is interpolated and rounded, halves to even numbers"
    lesson = "The line is Bresenham's, in whole numbers; a rounded straight line goes elsewhere at ties."
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        def minor(k: Cells, a: Cells, b: Cells) -> Cells:
            return np.rint(k * b / a).astype(np.int64)

        return lines_with(minor, gx0, gy0, gx1, gy1)


class RoundedCells(Mapper):
    name = "rounded-cells"
    title = "points on the line are rounded, halves to even cells"
    lesson = (
        "The line is Bresenham's, in whole numbers; a straight line whose points are rounded, as with np.linspace and "
        "round, goes elsewhere at ties."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        return straight_lines(np.rint, gx0, gy0, gx1, gy1)


class RoundedCellsUp(Mapper):
    name = "rounded-cells-up"
    title = "points on the line are rounded, halves up"
    lesson = (
        "The line is Bresenham's, in whole numbers; a straight line whose points are rounded, as with floor(x + 0.5), "
        "goes elsewhere at ties."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        return straight_lines(lambda v: np.floor(v + 0.5), gx0, gy0, gx1, gy1)


class FromTheLesserEnd(Mapper):
    name = "line-from-the-lesser-end"
    title = "the line is computed so that its longer axis grows"
    lesson = (
        "The line is computed from the robot to the end. The version that swaps the ends where the longer axis would "
        "go down draws other cells at ties."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        steep = np.abs(gy1 - gy0) > np.abs(gx1 - gx0)
        turned = np.where(steep, gy0 > gy1, gx0 > gx1)
        return reversed_lines(turned, gx0, gy0, gx1, gy1)


class FromTheLeft(Mapper):
    name = "line-from-the-left"
    title = "the line is computed from its left end"
    lesson = (
        "The line is computed from the robot to the end. Swapping the ends, so that x always grows, draws other cells "
        "at ties."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        return reversed_lines(gx0 > gx1, gx0, gy0, gx1, gy1)


class FromTheEnd(Mapper):
    name = "line-from-the-end"
    title = "the line is computed from the end to the robot"
    lesson = "The line is computed from the robot to the end; the other way round, ties go to other cells."
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        everywhere = np.ones(gx0.shape, dtype=bool)
        return reversed_lines(everywhere, gx0, gy0, gx1, gy1)


class Supercover(Mapper):
    name = "supercover"
    title = "every cell that the line touches is visited"
    lesson = (
        "The lesson's traversal is Bresenham's: one cell for each step along the longer axis. A supercover visits "
        "every cell that the line passes through, which are more."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        return supercover_lines(gx0, gy0, gx1, gy1, corners=False)


class SupercoverWithCorners(Mapper):
    name = "supercover-with-corners"
    title = "every cell that the line touches is visited, at corners too"
    lesson = (
        "The lesson's traversal is Bresenham's: one cell for each step along the longer axis. A supercover visits "
        "every cell that the line passes through, and where it meets a corner, the cells on both sides."
    )
    where = LINE

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        return supercover_lines(gx0, gy0, gx1, gy1, corners=True)


MISTAKES: tuple[type[Mapper], ...] = (
    HeadingIgnored,
    Clockwise,
    RadiansAsDegrees,
    DegreesForRadians,
    SineAndCosineSwapped,
    LastBearingMissing,
    BearingsHalfAStepOff,
    BearingsFromZero,
    CoarseParallel,
    OneBeamFewer,
    LastBeamLeftOut,
    MaxRangeOccupied,
    NoMargin,
    WideMargin,
    EndFromRobotsCell,
    FromTheCentre,
    NoReturnNotFreed,
    NoReturnAlwaysFreed,
    NoReturnEndNotFreed,
    NotANumberIsNoReturn,
    HitAlsoFree,
    LastCellMissed,
    HitOneCellShort,
    StartNotFreed,
    TiesUp,
    TiesOnBothSides,
    TiesAtEqualityInX,
    TiesAtEqualityInY,
    RealLine,
    RoundedCells,
    RoundedCellsUp,
    FromTheLesserEnd,
    FromTheLeft,
    FromTheEnd,
    Supercover,
    SupercoverWithCorners,
)
