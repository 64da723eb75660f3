"""Logs become scenarios: a grid that holds their hits, and their scans unchanged."""

from __future__ import annotations

import gzip
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from typer.testing import CliRunner

from occgrid.grid import OccupancyGrid
from occgrid.map_writer import pixel
from occgrid.mapper import map_scenario
from occgrid.scenario import Scenario, read_scenario
from occgrid.sensor import Scan, beam_endpoints
from occgrid_parity.commands.app import app
from occgrid_parity.logs.scenario_writing import short

FLASER = "FLASER 3 {} {} {} {} {} {} 0 0 0 1.5 host 2.5"
ROBOTLASER1 = (
    "ROBOTLASER1 0 -1.5 3 1.5 81.91 0.01 0 3 {} {} {} 0 {} {} {} " + "0 " * 11
)


def log_file(folder: Path, *lines: str) -> Path:
    path = folder / "some.log"
    path.write_bytes("".join(f"{line}\n" for line in lines).encode("latin-1"))
    return path


def convert(log: Path, *arguments: str) -> tuple[int, str]:
    output = str(log.with_name("scenario.log"))
    words = ["scenario", str(log), "-o", output, *arguments]
    result = CliRunner().invoke(app, words)
    return result.exit_code, result.output


def lines_of(log: Path) -> list[str]:
    return log.with_name("scenario.log").read_text().splitlines()


def parameters(log: Path) -> dict[str, str]:
    words = [line.split() for line in lines_of(log)]
    return {
        w[1].removeprefix("occgrid_"): w[2] for w in words if w[0] == "PARAM"
    }


def test_fits_the_grid_to_hits_and_positions(tmp_path: Path) -> None:
    log = log_file(
        tmp_path,
        "# a log",
        "PARAM laser_frontlaser_offset 0.04",
        FLASER.format(
            2, 4, 81.91, 1, 1, 0
        ),  # ends at (1, -1), (5, 1), nowhere
        "ODOM 0 0 0 0 0 0 1 host 1",
        FLASER.format(81.91, "nan", "inf", -3, 0.25, 0),
    )
    arguments = ["--resolution", "0.1", "--margin", "0.5", "--max-range", "10"]
    status, text = convert(log, *arguments)
    assert status == 0, text
    assert text == (
        f"{tmp_path}/scenario.log: 2 scans on 91 x 31 cells of 0.1 m from (-3.5, -1.5)\n"
        "lines: 2 FLASER taken; passed over: 1 PARAM, 1 ODOM\n"
        "readings: 6 in 2 scans of 3 beams; least 2.00 m, median 4.00 m, largest 81.91 m\n"
        "no return, 10 m or more: 50 % (33 % at 81.91, 17 % at infinity)\n"
        "of all readings: 17 % not a number (NaN)\n"
    )
    scans = [
        line
        for line in log.read_text().splitlines()
        if line.startswith("FLASER")
    ]
    assert lines_of(log) == [
        "# some.log: 2 of its 2 scans",
        "PARAM occgrid_width 91",
        "PARAM occgrid_height 31",
        "PARAM occgrid_resolution 0.1",
        "PARAM occgrid_origin_x -3.5",
        "PARAM occgrid_origin_y -1.5",
        "PARAM occgrid_max_range 10",
        "PARAM occgrid_no_return ignore",
        *scans,
    ]
    assert not list(tmp_path.glob(".*"))


def hit_cells(
    scenario: Scenario, grid: OccupancyGrid
) -> tuple[np.ndarray, np.ndarray]:
    xs, ys = [], []
    for scan in scenario.scans:
        assert isinstance(scan, Scan)
        hit = scan.ranges < scenario.settings.max_range
        ex, ey = beam_endpoints(scan.pose, scan.angles[hit], scan.ranges[hit])
        xs += [scan.pose.x, *ex]
        ys += [scan.pose.y, *ey]
    return grid.world_to_grid(np.array(xs), np.array(ys))


