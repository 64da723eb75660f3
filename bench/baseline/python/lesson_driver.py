"""The lesson's mapping written down plainly: a list of cells for each beam, a look at the borders for each update.

usage: lesson_driver.py WORK
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from driver import Array, answer_requests, read_work


def logit(p: float) -> float:
    return math.log(p / (1.0 - p))


@dataclass
class GridSpec:
    width: int
    height: int
    resolution: float
    origin_x: float
    origin_y: float


class Grid:
    def __init__(self, spec: GridSpec) -> None:
        self.spec = spec
        self.l0 = logit(0.5)
        self.l_occ = logit(0.75)
        self.l_free = logit(0.30)
        self.l_min, self.l_max = -8.0, 8.0
        self.log_odds = np.full((spec.height, spec.width), self.l0)

    def world_to_grid(self, x: float, y: float) -> tuple[int, int]:
        gx = math.floor((x - self.spec.origin_x) / self.spec.resolution)
        gy = math.floor((y - self.spec.origin_y) / self.spec.resolution)
        return gx, gy

    def in_bounds(self, gx: int, gy: int) -> bool:
        return 0 <= gx < self.spec.width and 0 <= gy < self.spec.height

    def update_cell(self, gx: int, gy: int, l_update: float) -> None:
        if not self.in_bounds(gx, gy):
            return
        self.log_odds[gy, gx] += l_update - self.l0
        if self.log_odds[gy, gx] > self.l_max:
            self.log_odds[gy, gx] = self.l_max
        elif self.log_odds[gy, gx] < self.l_min:
            self.log_odds[gy, gx] = self.l_min


def bresenham(x: int, y: int, x_end: int, y_end: int) -> list[tuple[int, int]]:
    cells = []
    dx, dy = abs(x_end - x), abs(y_end - y)
    x_step = 1 if x < x_end else -1
    y_step = 1 if y < y_end else -1
    error = dx - dy
    while True:
        cells.append((x, y))
        if x == x_end and y == y_end:
            return cells
        twice = 2 * error
        if twice > -dy:
            error -= dy
            x += x_step
        if twice < dx:
            error += dx
            y += y_step


def update_from_scan(
    grid: Grid, pose: list[float], angles: Array, ranges: Array, z_max: float
) -> None:
    x, y, theta = pose
    gx0, gy0 = grid.world_to_grid(x, y)
    for angle, measured in zip(angles, ranges, strict=True):
        heading = theta + float(angle)
        z = min(float(measured), z_max)
        gx1, gy1 = grid.world_to_grid(
            x + z * math.cos(heading), y + z * math.sin(heading)
        )
        cells = bresenham(gx0, gy0, gx1, gy1)
        hit = z < z_max - 1e-12
        for gx, gy in cells[:-1] if hit else cells:
            grid.update_cell(gx, gy, grid.l_free)
        if hit:
            gx, gy = cells[-1]
            grid.update_cell(gx, gy, grid.l_occ)


def main() -> None:
    work = read_work(sys.argv[1])
    mapped: list[Grid] = []

    def map_work() -> None:
        grid = Grid(GridSpec(*work[:5]))
        for pose, ranges in zip(work.poses.tolist(), work.ranges, strict=True):
            update_from_scan(grid, pose, work.angles, ranges, work.max_range)
        mapped[:] = [grid]

    def log_odds() -> Array:
        return mapped[0].log_odds

    answer_requests(map_work, log_odds)


if __name__ == "__main__":
    main()
