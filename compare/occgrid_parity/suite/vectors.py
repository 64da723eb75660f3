"""The shared vectors: arguments and right results of the contract's functions."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from occgrid_parity.suite.cases import scenario_folder

# the last columns of each file, which are results; those before are arguments
RESULTS = {
    "beam_endpoints": ["ex", "ey"],
    "bresenham": ["cells"],
    "clip_ray": ["first", "last"],
    "cos": ["y"],
    "exp": ["y"],
    "flaser_angles": ["angle"],
    "log": ["y"],
    "logit": ["log_odds"],
    "normal_deviate": ["deviate"],
    "philox": ["w0", "w1", "w2", "w3"],
    "pixel": ["pixel"],
    "read_ranges": ["z", "hit", "used"],
    "sigmoid": ["p"],
    "sin": ["y"],
    "update_cell": ["log_odds"],
    "world_to_grid": ["gx", "gy"],
}
FUNCTIONS = tuple(RESULTS)


class Vectors(NamedTuple):
    """What a file holds, as the probe is asked and answers."""

    arguments: list[str]  # the columns' names
    questions: list[str]
    answers: list[str]


def read_vectors(function: str, folder: Path | None = None) -> Vectors:
    """The file of a function. Raises ValueError where a line does not fit its columns."""
    place = folder or scenario_folder() / "vectors"
    lines = (place / f"{function}.csv").read_text("ascii").splitlines()
    columns, *rows = [line.split(",") for line in lines]
    results = len(RESULTS[function])
    if columns[-results:] != RESULTS[function]:
        raise ValueError(f"{function}.csv: {columns}")
    for number, row in enumerate(rows, start=2):
        if len(row) != len(columns) or not all(row):
            raise ValueError(f"{function}.csv:{number}: {row}")
    return Vectors(
        columns[:-results],
        [" ".join(row[:-results]) for row in rows],
        [" ".join(row[-results:]) for row in rows],
    )
