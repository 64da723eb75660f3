"""The Python port at the benchmark's work.

usage: port_driver.py WORK log|scan|plain

log: all scans at once; scan: the same module, one scan after another; plain: update_grid_from_scan, one scan after
another.
"""

from __future__ import annotations

import sys

from driver import Array, answer_requests, read_work

from occgrid.fast import update_grid_from_scans
from occgrid.grid import GridSpec, OccupancyGrid
from occgrid.sensor import Scan, update_grid_from_scan
from occgrid.world import Pose


def main() -> None:
    work = read_work(sys.argv[1])
    how = sys.argv[2]
    spec = GridSpec(*work[:5])
    scans = [
        Scan(Pose(*pose), work.angles, ranges)
        for pose, ranges in zip(work.poses.tolist(), work.ranges, strict=True)
    ]
    mapped: list[OccupancyGrid] = []

    def map_work() -> None:
        grid = OccupancyGrid(spec)
        if how == "log":
            update_grid_from_scans(grid, scans, work.max_range)
        elif how == "scan":
            for scan in scans:
                update_grid_from_scans(grid, [scan], work.max_range)
        else:
            for scan in scans:
                update_grid_from_scan(grid, scan, work.max_range)
        mapped[:] = [grid]

    def log_odds() -> Array:
        return mapped[0].log_odds

    answer_requests(map_work, log_odds)


if __name__ == "__main__":
    main()
