"""Mistakes in the log-odds, their bounds, and the picture made from them (lesson sections 3 to 5)."""

from __future__ import annotations

import math

import numpy as np

from occgrid_parity.model.array_types import Array, Cells
from occgrid_parity.model.mapper_steps import Mapper, Traced

UPDATE = "section 3 (log-odds form) and Problem 2"
CLAMP = "section 5, clamping / saturation"
PICTURE = "section 6 (the plots of P(occupied)); SPEC.md section 2.6"


class PriorNotSubtracted(Mapper):
    name = "prior-not-subtracted"
    title = "the prior is not subtracted in the update"
    lesson = (
        "The update adds the inverse model's log-odds and subtracts the prior's, or the prior is counted again with "
        "every beam. With p0 = 0.5 the prior is 0 and nobody notices."
    )
    where = UPDATE

    def steps(self) -> tuple[float, float]:
        return self.l_free, self.l_occ


class StartsAtZero(Mapper):
    name = "starts-at-zero"
    title = "cells start at log-odds 0, not at the prior's"
    lesson = "Every cell starts at logit(p0), which is 0 only for p0 = 0.5."
    where = "section 1 (first flow chart) and 6.1 (log_odds is filled with l0)"

    def start(self) -> float:
        return 0.0


class ModelSwapped(Mapper):
    name = "free-and-occupied-swapped"
    title = "p_occ and p_free are swapped"
    lesson = "p_occ is above 0.5 and belongs to the cell of the hit, p_free is below it and belongs to those before."
    where = "section 4, the design choices p_occ > 0.5 and p_free < 0.5"

    def steps(self) -> tuple[float, float]:
        return self.l_occ - self.l0, self.l_free - self.l0


class ComplementUpdated(Mapper):
    name = "complement-updated"
    title = "p and 1 - p are swapped in the update"
    lesson = "The log-odds are those of occupied: log(p / (1 - p)). Turned round, evidence counts against itself."
    where = UPDATE

    def steps(self) -> tuple[float, float]:
        return -(self.l_free - self.l0), -(self.l_occ - self.l0)


class CommonLogarithm(Mapper):
    name = "common-logarithm"
    title = "log-odds are taken with the logarithm of base 10"
    lesson = "logit and sigmoid belong together: the sigmoid has e, so the logit has the natural logarithm."
    where = "section 3; 6.1 (math.log)"

    def logit(self, p: float) -> float:
        q = min(max(p, 1e-9), 1.0 - 1e-9)
        return math.log10(q / (1.0 - q))


class NoClamp(Mapper):
    name = "no-clamp"
    title = "log-odds are not clamped"
    lesson = (
        "Log-odds are kept within [l_min, l_max]. Without it, evidence piles up without bound, and a cell needs as "
        "much of the opposite to change its mind."
    )
    where = CLAMP

    def clamp(self, log_odds: Array) -> Array:
        return log_odds


class ClampAtEnd(Mapper):
    name = "clamp-at-the-end"
    title = "log-odds are clamped once, after the last scan"
    lesson = (
        "Each update is clamped at once. Clamped only at the end, evidence above the bound is still there when the "
        "opposite evidence comes."
    )
    where = CLAMP + "; 6.1 (update_cell_logodds clamps each update)"

    def clamp(self, log_odds: Array) -> Array:
        return log_odds

    def finish(self, log_odds: Array) -> Array:
        return super().clamp(log_odds)


class ClampWithoutLower(Mapper):
    name = "no-lower-clamp"
    title = "log-odds are clamped at l_max only"
    lesson = (
        "Both bounds hold: free cells stop at l_min, occupied ones at l_max."
    )
    where = CLAMP

    def clamp(self, log_odds: Array) -> Array:
        return np.minimum(log_odds, self.settings.l_max)


class ClampPerScan(Mapper):
    name = "clamp-once-per-scan"
    title = "log-odds are clamped once per scan, after all of its updates"
    lesson = (
        "Each update is clamped at once. Where a scan's updates are added up first, as with np.add.at, a cell at its "
        "limit can be hit and crossed in one scan and stay there, although the crossing came last."
    )
    where = CLAMP + "; 6.1 (update_cell_logodds clamps each update)"

    def clamp(self, log_odds: Array) -> Array:
        return log_odds

    def apply(self, log_odds: Array, traced: Traced) -> None:
        for scan in np.unique(traced.scan):
            super().apply(log_odds, traced.where(traced.scan == scan))
            log_odds[:] = super().clamp(log_odds)


