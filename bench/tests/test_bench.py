"""The benchmark's own sums, files and tables; nothing here is timed."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from occgrid.grid import OccupancyGrid
from occgrid.sensor import beam_endpoints
from occgrid_bench import growth
from occgrid_bench.commands import port_command
from occgrid_bench.comparison import ENVIRONMENT
from occgrid_bench.contestants import CONTESTANTS, REFERENCE
from occgrid_bench.drivers import Driver
from occgrid_bench.folders import ROOT
from occgrid_bench.goals import Goal, goals
from occgrid_bench.log_odds import contract_map, differing
from occgrid_bench.markdown import markdown
from occgrid_bench.parts import PORTS
from occgrid_bench.plots import draw
from occgrid_bench.record import Part, Series, read_part
from occgrid_bench.statistics import deviation, ratio
from occgrid_bench.tables import duration, times
from occgrid_bench.work import Work, lesson_work, log_work

MACHINE = {"processor": "P", "cores": "2", "system": "S", "kernel": "1"}


def part(name: str, **seconds: list[float]) -> Part:
    """A part with these contestants, dashes for underscores."""
    series = [
        Series(contestant.replace("_", "-"), contestant, seconds=values)
        for contestant, values in seconds.items()
    ]
    return Part(name, "T: t", f"make {name}", 3, False, series, 0, MACHINE)


def lesson_part() -> Part:
    return part(
        "lesson",
        lesson_cpp=[6.0, 12.0, 6.0],
        cpp=[1.0, 2.0, 1.0],
        java=[2.0, 2.0, 2.0],
        lesson_java=[6.0, 6.0, 6.0],
        floor_list=[0.5, 1.0, 0.5],
        floor_ends=[0.25, 0.5, 0.25],
        mrpt=[0.9, 0.9, 0.9],
        python=[10.0, 10.0, 10.0],
        octomap=[40.0, 40.0, 40.0],
        octomap_rays=[30.0, 30.0, 30.0],
    )


def goal(found: list[Goal], start: str) -> Goal:
    (only,) = (g for g in found if g.text.startswith(start))
    return only


# --- statistics ---


def test_deviation_is_not_moved_by_one_outlier() -> None:
    assert deviation([1.0, 2.0, 3.0, 4.0, 1000.0]) == 1.0
    assert deviation([5.0]) == 0.0


def test_ratio_is_taken_round_by_round() -> None:
    # the medians' ratio would be 20 / 1
    assert ratio([10.0, 20.0, 30.0], [1.0, 1.0, 30.0]) == 10.0
    # a slow contestant has fewer rounds
    assert ratio([8.0], [2.0, 1.0, 1.0]) == 4.0


# --- goals ---


def test_goals_of_the_lesson() -> None:
    found = goals({"lesson": lesson_part()})
    faster = goal(found, "C++: times as fast as the lesson's")
    assert (faster.value, faster.bound, faster.met) == (6.0, 6.0, True)
    assert faster.command == "make lesson"
    mrpt = goal(found, "C++: times as fast as MRPT")
    assert (mrpt.value, mrpt.met) == (0.9, False)
    java = goal(found, "Java, warm: times as fast")
    assert (java.value, java.met) == (3.0, False)
    over = goal(found, "Java, warm: time over")
    assert (over.value, over.at_least, over.met) == (2.0, False, False)
    floor = goal(found, "C++: time over the floor's")
    assert floor.value == pytest.approx(4 / 3)
    assert floor.met
    # the quicker of the two ways to use OctoMap
    octomap = goal(found, "NumPy, whole log: times as fast as OctoMap")
    assert (octomap.value, octomap.met) == (3.0, True)
    # nothing is said of what was not measured
    assert len(found) == 6


def test_goals_of_the_other_parts() -> None:
    long_log = part("long", a=[1.0], b=[1.0], c=[1.0], d=[1.0])
    for series, scans, peak in zip(
        long_log.series, (10, 10, 99, 99), (4.0, 8.0, 4.0, 12.0), strict=True
    ):
        series.extra = {"scans": scans, "peak_mib": peak}
    found = goals(
        {
            "open": part("open", cpp=[1.0], mrpt=[1.5]),
            "commands": part("commands", mathematica=[21.0]),
            "threads": part("threads", cpp_1=[3.0], cpp_2=[2.0], java_1=[1.0]),
            "long": long_log,
        }
    )
    assert [(g.value, g.met) for g in found] == [
        (1.5, True),
        (21.0, False),
        (1.5, False),
        (1.25, False),
    ]
    assert goals({}) == []


# --- work files ---


def test_work_of_the_lesson() -> None:
    work = lesson_work()
    assert work.ranges.shape == (120, 181)
    assert np.isfinite(work.ranges).all()


def test_crossed_cells_are_about_those_of_the_lines() -> None:
    work = small_work()
    grid = OccupancyGrid(work.spec)
    cells = 0
    for pose, ranges in zip(work.poses, work.ranges, strict=True):
        x, y = (
            np.full(work.angles.size, pose.x),
            np.full(work.angles.size, pose.y),
        )
        ex, ey = beam_endpoints(pose, work.angles, ranges)
        gx0, gy0 = grid.world_to_grid(x, y)
        gx1, gy1 = grid.world_to_grid(ex, ey)
        steps = np.maximum(abs(gx1 - gx0), abs(gy1 - gy0))
        cells += int(steps.sum()) + steps.size
    assert work.cells == pytest.approx(cells, rel=0.01)


def test_every_scan_of_so_many() -> None:
    work = lesson_work().every(16)
    assert work.name == "lesson-16"
    assert len(work.poses) == len(work.ranges) == 8
    assert work.poses[1] == lesson_work().poses[16]


def small_work() -> Work:
    return growth.scans(0.05)


def test_work_file_reads_back_exactly(tmp_path: Path) -> None:
    work = small_work()
    head, angles, *scans = work.write(tmp_path).read_text("ascii").splitlines()
    assert head == "220 180 0.1 -11.0 -9.0 10.0 6 181"
    assert list(map(float, angles.split())) == work.angles.tolist()
    for line, pose, ranges in zip(scans, work.poses, work.ranges, strict=True):
        assert list(map(float, line.split())) == [*pose, *ranges.tolist()]


def test_log_of_a_work_holds_the_same_scans(tmp_path: Path) -> None:
    """But for the bearings' last bits: start + i*step rounds otherwise."""
    work = small_work()
    again = log_work(work.write_log(tmp_path), "again")
    assert again.spec == work.spec
    assert again.poses == work.poses
    assert (again.ranges == work.ranges).all()
    np.testing.assert_allclose(again.angles, work.angles, atol=1e-15)


