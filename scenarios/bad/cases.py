"""The bad scenarios: for each its file's name, its bytes, and the line and reason of its error.

One function for each group of rules of SPEC.md, in the order of its section 8.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

GRID = """PARAM occgrid_width 4
PARAM occgrid_height 3
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 10
# the scenarios of this folder begin with this good grid
"""
POSE = "POSE 0.5 0.5 0\n"
FLASER = "FLASER 2 1 2 0.5 0.5 0 0 0 0 1.5 host 2.5\n"
ROBOTLASER1 = (
    "ROBOTLASER1 0 -1.5 3 3 81.9 0.1 0 2 1 2 0 0.5 0.5 0" + " 0" * 11 + "\n"
)
REQUIRED = "width height resolution origin_x origin_y max_range".split()


class Case(NamedTuple):
    """One bad scenario."""

    name: str
    data: bytes
    line: int
    reason: str


def all_cases() -> list[Case]:
    """Every case, group after group."""
    groups = (
        without_a_scan,
        not_ascii,
        lines_as_they_are_counted,
        keywords,
        places,
        numbers_of_values,
        parameter_names,
        malformed_numbers,
        parameter_limits,
        scan_limits,
        flaser,
        robotlaser1,
        missing_parameters,
        joint_rules,
        orders,
    )
    return [case for group in groups for case in group()]


# --- how a case is made ----------------------------------------------------


def case(name: str, text: str, line: int, reason: str) -> Case:
    """A case of a whole text, written as Latin-1: a character is a byte."""
    return Case(name, text.encode("latin-1"), line, reason)


def after_grid(name: str, line: str, reason: str) -> Case:
    """A case with a wrong line 8, the first after the good grid."""
    return case(name, f"{GRID}{line}\n{POSE}", 8, reason)


def parameter(name: str, field: str, token: str, reason: str) -> Case:
    """A case whose line 1 gives a parameter a wrong value."""
    line = f"PARAM occgrid_{field} {token}\n"
    return case(name, line + GRID + POSE, 1, f"occgrid_{field} {reason}")


def with_field(line: str, place: int, token: str) -> str:
    """The line with another field in that place, counted from 0."""
    fields = line.split()
    fields[place] = token
    return " ".join(fields)


def changed(**values: str) -> str:
    """The good grid with other values; further parameters follow from line 8 on."""
    lines = GRID.splitlines()
    for field, value in values.items():
        new = f"PARAM occgrid_{field} {value}"
        at = [i for i, old in enumerate(lines) if f"occgrid_{field} " in old]
        if at:
            lines[at[0]] = new
        else:
            lines.append(new)
    return "".join(f"{line}\n" for line in lines)


def without(parameter: str) -> str:
    """The good grid without one of its parameters: six lines."""
    lines = GRID.splitlines(keepends=True)
    return "".join(x for x in lines if f"occgrid_{parameter} " not in x)


# --- the file and its lines ------------------------------------------------


def without_a_scan() -> Iterator[Case]:
    reason = "no scan"
    yield case("no-scan-empty", "", 0, reason)
    yield case("no-scan-blank", "\n\n \t \n", 3, reason)
    yield case("no-scan-comment-only", "# nothing", 1, reason)
    yield case("no-scan-grid-only", GRID, 7, reason)
    yield case("no-scan-no-last-end", GRID.rstrip("\n"), 7, reason)
    others = "ODOM 1 2 3\nPARAM robot_width 1\nPARAM\nSYNC x\n"
    yield case("no-scan-other-programs-lines", others, 4, reason)
    yield case("no-scan-small-letters", GRID + "pose 0 0 0\n", 8, reason)
    comments = "# POSE 0 0 0\n  #POSE 0 0 0\n"
    yield case("no-scan-in-a-comment", GRID + comments, 9, reason)
    yield case("no-scan-longer-keyword", GRID + "POSE2 0 0 0\n", 8, reason)


def not_ascii() -> Iterator[Case]:
    reason = "not plain ASCII text"
    for name, line in (
        ("latin-1", "ODOM caf\xe9 1"),
        ("utf-8", "ODOM caf\xc3\xa9 1"),
        ("control-character", "POSE 0 0 0\x01"),
        ("escape-character", "POSE 0 0 \x1b[0m0"),
        ("delete-character", "POSE 0 0 0 \x7f"),
        ("nul", "POSE 0 0\x00 0"),
        ("form-feed", "\x0c"),
        ("vertical-tab", "POSE 0 0\x0b0"),
        ("return-within", "POSE 0 0\r0"),
        ("two-returns", "POSE 0 0 0\r\r"),
        ("returns-only", "\r\r"),
        ("no-break-space", "\xa0POSE 0 0 0"),
        ("next-line-character", "POSE 0 0 0\xc2\x85"),
        ("full-width-digit", "POSE 0 0 \xef\xbc\x91"),
        ("minus-sign", "POSE 0 0 \xe2\x88\x921"),
        ("in-another-programs-line", "SYNC \xff"),
        ("behind-a-comment-sign", "WALL 0 0 1 1 # caf\xe9"),
    ):
        yield after_grid(f"ascii-{name}", line, reason)
    mark = "\xef\xbb\xbf"
    yield case("ascii-byte-order-mark", mark + GRID + POSE, 1, reason)
    yield case(
        "ascii-byte-order-mark-comment", f"{mark}# x\n{POSE}", 1, reason
    )
    only_returns = (GRID + POSE).replace("\n", "\r")
    yield case("ascii-returns-as-line-ends", only_returns, 1, reason)
    wide = "".join(f"{character}\x00" for character in GRID + POSE)
    yield case("ascii-utf-16", wide, 1, reason)


def lines_as_they_are_counted() -> Iterator[Case]:
    """Bad last lines whose number tells how the lines before it were read."""
    good, bad = GRID + POSE, "POSE 1 x 2"
    reason = "y 'x' is not a number"
    returns = f"{good}{bad}\n".replace("\n", "\r\n")
    yield case("lines-crlf", returns, 9, reason)
    yield case("lines-lf-and-crlf", f"{good}\r\nODOM\r\n{bad}\r\n", 11, reason)
    yield case("lines-blank", f"\n\n{good}\n \t\n#\n{bad}\n", 14, reason)
    yield case("lines-tabs", f"{good}\tPOSE\t\t1 \tx\t2\t \n", 9, reason)
    yield case("lines-no-last-end", good + bad, 9, reason)
    yield case("lines-last-end-without-lf", f"{good}{bad}\r", 9, reason)
    yield case("lines-many", f"{good}{50 * POSE}{bad}\n{good}", 59, reason)
    yield case(
        "lines-after-the-error", f"{good}{bad}\nPOSE\n\xff\n", 9, reason
    )
    # what ends a line elsewhere does not do so here, and a comment may hold any byte
    for name, byte in (
        ("nul", "\x00"),
        ("return", "\r"),
        ("vertical-tab", "\x0b"),
        ("form-feed", "\x0c"),
        ("file-separator", "\x1c"),
        ("control-z", "\x1a"),
        ("next-line", "\xc2\x85"),
        ("line-separator", "\xe2\x80\xa8"),
        ("latin-1", "\xe9"),
    ):
        comment = f"# a{byte}POSE x\n"
        yield case(f"lines-comment-{name}", good + comment + bad, 10, reason)
    # fields of other programs' lines are not looked at, after the first scan neither
    others = "PARAM robot_x\nODOM # 1\nPARAM\nWALLS\n_x\n"
    yield case("lines-of-others", good + others + bad, 14, reason)


# --- keywords, places, counts, names ---------------------------------------


def keywords() -> Iterator[Case]:
    for name, line in (
        ("colon", "POSE: 0 0 0"),
        ("comma", "POSE,0,0,0"),
        ("digit-first", "1POSE 0 0 0"),
        ("number", "-1.5"),
        ("comment-glued", "POSE# 0 0 0"),
        ("quote", '"\'"'),
        ("percent", "%d%s%n 1"),
        ("backslash", "\\n 1"),
        ("dollar", "$HOME `x` 1"),
        ("hyphen", "POSE-2 0 0 0"),
        ("brackets", "[POSE] {0} (0)"),
        ("two-slashes", "// POSE 0 0 0"),
    ):
        token = line.split()[0]
        yield after_grid(
            f"keyword-{name}", line, f"'{token}' is not a keyword"
        )
    long = "x" * 300 + "!"
    yield after_grid("keyword-long", long, f"'{long}' is not a keyword")


def places() -> Iterator[Case]:
    wall = "WALL must stand before the first scan"
    param = "PARAM must stand before the first scan"
    prior = "PARAM occgrid_p0 0.4\n"
    for name, scan in (
        ("pose", POSE),
        ("flaser", FLASER),
        ("robotlaser1", ROBOTLASER1),
    ):
        after = GRID + scan
        yield case(
            f"place-wall-after-{name}", after + "WALL 0 0 1 1\n", 9, wall
        )
        yield case(f"place-param-after-{name}", after + prior, 9, param)


def numbers_of_values() -> Iterator[Case]:
    for name, line, reason in (
        ("param-1", "PARAM occgrid_p0", "PARAM takes 2 values, found 1"),
        ("param-3", "PARAM occgrid_p0 4 5", "PARAM takes 2 values, found 3"),
        ("param-comment", "PARAM occgrid_p0 # 4", "PARAM takes 2 values, found 1"),
        ("param-3-comment", "PARAM occgrid_p0 4 5 #6", "PARAM takes 2 values, found 3"),
        ("wall-0", "WALL", "WALL takes 4 values, found 0"),
        ("wall-3", "WALL 1 2 3", "WALL takes 4 values, found 3"),
        ("wall-5", "WALL 1 2 3 4 5", "WALL takes 4 values, found 5"),
        ("wall-comment", "WALL 1 2 3 #4", "WALL takes 4 values, found 3"),
        ("pose-0", "POSE", "POSE takes 3 values, found 0"),
        ("pose-2", "POSE 1 2", "POSE takes 3 values, found 2"),
        ("pose-4", "POSE 1 2 3 4", "POSE takes 3 values, found 4"),
        ("pose-comment", "POSE x # y z", "POSE takes 3 values, found 1"),
        ("pose-only-a-comment", "POSE # 1 2 3", "POSE takes 3 values, found 0"),
    ):  # fmt: skip
        yield after_grid(f"count-{name}", line, reason)


def parameter_names() -> Iterator[Case]:
    for name, unknown in (
        ("misspelt", "occgrid_hight"),
        ("capital", "occgrid_P0"),
        ("empty", "occgrid_"),
        ("comment-glued", "occgrid_p0#1"),
        ("longer", "occgrid_min_range_"),
        ("twice-the-prefix", "occgrid_occgrid_p0"),
    ):
        reason = f"unknown parameter {unknown}"
        yield after_grid(f"name-{name}", f"PARAM {unknown} 0.5", reason)
    again = "PARAM occgrid_width 4"
    yield after_grid("name-twice", again, "occgrid_width is given twice")
    twice = 2 * "PARAM occgrid_p0 0.5\n"
    text = GRID + twice + POSE
    yield case("name-twice-default", text, 9, "occgrid_p0 is given twice")


# --- values ----------------------------------------------------------------


def malformed_numbers() -> Iterator[Case]:
    for name, token in (
        ("word", "x"),
        ("hexadecimal", "0x10"),
        ("binary", "0b1"),
        ("exponent-empty", "1e"),
        ("exponent-sign-only", "1e+"),
        ("exponent-twice", "1e5e5"),
        ("exponent-only", "e5"),
        ("exponent-with-point", "1e5.0"),
        ("exponent-d", "1d3"),
        ("exponent-wolfram", "1*^3"),
        ("points-two", "1.5.2"),
        ("point-only", "."),
        ("sign-only", "-"),
        ("signs-two", "--1"),
        ("signs-plus-minus", "+-1"),
        ("sign-behind", "1-"),
        ("underscore", "1_000"),
        ("comma", "1,5"),
        ("colon", "1:2"),
        ("fraction", "1/2"),
        ("suffix-f", "1f"),
        ("imaginary", "1i"),
        ("brackets", "[1]"),
        ("quotes", "'1'"),
        ("double-quotes", '"1"'),
        ("pi", "pi"),
        ("comment-glued", "0#x"),
        ("nan-argument", "nan(1)"),
        ("nan-longer", "nanx"),
        ("inf-shorter", "in"),
        ("inf-longer", "infinit"),
        ("inf-1", "1.#INF"),
    ):
        reason = f"y '{token}' is not a number"
        yield after_grid(f"number-{name}", f"POSE 0 {token} 0", reason)
    for name, token in (
        ("point-zero", "4.0"),
        ("plus", "+4"),
        ("minus", "-4"),
        ("exponent", "1e1"),
        ("hexadecimal", "0x4"),
        ("word", "four"),
        ("nan", "nan"),
        ("underscore", "1_0"),
        ("comment-glued", "4#x"),
    ):
        reason = f"'{token}' is not a whole number"
        yield parameter(f"whole-{name}", "width", token, reason)
    yield parameter(
        "whole-beams", "beams", "1.5", "'1.5' is not a whole number"
    )
    for place, field in enumerate(("x0", "y0", "x1", "y1"), start=1):
        line = with_field("WALL 0 0 1 1", place, "a")
        yield after_grid(
            f"number-wall-{field}", line, f"{field} 'a' is not a number"
        )
    for place, field in enumerate(("x", "y", "theta"), start=1):
        line = with_field("POSE 0 0 1", place, "a")
        yield after_grid(
            f"number-pose-{field}", line, f"{field} 'a' is not a number"
        )
    for field in ("resolution", "p0", "l_max", "min_range"):
        yield parameter(f"number-{field}", field, "a", "'a' is not a number")
    for token in ("Free", "ignored", "0"):
        reason = f"'{token}' is not free or ignore"
        yield parameter(f"no-return-{token}", "no_return", token, reason)


def parameter_limits() -> Iterator[Case]:
    coordinate = ("-10000000", "10000000")
    for field, low, high, tokens in (
        ("width", "1", "25000000", "0 25000001 00000 99999999999999999999999"),
        ("height", "1", "25000000", "0 25000001 18446744073709551617"),
        ("resolution", "0.001", "1000", "0.00099999999999999 1000.0000000000002 -1 nan"),
        ("origin_x", *coordinate, "10000000.000000002 NAN -Infinity"),
        ("origin_y", *coordinate, "-10000000.000000002 1e6001 +nan"),
        ("max_range", "0.001", "10000", "0.0009 10000.000000000002 inf 1e-310"),
        ("min_range", "0", "10000", "-0.5 -1e-300 10000.000000000002 nan inf"),
        ("l_min", "-1000", "1000", "-1000.0000000000001 1e9 nan"),
        ("l_max", "-1000", "1000", "1000.0000000000001 -inf"),
        ("fov", "0", "6.283185307179586", "6.283185307179587 -0.1 nan"),
        ("beams", "1", "100000", "0 100001"),
        ("noise_std", "0", "1000", "-1e-299 1000.0000000000002 nan"),
    ):  # fmt: skip
        for number, token in enumerate(tokens.split(), start=1):
            reason = f"'{token}' is not from {low} to {high}"
            yield parameter(f"limit-{field}-{number}", field, token, reason)
    for field, tokens in (
        ("p0", "0 1 -0.5 nan inf 1e-301 0.99999999999999999"),
        ("p_occ", "1 1.5"),
        ("p_free", "0 nan"),
    ):
        for number, token in enumerate(tokens.split(), start=1):
            reason = f"'{token}' is not between 0 and 1"
            yield parameter(f"limit-{field}-{number}", field, token, reason)
    # half an ulp above the limit would round to it; a little more does not
    token = "10000000.000000000931322574615478515625" + "0" * 30 + "1"
    reason = f"'{token}' is not from -10000000 to 10000000"
    yield parameter("limit-beyond-a-tie", "origin_x", token, reason)


def scan_limits() -> Iterator[Case]:
    far = "is not from -10000000 to 10000000"
    turn = "is not from -1000000 to 1000000"
    for number, token in enumerate(
        "10000000.000000002 nan -INFINITY 1e999".split(), start=1
    ):
        line = f"POSE {token} 0 0"
        yield after_grid(f"limit-pose-x-{number}", line, f"x '{token}' {far}")
    yield after_grid(
        "limit-pose-y", "POSE 0 -10000001 0", f"y '-10000001' {far}"
    )
    yield after_grid(
        "limit-pose-theta", "POSE 0 0 1000001", f"theta '1000001' {turn}"
    )
    yield after_grid(
        "limit-pose-theta-nan", "POSE 0 0 nan", f"theta 'nan' {turn}"
    )
    for place, field in enumerate(("x0", "y0", "x1", "y1"), start=1):
        line = with_field("WALL 0 0 1 1", place, "-10000001")
        yield after_grid(
            f"limit-wall-{field}", line, f"{field} '-10000001' {far}"
        )


# --- recorded scans --------------------------------------------------------


def flaser() -> Iterator[Case]:
    far = "is not from -10000000 to 10000000"
    turn = "is not from -1000000 to 1000000"
    few = FLASER.rstrip().removesuffix(" 2.5")
    for name, line, reason in (
        ("no-value", "FLASER", "FLASER has no beam count"),
        ("count-word", "FLASER x 1 2", "beam count 'x' is not a whole number"),
        ("count-real", with_field(FLASER, 1, "2.0"), "beam count '2.0' is not a whole number"),
        ("count-comment", "FLASER # 2 1 2", "beam count '#' is not a whole number"),
        ("count-0", "FLASER 0", "beam count '0' is not from 1 to 100000"),
        ("count-100001", "FLASER 100001", "beam count '100001' is not from 1 to 100000"),
        ("count-huge", "FLASER 18446744073709551618", "beam count '18446744073709551618' is not from 1 to 100000"),
        ("few", few, "FLASER with 2 beams takes 12 values, found 11"),
        ("many", FLASER.rstrip() + " 1", "FLASER with 2 beams takes 12 values, found 13"),
        ("only-the-count", "FLASER 100000", "FLASER with 100000 beams takes 100010 values, found 1"),
        ("count-leading-zero", "FLASER 002 1 2", "FLASER with 2 beams takes 12 values, found 3"),
        ("comment-is-a-field", FLASER.rstrip() + " # x", "FLASER with 2 beams takes 12 values, found 14"),
        ("range-word", with_field(FLASER, 2, "x"), "range 0 'x' is not a number"),
        ("range-comment", with_field(FLASER, 3, "#2"), "range 1 '#2' is not a number"),
        ("range-negative", with_field(FLASER, 2, "-1"), "range 0 '-1' is negative"),
        ("range-minus-infinity", with_field(FLASER, 3, "-inf"), "range 1 '-inf' is negative"),
        ("range-just-negative", with_field(FLASER, 3, "-1e-300"), "range 1 '-1e-300' is negative"),
        ("pose-x", with_field(FLASER, 4, "x"), "x 'x' is not a number"),
        ("pose-y", with_field(FLASER, 5, "nan"), f"y 'nan' {far}"),
        ("pose-y-far", with_field(FLASER, 5, "10000000.000000002"), f"y '10000000.000000002' {far}"),
        ("pose-theta", with_field(FLASER, 6, "1e7"), f"theta '1e7' {turn}"),
    ):  # fmt: skip
        yield after_grid(f"flaser-{name}", line, reason)
    # a field that begins with # in the tail is a field: its line is good, the one after it is not
    tail = with_field(FLASER, 11, "#host")
    text = f"{GRID}{tail}\nPOSE 0 0\n"
    yield case("flaser-tail-is-good", text, 9, "POSE takes 3 values, found 2")


def robotlaser1() -> Iterator[Case]:
    far = "is not from -10000000 to 10000000"
    turn = "is not from -1000000 to 1000000"
    line = ROBOTLASER1.rstrip()
    for name, text, reason in (
        ("no-value", "ROBOTLASER1", "ROBOTLASER1 has no beam count"),
        ("seven-values", "ROBOTLASER1 0 0 0 0 0 0 0", "ROBOTLASER1 has no beam count"),
        ("count-word", "ROBOTLASER1 a b c d e f g h", "beam count 'h' is not a whole number"),
        ("count-0", "ROBOTLASER1 0 0 0 0 0 0 0 0", "beam count '0' is not from 1 to 100000"),
        ("few", line.removesuffix(" 0"), "ROBOTLASER1 with 2 beams takes at least 25 values, found 24"),
        ("few-remission-count-bad", with_field(line, 11, "x").removesuffix(" 0"),
         "ROBOTLASER1 with 2 beams takes at least 25 values, found 24"),
        ("many", line + " 0", "ROBOTLASER1 with 2 beams and 0 remissions takes 25 values, found 26"),
        ("comment-is-a-field", line + " # x", "ROBOTLASER1 with 2 beams and 0 remissions takes 25 values, found 27"),
        ("remission-count-word", with_field(line, 11, "x"), "remission count 'x' is not a whole number"),
        ("remission-count-real", with_field(line, 11, "0.0"), "remission count '0.0' is not a whole number"),
        ("remission-count-minus", with_field(line, 11, "-1"), "remission count '-1' is not a whole number"),
        ("remission-count-much", with_field(line, 11, "100001"), "remission count '100001' is not from 0 to 100000"),
        ("remissions-few", with_field(line, 11, "2"),
         "ROBOTLASER1 with 2 beams and 2 remissions takes 27 values, found 25"),
        ("start-word", with_field(line, 2, "x"), "start 'x' is not a number"),
        ("start-nan", with_field(line, 2, "nan"), f"start 'nan' {turn}"),
        ("step-far", with_field(line, 4, "-1000001"), f"step '-1000001' {turn}"),
        ("step-comment", with_field(line, 4, "#3"), "step '#3' is not a number"),
        ("range-word", with_field(line, 9, "1e"), "range 0 '1e' is not a number"),
        ("range-negative", with_field(line, 10, "-0.1"), "range 1 '-0.1' is negative"),
        ("pose-x", with_field(line, 12, "1e8"), f"x '1e8' {far}"),
        ("pose-y", with_field(line, 13, "#"), "y '#' is not a number"),
        ("pose-theta", with_field(line, 14, "inf"), f"theta 'inf' {turn}"),
    ):  # fmt: skip
        yield after_grid(f"robotlaser1-{name}", text, reason)
    # type, fov, max_range, accuracy, mode, remissions and the last eleven fields may be anything
    fields = line.split()
    for place in (1, 3, 5, 6, 7, *range(15, 26)):
        fields[place] = "#"
    fields[11:12] = ["2", "?", "-"]
    anything = " ".join(fields)
    text = f"{GRID}{anything}\nPOSE 0 0\n"
    yield case(
        "robotlaser1-rest-is-good", text, 9, "POSE takes 3 values, found 2"
    )


# --- the parameters together -----------------------------------------------


def missing_parameters() -> Iterator[Case]:
    for field in REQUIRED:
        reason = f"occgrid_{field} is missing"
        yield case(f"missing-{field}", without(field) + POSE, 7, reason)
    text = "WALL 0 0 1 1\nFLASER\n"
    yield case("missing-all", text, 2, "occgrid_width is missing")
    text = without("origin_y").replace("resolution", "p0 0.5 #")
    reason = "occgrid_resolution is missing"
    yield case("missing-two", text + FLASER, 7, reason)
    text = without("origin_x") + ROBOTLASER1
    yield case(
        "missing-at-robotlaser1", text, 7, "occgrid_origin_x is missing"
    )
    text = "".join(f"# {line}\n" for line in GRID.splitlines()) + POSE
    yield case("missing-in-comments", text, 8, "occgrid_width is missing")


CELLS = "the grid has more than 25000000 cells"
RANGE = "occgrid_max_range is more than 1000000 cells"
CLAMPS = "occgrid_l_min is not below occgrid_l_max"
PRIOR = "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max"
LEAST = "occgrid_min_range is not below occgrid_max_range"


def joint_rules() -> Iterator[Case]:
    for name, values, line, reason in (
        ("cells", {"width": "5001", "height": "5000"}, 2, CELLS),
        ("cells-most", {"width": "25000000", "height": "25000000"}, 2, CELLS),
        ("cells-32-bits", {"width": "65536", "height": "65536"}, 2, CELLS),
        ("range", {"max_range": "1000.01", "resolution": "0.001"}, 6, RANGE),
        ("range-one-ulp", {"max_range": "10000", "resolution": "0.009999999999999998"}, 6, RANGE),
        ("clamps-equal", {"l_min": "1", "l_max": "1", "p0": "0.8"}, 9, CLAMPS),
        ("clamps-default-max", {"l_min": "8"}, 8, CLAMPS),
        ("clamps-default-min", {"p0": "0.5", "l_max": "-9"}, 9, CLAMPS),
        ("clamps-swapped", {"l_max": "-1", "p0": "0.4", "l_min": "1"}, 10, CLAMPS),
        ("prior-below", {"p0": "0.00001"}, 8, PRIOR),
        ("prior-above", {"l_max": "1", "p0": "0.9", "l_min": "-1", "p_occ": "0.9"}, 10, PRIOR),
        ("prior-default", {"l_min": "0.5"}, 8, PRIOR),
        ("prior-one-ulp", {"p0": "0.75", "l_max": "1.0986122886681093"}, 9, PRIOR),
        ("prior-clamped", {"p0": "1e-200", "l_min": "-20.72"}, 9, PRIOR),
        ("least-range-equal", {"min_range": "10"}, 8, LEAST),
        ("least-range-above", {"min_range": "10.5"}, 8, LEAST),
        ("least-range-limits", {"max_range": "10000", "min_range": "1e4"}, 8, LEAST),
        ("least-range-zeros", {"max_range": "0.001", "min_range": "0.001"}, 8, LEAST),
    ):  # fmt: skip
        yield case(f"joint-{name}", changed(**values) + POSE, line, reason)
    # the later of the lines, whichever parameter it has
    text = "PARAM occgrid_height 5001\nPARAM robot_x 1\nPARAM occgrid_width 5000\n"
    rest = without("width").replace("PARAM occgrid_height 3\n", "")
    yield case("joint-cells-swapped", text + rest + POSE, 3, CELLS)
    text = "PARAM occgrid_max_range 10000\n" + without("max_range")
    text = text.replace("resolution 1", "resolution 0.00999")
    yield case("joint-range-swapped", text + POSE, 4, RANGE)
    text = "PARAM occgrid_min_range 10\n" + GRID
    yield case("joint-least-range-swapped", text + POSE, 7, LEAST)


# --- one line that breaks several rules ------------------------------------


def orders() -> Iterator[Case]:
    ascii_first, keyword_first = (
        "not plain ASCII text",
        "'P!' is not a keyword",
    )
    late = "must stand before the first scan"
    yield after_grid("order-ascii-keyword", "P\xd6SE! 0", ascii_first)
    yield case(
        "order-ascii-place", GRID + POSE + "WALL \xe9\n", 9, ascii_first
    )
    yield case("order-ascii-missing", "POSE 0 0 \xe9\n", 1, ascii_first)
    yield case(
        "order-ascii-joint",
        changed(l_min="9") + "FLASER \xe9\n",
        9,
        ascii_first,
    )
    yield case("order-keyword-missing", "P! 0 0 0\n", 1, keyword_first)
    text = GRID + POSE
    yield case(
        "order-place-count", text + "PARAM occgrid_p0\n", 9, f"PARAM {late}"
    )
    yield case(
        "order-place-unknown", text + "PARAM occgrid_q 1\n", 9, f"PARAM {late}"
    )
    yield case(
        "order-place-twice",
        text + "PARAM occgrid_width x\n",
        9,
        f"PARAM {late}",
    )
    yield case("order-place-wall-values", text + "WALL x\n", 9, f"WALL {late}")
    for name, line, reason in (
        ("count-unknown", "PARAM occgrid_q", "PARAM takes 2 values, found 1"),
        ("count-twice", "PARAM occgrid_width 4 5", "PARAM takes 2 values, found 3"),
        ("unknown-value", "PARAM occgrid_q x", "unknown parameter occgrid_q"),
        ("twice-value", "PARAM occgrid_width x", "occgrid_width is given twice"),
        ("count-wall-value", "WALL x 0 1", "WALL takes 4 values, found 3"),
        ("count-pose-value", "POSE x 0", "POSE takes 3 values, found 2"),
        ("wall-fields", "WALL 0 1e8 x nan", "y0 '1e8' is not from -10000000 to 10000000"),
        ("pose-fields", "POSE 0 nan x", "y 'nan' is not from -10000000 to 10000000"),
        ("flaser-count-values", "FLASER 0 1 2", "beam count '0' is not from 1 to 100000"),
        ("flaser-values-ranges", "FLASER 2 x -1", "FLASER with 2 beams takes 12 values, found 3"),
        ("flaser-ranges-pose", "FLASER 2 1 -1 x y z 0 0 0 0 h 0", "range 1 '-1' is negative"),
        ("flaser-ranges", "FLASER 2 -1 x x y z 0 0 0 0 h 0", "range 0 '-1' is negative"),
        ("flaser-pose", "FLASER 1 1 0 y z 0 0 0 0 h 0", "y 'y' is not a number"),
        ("robotlaser1-count-values", "ROBOTLASER1 0 s 0 t 0 0 0 x", "beam count 'x' is not a whole number"),
        ("robotlaser1-values-start", with_field(ROBOTLASER1, 2, "s") + " 0",
         "ROBOTLASER1 with 2 beams and 0 remissions takes 25 values, found 26"),
        ("robotlaser1-remissions-start", with_field(with_field(ROBOTLASER1, 2, "s"), 11, "m"),
         "remission count 'm' is not a whole number"),
        ("robotlaser1-start-step", with_field(with_field(ROBOTLASER1, 4, "t"), 2, "s"), "start 's' is not a number"),
        ("robotlaser1-step-range", with_field(with_field(ROBOTLASER1, 4, "t"), 9, "-1"), "step 't' is not a number"),
        ("robotlaser1-range-pose", with_field(with_field(ROBOTLASER1, 10, "-1"), 12, "x"), "range 1 '-1' is negative"),
        ("robotlaser1-pose", with_field(with_field(ROBOTLASER1, 14, "z"), 12, "x"), "x 'x' is not a number"),
    ):  # fmt: skip
        yield after_grid(f"order-{name}", line, reason)
    # a scan line is checked after the parameters as a whole
    text = without("max_range").replace("width 4", "width 25000000")
    yield case(
        "order-missing-joint", text + POSE, 7, "occgrid_max_range is missing"
    )
    text = without("max_range") + "POSE x\n"
    yield case("order-missing-scan", text, 7, "occgrid_max_range is missing")
    yield case("order-joint-scan", changed(l_min="9") + "FLASER\n", 8, CLAMPS)
    # each of the five joint rules before the next
    for name, values, at, reason in (
        ("cells-range", {"width": "25000000", "height": "2", "resolution": "0.001", "max_range": "10000"}, 2, CELLS),
        ("range-clamps", {"resolution": "0.001", "max_range": "10000", "l_min": "9"}, 6, RANGE),
        ("clamps-prior", {"l_min": "9", "p0": "0.5"}, 8, CLAMPS),
        ("clamps-least-range", {"l_min": "9", "min_range": "10"}, 8, CLAMPS),
        ("prior-least-range", {"min_range": "10", "p0": "0.99999"}, 9, PRIOR),
    ):  # fmt: skip
        yield case(f"order-{name}", changed(**values) + POSE, at, reason)