class ClampBefore(Mapper):
    name = "clamp-before-update"
    title = "log-odds are clamped before an update, not after it"
    lesson = "The result of each update is clamped. Clamped before, the last update can lead beyond the limits."
    where = CLAMP + "; 6.1 (update_cell_logodds)"

    def updated(self, log_odds: Array, steps: Array) -> Array:
        return self.clamp(log_odds) + steps


class StopsAtLimit(Mapper):
    name = "stops-at-limit"
    title = "a cell that has reached a limit is not updated any more"
    lesson = (
        "A limit stops evidence that goes beyond it, and no other: a cell at l_max that a beam crosses becomes less "
        "certain again."
    )
    where = CLAMP

    def updated(self, log_odds: Array, steps: Array) -> Array:
        s = self.settings
        inside = (log_odds > s.l_min) & (log_odds < s.l_max)
        return np.where(inside, super().updated(log_odds, steps), log_odds)


class SkippedAtLimit(Mapper):
    name = "update-beyond-limit-skipped"
    title = "an update that would lead beyond a limit is left out"
    lesson = "An update that leads beyond a limit brings the cell to the limit; left out, the cell stays short of it."
    where = CLAMP

    def updated(self, log_odds: Array, steps: Array) -> Array:
        s = self.settings
        new = log_odds + steps
        return np.where((new < s.l_min) | (new > s.l_max), log_odds, new)


class LimitsOfTen(Mapper):
    name = "limits-of-ten"
    title = "log-odds are clamped at -10 and 10, whatever the scenario says"
    lesson = (
        "The limits are l_min and l_max of the scenario, -8 and 8 where it has none. The defaults of the lesson's "
        "Python class are -10 and 10, but its main program sets -8 and 8."
    )
    where = "section 6.1 (OccupancyGrid, and main)"

    def clamp(self, log_odds: Array) -> Array:
        return np.minimum(np.maximum(log_odds, -10.0), 10.0)


class LimitsOfEight(Mapper):
    name = "limits-of-eight"
    title = "log-odds are clamped at -8 and 8, whatever the scenario says"
    lesson = "The limits are l_min and l_max of the scenario; -8 and 8 hold only where it does not say them."
    where = CLAMP + "; SPEC.md section 5.2"

    def clamp(self, log_odds: Array) -> Array:
        return np.minimum(np.maximum(log_odds, -8.0), 8.0)


class OncePerScan(Mapper):
    name = "once-per-scan"
    title = (
        "each cell is updated once per scan, by the first beam that crosses it"
    )
    lesson = (
        "The lesson's flow chart updates the cells beam by beam: a cell that several beams of one scan cross gets "
        "several updates."
    )
    where = "section 4, second flow chart"

    def within_scan(self, traced: Traced) -> Traced:
        _, first = np.unique(_keys(traced), return_index=True)
        return traced.where(np.sort(first))


class OncePerScanOccupiedWins(Mapper):
    name = "once-per-scan-occupied-wins"
    title = (
        "each cell is updated once per scan, as occupied if any beam hit it"
    )
    lesson = (
        "The lesson's flow chart updates the cells beam by beam: a cell that several beams of one scan cross gets "
        "several updates, free and occupied ones."
    )
    where = "section 4, second flow chart"

    def within_scan(self, traced: Traced) -> Traced:
        order = np.argsort(~traced.occupied, kind="stable")
        occupied_first = traced.where(order)
        _, first = np.unique(_keys(occupied_first), return_index=True)
        return occupied_first.where(first)


def _keys(traced: Traced) -> Cells:
    """One number for each cell of each scan."""
    columns, low = _span(traced.gx)
    rows, bottom = _span(traced.gy)
    return (traced.scan * rows + traced.gy - bottom) * columns + (
        traced.gx - low
    )


def _span(cells: Cells) -> tuple[int, int]:
    """How many numbers there are from the least to the largest, and the least."""
    low = int(np.min(cells, initial=0))
    return int(np.max(cells, initial=0)) - low + 1, low


class OncePerScanEachKind(Mapper):
    name = "once-per-scan-each-kind"
    title = "each cell is updated at most twice per scan: once as free, then once as occupied"
    lesson = (
        "The lesson's flow chart updates the cells beam by beam: a cell that several beams of one scan cross gets "
        "several updates. NumPy's log_odds[gy, gx] += d counts an index that is there twice only once; np.add.at "
        "counts it twice."
    )
    where = "section 4, second flow chart"

    def within_scan(self, traced: Traced) -> Traced:
        key = 2 * _keys(traced) + traced.occupied
        _, first = np.unique(key, return_index=True)
        return traced.where(first)