def test_differing_cells_are_counted_in_bits(tmp_path: Path) -> None:
    file = tmp_path / "a.logodds"
    file.write_text("# logodds 2 2\n0.1 -0.0\n1.0 2\n", "ascii")
    assert differing(file, np.array([[0.1, -0.0], [1.0, 2.0]])) == 0
    assert differing(file, np.array([[0.1, 0.0], [1.0, 2.5]])) == 2
    with pytest.raises(ValueError, match="4 cells, not 3"):
        differing(file, np.zeros(3))


@pytest.mark.parametrize("axis", list(growth.AXES))
def test_growth_starts_at_the_lesson(axis: str) -> None:
    make, values, quick = growth.AXES[axis]
    assert set(quick) <= set(values)
    same = {"scans": 1, "beams": 181, "resolution": 0.1, "grid": 1}[axis]
    assert make(same).spec == lesson_work().spec
    assert (make(same).ranges == lesson_work().ranges).all()


# --- contestants ---


def test_every_port_takes_part() -> None:
    declared = {path.parent.name for path in ROOT.glob("*/port.toml")}
    assert set(PORTS) == declared
    for port in PORTS:
        command = port_command(port, Path("s.log"), ["--threads", "2"])
        at = command.index("--noise-free")
        assert command[at + 1 : at + 3] == ["--out", "{out}"]
        assert command[-3:] == ["--threads", "2", "s.log"]
        assert not any("{port}" in word for word in command)


@pytest.mark.parametrize(
    "name",
    [
        "python",
        "python-scan",
        "python-plain",
        "lesson-python",
        "web",
        "web-plain",
        "lesson-web",
    ],
)
def test_drivers_map_the_work(name: str, tmp_path: Path) -> None:
    """Those that need no build; the others are held to the contract by each measurement."""
    (contestant,) = (c for c in CONTESTANTS if c.name == name)
    if contestant.missing():
        if os.environ.get("PARITY_REQUIRE_ALL", "") not in ("", "0"):
            pytest.fail(contestant.missing())
        pytest.skip(contestant.missing())
    work = small_work()
    path = str(work.write(tmp_path))
    command = [word.format(work=path) for word in contestant.command]
    with Driver(command, ENVIRONMENT) as driver:
        seconds = driver.map(2)
        driver.write(tmp_path / "map.logodds")
    assert len(seconds) == 2
    assert min(seconds) > 0.0
    expected = contract_map(work)
    if contestant.check == "bits":
        assert differing(tmp_path / "map.logodds", expected) == 0
        return
    text = (tmp_path / "map.logodds").read_text("ascii").split("\n", 1)[1]
    found = np.array(text.split(), dtype=np.float64)
    # another library's cosine may move a few beams' ends
    assert np.sum(abs(found - expected.ravel()) > 1e-9) < 10


# --- records, tables, pictures ---


def test_part_is_written_and_read(tmp_path: Path) -> None:
    before = lesson_part()
    path = before.write(tmp_path)
    assert json.loads(path.read_text("utf-8"))["command"] == "make lesson"
    assert read_part(path) == before


def test_figures_have_units() -> None:
    assert duration(0.0012345) == "1.23 ms"
    assert duration(12.345) == "12.3 s"
    assert duration(123.4) == "123 s"
    assert times(0.1234) == "0.12"
    assert times(1.0) == "1.00"
    assert times(2345.6) == "2,346"


def test_names_are_used_once() -> None:
    names = [c.name for c in CONTESTANTS]
    assert len(set(names)) == len(names)
    assert names[0] == REFERENCE


def test_markdown_says_what_where_and_again_with() -> None:
    text = markdown({"lesson": lesson_part()})
    assert "Measured on: P, 2 cores; S; Linux 1." in text
    assert "| C++ port | 0.17 |" in text
    assert "| lesson's algorithm, Octave |" not in text
    assert "| at least 6 | 6 | met | `make lesson` |" in text
    assert "| at least 1 | 0.9 | **missed** | `make lesson` |" in text
    assert markdown({}) == "\n"


def test_pictures_are_drawn(tmp_path: Path) -> None:
    grown = part("growth")
    for value in (1.0, 2.0):
        series = Series("scans/cpp", "C++ port", seconds=[value])
        series.extra = {"value": value, "crossed": 9.0, "peak_mib": 4.0}
        grown.series.append(series)
    drawn = draw({"lesson": lesson_part(), "growth": grown}, tmp_path)
    assert [path.name for path in drawn] == ["comparison.png", "growth.png"]
    assert all(path.read_bytes()[:4] == b"\x89PNG" for path in drawn)
