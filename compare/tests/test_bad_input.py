"""Bad input: every port refuses it with the same status, line and reason, and writes nothing."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.process_group import Finished, run_process

from .conftest import JOBS, PORTS, unavailable

# without its last line, POSE, it is seven lines long
GOOD = """PARAM occgrid_width 4
PARAM occgrid_height 3
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 10
# a comment
POSE 0.5 0.5 0
"""
GRID = GOOD.removesuffix("POSE 0.5 0.5 0\n")
FLASER = "FLASER 2 1 2 0.5 0.5 0 0 0 0 1.5 host 2.5\n"
ROBOTLASER1 = (
    "ROBOTLASER1 0 -1.5 3 3 81.9 0.1 0 2 1 2 0 0.5 0.5 0" + " 0" * 11 + "\n"
)
# Every case is a process of its own, and interpreters start slowly. So each port is
# given these cases, and all of them where the environment has PARITY_ALL_CASES=1.
CORE = """
empty blank grid-only-no-last-end keyword-in-small-letters latin-1 nul vertical-tab
two-returns before-the-keyword-is-looked-at byte-order-mark returns-only
keyword-punctuation keyword-digit keyword-percent wall-late parameter-late-and-bad
parameter-values~#~4 parameter-unknown-values wall-values~1~2~3~#4 pose-values~x~#~y~z
unknown unknown-capital unknown-empty twice-and-bad twice-with-default
number-0x10 number-1e number-1_000 number-1d3 number-. number-nan(1) number--+1 number-1/2
number-1i number-[] whole-4.0 whole-+4 whole-nan whole-1e1 no-return-Free
limit-width-99999999999999999999999 limit-resolution-0.00099999999999999
limit-origin_x-1000000.0000000002 limit-origin_x-NAN limit-max_range-1e-310
limit-fov-6.283185307179587 limit-noise_std--1e-299 limit-p0-1e-301
limit-p_free-0.99999999999999999 limit-pose-1e999 limit-wall
flaser-none flaser-count-2.0 flaser-count-0 flaser-few flaser-comment flaser-3--inf
flaser-order robotlaser1-seven robotlaser1-few robotlaser1-many
robotlaser1-remissions-count robotlaser1-remissions-few robotlaser1-2-nan
robotlaser1-14-inf missing-all missing-before-the-scan cells-most cells-swapped
range-swapped l-swapped l-default-min prior-default joint-order-2
joint-before-the-scan missing-before-joint crlf blanks-count no-last-end last-end-without-lf late
"""
DROP_PRIVILEGE = [
    "setpriv",
    "--bounding-set=-dac_override,-dac_read_search",
    "--inh-caps=-all",
]


@dataclass(frozen=True)
class Case:
    """A bad scenario: its bytes, and where and why it is refused."""

    data: bytes
    line: int
    reason: str


CASES: dict[str, Case] = {}


def case(name: str, text: str | bytes, line: int, reason: str) -> None:
    """Adds a case; text is written as Latin-1."""
    assert name not in CASES
    data = text if isinstance(text, bytes) else text.encode("latin-1")
    CASES[name] = Case(data, line, reason)


def after_grid(name: str, line: str, reason: str) -> None:
    """A case whose eighth line, the first after a good grid, is refused."""
    case(name, f"{GRID}{line}\nPOSE 0.5 0.5 0\n", 8, reason)


def without(parameter: str, scan: str = "POSE 0.5 0.5 0\n") -> str:
    """The good grid without one parameter, and a scan in line 7."""
    lines = GRID.splitlines(keepends=True)
    kept = [line for line in lines if f"occgrid_{parameter} " not in line]
    assert len(kept) == len(lines) - 1
    return "".join(kept) + scan


# --- no scan at all
case("empty", "", 0, "no scan")
case("blank", "\n\n \t \n", 3, "no scan")
case("comment-only", "# nothing", 1, "no scan")
case("grid-only", GRID, 7, "no scan")
case("grid-only-no-last-end", GRID.rstrip("\n"), 7, "no scan")
case("others-only", "ODOM 1 2 3\nPARAM robot_width 1\nSYNC x\n", 3, "no scan")
case("keyword-in-small-letters", GRID + "pose 0 0 0\n", 8, "no scan")
case("scan-in-a-comment", GRID + "# POSE 0 0 0\n  #POSE 0 0 0\n", 9, "no scan")
# --- not plain ASCII text
ASCII = "not plain ASCII text"
after_grid("latin-1", "ODOM caf\xe9 1", ASCII)
after_grid("control-character", "POSE 0 0 0\x01", ASCII)
after_grid("delete-character", "POSE 0 0 0 \x7f", ASCII)
after_grid("nul", "POSE 0 0\x00 0", ASCII)
after_grid("form-feed", "\x0c", ASCII)
after_grid("vertical-tab", "POSE 0 0\x0b0", ASCII)
after_grid("return-within", "POSE 0 0\r0", ASCII)
after_grid("two-returns", "POSE 0 0 0\r\r", ASCII)
after_grid("no-break-space", "\xa0POSE 0 0 0", ASCII)
after_grid("before-the-keyword-is-looked-at", "P\xd6SE! 0 0 0", ASCII)
after_grid("in-a-comment-behind-a-value", "WALL 0 0 1 1 # caf\xe9", ASCII)
case("byte-order-mark", b"\xef\xbb\xbf" + GOOD.encode(), 1, ASCII)
case("byte-order-mark-comment", b"\xef\xbb\xbf# x\n" + GOOD.encode(), 1, ASCII)
case("returns-only", GOOD.replace("\n", "\r"), 1, ASCII)
case("utf-16", GOOD.encode("utf-16-le"), 1, ASCII)
# --- keywords
after_grid("keyword-punctuation", "POSE: 0 0 0", "'POSE:' is not a keyword")
after_grid("keyword-digit", "1POSE 0 0 0", "'1POSE' is not a keyword")
after_grid("keyword-number", "-1.5", "'-1.5' is not a keyword")
after_grid("keyword-comment-behind", "POSE# 0 0 0", "'POSE#' is not a keyword")
after_grid("keyword-quote", '"\'"', "'\"'\"' is not a keyword")
after_grid("keyword-percent", "%d%s 1", "'%d%s' is not a keyword")
after_grid("keyword-backslash", "\\n 1", "'\\n' is not a keyword")
after_grid("keyword-dollar", "$HOME `x` 1", "'$HOME' is not a keyword")
# --- place
BEFORE = "must stand before the first scan"
case("wall-late", GOOD + "WALL 0 0 1 1\n", 9, f"WALL {BEFORE}")
case("parameter-late", GOOD + "PARAM occgrid_p0 0.4\n", 9, f"PARAM {BEFORE}")
case(
    "parameter-late-and-bad",
    GOOD + "PARAM occgrid_nil\n",
    9,
    f"PARAM {BEFORE}",
)
case("wall-late-and-bad", GRID + FLASER + "WALL x\n", 9, f"WALL {BEFORE}")
# --- number of values
for values, found in (("", 1), (" 4 5", 3), (" # 4", 1), (" 4 5 # 6", 3)):
    text = f"PARAM takes 2 values, found {found}"
    after_grid(f"parameter-values{values}", f"PARAM occgrid_p0{values}", text)
after_grid(
    "parameter-unknown-values",
    "PARAM occgrid_nil",
    "PARAM takes 2 values, found 1",
)
for values, found in (
    ("", 0),
    (" 1 2 3", 3),
    (" 1 2 3 4 5", 5),
    (" 1 2 3 #4", 3),
):
    after_grid(
        f"wall-values{values}",
        f"WALL{values}",
        f"WALL takes 4 values, found {found}",
    )
for values, found in (("", 0), (" 1 2", 2), (" 1 2 3 4", 4), (" x # y z", 1)):
    after_grid(
        f"pose-values{values}",
        f"POSE{values}",
        f"POSE takes 3 values, found {found}",
    )
# --- names of parameters
after_grid(
    "unknown", "PARAM occgrid_hight 3", "unknown parameter occgrid_hight"
)
after_grid(
    "unknown-capital", "PARAM occgrid_P0 0.5", "unknown parameter occgrid_P0"
)
after_grid("unknown-empty", "PARAM occgrid_ 0.5", "unknown parameter occgrid_")
after_grid("twice", "PARAM occgrid_width 4", "occgrid_width is given twice")
after_grid(
    "twice-and-bad", "PARAM occgrid_width x", "occgrid_width is given twice"
)
case(
    "twice-with-default",
    GRID + "PARAM occgrid_p0 0.5\nPARAM occgrid_p0 0.5\nPOSE 0 0 0\n",
    9,
    "occgrid_p0 is given twice",
)
# --- numbers
NO_NUMBERS = (
    "x 0x10 1e 1e+ 1.5.2 --1 +-1 -+1 1_000 1d3 1,5 nan(1) infinit + - . -. e5 .e5 1f "
    "1E5. 1e5.0 (1) 1;2 [] in i 1i NaN0 1/2 *^3 1*^3 '1' \"1\" nanx -infinityx 1e5e5 0b1 1L"
)
for token in NO_NUMBERS.split():
    after_grid(
        f"number-{token}", f"POSE 0 {token} 0", f"y '{token}' is not a number"
    )
NO_WHOLES = "4.0 4. +4 -4 1e1 0x4 four nan inf 4e0 1_0"
for token in NO_WHOLES.split():
    case(
        f"whole-{token}",
        f"PARAM occgrid_width {token}\n" + GOOD,
        1,
        f"occgrid_width '{token}' is not a whole number",
    )
after_grid("wall-x0", "WALL a b c d", "x0 'a' is not a number")
after_grid("wall-y0", "WALL 0 b c d", "y0 'b' is not a number")
after_grid("wall-x1", "WALL 0 0 c d", "x1 'c' is not a number")
after_grid("wall-y1", "WALL 0 0 0 d", "y1 'd' is not a number")
after_grid("pose-x", "POSE a b c", "x 'a' is not a number")
after_grid("pose-theta", "POSE 0 0 c", "theta 'c' is not a number")
for token in ("Free", "ignored", "0", "true"):
    after_grid(
        f"no-return-{token}",
        f"PARAM occgrid_no_return {token}",
        f"occgrid_no_return '{token}' is not free or ignore",
    )
# --- limits
LIMITS = {
    "width": ("1", "25000000", "0 25000001 00000 99999999999999999999999"),
    "height": ("1", "25000000", "0 25000001"),
    "resolution": (
        "0.001",
        "1000",
        "0.00099999999999999 1000.0000000000002 0 -1 nan inf",
    ),
    "origin_x": (
        "-1000000",
        "1000000",
        "1000000.0000000002 -1e7 NAN -Infinity 1e400",
    ),
    "origin_y": ("-1000000", "1000000", "1e6001 -1000000.1 +nan"),
    "max_range": ("0.001", "10000", "0.0009 10000.000000000002 -5 inf 1e-310"),
    "l_min": ("-1000", "1000", "-1000.0000000000001 1e9 nan"),
    "l_max": ("-1000", "1000", "1000.0000000000001 -inf"),
    "fov": ("0", "6.283185307179586", "6.283185307179587 -0.1 nan"),
    "beams": ("1", "100000", "0 100001"),
    "noise_std": ("0", "1000", "-1e-299 1000.0000000000002 nan"),
}
for field, (low, high, tokens) in LIMITS.items():
    for token in tokens.split():
        reason = f"occgrid_{field} '{token}' is not from {low} to {high}"
        case(
            f"limit-{field}-{token}",
            f"PARAM occgrid_{field} {token}\n{GOOD}",
            1,
            reason,
        )
for field in ("p0", "p_occ", "p_free"):
    for token in (
        "0",
        "1",
        "-0.5",
        "nan",
        "inf",
        "1e-301",
        "0.99999999999999999",
    ):
        reason = f"occgrid_{field} '{token}' is not between 0 and 1"
        case(
            f"limit-{field}-{token}",
            f"PARAM occgrid_{field} {token}\n{GOOD}",
            1,
            reason,
        )
COORDINATE = "is not from -1000000 to 1000000"
for token in (
    "1000000.0000000002",
    "-1e7",
    "nan",
    "inf",
    "-INFINITY",
    "1e999",
):
    after_grid(
        f"limit-pose-{token}", f"POSE {token} 0 0", f"x '{token}' {COORDINATE}"
    )
after_grid("limit-theta", "POSE 0 0 1000001", f"theta '1000001' {COORDINATE}")
after_grid("limit-wall", "WALL 0 0 0 -1000001", f"y1 '-1000001' {COORDINATE}")
# --- FLASER
after_grid("flaser-none", "FLASER", "FLASER has no beam count")
after_grid(
    "flaser-count", "FLASER x 1 2", "beam count 'x' is not a whole number"
)
after_grid(
    "flaser-count-2.0",
    FLASER.replace("2", "2.0", 1).rstrip(),
    "beam count '2.0' is not a whole number",
)
after_grid(
    "flaser-count-0", "FLASER 0", "beam count '0' is not from 1 to 100000"
)
after_grid(
    "flaser-count-much",
    "FLASER 100001",
    "beam count '100001' is not from 1 to 100000",
)
after_grid(
    "flaser-few",
    FLASER.rstrip().removesuffix(" 2.5"),
    "FLASER with 2 beams takes 12 values, found 11",
)
after_grid(
    "flaser-many",
    FLASER.rstrip() + " 1",
    "FLASER with 2 beams takes 12 values, found 13",
)
after_grid(
    "flaser-comment",
    FLASER.rstrip() + " # x",
    "FLASER with 2 beams takes 12 values, found 14",
)
after_grid(
    "flaser-only-count",
    "FLASER 100000",
    "FLASER with 100000 beams takes 100010 values, found 1",
)
for i, token, reason in (
    (2, "x", "range 0 'x' is not a number"),
    (3, "x", "range 1 'x' is not a number"),
    (3, "#2", "range 1 '#2' is not a number"),
    (2, "-1", "range 0 '-1' is negative"),
    (3, "-inf", "range 1 '-inf' is negative"),
    (3, "-1e-300", "range 1 '-1e-300' is negative"),
    (4, "x", "x 'x' is not a number"),
    (5, "nan", f"y 'nan' {COORDINATE}"),
    (6, "1e7", f"theta '1e7' {COORDINATE}"),
):
    words = FLASER.split()
    words[i] = token
    after_grid(f"flaser-{i}-{token}", " ".join(words), reason)
after_grid(
    "flaser-order",
    "FLASER 2 1 -1 x y z 0 0 0 0 h 0",
    "range 1 '-1' is negative",
)
# --- ROBOTLASER1
after_grid("robotlaser1-none", "ROBOTLASER1", "ROBOTLASER1 has no beam count")
after_grid(
    "robotlaser1-seven",
    "ROBOTLASER1 0 0 0 0 0 0 0",
    "ROBOTLASER1 has no beam count",
)
after_grid(
    "robotlaser1-count",
    "ROBOTLASER1 a b c d e f g h",
    "beam count 'h' is not a whole number",
)
after_grid(
    "robotlaser1-count-0",
    "ROBOTLASER1 0 0 0 0 0 0 0 0",
    "beam count '0' is not from 1 to 100000",
)
after_grid(
    "robotlaser1-few",
    ROBOTLASER1.replace(" 1 2 0 ", " 1 x ").rstrip(),
    "ROBOTLASER1 with 2 beams takes at least 25 values, found 24",
)
after_grid(
    "robotlaser1-many",
    ROBOTLASER1.rstrip() + " 0",
    "ROBOTLASER1 with 2 beams and 0 remissions takes 25 values, found 26",
)
after_grid(
    "robotlaser1-remissions-few",
    ROBOTLASER1.replace(" 1 2 0 ", " 1 2 2 7 ").rstrip(),
    "ROBOTLASER1 with 2 beams and 2 remissions takes 27 values, found 26",
)
after_grid(
    "robotlaser1-remissions-count",
    ROBOTLASER1.replace(" 1 2 0 ", " x y 1.0 ").rstrip(),
    "remission count '1.0' is not a whole number",
)
after_grid(
    "robotlaser1-remissions-much",
    ROBOTLASER1.replace(" 1 2 0 ", " 1 2 100001 ").rstrip(),
    "remission count '100001' is not from 0 to 100000",
)
for i, token, reason in (
    (2, "x", "start 'x' is not a number"),
    (2, "nan", f"start 'nan' {COORDINATE}"),
    (4, "x", "step 'x' is not a number"),
    (4, "-1000000.5", f"step '-1000000.5' {COORDINATE}"),
    (9, "x", "range 0 'x' is not a number"),
    (10, "-0.1", "range 1 '-0.1' is negative"),
    (12, "x", "x 'x' is not a number"),
    (13, "x", "y 'x' is not a number"),
    (14, "inf", f"theta 'inf' {COORDINATE}"),
):
    words = ROBOTLASER1.split()
    words[i] = token
    after_grid(f"robotlaser1-{i}-{token}", " ".join(words), reason)
# --- the parameters as a whole, at the first scan
for field in (
    "width",
    "height",
    "resolution",
    "origin_x",
    "origin_y",
    "max_range",
):
    case(f"missing-{field}", without(field), 7, f"occgrid_{field} is missing")
case("missing-all", "WALL 0 0 1 1\nFLASER\n", 2, "occgrid_width is missing")
case(
    "missing-before-the-scan",
    without("max_range", "POSE x\n"),
    7,
    "occgrid_max_range is missing",
)
case(
    "missing-at-robotlaser1",
    without("origin_y", ROBOTLASER1),
    7,
    "occgrid_origin_y is missing",
)


def changed(**values: str) -> str:
    """The good scenario with other values, and further parameters after line 7."""
    text, more = GRID, ""
    for field, value in values.items():
        lines = text.splitlines(keepends=True)
        at = [i for i, line in enumerate(lines) if f"occgrid_{field} " in line]
        if at:
            lines[at[0]] = f"PARAM occgrid_{field} {value}\n"
            text = "".join(lines)
        else:
            more += f"PARAM occgrid_{field} {value}\n"
    return text + more + "POSE 0.5 0.5 0\n"


CELLS = "the grid has more than 25000000 cells"
case("cells", changed(width="5001", height="5000"), 2, CELLS)
case("cells-most", changed(width="25000000", height="25000000"), 2, CELLS)
swapped = (
    "PARAM occgrid_height 5001\nPARAM robot_x 1\nPARAM occgrid_width 5000\n"
)
case(
    "cells-swapped",
    swapped + without("width").replace("PARAM occgrid_height 3\n", ""),
    3,
    CELLS,
)
RANGE = "occgrid_max_range is more than 1000000 cells"
case("range", changed(max_range="1000.01", resolution="0.001"), 6, RANGE)
case(
    "range-swapped",
    "PARAM occgrid_max_range 10000\n"
    + without("max_range").replace("resolution 1", "resolution 0.00999"),
    4,
    RANGE,
)
ORDER = "occgrid_l_min is not below occgrid_l_max"
case("l-equal", changed(l_min="1", l_max="1", p0="0.8"), 9, ORDER)
case("l-default-max", changed(l_min="8"), 8, ORDER)
case("l-default-min", changed(p0="0.5", l_max="-9"), 9, ORDER)
case("l-swapped", changed(l_max="-1", p0="0.4", l_min="1"), 10, ORDER)
PRIOR = "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max"
case("prior-below", changed(p0="0.00001"), 8, PRIOR)
case(
    "prior-above",
    changed(l_max="1", p0="0.9", l_min="-1", p_occ="0.9"),
    10,
    PRIOR,
)
case("prior-default", changed(l_min="0.5"), 8, PRIOR)
case(
    "joint-order-1",
    changed(
        width="25000000", height="2", resolution="0.001", max_range="10000"
    ),
    2,
    CELLS,
)
case(
    "joint-order-2",
    changed(resolution="0.001", max_range="10000", l_min="9"),
    6,
    RANGE,
)
case("joint-order-3", changed(l_min="9", p0="0.5"), 8, ORDER)
case(
    "joint-before-the-scan",
    changed(l_min="9").replace("POSE 0.5", "POSE x"),
    8,
    ORDER,
)
case(
    "missing-before-joint",
    without("max_range").replace("width 4", "width 25000000"),
    7,
    "occgrid_max_range is missing",
)
# --- lines are counted as they stand
case(
    "crlf",
    GOOD.replace("\n", "\r\n") + "POSE 1\r\n",
    9,
    "POSE takes 3 values, found 1",
)
case(
    "blanks-count",
    "\n\n" + GOOD + "\n \t\n#\nPOSE 1\n",
    14,
    "POSE takes 3 values, found 1",
)
case("tabs", GOOD + "\tPOSE\t\t1 \t2\t\n", 9, "POSE takes 3 values, found 2")
case("no-last-end", GOOD + "POSE 1 x 2", 9, "y 'x' is not a number")
case("last-end-without-lf", GOOD + "POSE 1 x 2\r", 9, "y 'x' is not a number")
case(
    "late",
    GOOD + 50 * "POSE 1 1 1\n" + "POSE 1 1 y\n" + GOOD,
    59,
    "theta 'y' is not a number",
)


def chosen() -> list[str]:
    """The names of the cases that are tried."""
    if os.environ.get("PARITY_ALL_CASES", "") not in ("", "0"):
        return list(CASES)
    return [name.replace("~", " ") for name in CORE.split()]


TRIED = chosen()


@dataclass(frozen=True)
class Refused:
    """How a port ended, what it said and what it left in its folder."""

    finished: Finished
    stdout: bytes
    stderr: bytes
    left: list[str]


def refuse(
    port: Port, file: Path, work: Path, prefix: Sequence[str] = ()
) -> Refused:
    """Gives a port a bad scenario, with an empty folder to write into."""
    out = work / "out"
    out.mkdir(parents=True)
    run = port.command(
        port.run,
        mode=["--noise-free"],
        out=out,
        scenario=[file],
        scenarios=[file],
    )
    finished = run_process(
        [*prefix, *run],
        cwd=port.folder,
        stdout=work / "stdout",
        stderr=work / "stderr",
        time_limit=port.timeout,
    )
    return Refused(
        finished,
        finished.stdout.read_bytes(),
        finished.stderr.read_bytes(),
        sorted(path.name for path in out.iterdir()),
    )


@pytest.fixture(scope="session")
def refusals(
    ready: list[Port], tmp_path_factory: pytest.TempPathFactory
) -> dict[tuple[str, str], tuple[Path, Refused]]:
    """Every port's answer to every case."""
    folder = tmp_path_factory.mktemp("bad-input")
    files = {}
    for number, name in enumerate(TRIED):
        files[name] = folder / f"bad-{number}.log"
        files[name].write_bytes(CASES[name].data)
    work = [(port, name) for port in ready for name in TRIED]

    def answer(item: tuple[Port, str], stop: object) -> Refused:
        port, name = item
        return refuse(port, files[name], folder / port.name / files[name].stem)

    found = side_by_side(answer, work, JOBS)
    return {
        (port.name, name): (files[name], refused)
        for (port, name), refused in zip(work, found, strict=True)
    }


