"""The lesson's mapping written down plainly: a list of cells for each beam, a look at the borders for each update.

usage: lesson_driver.py WORK
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from driver import Array, Work, answer_requests, read_work


def logit(p: float) -> float:
    return math.log(p / (1.0 - p))


class Grid:
    def __init__(self, work: Work) -> None:
        self.work = work
        self.l0 = logit(0.5)
        self.l_occ = logit(0.75)
        self.l_free = logit(0.30)
        self.l_min, self.l_max = -8.0, 8.0
        self.log_odds = np.full((work.height, work.width), self.l0)

    def world_to_grid(self, x: float, y: float) -> tuple[int, int]:
        gx = math.floor((x - self.work.origin_x) / self.work.resolution)
        gy = math.floor((y - self.work.origin_y) / self.work.resolution)
        return gx, gy

    def update_cell(self, gx: int, gy: int, l_update: float) -> None:
        if not (0 <= gx < self.work.width and 0 <= gy < self.work.height):
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


def update_from_scan(grid: Grid, pose: list[float], ranges: Array) -> None:
    x, y, theta = pose
    max_range = grid.work.max_range
    gx, gy = grid.world_to_grid(x, y)
    for angle, measured in zip(grid.work.angles, ranges, strict=True):
        heading = theta + float(angle)
        z = min(float(measured), max_range)
        end = grid.world_to_grid(
            x + z * math.cos(heading), y + z * math.sin(heading)
        )
        cells = bresenham(gx, gy, *end)
        hit = z < max_range - 1e-12
        for cell in cells[:-1] if hit else cells:
            grid.update_cell(*cell, grid.l_free)
        if hit:
            grid.update_cell(*cells[-1], grid.l_occ)


def main() -> None:
    work = read_work(sys.argv[1])
    mapped: list[Grid] = []

    def map_work() -> None:
        grid = Grid(work)
        for pose, ranges in zip(work.poses.tolist(), work.ranges, strict=True):
            update_from_scan(grid, pose, ranges)
        mapped[:] = [grid]

    def log_odds() -> Array:
        return mapped[0].log_odds

    answer_requests(map_work, log_odds)


if __name__ == "__main__":
    main()
