"""scenario: what is read, and every error of SPEC.md section 8 with its line and words."""

from __future__ import annotations

import math
import os
import threading
from pathlib import Path

import numpy as np
import pytest

from occgrid.mapper import map_scenario, simulated_scans
from occgrid.scenario import (
    Scenario,
    ScenarioError,
    Settings,
    read_scenario,
    scenario_name,
)
from occgrid.sensor import Scan, flaser_angles
from occgrid.world import Pose

GRID = [
    "PARAM occgrid_width 20",
    "PARAM occgrid_height 10",
    "PARAM occgrid_resolution 0.5",
    "PARAM occgrid_origin_x -5",
    "PARAM occgrid_origin_y -2.5",
    "PARAM occgrid_max_range 8",
]
POSE = "POSE 0 0 0"
TAIL9 = "1 2 0.5 0 0 0 0 host 0"
TAIL14 = "1 2 0.5 0 0 0 0 0 0 0 0 0 host 0"


def write(folder: Path, *lines: str, end: str = "\n") -> Path:
    file = folder / "a.log"
    file.write_bytes(end.join([*lines, ""]).encode())
    return file


def read_all(file: Path) -> tuple[Scenario, list[Pose | Scan]]:
    with read_scenario(file) as scenario:
        return scenario, list(scenario.scans)


def failure(file: Path) -> str:
    with pytest.raises(ScenarioError) as caught:
        read_all(file)
    text = str(caught.value)
    assert text.startswith(f"{file}:")
    return text.removeprefix(f"{file}:")


def test_settings_and_their_defaults(tmp_path: Path) -> None:
    scenario, scans = read_all(write(tmp_path, *GRID, POSE))
    assert scenario.name == "a"
    assert scenario.settings == Settings(20, 10, 0.5, -5.0, -2.5, 8.0)
    assert scenario.walls == []
    assert scans == [Pose(0.0, 0.0, 0.0)]


def test_all_settings(tmp_path: Path) -> None:
    more = {
        "min_range": "0.2", "p0": "0.4", "p_occ": "0.9", "p_free": "0.1", "l_min": "-3", "l_max": "4.5",
        "no_return": "ignore", "fov": "1.5", "beams": "7", "noise_std": "0",
    }  # fmt: skip
    params = [f"PARAM occgrid_{name} {value}" for name, value in more.items()]
    scenario, _ = read_all(write(tmp_path, *GRID, *params, POSE))
    assert scenario.settings == Settings(
        20,
        10,
        0.5,
        -5.0,
        -2.5,
        8.0,
        0.2,
        0.4,
        0.9,
        0.1,
        -3.0,
        4.5,
        "ignore",
        1.5,
        7,
        0.0,
    )


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_lines(tmp_path: Path, end: str) -> None:
    file = write(
        tmp_path,
        "# café",
        "",
        " \t ",
        *GRID,
        "PARAM other_parameter 7 host 0",
        "ODOM 1 2 3",
        "\tWALL  1 2\t3 4   # a wall",
        "POSE 1 2 3 # a pose",
        end=end,
    )
    scenario, scans = read_all(file)
    assert scenario.walls == [(1.0, 2.0, 3.0, 4.0)]
    assert scans == [Pose(1.0, 2.0, 3.0)]


def test_a_last_line_without_its_end(tmp_path: Path) -> None:
    file = tmp_path / "a.log"
    file.write_text("\n".join([*GRID, POSE]))
    assert len(read_all(file)[1]) == 1


def test_flaser(tmp_path: Path) -> None:
    file = write(tmp_path, *GRID, f"FLASER 3 1.5 nan INF {TAIL9}")
    (scan,) = read_all(file)[1]
    assert isinstance(scan, Scan)
    assert scan.pose == (1.0, 2.0, 0.5)
    assert scan.angles.tolist() == flaser_angles(3).tolist()
    np.testing.assert_array_equal(scan.ranges, [1.5, math.nan, math.inf])


