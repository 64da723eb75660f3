"""Fits a grid around the scans of a log."""

from __future__ import annotations

from decimal import ROUND_FLOOR, ROUND_UP, Decimal, localcontext
from typing import NamedTuple

import numpy as np

from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.sensor import Scan, beam_endpoints, read_ranges
from occgrid.world import Pose
from occgrid_parity.logs.conversion import ConversionError, Request

BEAMS_AT_ONCE = 8192


class Fitted(NamedTuple):
    """A grid that holds a log's scans; the origin is a multiple of the resolution."""

    width: int
    height: int
    origin_x: Decimal
    origin_y: Decimal


class Bounds:
    """The box around the hits and the positions of scans, metres."""

    def __init__(self, max_range: float, min_range: float) -> None:
        self.max_range, self.min_range = max_range, min_range
        self.low = np.full(2, np.inf)
        self.high = np.full(2, -np.inf)
        self.waiting: list[Scan] = []
        self.waiting_beams = 0

    def add(self, scan: Scan) -> None:
        """Takes in the scan's position and where its hits end."""
        self.waiting.append(scan)
        self.waiting_beams += scan.ranges.size
        if self.waiting_beams >= BEAMS_AT_ONCE:
            self.finish()

    def finish(self) -> None:
        """Looks at the scans that wait; together, because that is faster."""
        if not self.waiting:
            return
        beams = [scan.ranges.size for scan in self.waiting]
        poses = [scan.pose for scan in self.waiting]
        x, y, theta = np.repeat(poses, beams, axis=0).T
        ranges = np.concatenate([scan.ranges for scan in self.waiting])
        angles = np.concatenate([scan.angles for scan in self.waiting])
        z, hit, _ = read_ranges(ranges, self.max_range, "ignore")
        hit &= ranges >= self.min_range
        pose = Pose(x[hit], y[hit], theta[hit])
        ex, ey = beam_endpoints(pose, angles[hit], z[hit])
        points = np.array([[*ex, *x], [*ey, *y]])
        self.low = np.minimum(self.low, points.min(axis=1))
        self.high = np.maximum(self.high, points.max(axis=1))
        self.waiting, self.waiting_beams = [], 0


def fit(bounds: Bounds, request: Request) -> Fitted:
    """The smallest grid around the bounds and the margin.

    Raises ConversionError where it has more than ``max_cells`` cells.
    """
    (x, width), (y, height) = (
        _fit_axis(low, high, request)
        for low, high in zip(bounds.low, bounds.high, strict=True)
    )
    cells = width * height
    if cells > request.max_cells:
        with localcontext(prec=2, rounding=ROUND_UP):
            enough = (
                request.resolution
                * (Decimal(cells) / request.max_cells).sqrt()
            )
        raise ConversionError(
            f"{request.log}: a grid of {width} x {height} = {cells} cells, more than "
            f"{request.max_cells}: choose a larger --resolution (about {enough:f}), a "
            "smaller --max-range, fewer --scans or a larger --max-cells"
        )
    return Fitted(width, height, x, y)


def _fit_axis(
    low: float, high: float, request: Request
) -> tuple[Decimal, int]:
    """Origin and number of cells along one axis."""
    resolution, margin = request.resolution, request.margin
    with localcontext(prec=60, rounding=ROUND_FLOOR):
        first = int(((Decimal(low) - margin) / resolution).to_integral_value())
        last = int(((Decimal(high) + margin) / resolution).to_integral_value())
        origin = first * resolution
        # the mapper divides doubles: at an edge it may see the next cell
        last = max(last, first + _cell(high, origin, resolution))
    return origin, last - first + 1


def _cell(value: float, origin: Decimal, resolution: Decimal) -> int:
    """The cell of a coordinate as the mapper computes it."""
    spec = GridSpec(1, 1, float(resolution), float(origin), 0.0)
    gx, _ = OccupancyGrid(spec).world_to_grid(np.array([value]), np.zeros(1))
    return int(gx[0])