def check(refused: Refused, file: Path, line: int, reason: str) -> None:
    """The status, exactly one line on standard error, nothing else anywhere."""
    expected = f"{file}:{line}: {reason}\n".encode("latin-1")
    assert (refused.finished.exit_status, refused.stderr) == (1, expected)
    assert refused.stdout == b""
    assert refused.left == []


@pytest.mark.parametrize("name", TRIED)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_refuses(
    refusals: dict[tuple[str, str], tuple[Path, Refused]],
    need: Callable[[str], Port],
    port: str,
    name: str,
) -> None:
    need(port)
    file, refused = refusals[port, name]
    check(refused, file, CASES[name].line, CASES[name].reason)


@pytest.mark.parametrize("kind", ["missing", "folder", "in-a-file"])
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_refuses_what_cannot_be_read(
    need: Callable[[str], Port], tmp_path: Path, port: str, kind: str
) -> None:
    file = tmp_path / "scenario.log"
    if kind == "folder":
        file.mkdir()
    if kind == "in-a-file":
        file.write_text(GOOD)
        file = file / "scenario.log"
    check(
        refuse(need(port), file, tmp_path / "work"), file, 0, "cannot be read"
    )


def obeying_permissions() -> list[str]:
    """What to put before a command so that permissions bind it, root or not."""
    if os.geteuid() != 0:
        return []
    if shutil.which("setpriv") is None:
        unavailable(
            "root obeys no permissions without setpriv: install util-linux"
        )
    return DROP_PRIVILEGE


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_refuses_what_it_may_not_read(
    need: Callable[[str], Port], tmp_path: Path, port: str
) -> None:
    ready = need(port)
    file = tmp_path / "scenario.log"
    file.write_text(GOOD)
    file.chmod(0)
    refused = refuse(ready, file, tmp_path / "work", obeying_permissions())
    check(refused, file, 0, "cannot be read")


