"""Scenarios with random faults: a valid one, changed in one to three places. The same for the same seed."""

from __future__ import annotations

import random
from collections.abc import Callable

VALID = [
    """# a scenario with every kind of line
PARAM robot_width 0.4
PARAM occgrid_width 12
PARAM occgrid_height 9
PARAM occgrid_resolution 0.5
PARAM occgrid_origin_x -3
PARAM occgrid_origin_y -2.5
PARAM occgrid_max_range 6
PARAM occgrid_min_range 0.25
PARAM occgrid_p0 0.4
PARAM occgrid_p_occ 0.8   # a comment
PARAM occgrid_p_free 0.25
PARAM occgrid_l_min -5
PARAM occgrid_l_max 5.5
PARAM occgrid_no_return ignore
PARAM occgrid_fov 3.1
PARAM occgrid_beams 7
PARAM occgrid_noise_std 0.05

WALL -2.5 -2 2.5 -2
WALL 2.5 -2 2.5 1.75 # the last
POSE 0.1 0.2 0.3
ODOM 0 0 0 0.1
FLASER 3 1.5 0.2 inf 0.5 -0.5 1.57 0 0 0 1 host 2
ROBOTLASER1 0 -1.5 3 0.75 9 0.01 0 4 1 2 3 nan 2 5 6 1 0.5 0 0 0 0 0 0 0 0 0 1 host 2
POSE -1 1 -2.5
""",
    """PARAM occgrid_max_range 3
PARAM occgrid_height 2
PARAM occgrid_width 5
PARAM occgrid_origin_y 0
PARAM occgrid_origin_x 0
PARAM occgrid_resolution 1
FLASER 2 1 2 0.5 0.5 0 0 0 0 1.5 host 2.5
FLASER 1 2.5 0.5 0.5 1 0 0 0 1.5 #host 2.5
""",
    """PARAM\toccgrid_width 3
PARAM occgrid_height\t4
PARAM occgrid_resolution 1.5
PARAM occgrid_origin_x 1e1
PARAM occgrid_origin_y +2.5E+0
PARAM occgrid_max_range .5e1
WALL 10 0 10 9
POSE 11 3. 1.25
POSE 12 4 -.25 # here

ROBOTLASER1 0 0 0 0 0 0 0 1 2.5 0 11 3 0 0 0 0 0 0 0 0 0 0 0 0
""",
]

# No whole number between what is small and what is refused: a grid of millions of cells would be a valid scenario, and
# a slow one.
TOKENS = (
    "0 -0 1 2 3 1.5 -1 -0.5 +2 007 4.0 1e2 .5 5. nan NaN -nan inf -inf Infinity infinit 1e999 1e-999 -1e-301 1e300 "
    "1e7 -10000000 10000000.000000002 -10000001 1e6 1000001.0 1000.0000000000002 10000.000000000002 0.0009999 "
    "6.283185307179587 0.99999999999999999 25000001 99999999999999999999 x 0x1 1_0 1,5 1d3 1e 1e+ . - -- # #1 1#2 "
    "free ignore Free POSE WALL PARAM FLASER pose occgrid_p0 occgrid_width occgrid_nothing '1' \"1\" %s $x \\n 1/2"
).split()
BYTES = [b"\x00", b"\x0b", b"\x0c", b"\r", b"\x1a", b"\x7f", b"\xa0", b"\xe9"]
BYTES += [b"\xc2\x85", b"\xef\xbb\xbf", b" ", b"\t", b"#", b"-", b".", b"\n"]

Lines = list[list[str]]


def mutant(seed: int) -> bytes:
    """A scenario with faults; now and then they leave it valid."""
    source = random.Random(seed)
    text = VALID[seed % len(VALID)]
    lines = [line.split(" ") for line in text.splitlines()]
    for _ in range(source.choice([1, 1, 1, 2, 3])):
        source.choice(LINE_FAULTS)(source, lines)
    end = source.choice(["\n", "\n", "\n", "\r\n"])
    data = end.join(" ".join(line) for line in lines).encode("ascii")
    if source.random() < 0.25:
        at = source.randrange(len(data))
        width = source.choice([0, 1])  # before a byte, or in its place
        data = data[:at] + source.choice(BYTES) + data[at + width :]
    if source.random() < 0.1:
        data = data[: source.randrange(len(data))]
    return data + source.choice([b"", end.encode("ascii")])


def _place(source: random.Random, lines: Lines) -> tuple[list[str], int]:
    """One of the lines that have fields, and one of its fields."""
    line = source.choice([line for line in lines if line != [""]])
    return line, source.randrange(len(line))


def _replace_field(source: random.Random, lines: Lines) -> None:
    line, at = _place(source, lines)
    line[at] = source.choice(TOKENS)


def _replace_value(source: random.Random, lines: Lines) -> None:
    line, _ = _place(source, lines)
    line[-1] = source.choice(TOKENS)


def _insert_field(source: random.Random, lines: Lines) -> None:
    line, at = _place(source, lines)
    line.insert(at + 1, source.choice(TOKENS))


def _drop_field(source: random.Random, lines: Lines) -> None:
    line, at = _place(source, lines)
    if len(line) > 1:
        del line[at]


def _swap_fields(source: random.Random, lines: Lines) -> None:
    line, at = _place(source, lines)
    other = source.randrange(len(line))
    line[at], line[other] = line[other], line[at]


def _drop_line(source: random.Random, lines: Lines) -> None:
    if len(lines) > 1:
        del lines[source.randrange(len(lines))]


def _copy_line(source: random.Random, lines: Lines) -> None:
    line = list(source.choice(lines))
    lines.insert(source.randrange(len(lines) + 1), line)


def _move_line(source: random.Random, lines: Lines) -> None:
    line = lines.pop(source.randrange(len(lines)))
    lines.insert(source.randrange(len(lines) + 1), line)


def _join_lines(source: random.Random, lines: Lines) -> None:
    at = source.randrange(len(lines))
    if at + 1 < len(lines):
        lines[at] += lines.pop(at + 1)


LINE_FAULTS: list[Callable[[random.Random, Lines], None]] = [
    *3 * [_replace_field],
    *3 * [_replace_value],
    _insert_field,
    _drop_field,
    _swap_fields,
    _drop_line,
    _copy_line,
    _move_line,
    _join_lines,
]
