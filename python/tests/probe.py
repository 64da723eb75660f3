"""The port's probe: lays open what the contract is made of to the suite's tests (see CONTRIBUTING.md).

usage: probe.py FUNCTION INPUT OUTPUT

Each line of INPUT holds the input columns of FUNCTION, each line of OUTPUT its output columns, separated by one space.
Doubles are 16 hexadecimal digits, words of Philox 8, integers decimal, flags 0 or 1.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np

from occgrid import portable_math
from occgrid.fast import clip_ray
from occgrid.grid import GridSpec, OccupancyGrid, logit, sigmoid
from occgrid.map_writer import pixel
from occgrid.noise import normal_deviate, philox4x32
from occgrid.portable_math import Array
from occgrid.ray import bresenham
from occgrid.sensor import (
    NoReturn,
    beam_endpoints,
    flaser_angles,
    read_ranges,
)
from occgrid.world import Pose

NO_RETURN: dict[str, NoReturn] = {"free": "free", "ignore": "ignore"}


def doubles(words: Iterable[str]) -> Array:
    bits = np.array([int(word, 16) for word in words], dtype=np.uint64)
    return bits.view(np.float64)


def double_words(values: Array) -> list[str]:
    values = np.where(np.isnan(values), np.nan, values)  # one of all the NaNs
    return [f"{bits:016x}" for bits in values.view(np.uint64).tolist()]


def numbers(values: Iterable[object]) -> str:
    return " ".join(map(str, values))


# One function each, from the lines' fields to the lines of the answer.
Rows = Sequence[list[str]]


def of_doubles(function: Callable[[Array], Array], rows: Rows) -> list[str]:
    return double_words(function(doubles(row[0] for row in rows)))


def answer_logit(rows: Rows) -> list[str]:
    p = doubles(row[0] for row in rows).tolist()
    return double_words(np.array([logit(value) for value in p]))


def answer_world_to_grid(rows: Rows) -> Iterator[str]:
    for row in rows:
        resolution, origin_x, origin_y, x, y = doubles(row).tolist()
        grid = OccupancyGrid(GridSpec(1, 1, resolution, origin_x, origin_y))
        yield numbers(grid.world_to_grid(x, y))


def answer_bresenham(rows: Rows) -> Iterator[str]:
    for row in rows:
        gx0, gy0, gx1, gy1 = map(int, row)
        gx, gy = bresenham(gx0, gy0, gx1, gy1)
        cells = zip(gx.tolist(), gy.tolist(), strict=True)
        yield " ".join(f"{x}:{y}" for x, y in cells)


def answer_clip_ray(rows: Rows) -> Iterator[str]:
    for row in rows:
        gx0, gy0, gx1, gy1 = np.array(row[:4], dtype=np.int64)
        found = clip_ray(gx0, gy0, gx1, gy1, int(row[4]), int(row[5]))
        first, last = map(int, found)
        yield f"{first} {last}" if first <= last else "0 -1"


def answer_flaser_angles(rows: Rows) -> list[str]:
    angles = {row[0]: flaser_angles(int(row[0])) for row in rows}
    return double_words(np.array([angles[n][int(i)] for n, i in rows]))


def answer_read_ranges(rows: Rows) -> Iterator[str]:
    for reading, z_max, no_return in rows:
        z, hit, used = read_ranges(
            doubles([reading]),
            float(doubles([z_max])[0]),
            NO_RETURN[no_return],
        )
        yield numbers([*double_words(z), int(hit[0]), int(used[0])])


def answer_beam_endpoints(rows: Rows) -> Iterator[str]:
    for row in rows:
        x, y, theta, angle, z = doubles(row)
        pose = Pose(float(x), float(y), float(theta))
        ends = beam_endpoints(pose, np.array([angle]), np.array([z]))
        yield numbers(double_words(np.concatenate(ends)))


def answer_update_cell(rows: Rows) -> list[str]:
    values = []
    for *model, updates in rows:
        grid = OccupancyGrid(
            GridSpec(1, 1, 1.0, 0.0, 0.0), *doubles(model).tolist()
        )
        for letter in updates:
            evidence = {"o": grid.l_occ, "f": grid.l_free}[letter]
            grid.update_cell(0, 0, evidence)
        values.append(grid.log_odds[0, 0])
    return double_words(np.array(values))


def answer_pixel(rows: Rows) -> list[str]:
    return list(map(str, pixel(doubles(row[0] for row in rows)).tolist()))


def answer_philox(rows: Rows) -> Iterator[str]:
    for row in rows:
        *counter, k0, k1 = (int(word, 16) for word in row)
        column = np.array(counter, dtype=np.uint64).reshape(4, 1)
        words = philox4x32(column, (k0, k1))[:, 0].tolist()
        yield " ".join(f"{word:08x}" for word in words)


def answer_normal_deviate(rows: Rows) -> Iterator[str]:
    for seed, scan, beam in rows:
        deviates = normal_deviate(int(seed), int(scan), [int(beam)])
        yield from double_words(deviates)


ANSWERS: dict[str, Callable[[Rows], Iterable[str]]] = {
    "sin": lambda rows: of_doubles(portable_math.sin, rows),
    "cos": lambda rows: of_doubles(portable_math.cos, rows),
    "exp": lambda rows: of_doubles(portable_math.exp, rows),
    "log": lambda rows: of_doubles(portable_math.log, rows),
    "logit": answer_logit,
    "sigmoid": lambda rows: of_doubles(sigmoid, rows),
    "world_to_grid": answer_world_to_grid,
    "bresenham": answer_bresenham,
    "clip_ray": answer_clip_ray,
    "flaser_angles": answer_flaser_angles,
    "read_ranges": answer_read_ranges,
    "beam_endpoints": answer_beam_endpoints,
    "update_cell": answer_update_cell,
    "pixel": answer_pixel,
    "philox": answer_philox,
    "normal_deviate": answer_normal_deviate,
}


def main(function: str, source: str, target: str) -> None:
    lines = Path(source).read_text(encoding="ascii").splitlines()
    answers = ANSWERS[function]([line.split(" ") for line in lines])
    with Path(target).open("w", encoding="ascii", newline="\n") as output:
        output.writelines(f"{answer}\n" for answer in answers)


if __name__ == "__main__":
    main(*sys.argv[1:])