def test_robotlaser1(tmp_path: Path) -> None:
    line = f"ROBOTLASER1 0 -1.5 9 0.25 80 0.01 0 3 1 2 3 2 200 201 {TAIL14}"
    (scan,) = read_all(write(tmp_path, *GRID, line))[1]
    assert isinstance(scan, Scan)
    assert scan.pose == (1.0, 2.0, 0.5)
    assert scan.angles.tolist() == [-1.5, -1.25, -1.0]
    assert scan.ranges.tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(
    ("token", "value"),
    [
        ("1", 1.0),
        ("+1.", 1.0),
        (".5", 0.5),
        ("5E-1", 0.5),
        ("00000.1e+1", 1.0),
        ("0.1000000000000000055511151231257827021181583404541015625", 0.1),
        ("0.30000000000000004", 0.30000000000000004),
        ("1e299", 1e299),
        ("1e300", math.inf),
        ("1e99999", math.inf),
        ("Infinity", math.inf),
        ("+inf", math.inf),
        ("1e-300", 1e-300),
        ("9e-301", 0.0),
        ("1e-99999", 0.0),
        ("-0", 0.0),
        ("-1e-320", 0.0),
    ],
)
def test_numbers(tmp_path: Path, token: str, value: float) -> None:
    (scan,) = read_all(write(tmp_path, *GRID, f"FLASER 1 {token} {TAIL9}"))[1]
    assert isinstance(scan, Scan)
    assert scan.ranges.tobytes() == np.array([value]).tobytes()


@pytest.mark.parametrize(
    "token",
    ["1_0", "0x1p3", "1e", "e5", ".", "+", "--1", "1.2.3", "nano", "infin", "-+inf",
     "1d", "1f", "1,5", "NaN(1)", "1#IND", "\u0661"],
)  # fmt: skip
def test_what_is_not_a_number(tmp_path: Path, token: str) -> None:
    file = write(tmp_path, *GRID, f"FLASER 1 {token} {TAIL9}")
    expected = f"range 0 '{token}' is not a number"
    if not token.isascii():
        expected = "not plain ASCII text"
    assert failure(file) == f"7: {expected}"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ([], "0: no scan"),
        (["# nothing"], "1: no scan"),
        ([*GRID, "ODOM 1 2 3"], "7: no scan"),
        (["\ufeffPARAM occgrid_width 2"], "1: not plain ASCII text"),
        (["ODOM \x00"], "1: not plain ASCII text"),
        (["[1, 2]"], "1: '[1,' is not a keyword"),
        (["9LIVES"], "1: '9LIVES' is not a keyword"),
        ([*GRID, POSE, GRID[0]], "8: PARAM must stand before the first scan"),
        ([*GRID, POSE, "WALL 1"], "8: WALL must stand before the first scan"),
        (["PARAM occgrid_width"], "1: PARAM takes 2 values, found 1"),
        (["PARAM occgrid_width 1 2"], "1: PARAM takes 2 values, found 3"),
        (["PARAM occgrid_width #1"], "1: PARAM takes 2 values, found 1"),
        (["WALL 1 2 3"], "1: WALL takes 4 values, found 3"),
        ([*GRID, "POSE 1 2"], "7: POSE takes 3 values, found 2"),
        (["PARAM occgrid_wdith 2"], "1: unknown parameter occgrid_wdith"),
        ([*GRID, GRID[1]], "7: occgrid_height is given twice"),
        (["PARAM occgrid_p0 half"], "1: occgrid_p0 'half' is not a number"),
        (
            ["PARAM occgrid_width 2.0"],
            "1: occgrid_width '2.0' is not a whole number",
        ),
        (
            ["PARAM occgrid_width -2"],
            "1: occgrid_width '-2' is not a whole number",
        ),
        (
            ["PARAM occgrid_no_return Free"],
            "1: occgrid_no_return 'Free' is not free or ignore",
        ),
        (
            ["PARAM occgrid_width 0"],
            "1: occgrid_width '0' is not from 1 to 25000000",
        ),
        (
            [f"PARAM occgrid_beams {'9' * 5000}"],
            f"1: occgrid_beams '{'9' * 5000}' is not from 1 to 100000",
        ),
        (
            ["PARAM occgrid_resolution 0"],
            "1: occgrid_resolution '0' is not from 0.001 to 1000",
        ),
        (
            ["PARAM occgrid_resolution -0.1"],
            "1: occgrid_resolution '-0.1' is not from 0.001 to 1000",
        ),
        (
            ["PARAM occgrid_origin_x nan"],
            "1: occgrid_origin_x 'nan' is not from -10000000 to 10000000",
        ),
        (
            ["PARAM occgrid_fov 6.2831853071795869"],
            "1: occgrid_fov '6.2831853071795869' is not from 0 to 6.283185307179586",
        ),
        (["PARAM occgrid_p_occ 1"], "1: occgrid_p_occ '1' is not between 0 and 1"),
        (["PARAM occgrid_p0 0"], "1: occgrid_p0 '0' is not between 0 and 1"),
        (["PARAM occgrid_p0 nan"], "1: occgrid_p0 'nan' is not between 0 and 1"),
        (["WALL 1 2 x 4"], "1: x1 'x' is not a number"),
        (["WALL 1 2 3 inf"], "1: y1 'inf' is not from -10000000 to 10000000"),
        (
            [*GRID, "POSE 0 0 1000001"],
            "7: theta '1000001' is not from -1000000 to 1000000",
        ),
        ([*GRID, "FLASER"], "7: FLASER has no beam count"),
        ([*GRID, "FLASER x"], "7: beam count 'x' is not a whole number"),
        ([*GRID, "FLASER 0"], "7: beam count '0' is not from 1 to 100000"),
        (
            [*GRID, f"FLASER 3 1 2 {TAIL9}"],
            "7: FLASER with 3 beams takes 13 values, found 12",
        ),
        (
            [*GRID, f"FLASER 1 1 2 {TAIL9}"],
            "7: FLASER with 1 beams takes 11 values, found 12",
        ),
        (
            [*GRID, f"FLASER 2 1 -0.5 {TAIL9}"],
            "7: range 1 '-0.5' is negative",
        ),
        ([*GRID, f"FLASER 1 -inf {TAIL9}"], "7: range 0 '-inf' is negative"),
        ([*GRID, "ROBOTLASER1 0 1 2 3 4 5 6"], "7: ROBOTLASER1 has no beam count"),
        (
            [*GRID, f"ROBOTLASER1 0 0 0 0 0 0 0 2 1 0 {TAIL14}"],
            "7: ROBOTLASER1 with 2 beams takes at least 25 values, found 24",
        ),
        (
            [*GRID, f"ROBOTLASER1 0 0 0 0 0 0 0 1 1 1.5 {TAIL14}"],
            "7: remission count '1.5' is not a whole number",
        ),
        (
            [*GRID, f"ROBOTLASER1 0 0 0 0 0 0 0 1 1 2 5 {TAIL14}"],
            "7: ROBOTLASER1 with 1 beams and 2 remissions takes 26 values, found 25",
        ),
        (
            [*GRID, f"ROBOTLASER1 0 inf 0 0 0 0 0 1 x 0 {TAIL14}"],
            "7: start 'inf' is not from -1000000 to 1000000",
        ),
        (
            [*GRID, f"ROBOTLASER1 0 0 0 s 0 0 0 1 x 0 {TAIL14}"],
            "7: step 's' is not a number",
        ),
        ([*GRID[:2], *GRID[3:], POSE], "6: occgrid_resolution is missing"),
        ([POSE], "1: occgrid_width is missing"),
        (
            ["PARAM occgrid_height 5001", "PARAM occgrid_width 5000", *GRID[2:], POSE],
            "2: the grid has more than 25000000 cells",
        ),
        (
            [*GRID[:2], "PARAM occgrid_resolution 0.001", *GRID[3:5],
             "PARAM occgrid_max_range 1001", POSE],
            "6: occgrid_max_range is more than 1000000 cells",
        ),
        (
            ["PARAM occgrid_l_min 8", *GRID, POSE],
            "1: occgrid_l_min is not below occgrid_l_max",
        ),
        (
            ["PARAM occgrid_l_max 2", "PARAM occgrid_p0 0.9", *GRID, "#", POSE],
            "2: logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
        ),
    ],
)  # fmt: skip
def test_errors(tmp_path: Path, lines: list[str], expected: str) -> None:
    assert (
        failure(write(tmp_path, *lines) if lines else _empty(tmp_path))
        == expected
    )