@pytest.mark.parametrize(
    "resolution", ["0.1", "0.05", "0.3", "0.07", "1", "2.5"]
)
@pytest.mark.parametrize("margin", ["0", "0.35"])
def test_every_hit_lies_in_the_grid(
    tmp_path: Path, resolution: str, margin: str
) -> None:
    source = np.random.default_rng(7)
    lines = []
    for form in 30 * [FLASER] + 30 * [ROBOTLASER1]:
        # multiples of a tenth: on the edges of many grids
        numbers = source.integers(0, 60, 3) / 10.0
        pose = [*(source.integers(-600, 600, 2) / 10.0), source.uniform(-9, 9)]
        lines.append(form.format(*numbers, *pose))
    log = log_file(tmp_path, *lines)
    arguments = [
        "--resolution",
        resolution,
        "--margin",
        margin,
        "--max-range",
        "5",
    ]
    status, text = convert(log, *arguments)
    assert status == 0, text
    with read_scenario(tmp_path / "scenario.log") as scenario:
        settings = scenario.settings
        gx, gy = hit_cells(scenario, settings.new_grid())
    assert min(gx.min(), gy.min()) >= 0
    assert gx.max() < settings.width
    assert gy.max() < settings.height
    if margin == "0":  # and no column or row of it is for nothing
        assert (gx.min(), gy.min()) == (0, 0)
        assert (gx.max(), gy.max()) == (
            settings.width - 1,
            settings.height - 1,
        )
    for text in (parameters(log)["origin_x"], parameters(log)["origin_y"]):
        assert Decimal(text) % Decimal(resolution) == 0
        assert text == short(Decimal(text))
        assert len(text) <= 7


def test_a_position_that_the_mapper_rounds_into_the_next_cell(
    tmp_path: Path,
) -> None:
    """(68.8 + 51.5) / 0.1 is a little below 1203, and 1203 as a double."""
    scans = [
        FLASER.format(81.91, 81.91, 81.91, x, 0, 0) for x in (-51.5, 68.8)
    ]
    log = log_file(tmp_path, *scans)
    assert convert(log, "--margin", "0")[0] == 0
    with read_scenario(tmp_path / "scenario.log") as scenario:
        settings = scenario.settings
        gx, _ = hit_cells(scenario, settings.new_grid())
    assert (gx.min(), gx.max()) == (0, 1203)
    assert settings.width == 1204


def test_keeps_the_scans_that_are_chosen(tmp_path: Path) -> None:
    scans = [FLASER.format(1, 1, 1, i, 0, 0) for i in range(10)]
    log = log_file(tmp_path, *scans)

    def kept(*arguments: str) -> list[int]:
        status, text = convert(log, *arguments)
        assert status == 0, text
        return [
            scans.index(line)
            for line in lines_of(log)
            if line.startswith("FLASER")
        ]

    assert kept() == list(range(10))
    assert kept("--every", "3") == [0, 3, 6, 9]
    assert kept("--scans", "2:5") == [2, 3, 4]
    assert kept("--scans", ":2") == [0, 1]
    assert kept("--scans", "8:") == [8, 9]
    assert kept("--scans", "1:8", "--every", "4") == [1, 5]
    assert lines_of(log)[0] == "# some.log: 2 of its 10 scans"
    # the grid is fitted to these only: positions at x = 1 and 5, a hit 1 m ahead
    assert parameters(log)["width"] == "71"


def test_keeps_other_lines_on_request(tmp_path: Path) -> None:
    lines = [
        "# first",
        "PARAM robot_width 0.4",
        FLASER.format(1, 1, 1, 0, 0, 0),
        "ODOM 0 0 0 0 0 0 1 host 1",
        FLASER.format(1, 1, 1, 5, 0, 0) + "\r",
    ]
    log = log_file(tmp_path, *lines)
    log.write_bytes(log.read_bytes().rstrip(b"\r\n"))
    assert convert(log, "--all-lines", "--scans", "1:")[0] == 0
    data = (tmp_path / "scenario.log").read_bytes()
    assert data.endswith(
        b"PARAM occgrid_no_return ignore\n# first\nPARAM robot_width 0.4\n"
        b"ODOM 0 0 0 0 0 0 1 host 1\n" + lines[4].strip().encode() + b"\n"
    )


