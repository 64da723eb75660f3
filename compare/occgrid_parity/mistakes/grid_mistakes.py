"""Mistakes between a point in the world and a cell of the array (lesson section 1)."""

from __future__ import annotations

import numpy as np

from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.mapper_steps import Mapper

INDEX = "section 1, the formula for g_x and g_y"


class RowsAndColumnsSwapped(Mapper):
    name = "rows-and-columns-swapped"
    title = "rows and columns are swapped in the array of cells"
    lesson = (
        "A cell is the pair (column g_x, row g_y), and the lesson's programs keep it at log_odds[g_y, g_x]: the row "
        "comes first in the array although x comes first in the pair."
    )
    where = "section 1 and 6.1 (update_cell_logodds)"

    def place(self, gx: Cells, gy: Cells) -> tuple[Cells, Mask]:
        w, h = self.settings.width, self.settings.height
        inside = (gx >= 0) & (gx < h) & (gy >= 0) & (gy < w)
        return gx * w + gy, inside


class PictureTransposed(Mapper):
    name = "picture-transposed"
    title = "the picture is written column by column"
    lesson = (
        "The grid has W columns and H rows; a picture is written row by row, each with W pixels. Writing the columns "
        "one after the other exchanges its width and its height."
    )
    where = "section 1 (W x H cells)"

    def file_order(self, log_odds: Array) -> Array:
        return log_odds.T

    def arrange(self, cells: Cells) -> Cells:
        return super().arrange(cells).T


class PictureUpsideDown(Mapper):
    name = "y-flipped"
    title = "the picture's first row is the one with the smallest y"
    lesson = (
        "g_y grows with y, and a picture's rows go downwards: so the last row of the array is written first. The "
        "lesson's programs tell the plotting function the same (origin lower, YDir normal)."
    )
    where = "section 1, and the plots of section 6"

    def arrange(self, cells: Cells) -> Cells:
        return super().arrange(cells)[::-1]


class YAxisDown(Mapper):
    name = "y-axis-down"
    title = "rows are counted from the top, in the array too"
    lesson = (
        "g_y is the whole number of cells between the origin and y, and grows with y. Counting rows from the top, as "
        "pictures do, turns the map upside down."
    )
    where = INDEX

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        gx, gy = super().to_grid(x, y)
        return gx, self.settings.height - 1 - gy


class PictureMirrored(Mapper):
    name = "x-flipped"
    title = "the picture is mirrored left to right"
    lesson = "g_x grows with x, so each row of the picture starts with the cell of the smallest x."
    where = INDEX

    def arrange(self, cells: Cells) -> Cells:
        return super().arrange(cells)[:, ::-1]


class Truncation(Mapper):
    name = "truncation"
    title = "truncation instead of floor"
    lesson = (
        "The index is the floor of the distance from the origin in cells. A conversion to an integer cuts towards "
        "zero instead: just left of or below the grid that gives cell 0, which is inside, in place of cell -1."
    )
    where = INDEX

    def index(self, cells: Array) -> Array:
        return np.trunc(cells)


class OffByOne(Mapper):
    name = "off-by-one"
    title = "the indices are one too large"
    lesson = (
        "Indices start at 0: a point less than one cell from the origin is in cell (0, 0). In languages that count "
        "from 1 the lesson's programs add the 1 when they use the array, not when they compute the cell."
    )
    where = "section 1 and 6.4 (logOdds(gy+1, gx+1))"

    def index(self, cells: Array) -> Array:
        return np.floor(cells) + 1.0


class IndexRounded(Mapper):
    name = "index-rounded"
    title = "the index is rounded to the nearest number"
    lesson = (
        "The index is the floor. Rounding moves every point of a cell's upper half into the next cell, which shifts "
        "the map by half a cell."
    )
    where = INDEX

    def index(self, cells: Array) -> Array:
        return np.floor(cells + 0.5)


class IndexRoundedHalfEven(Mapper):
    name = "index-rounded-half-even"
    title = "the index is rounded to the nearest number, halves to even ones"
    lesson = (
        "The index is the floor. Python's and NumPy's round take halves to the nearest even number, so centres of "
        "cells go up or down in turn."
    )
    where = INDEX

    def index(self, cells: Array) -> Array:
        return np.rint(cells)


class FloorDivision(Mapper):
    name = "index-by-floor-division"
    title = "the index is the result of floor division (//)"
    lesson = (
        "The index is the floor of the rounded quotient. Python's // and NumPy's floor_divide do not round it first: "
        "1.0 / 0.1 is 10, but 1.0 // 0.1 is 9, since the double 0.1 is a little more than a tenth. So a point on a "
        "cell edge can fall into the cell before it."
    )
    where = INDEX

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s = self.settings
        gx = np.floor_divide(x - s.origin_x, s.resolution)
        gy = np.floor_divide(y - s.origin_y, s.resolution)
        return gx.astype(np.int64), gy.astype(np.int64)