BAD = Path(__file__).parents[2] / "scenarios" / "bad"


def test_the_bad_scenarios(monkeypatch: pytest.MonkeyPatch) -> None:
    """scenarios/bad: every file against the line that stands in expected.txt."""
    monkeypatch.chdir(BAD)
    files = sorted(file.name for file in BAD.glob("*.log"))
    assert len(files) > 300
    found = [f"{name}:{failure(Path(name))}" for name in files]
    assert found == (BAD / "expected.txt").read_text().splitlines()


def test_a_range_below_the_least_is_ignored(tmp_path: Path) -> None:
    """A recorded one, that is; at the least range it counts."""
    lines = f"FLASER 5 0.5 0 nan 0.4999 inf {TAIL9}", POSE, "WALL 0.2 -9 0.2 9"
    file = write(
        tmp_path, *GRID, "PARAM occgrid_min_range 0.5", lines[2], *lines[:2]
    )
    with read_scenario(file) as scenario:
        recorded, simulated = simulated_scans(scenario, None)
    assert str(recorded.ranges.tolist()) == "[0.5, nan, nan, nan, inf]"
    assert simulated.ranges.min() == 0.2
    file = write(tmp_path, *GRID, lines[0])
    (scan,) = read_all(file)[1]
    assert isinstance(scan, Scan)
    assert str(scan.ranges.tolist()) == "[0.5, 0.0, nan, 0.4999, inf]"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["PARAM occgrid_min_range -1"], "1: occgrid_min_range '-1' is not from 0 to 10000"),
        (
            ["PARAM occgrid_min_range 8", *GRID, POSE],
            "7: occgrid_min_range is not below occgrid_max_range",
        ),
        (
            [*GRID, "PARAM occgrid_min_range 8.5", POSE],
            "7: occgrid_min_range is not below occgrid_max_range",
        ),
    ],
)  # fmt: skip
def test_errors_of_the_least_range(
    tmp_path: Path, lines: list[str], expected: str
) -> None:
    assert failure(write(tmp_path, *lines)) == expected


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_scenario_can_be_mapped_again(tmp_path: Path, end: str) -> None:
    """Noise-free, then with a seed, then noise-free: the scans begin anew each time, and so do the lines' numbers."""
    lines = "WALL 3 -2 3 2", "#", POSE, "ODOM 1", f"FLASER 2 1 2 {TAIL9}", POSE
    file = write(tmp_path, *GRID, *lines, end=end)
    with read_scenario(file) as scenario:
        first = map_scenario(scenario, None)
        noisy = map_scenario(scenario, 7)
        again = map_scenario(scenario, None)
        assert len(list(scenario.scans)) == 3
    assert again.log_odds.tobytes() == first.log_odds.tobytes()
    assert noisy.log_odds.tobytes() != first.log_odds.tobytes()
    bad = write(tmp_path, *GRID, *lines, "POSE 1 x 2", end=end)
    with read_scenario(bad) as scenario:
        for _ in range(2):
            with pytest.raises(ScenarioError, match=":13: y 'x' is not"):
                map_scenario(scenario, None)