def test_writes_the_parameters_that_are_given(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    arguments = [
        "--p0",
        "0.4",
        "--p-occ",
        "0.9",
        "--p-free",
        ".35",
        "--l-min",
        "-4",
    ]
    arguments += [
        "--l-max",
        "5.50",
        "--no-return",
        "ignore",
        "--resolution",
        "5e-2",
    ]
    status, text = convert(log, *arguments)
    assert status == 0, text
    found = parameters(log)
    assert found["resolution"] == "0.05"
    expected = {"p0": "0.4", "p_occ": "0.9", "p_free": ".35", "l_min": "-4"}
    expected |= {"l_max": "5.50", "no_return": "ignore"}
    assert {name: found[name] for name in expected} == expected


def test_refuses_a_grid_that_is_too_large(tmp_path: Path) -> None:
    log = log_file(
        tmp_path,
        FLASER.format(1, 1, 1, 0, 0, 0),
        FLASER.format(1, 1, 1, 1000, 4000, 0),
    )
    status, text = convert(log)
    assert status == 1
    assert text == (
        f"{log}: a grid of 10031 x 40041 = 401651271 cells, more than 25000000: choose "
        "a larger --resolution (about 0.41), a smaller --max-range, fewer --scans or a "
        "larger --max-cells\n"
    )
    assert convert(log, "--resolution", "0.41")[0] == 0
    assert convert(log, "--resolution", "0.41", "--max-cells", "1000")[0] == 1
    assert convert(log, "--scans", ":1")[0] == 0


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        ([], "{log}:0: no FLASER or ROBOTLASER1: the file has no line"),
        (
            ["ODOM 1 2 3", "# end"],
            "{log}:2: no FLASER or ROBOTLASER1; found 1 ODOM",
        ),
        (
            [*3 * ["RAWLASER1 0 1 2"], "ODOM 1 2 3", "RLASER 1 2"],
            "{log}:5: no FLASER or ROBOTLASER1; found 3 RAWLASER1, which has no pose and 1 RLASER, "
            "which is another laser of the robot, of unstated direction",
        ),
        (
            ["1.5 2.5 0 0 0 0 0 0"],
            "{log}:1: no FLASER or ROBOTLASER1; found 1 lines that begin with a number",
        ),
        (
            ["# x", "FLASER 2 1 x 0 0 0 0 0 0 0 h 0"],
            "{log}:2: range 1 'x' is not a number",
        ),
        (["FLASER"], "{log}:1: FLASER has no beam count"),
        (
            ["", "FLASER 2 1 1 0 0"],
            "{log}:2: FLASER with 2 beams takes 12 values, found 5",
        ),
        (
            [FLASER.format(1, 1, 1, 0, 0, 0).replace("host", "h\xf6st")],
            "{log}:1: not plain ASCII text",
        ),
        (["POSE 0 0 0"], "{log}:1: this is a scenario already, not a log"),
        (
            ["# x", "PARAM occgrid_width 3"],
            "{log}:2: this is a scenario already, not a log",
        ),
    ],
)
def test_says_what_is_wrong_with_a_log(
    tmp_path: Path, lines: list[str], reason: str
) -> None:
    log = log_file(tmp_path, *lines)
    assert convert(log) == (1, reason.format(log=log) + "\n")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["some.log"]


