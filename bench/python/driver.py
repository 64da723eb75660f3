"""What the Python programs of the benchmark share: the work, and the answers to its requests (see cpp/driver.hpp)."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class Work(NamedTuple):
    """Poses (scans, 3) and ranges (scans, beams) that every contestant maps; metres, radians."""

    width: int
    height: int
    resolution: float
    origin_x: float
    origin_y: float
    max_range: float
    angles: Array
    poses: Array
    ranges: Array


def read_work(path: str) -> Work:
    with Path(path).open() as lines:
        head = next(lines).split()
        angles = np.array(next(lines).split(), dtype=np.float64)
        scans = np.array([line.split() for line in lines], dtype=np.float64)
    sizes = int(head[0]), int(head[1])
    resolution, origin_x, origin_y, max_range = map(float, head[2:6])
    return Work(
        *sizes,
        resolution,
        origin_x,
        origin_y,
        max_range,
        angles,
        scans[:, :3],
        scans[:, 3:],
    )


def answer_requests(
    map_work: Callable[[], object], log_odds: Callable[[], Array]
) -> None:
    """Answer requests until the input ends.

    map_work() maps the work into a grid of its own; log_odds() is what it mapped last, (height, width).
    """
    for line in sys.stdin:
        verb, argument = line.split()
        if verb == "map":
            for _ in range(int(argument)):
                start = time.perf_counter()
                map_work()
                print(time.perf_counter() - start, end=" ")
            print(flush=True)
        else:
            values = log_odds()
            height, width = values.shape
            rows = (" ".join(map(repr, row)) for row in values.tolist())
            text = f"# logodds {width} {height}\n" + "\n".join(rows) + "\n"
            Path(argument).write_text(text)
            print("written", flush=True)
