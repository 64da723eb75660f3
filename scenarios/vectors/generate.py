"""Write the shared vectors of this folder: python scenarios/vectors/generate.py [FOLDER]

README.md says what they are. No value comes from a port: `definitions.py` has
the contract's functions in exact arithmetic, `strict_math.py` asks Java for
sin, cos, exp and log. `arguments.py` chooses what is asked.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

import arguments
import definitions
from exact import hexadecimal
from strict_math import strict_math

Row = Sequence[object]


def main(folder: Path) -> None:
    """Writes every file of vectors into ``folder``."""
    rows: list[Row]
    for function, values in (
        ("sin", arguments.angles()),
        ("cos", arguments.angles()),
        ("exp", arguments.exponents()),
        ("log", arguments.logarithm_arguments()),
    ):
        write(
            folder,
            function,
            "x y",
            pairs(values, strict_math(function, values)),
        )

    ps = arguments.probabilities()
    write(folder, "logit", "p log_odds", pairs(ps, definitions.logit(ps)))
    log_odds = arguments.log_odds()
    write(
        folder,
        "sigmoid",
        "log_odds p",
        pairs(log_odds, definitions.sigmoid(log_odds)),
    )
    log_odds = arguments.pixel_log_odds()
    write(
        folder,
        "pixel",
        "log_odds pixel",
        pairs(log_odds, definitions.pixel(log_odds)),
    )
    rows = [
        (*row, *definitions.world_to_grid(*row)) for row in arguments.points()
    ]
    write(
        folder, "world_to_grid", "resolution origin_x origin_y x y gx gy", rows
    )
    updates = arguments.updates()
    rows = [
        (*row, value)
        for row, value in zip(
            updates, definitions.update_cell(updates), strict=True
        )
    ]
    write(
        folder,
        "update_cell",
        "p0 p_occ p_free l_min l_max updates log_odds",
        rows,
    )

    rows = [
        (*row, cells(definitions.bresenham(*row))) for row in arguments.lines()
    ]
    write(folder, "bresenham", "gx0 gy0 gx1 gy1 cells", rows)
    rows = [
        (*row, *definitions.clip_ray(*row))
        for row in arguments.clipped_lines()
    ]
    write(folder, "clip_ray", "gx0 gy0 gx1 gy1 width height first last", rows)

    rows = [
        (*row, definitions.flaser_angle(*row))
        for row in arguments.flaser_beams()
    ]
    write(folder, "flaser_angles", "n_beams beam angle", rows)
    rows = [
        (*row, *definitions.read_range(*row)) for row in arguments.ranges()
    ]
    write(folder, "read_ranges", "range z_max no_return z hit used", rows)
    beams = arguments.beams()
    rows = [
        (*row, *end)
        for row, end in zip(
            beams, definitions.beam_endpoints(beams), strict=True
        )
    ]
    write(folder, "beam_endpoints", "x y theta angle z ex ey", rows)

    rows = [
        (*map(word, row), *map(word, definitions.philox(row[:4], row[4:])))
        for row in arguments.philox_words()
    ]
    write(folder, "philox", "c0 c1 c2 c3 k0 k1 w0 w1 w2 w3", rows)
    deviates = arguments.deviates()
    rows = [
        (*row, value)
        for row, value in zip(
            deviates, definitions.normal_deviate(deviates), strict=True
        )
    ]
    write(folder, "normal_deviate", "seed scan beam deviate", rows)


def pairs(arguments: Iterable[object], results: Iterable[object]) -> list[Row]:
    """Rows of one argument and one result each."""
    return list(zip(arguments, results, strict=True))


def cells(line: Iterable[tuple[int, int]]) -> str:
    """The cells of a line as one column."""
    return " ".join(f"{gx}:{gy}" for gx, gy in line)


def word(value: int) -> str:
    """A word of Philox."""
    return f"{value:08x}"


def write(
    folder: Path, function: str, columns: str, rows: Iterable[Row]
) -> None:
    """Writes FUNCTION.csv: the columns' names, then the rows."""
    lines = [",".join(columns.split())]
    for row in rows:
        fields = [
            hexadecimal(field) if isinstance(field, float) else str(field)
            for field in row
        ]
        assert len(fields) == len(columns.split())
        lines.append(",".join(fields))
    text = "".join(f"{line}\n" for line in lines)
    (folder / f"{function}.csv").write_text(
        text, encoding="ascii", newline="\n"
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