def test_refuses_a_choice_without_scans(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    reason = f"{log}: none of its 1 scans is chosen\n"
    assert convert(log, "--scans", "1:") == (1, reason)


def test_refuses_parameters_that_the_contract_refuses(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    status, text = convert(log, "--p-occ", "1.5")
    assert status == 1
    reason = "8: occgrid_p_occ '1.5' is not between 0 and 1"
    assert text == f"{tmp_path}/scenario.log:{reason}\n"
    assert not (tmp_path / "scenario.log").exists()


def test_a_log_that_is_not_there(tmp_path: Path) -> None:
    log = tmp_path / "gone.log"
    assert convert(log) == (1, f"{log}:0: cannot be read\n")


def test_does_not_write_over_the_log(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    before = log.read_bytes()
    result = CliRunner().invoke(app, ["scenario", str(log), "-o", str(log)])
    assert result.exit_code == 1
    assert result.output == f"{log}: is the log itself\n"
    assert log.read_bytes() == before


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    output = tmp_path / "no" / "where.log"
    result = CliRunner().invoke(app, ["scenario", str(log), "-o", str(output)])
    assert result.exit_code == 1
    assert (
        result.output
        == f"{output}: cannot be written: No such file or directory\n"
    )


@pytest.mark.parametrize(
    "arguments",
    [
        ("--resolution", "0"),
        ("--resolution", "x"),
        ("--resolution", "nan"),
        ("--resolution", "1e-30"),
        ("--max-range", "-1"),
        ("--margin", "-0.1"),
        ("--scans", "3"),
        ("--every", "0"),
        ("--max-cells", "25000001"),
        ("--p0", "0.5 0.6"),
        ("--p0", "#"),
    ],
)
def test_wrong_usage_ends_with_2(
    tmp_path: Path, arguments: tuple[str, str]
) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 1, 0, 0, 0))
    assert convert(log, *arguments)[0] == 2


def test_a_map_that_ignores_no_return_is_the_default(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(1, 1, 81.91, 0, 0, 0))
    assert "through walls" not in convert(log)[1]
    assert parameters(log)["no_return"] == "ignore"
    assert "through walls" in convert(log, "--no-return", "free")[1]
    assert parameters(log)["no_return"] == "free"


def test_warns_of_a_largest_reading_that_is_often_there(
    tmp_path: Path,
) -> None:
    log = log_file(tmp_path, *10 * [FLASER.format(1, 2, 8.19, 0, 0, 0)])
    assert (
        "warning: 33 % of the readings are 8.19, the largest that there is: if that means no return, "
        "give --max-range 8.17\n"
    ) in convert(log)[1]
    _, text = convert(log, "--max-range", "8.17")
    assert "warning" not in text
    assert "no return, 8.17 m or more: 33 % (33 % at 8.19)\n" in text


def test_readings_below_the_least_range_make_no_hit(tmp_path: Path) -> None:
    log = log_file(tmp_path, FLASER.format(0, 0.25, 3, 5, 5, 0))
    assert (
        "33 % of the readings are 0: they are taken as hits" in convert(log)[1]
    )
    status, text = convert(log, "--min-range", "0.30", "--margin", "0")
    assert status == 0
    assert "of all readings: 33 % 0, 67 % below 0.3 m\n" in text
    assert "warning" not in text
    found = parameters(log)
    assert found["min_range"] == "0.3"
    # the grid is fitted to the third beam, three metres to the left
    assert (found["width"], found["height"]) == ("1", "31")


def test_a_compressed_log_gives_the_same_scenario(tmp_path: Path) -> None:
    log = log_file(
        tmp_path, *(FLASER.format(1, 2, 3, i, 0, 0) for i in range(20))
    )
    assert convert(log)[0] == 0
    expected = lines_of(log)
    plain = log.read_bytes()
    log.write_bytes(gzip.compress(plain))  # whatever its name
    assert convert(log)[0] == 0
    assert lines_of(log) == expected
    log.write_bytes(gzip.compress(plain)[:-30])
    status, text = convert(log)
    assert status == 1
    assert text.startswith(
        f"{log}: the compressed file is damaged or cut off after line "
    )


def test_a_byte_order_mark_and_a_cut_off_line(tmp_path: Path) -> None:
    whole = FLASER.format(1, 1, 1, 0, 0, 0)
    log = log_file(tmp_path, whole)
    log.write_bytes(b"\xef\xbb\xbf" + log.read_bytes() + whole[:12].encode())
    status, text = convert(log)
    assert status == 0, text
    assert (
        "warning: the last line is cut off and skipped: FLASER with 3 beams"
        in text
    )
    assert [w for w in lines_of(log) if w.startswith("FLASER")] == [whole]
    assert lines_of(log)[0] == "# some.log: 1 of its 1 scans"
    log.write_bytes(log.read_bytes() + b"\n")  # not the file's end any more
    assert convert(log)[0] == 1


def test_fills_up_a_flaser_that_lacks_time_stamps(tmp_path: Path) -> None:
    whole = FLASER.format(1, 2, 3, 4, 5, 0.5)
    for fields in range(3, 9):
        short_line = " ".join(whole.split()[: 5 + fields])
        log = log_file(tmp_path, short_line)
        status, text = convert(log)
        assert status == 0, text
        assert "warning: 1 FLASER with fewer than 9 values" in text
        assert lines_of(log)[-1] == short_line + (9 - fields) * " 0"
        with read_scenario(tmp_path / "scenario.log") as scenario:
            (scan,) = scenario.scans
        assert isinstance(scan, Scan)
        assert scan.pose == (4.0, 5.0, 0.5)
    log = log_file(tmp_path, " ".join(whole.split()[:7]))
    assert convert(log)[0] == 1  # not even a pose


def test_utm_coordinates(tmp_path: Path) -> None:
    scans = [
        FLASER.format(1, 2, 3, 512345.125 + i, 5512345.5, 0.1)
        for i in range(3)
    ]
    log = log_file(tmp_path, *scans)
    status, text = convert(log, "--resolution", "0.05")
    assert status == 0, text
    with read_scenario(tmp_path / "scenario.log") as scenario:
        settings = scenario.settings
        gx, gy = hit_cells(scenario, settings.new_grid())
    assert min(gx.min(), gy.min()) >= 0
    assert gx.max() < settings.width
    assert gy.max() < settings.height


def test_draws_the_map(tmp_path: Path) -> None:
    log = log_file(tmp_path, *5 * [FLASER.format(2, 2, 2, 0, 0, 0)])
    picture = tmp_path / "map.png"
    assert convert(log, "--preview", str(picture))[0] == 0
    with read_scenario(tmp_path / "scenario.log") as scenario:
        grid = map_scenario(scenario, None)
    with Image.open(picture) as image:
        pixels = np.asarray(image)
    assert (pixels[::-1] == pixel(grid.log_odds)).all()
    assert len(set(pixels.flat)) > 2
    wrong = convert(log, "--preview", str(tmp_path / "map.txt"))
    assert wrong[0] == 2
    assert "its ending is no kind of picture" in wrong[1]
    gone = tmp_path / "gone" / "map.png"
    assert convert(log, "--preview", str(gone))[0] == 1