@pytest.mark.parametrize(
    "kind", ["no-permission", "no-permission-above", "a-file", "in-a-file"]
)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_says_that_the_folder_cannot_be_written(
    need: Callable[[str], Port], tmp_path: Path, port: str, kind: str
) -> None:
    ready = need(port)
    file = tmp_path / "good.log"
    file.write_text(GOOD)
    out = tmp_path / "out"
    prefix: list[str] = []
    if kind.startswith("no-permission"):
        prefix = obeying_permissions()
        out.mkdir()
        out.chmod(0o555)
    if kind in ("a-file", "in-a-file"):
        out.write_text("here already")
    if kind in ("no-permission-above", "in-a-file"):
        out = out / "below"
    run = ready.command(
        ready.run,
        mode=["--noise-free"],
        out=out,
        scenario=[file],
        scenarios=[file],
    )
    finished = run_process(
        [*prefix, *run],
        cwd=ready.folder,
        stdout=tmp_path / "stdout",
        stderr=tmp_path / "stderr",
        time_limit=ready.timeout,
    )
    said = finished.stderr.read_text()
    paths = [
        out,
        *(out / f"good{suffix}" for suffix in (".pgm", ".yaml", ".logodds")),
    ]
    # PATH is DIR or the file (SPEC section 8); a folder that is not there is DIR
    allowed = [f"{path}: cannot be written\n" for path in paths]
    if kind != "no-permission":
        allowed = allowed[:1]
    assert (finished.exit_status, finished.stdout.read_bytes()) == (1, b"")
    assert said in allowed
    if out.is_dir():
        assert list(out.iterdir()) == []
    if kind == "a-file":
        assert out.read_text() == "here already"


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_keeps_the_maps_before_the_error(
    need: Callable[[str], Port], tmp_path: Path, port: str
) -> None:
    """What earlier scenarios wrote stays; of the bad one and those after it nothing is there."""
    ready = need(port)
    files = [tmp_path / f"{name}.log" for name in ("first", "second", "third")]
    for file in files:
        file.write_text(GOOD)
    files[1].write_text(GOOD + "POSE 0 0 x\n")
    if not ready.takes_many:
        pytest.skip(f"{port} takes one scenario at a time")
    out = tmp_path / "out"
    run = ready.command(
        ready.run, mode=["--seed", "3"], out=out, scenarios=files
    )
    finished = run_process(
        run,
        cwd=ready.folder,
        stdout=tmp_path / "stdout",
        stderr=tmp_path / "stderr",
        time_limit=ready.timeout,
    )
    assert finished.exit_status == 1
    assert (
        finished.stderr.read_text()
        == f"{files[1]}:9: theta 'x' is not a number\n"
    )
    names = ["first.logodds", "first.pgm", "first.yaml"]
    assert sorted(path.name for path in out.iterdir()) == names


@pytest.mark.parametrize(
    "row",
    [
        "cannot be read",
        "not plain ASCII text",
        "is not a keyword",
        "must stand before the first scan",
        "PARAM takes 2 values",
        "WALL takes 4 values",
        "POSE takes 3 values",
        "unknown parameter",
        "is given twice",
        "is not a number",
        "is not a whole number",
        "is not free or ignore",
        "is not from",
        "is not between 0 and 1",
        "is negative",
        "FLASER has no beam count",
        "ROBOTLASER1 has no beam count",
        "FLASER with 2 beams takes 12 values",
        "takes at least",
        "remissions takes",
        "is missing",
        "the grid has more than 25000000 cells",
        "occgrid_max_range is more than 1000000 cells",
        "occgrid_l_min is not below occgrid_l_max",
        "logit(occgrid_p0)",
        "no scan",
    ],
)
def test_every_row_of_the_contract_has_a_case(row: str) -> None:
    reasons = [CASES[name].reason for name in TRIED] + ["cannot be read"]
    assert any(row in reason for reason in reasons)