class FreeThenOccupied(Mapper):
    name = "free-before-occupied"
    title = "a scan's free cells are updated first, then its hits"
    lesson = (
        "The lesson's flow chart goes beam by beam. In another order, a cell at its limit that one beam hits and "
        "another crosses ends with another value."
    )
    where = "section 4, second flow chart"

    def within_scan(self, traced: Traced) -> Traced:
        return traced.where(np.lexsort((traced.occupied, traced.scan)))


class BeamsReversed(Mapper):
    name = "beams-in-reverse-order"
    title = "the beams of a scan are taken from the last to the first"
    lesson = (
        "Beams are taken in their order. In another one, a cell at its limit that one beam hits and another crosses "
        "ends with another value."
    )
    where = "section 4, second flow chart; SPEC.md section 2.5"

    def within_scan(self, traced: Traced) -> Traced:
        last_first = -np.arange(traced.scan.size)
        return traced.where(np.lexsort((last_first, traced.scan)))


class ExpOfReducedArgument(Mapper):
    name = "exp-of-reduced-argument"
    title = "exp looks at the exponent of the reduced argument, not of its own"
    lesson = (
        "In exp, ix is the upper word of the argument that was given, also after x has been reduced. Else a reduced x "
        "near 0 ends in 1 + x, and the power of 2 is lost: exp(-log(2)) becomes 1."
    )
    where = "SPEC.md section 9.3"

    def probability(self, log_odds: Array) -> Array:
        x = -np.abs(log_odds)
        rest = x - np.rint(x / np.log(2.0)) * np.log(2.0)
        lost = (np.abs(x) > 0.5 * np.log(2.0)) & (np.abs(rest) < 2.0**-28)
        z = np.where(lost, 1.0 + rest, self.numbers.exp(x))
        return np.where(log_odds >= 0.0, 1.0, z) / (1.0 + z)


class PictureInverted(Mapper):
    name = "picture-inverted"
    title = "p and 1 - p are swapped in the picture"
    lesson = "A pixel shows 1 - p: occupied cells are black (0), free ones white (255), as in map_server's pictures."
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return np.floor(p * 255.0 + 0.5)


class PixelHalfEven(Mapper):
    name = "pixel-half-even"
    title = "pixels are rounded with halves to even numbers"
    lesson = (
        "A pixel is floor((1 - p) * 255 + 0.5), so halves go up. Python's and NumPy's round take them to the nearest "
        "even number: a cell freed once has 178.5, and gets 178 in place of 179."
    )
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return np.rint((1.0 - p) * 255.0)


class PixelHalfDown(Mapper):
    name = "pixel-half-down"
    title = "pixels are rounded with halves downwards"
    lesson = (
        "A pixel is floor((1 - p) * 255 + 0.5), so halves go up: a cell that nothing has touched has 127.5, and gets "
        "128. With 255 - round(255 p), p is rounded up in place of 1 - p, and the cell gets 127."
    )
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return 255.0 - np.floor(p * 255.0 + 0.5)


class PixelUp(Mapper):
    name = "pixel-rounded-up"
    title = "pixels are rounded up"
    lesson = (
        "A pixel is floor((1 - p) * 255 + 0.5), the nearest grey level. 255 - int(255 p) cuts p off, and so rounds "
        "1 - p up."
    )
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return 255.0 - np.floor(p * 255.0)


class PixelTruncated(Mapper):
    name = "pixel-truncated"
    title = "pixels are cut off, not rounded"
    lesson = "A pixel is floor((1 - p) * 255 + 0.5), the nearest grey level. Cutting off darkens the map by one level."
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return np.floor((1.0 - p) * 255.0)


class PixelOf256(Mapper):
    name = "pixel-of-256"
    title = "pixels are scaled by 256"
    lesson = "Grey levels go from 0 to 255, so 1 - p is multiplied by 255."
    where = PICTURE

    def pixel(self, p: Array) -> Array:
        return np.minimum(np.floor((1.0 - p) * 256.0), 255.0)


MISTAKES: tuple[type[Mapper], ...] = (
    PriorNotSubtracted,
    StartsAtZero,
    ModelSwapped,
    ComplementUpdated,
    CommonLogarithm,
    NoClamp,
    ClampAtEnd,
    ClampWithoutLower,
    ClampPerScan,
    ClampBefore,
    StopsAtLimit,
    SkippedAtLimit,
    LimitsOfTen,
    LimitsOfEight,
    OncePerScan,
    OncePerScanOccupiedWins,
    OncePerScanEachKind,
    FreeThenOccupied,
    BeamsReversed,
    ExpOfReducedArgument,
    PictureInverted,
    PixelHalfEven,
    PixelHalfDown,
    PixelUp,
    PixelTruncated,
    PixelOf256,
)
