"""ROS bags of a known world: the map from the bag is that of the same scans at the true poses, cell by cell."""

from __future__ import annotations

import functools
import math
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from occgrid.grid import OccupancyGrid
from occgrid.mapper import map_scenario
from occgrid.scenario import Scenario, read_scenario
from occgrid.sensor import Scan
from occgrid.world import Pose, build_box_world, simulate_lidar_scan
from occgrid_parity.commands.app import app
from occgrid_parity.logs.transforms import FrameTree, Transform, When

from .bags import KINDS, SECOND, START, Messages, Stamped, euler, write_bag

WALLS = [*build_box_world(-4.03, -3.07, 5.11, 3.93)]
BEAMS, FIRST_ANGLE = 121, -1.5
STEP = 0.025
SCANS = 40
PERIOD = SECOND // 10
HALF = PERIOD // 2
IDENTITY = (0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Mount:
    """How the laser is mounted on the robot; it leads from base_link over mast to laser."""

    x: float = 0.2
    y: float = -0.05
    yaw: float = 0.0
    roll: float = 0.0

    @property
    def upside_down(self) -> bool:
        return self.roll != 0.0


def robot(time: float) -> Pose:
    """The true pose: along a line at constant speed and turn, so that interpolation is exact."""
    return Pose(-2.0 + 0.6 * time, -1.0 + 0.25 * time, 0.3 + 0.2 * time)


def laser(time: float, mount: Mount) -> Pose:
    """The true pose of the laser."""
    pose = robot(time)
    c, s = math.cos(pose.theta), math.sin(pose.theta)
    return Pose(
        pose.x + c * mount.x - s * mount.y,
        pose.y + s * mount.x + c * mount.y,
        pose.theta + mount.yaw,
    )


def bearings(mount: Mount) -> np.ndarray:
    """Bearings as seen from above."""
    angles = FIRST_ANGLE + STEP * np.arange(BEAMS)
    return -angles if mount.upside_down else angles


@functools.cache
def measured(number: int, mount: Mount) -> np.ndarray:
    """What the laser measures, to the millimetre as single precision."""
    pose = laser(number * 0.1 + 0.05, mount)
    ranges = simulate_lidar_scan(pose, WALLS, bearings(mount), 12.0)
    return np.round(ranges, 3).astype(np.float32)


def true_ranges(number: int, mount: Mount) -> np.ndarray:
    """Those ranges, for the caller to change."""
    return measured(number, mount).copy()


def drive(
    make: Messages,
    mount: Mount,
    spoil: dict[int, float] | None = None,
    first_transform: int = 0,
) -> Iterator[Stamped]:
    """Transforms every tenth of a second, and scans in between, each recorded before the next transform."""
    at = (mount.x, mount.y, 0.0)
    yield Stamped(
        "/tf_static", START,
        make.transform(START, "base_link", "mast", at, euler(0, 0, mount.yaw)),
    )  # fmt: skip
    turn = euler(mount.roll, 0.0, 0.0)
    yield Stamped(
        "/tf_static", START,
        make.transform(START, "mast", "laser", (0, 0, 0.4), turn),
    )  # fmt: skip
    for number in range(SCANS + 1):
        time = START + number * PERIOD
        if number >= first_transform:
            yield from transforms(make, time, number * 0.1)
        ranges = true_ranges(number, mount)
        for beam, value in (spoil or {}).items():
            ranges[beam] = value
        message = make.scan(time + HALF, (FIRST_ANGLE, STEP), ranges)
        if number < SCANS:
            yield Stamped("/scan", time + HALF, message)


def transforms(make: Messages, time: int, seconds: float) -> Iterator[Stamped]:
    """map > odom, which drifts, and odom > base_link, so that together they are the true pose."""
    pose = robot(seconds)
    drift = (0.5, -0.25, 0.0)
    yield Stamped(
        "/tf", time, make.transform(time, "map", "odom", drift, IDENTITY)
    )
    place = (pose.x - drift[0], pose.y - drift[1], 0.0)
    turn = euler(0, 0, pose.theta)
    yield Stamped(
        "/tf", time, make.transform(time, "odom", "base_link", place, turn)
    )


def convert(log: Path, *arguments: str) -> tuple[int, str]:
    output = str(log.parent / "scenario.log")
    words = ["scenario", str(log), "-o", output, "--resolution", "0.1"]
    result = CliRunner().invoke(app, [*words, *arguments])
    return result.exit_code, result.output


def scenario_of(log: Path) -> Path:
    return log.parent / "scenario.log"


def scans_of(log: Path) -> list[Scan]:
    with read_scenario(scenario_of(log)) as scenario:
        found = list(scenario.scans)
    assert all(isinstance(scan, Scan) for scan in found)
    return found  # type: ignore[return-value]


def same_map(
    log: Path,
    mount: Mount,
    numbers: Sequence[int],
    spoil: dict[int, float] | None = None,
    shift: tuple[float, float] = (0.0, 0.0),
) -> OccupancyGrid:
    """Maps the scenario, and the known scans at the true poses on the same grid: all cells are the same."""
    scans: list[Pose | Scan] = []
    for number in numbers:
        x, y, theta = laser(number * 0.1 + 0.05, mount)
        pose = Pose(x - shift[0], y - shift[1], theta)
        ranges = true_ranges(number, mount)
        for beam, value in (spoil or {}).items():
            ranges[beam] = value
        text = [float(str(value)) for value in ranges]
        scans.append(Scan(pose, bearings(mount), np.array(text)))
    with read_scenario(scenario_of(log)) as scenario:
        found = map_scenario(scenario, None)
        direct = Scenario("direct", scenario.settings, [], scans)
        expected = map_scenario(direct, None)
    assert (expected.log_odds > 1.0).sum() > 50
    different = np.argwhere(found.log_odds != expected.log_odds)
    assert different.size == 0, different[:5]
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_the_map_of_a_bag_is_that_of_its_scans(
    tmp_path: Path, kind: str
) -> None:
    mount = Mount()
    log = write_bag(tmp_path / "drive", kind, lambda m: drive(m, mount))
    status, text = convert(log, "--topic", "/scan", "--frame", "map")
    assert status == 0, text
    assert "poses: TF, map > odom > base_link > mast > laser\n" in text
    assert "skipped" not in text
    same_map(log, mount, range(SCANS))
    assert "PARAM occgrid_max_range 12\n" in scenario_of(log).read_text()
    default = scenario_of(log).read_bytes()
    assert convert(log)[0] == 0  # the only topic, and the frame map
    assert scenario_of(log).read_bytes() == default


@pytest.mark.parametrize("kind", ["db3", "mcap"])
def test_a_file_of_a_ros_2_bag_will_do(tmp_path: Path, kind: str) -> None:
    log = write_bag(tmp_path / "drive", kind, lambda m: drive(m, Mount()))
    (file,) = log.glob(f"*.{kind}")
    assert convert(log)[0] == 0
    whole = scenario_of(log).read_text().splitlines()
    status, text = convert(file)
    assert status == 0, text
    alone = (file.parent / "scenario.log").read_text().splitlines()
    assert alone[1:] == whole[1:]


MOUNTS = {
    "turned": Mount(yaw=2.5),
    "upside down": Mount(roll=math.pi),
    "upside down and turned": Mount(yaw=-1.2, roll=math.pi),
}


@pytest.mark.parametrize("mount", MOUNTS.values(), ids=MOUNTS)
@pytest.mark.parametrize("kind", ["bag", "mcap"])
def test_lasers_that_are_turned_or_upside_down(
    tmp_path: Path, kind: str, mount: Mount
) -> None:
    log = write_bag(tmp_path / "drive", kind, lambda m: drive(m, mount))
    status, text = convert(log)
    assert status == 0, text
    assert ("upside down in 40" in text) == mount.upside_down
    same_map(log, mount, range(SCANS))


def test_scans_without_a_transform_are_counted_and_skipped(
    tmp_path: Path,
) -> None:
    mount = Mount()

    def messages(make: Messages) -> Iterator[Stamped]:
        yield from drive(make, mount, first_transform=7)
        late = START + (SCANS + 5) * PERIOD
        scan = make.scan(late, (FIRST_ANGLE, STEP), true_ranges(0, mount))
        yield Stamped("/scan", late, scan)

    log = write_bag(tmp_path / "drive", "bag", messages)
    status, text = convert(log)
    assert status == 0, text
    assert (
        "warning: scans skipped: 7 before the first transform, 1 after the last transform\n"
        in text
    )
    same_map(log, mount, range(7, SCANS))
    first = scenario_of(log).read_text().splitlines()[0]
    assert first == "# drive.bag: 33 of its 41 scans"


def test_readings_that_are_none(tmp_path: Path) -> None:
    """REP 117: inf is no return; -inf, NaN and what range_min and range_max exclude are no measurements."""
    mount = Mount()
    spoil = {
        0: math.inf, 1: -math.inf, 2: math.nan, 3: 0.0, 4: 0.04, 5: 12.5, 60: math.inf,
    }  # fmt: skip
    log = write_bag(
        tmp_path / "drive", "mcap", lambda m: drive(m, mount, spoil)
    )
    for no_return in ("ignore", "free"):
        status, text = convert(log, "--no-return", no_return)
        assert status == 0, text
        (scan, *_) = scans_of(log)
        assert np.isposinf(scan.ranges[[0, 60]]).all()
        assert np.isnan(scan.ranges[1:6]).all()
        assert np.isfinite(scan.ranges[6:60]).all()
        same_map(log, mount, range(SCANS), spoil | dict.fromkeys(range(1, 6), math.nan))  # fmt: skip
    assert "no return, 12 m or more: 1.7 % (1.7 % at infinity)\n" in text


def test_the_users_range_counts_before_the_bags(tmp_path: Path) -> None:
    log = write_bag(tmp_path / "drive", "mcap", lambda m: drive(m, Mount()))
    assert convert(log, "--max-range", "4.5")[0] == 0
    assert "PARAM occgrid_max_range 4.5\n" in scenario_of(log).read_text()
    same_map(log, Mount(), range(SCANS))


def odometry(
    make: Messages, mount: Mount, frames: tuple[str, str], static: bool
) -> Iterator[Stamped]:
    """Scans with an odometry topic; with TF for the mount alone, or without any."""
    for one in drive(make, mount):
        if one.topic == "/scan" or (static and one.topic == "/tf_static"):
            yield one
    for number in range(SCANS + 1):
        time = START + number * PERIOD
        pose = robot(number * 0.1)
        turn = euler(0, 0, pose.theta)
        message = make.odometry(time, frames, (pose.x, pose.y, 0.0), turn)
        yield Stamped("/odom", time, message)


def in_order(messages: Iterable[Stamped]) -> list[Stamped]:
    return sorted(messages, key=lambda one: one.time)


@pytest.mark.parametrize("kind", KINDS)
def test_poses_from_an_odometry_topic(tmp_path: Path, kind: str) -> None:
    mount = Mount(yaw=0.4)
    log = write_bag(
        tmp_path / "drive", kind,
        lambda m: in_order(odometry(m, mount, ("odom", "base_link"), True)),
    )  # fmt: skip
    status, text = convert(log)
    assert status == 0, text
    assert (
        "poses: odometry of /odom (odom > base_link), because TF does not connect laser with map or odom"
        in text
    )
    assert "warning" not in text
    same_map(log, mount, range(SCANS))


def test_odometry_without_any_transform(tmp_path: Path) -> None:
    mount = Mount(x=0.0, y=0.0)
    log = write_bag(
        tmp_path / "drive", "bag",
        lambda m: in_order(odometry(m, mount, ("/odom", ""), False)),
    )  # fmt: skip
    status, text = convert(log)
    assert status == 0, text
    assert (
        "warning: nothing says where laser is on base_link: it is taken to be at its origin\n"
        in text
    )
    same_map(log, mount, range(SCANS))


def test_the_frame_odom(tmp_path: Path) -> None:
    """TF's own, where it is asked for, and where there is no map."""
    mount = Mount()
    log = write_bag(tmp_path / "drive", "bag", lambda m: drive(m, mount))
    status, text = convert(log, "--frame", "odom")
    assert status == 0, text
    assert "poses: TF, odom > base_link > mast > laser\n" in text
    asked = scenario_of(log).read_text().splitlines()
    same_map(log, mount, range(SCANS), shift=(0.5, -0.25))

    def without_map(make: Messages) -> Iterator[Stamped]:
        for one in drive(make, mount):
            tf = one.topic == "/tf"
            if not tf or one.message.transforms[0].child_frame_id != "odom":
                yield one

    log = write_bag(tmp_path / "other", "bag", without_map)
    assert convert(log)[0] == 0
    assert scenario_of(log).read_text().splitlines()[1:] == asked[1:]


def test_chosen_scans(tmp_path: Path) -> None:
    log = write_bag(tmp_path / "drive", "db3", lambda m: drive(m, Mount()))
    status, text = convert(log, "--scans", "5:30", "--every", "4")
    assert status == 0, text
    same_map(log, Mount(), range(5, 30, 4))


def test_a_tilted_laser(tmp_path: Path) -> None:
    log = write_bag(
        tmp_path / "few", "bag", lambda m: drive(m, Mount(roll=0.05))
    )
    assert (
        "warning: the laser is tilted by up to 2.9 degrees" in convert(log)[1]
    )
    log = write_bag(
        tmp_path / "many", "bag", lambda m: drive(m, Mount(roll=0.5))
    )
    status, text = convert(log)
    assert status == 1
    assert text == (
        f"{log}: none of its 40 scans can be used: 40 tilted by more than 10 degrees\n"
    )


def test_says_what_a_bag_lacks(tmp_path: Path) -> None:
    def two(make: Messages) -> Iterator[Stamped]:
        for one in drive(make, Mount()):
            yield one
            if one.topic == "/scan":
                yield Stamped("/rear", one.time, one.message)

    log = write_bag(tmp_path / "two", "bag", two)
    assert convert(log) == (
        1,
        f"{log}: several topics of LaserScan: choose one with --topic: /rear (40), /scan (40)\n",
    )
    assert convert(log, "--topic", "/rear")[0] == 0
    assert convert(log, "--topic", "/x") == (
        1, f"{log}: no LaserScan in /x; found /rear (40), /scan (40)\n",
    )  # fmt: skip
    status, text = convert(log, "--topic", "/scan", "--frame", "world")
    assert status == 1
    assert text == (
        f"{log}: nothing says where laser is in world: no transform and no odometry topic; frames: "
        "base_link, laser, map, mast, odom\n"
    )
    no_scans = write_bag(
        tmp_path / "none", "mcap",
        lambda m: transforms(m, START, 0.0),
    )  # fmt: skip
    assert convert(no_scans) == (
        1,
        f"{no_scans}: no topic of LaserScan; found /tf (tf2_msgs/msg/TFMessage)\n",
    )
    damaged = tmp_path / "damaged.bag"
    damaged.write_bytes(log.read_bytes()[:3000])
    status, text = convert(damaged)
    assert status == 1
    assert text.startswith(f"{damaged}: not a bag that can be read: ")
    assert text.count("\n") == 1
    (tmp_path / "folder").mkdir()
    assert convert(tmp_path / "folder") == (
        1,
        f"{tmp_path}/folder: a folder without metadata.yaml is no ROS 2 bag\n",
    )
    missing = tmp_path / "gone.bag"
    status, text = convert(missing)
    assert status == 1
    assert text.count("\n") == 1
    assert not list(tmp_path.glob(".*"))


def test_without_the_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    log = write_bag(tmp_path / "drive", "bag", lambda m: drive(m, Mount()))
    monkeypatch.setitem(sys.modules, "rosbags.highlevel", None)
    assert convert(log) == (
        1,
        f"{log}: a ROS bag is read by the package rosbags: pip install 'occgrid-parity[ros]'\n",
    )


def test_options_of_the_other_kind_of_log(tmp_path: Path) -> None:
    log = write_bag(tmp_path / "drive", "bag", lambda m: drive(m, Mount()))
    status, text = convert(log, "--all-lines")
    assert (status, text) == (
        1, f"{log}: a bag has no lines for --all-lines\n",
    )  # fmt: skip
    text_log = tmp_path / "some.log"
    text_log.write_text("FLASER 1 1 0 0 0 0 0 0 0 h 0\n")
    status, text = convert(text_log, "--topic", "/scan")
    assert status == 1
    assert "--topic and --frame are for ROS bags" in text


def test_memory_does_not_grow_with_the_bag() -> None:
    """Transforms that no scan needs any more are forgotten, those around a scan that waits are not."""
    tree = FrameTree()
    place = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    held = 0
    for time in range(10_000):
        tree.add("map", "laser", time, place)
        tree.forget_before(time - 100)
        held = max(held, len(tree.edges["map", "laser"].times))
    assert held < 200
    assert tree.when([("map", "laser")], 9_900) is When.WITHIN
    assert tree.when([("map", "laser")], 5_000) is When.BEFORE