def test_two_passes_at_once_are_an_error(tmp_path: Path) -> None:
    with read_scenario(write(tmp_path, *GRID, POSE, POSE, POSE)) as scenario:
        first = iter(scenario.scans)
        next(first)
        assert len(list(scenario.scans)) == 3
        with pytest.raises(RuntimeError, match="anew"):
            next(first)


def test_scans_of_an_iterator_are_kept(tmp_path: Path) -> None:
    scenario, scans = read_all(write(tmp_path, *GRID, POSE, POSE))
    made = Scenario("made", scenario.settings, [], iter(scans))
    assert list(made.scans) == list(made.scans) == scans


@pytest.mark.skipif(os.name == "nt", reason="Windows has no named pipes")
def test_a_pipe_can_be_mapped_once(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.log"
    os.mkfifo(pipe)
    text = "\n".join([*GRID, POSE, POSE])
    writer = threading.Thread(target=lambda: pipe.write_text(text))
    writer.start()
    with read_scenario(pipe) as scenario:
        writer.join()
        assert len(list(scenario.scans)) == 2
        with pytest.raises(ScenarioError) as caught:
            list(scenario.scans)
    assert str(caught.value) == f"{pipe}:0: cannot be read a second time"


def _empty(folder: Path) -> Path:
    file = folder / "empty.log"
    file.touch()
    return file


def test_what_cannot_be_read(tmp_path: Path) -> None:
    assert failure(tmp_path / "missing.log") == "0: cannot be read"
    assert failure(tmp_path) == "0: cannot be read"
    file = write(tmp_path, *GRID, POSE)
    assert not failure_or_none(str(file))
    for name in (f"{file}/", f"{file}\0", ""):
        text = str(failure_or_none(name))
        assert text == f"{name.replace(chr(0), '?')}:0: cannot be read"


def failure_or_none(name: str) -> ScenarioError | None:
    try:
        with read_scenario(name) as scenario:
            list(scenario.scans)
    except ScenarioError as error:
        return error
    return None


def test_an_error_is_one_line(tmp_path: Path) -> None:
    error = failure_or_none(f"{tmp_path}/a\nb\x7f\x1f\u00fc.log")
    assert str(error) == f"{tmp_path}/a?b??\u00fc.log:0: cannot be read"


@pytest.mark.skipif(
    not Path("/proc/self/mem").exists(), reason="a file of Linux"
)
def test_reading_that_fails_later() -> None:
    """It opens, and the first read fails."""
    assert str(failure_or_none("/proc/self/mem")) == (
        "/proc/self/mem:0: cannot be read"
    )


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("x/intel.gfs.log", "intel.gfs"),
        ("a", "a"),
        (".log", ".log"),
        ("a.", "a"),
        ("x/a.log//", "a"),
        ("x/.", "."),
        ("..", "."),
        ("", ""),
        ("a b\n.log", "a b\n"),
        ("seed-0.log", "seed-0"),
    ],
)
def test_scenario_name(file: str, name: str) -> None:
    assert scenario_name(file) == name