class Reciprocal(Mapper):
    name = "index-by-reciprocal"
    title = "the distance is multiplied by 1 / resolution, or something is added to the quotient before it is cut"
    lesson = (
        "The index is the floor of the quotient itself. The reciprocal is rounded, too, so the product can have "
        "another last bit than the quotient; so can a sum, as in int(q + 1000) - 1000 or floor(q + 1e-9). A point on "
        "a cell edge then falls into the other cell."
    )
    where = INDEX + "; SPEC.md section 1"

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s = self.settings
        per_metre = 1.0 / s.resolution
        gx = self.index((x - s.origin_x) * per_metre)
        gy = self.index((y - s.origin_y) * per_metre)
        return gx.astype(np.int64), gy.astype(np.int64)


class DividedApart(Mapper):
    name = "index-by-difference"
    title = "position and origin are divided by the resolution one by one"
    lesson = (
        "The origin is subtracted first, then the distance is divided. Two quotients, x / r - o_x / r, are rounded "
        "each, and a point on a cell edge can fall into the other cell."
    )
    where = INDEX + "; SPEC.md section 1"

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s, r = self.settings, self.settings.resolution
        gx = self.index(x / r - s.origin_x / r)
        gy = self.index(y / r - s.origin_y / r)
        return gx.astype(np.int64), gy.astype(np.int64)


class OriginIgnored(Mapper):
    name = "origin-ignored"
    title = "the origin is not subtracted"
    lesson = "The distance is measured from the grid's lower left corner (o_x, o_y), not from the world's zero."
    where = INDEX

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s = self.settings
        gx, gy = self.index(x / s.resolution), self.index(y / s.resolution)
        return gx.astype(np.int64), gy.astype(np.int64)


class NegativeIndexWraps(Mapper):
    name = "negative-index-wraps"
    title = "negative indices count from the far end"
    lesson = (
        "A cell is in the grid when 0 <= g_x < W and 0 <= g_y < H. Without the test for negative numbers, Python takes "
        "-1 as the last row or column."
    )
    where = "section 6.1 (in_bounds)"

    def place(self, gx: Cells, gy: Cells) -> tuple[Cells, Mask]:
        w, h = self.settings.width, self.settings.height
        inside = (gx >= -w) & (gx < w) & (gy >= -h) & (gy < h)
        return gy % h * w + gx % w, inside


class RobotOutsideSkipped(Mapper):
    name = "robot-outside-skipped"
    title = (
        "nothing is drawn where the robot stands outside the grid: the scan is skipped, or its lines stop at the first "
        "cell outside"
    )
    lesson = (
        "Only the cells outside are skipped, one by one, when they are updated. Beams of a robot outside the grid "
        "still cross it; in the lesson the robot leaves the grid on the left. A line goes on behind a cell outside."
    )
    where = "section 6.1 (update_cell_logodds tests each cell)"

    def kept(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Mask:
        s = self.settings
        return (gx0 >= 0) & (gx0 < s.width) & (gy0 >= 0) & (gy0 < s.height)


class EndOutsideSkipped(Mapper):
    name = "end-outside-skipped"
    title = "a beam is skipped when it ends outside the grid"
    lesson = (
        "Only the cells outside are skipped, one by one. A beam that leaves the grid still frees the cells it crossed "
        "before."
    )
    where = "section 6.1 (update_cell_logodds tests each cell)"

    def kept(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Mask:
        s = self.settings
        return (gx1 >= 0) & (gx1 < s.width) & (gy1 >= 0) & (gy1 < s.height)


class EndsMovedIntoGrid(Mapper):
    name = "ends-moved-into-grid"
    title = "ends outside the grid are moved to its border"
    lesson = (
        "A beam is traced to the cell it ends in, wherever that is. Moving the end to the border changes the beam's "
        "direction and marks the border as occupied."
    )
    where = "section 6.1 (world_to_grid has no bounds)"

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s = self.settings
        gx, gy = super().to_grid(x, y)
        return np.clip(gx, 0, s.width - 1), np.clip(gy, 0, s.height - 1)


MISTAKES: tuple[type[Mapper], ...] = (
    RowsAndColumnsSwapped,
    PictureTransposed,
    PictureUpsideDown,
    YAxisDown,
    PictureMirrored,
    Truncation,
    OffByOne,
    IndexRounded,
    IndexRoundedHalfEven,
    FloorDivision,
    Reciprocal,
    DividedApart,
    OriginIgnored,
    NegativeIndexWraps,
    RobotOutsideSkipped,
    EndOutsideSkipped,
    EndsMovedIntoGrid,
)
