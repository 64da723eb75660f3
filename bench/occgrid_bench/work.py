"""The work: poses and ranges, the same for every contestant, in one file that all of them read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.grid import GridSpec
from occgrid.lesson import lesson_poses, lesson_settings, lesson_world
from occgrid.scenario import read_scenario
from occgrid.sensor import Scan, beam_angles
from occgrid.world import Pose, simulate_lidar_scan

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Work:
    """Scans with the same bearings (n,), ranges (scans, n) all finite, and the grid they are mapped into."""

    name: str
    title: str
    spec: GridSpec
    max_range: float
    angles: Array
    poses: list[Pose]
    ranges: Array

    @property
    def cells(self) -> int:
        """About how many cells the beams cross, in the grid or not."""
        z = np.minimum(self.ranges, self.max_range)
        heading = np.array([p.theta for p in self.poses])[:, None]
        heading = heading + self.angles
        longest = np.maximum(abs(np.cos(heading)), abs(np.sin(heading)))
        return int(np.sum(z * longest / self.spec.resolution) + z.size)

    def every(self, step: int) -> Work:
        """Only each step-th scan."""
        if step == 1:
            return self
        return replace(
            self,
            name=f"{self.name}-{step}",
            poses=self.poses[::step],
            ranges=self.ranges[::step],
        )

    def write(self, folder: Path) -> Path:
        """Write the file of the work: a line for the grid, one for the bearings, one for each scan."""
        path = folder / f"{self.name}.work"
        if path.exists():
            return path
        spec = self.spec
        lines = [
            f"{spec.width} {spec.height} {spec.resolution!r} {spec.origin_x!r} {spec.origin_y!r} "
            f"{self.max_range!r} {len(self.poses)} {self.angles.size}",
            _row(self.angles),
        ]
        lines += [
            f"{_row(np.array(pose))} {_row(ranges)}"
            for pose, ranges in zip(self.poses, self.ranges, strict=True)
        ]
        beside = path.with_suffix(".part")
        beside.write_text("\n".join(lines) + "\n", encoding="ascii")
        return beside.rename(path)

    def write_log(self, folder: Path) -> Path:
        """Write the same as a scenario of recorded scans, for a port's command."""
        path = folder / f"{self.name}.log"
        if path.exists():
            return path
        beside = path.with_suffix(".part")
        with beside.open("w", encoding="ascii") as file:
            file.write(parameters(self.spec, self.max_range))
            for pose, ranges in zip(self.poses, self.ranges, strict=True):
                file.write(robotlaser(pose, self.angles, _row(ranges)))
        return beside.rename(path)


def parameters(spec: GridSpec, max_range: float) -> str:
    """The PARAM lines of a scenario."""
    values = {
        "width": spec.width,
        "height": spec.height,
        "resolution": spec.resolution,
        "origin_x": spec.origin_x,
        "origin_y": spec.origin_y,
        "max_range": max_range,
    }
    return "".join(
        f"PARAM occgrid_{name} {value!r}\n" for name, value in values.items()
    )


def robotlaser(pose: Pose, angles: Array, ranges: str) -> str:
    """A recorded scan with evenly spaced bearings."""
    n = angles.size
    start = float(angles[0])
    step = float(angles[-1] - angles[0]) / max(n - 1, 1)
    x, y, theta = map(float, pose)
    head = f"ROBOTLASER1 0 {start!r} 0 {step!r} 0 0 0 {n} "
    return f"{head}{ranges} 0 {x!r} {y!r} {theta!r}" + 11 * " 0" + "\n"


def _row(values: Array) -> str:
    return " ".join(map(repr, values.tolist()))


def simulated(
    name: str,
    title: str,
    spec: GridSpec,
    poses: Sequence[Pose],
    beams: int = 181,
) -> Work:
    """The lesson's robot among its walls, ranges free of noise."""
    settings = lesson_settings()
    angles = beam_angles(settings.fov, beams)
    walls = lesson_world()
    z_max = settings.max_range
    known: dict[Pose, Array] = {}
    for pose in poses:
        if pose not in known:
            known[pose] = simulate_lidar_scan(pose, walls, angles, z_max)
    ranges = np.array([known[pose] for pose in poses])
    return Work(name, title, spec, z_max, angles, list(poses), ranges)


def lesson_spec() -> GridSpec:
    return lesson_settings().new_grid().spec


def lesson_work() -> Work:
    return simulated(
        "lesson",
        "the lesson: 120 scans x 181 beams on 220 x 180 cells",
        lesson_spec(),
        lesson_poses(),
    )


def open_lesson_work() -> Work:
    """The lesson on a grid that holds every beam: the robot leaves the lesson's own.

    It is a metre wider than that all around, or else MRPT's grid grows.
    """
    spec = GridSpec(480, 320, 0.1, -24.0, -16.0)
    return simulated(
        "open",
        "the lesson on 480 x 320 cells, which hold every beam",
        spec,
        lesson_poses(),
    )


def log_work(scenario_file: Path, title: str) -> Work:
    """A recorded log, from the scenario that was made of it; NaN and infinite ranges are read as no return."""
    with read_scenario(scenario_file) as scenario:
        settings = scenario.settings
        scans = [scan for scan in scenario.scans if isinstance(scan, Scan)]
    angles = scans[0].angles
    scans = [scan for scan in scans if np.array_equal(scan.angles, angles)]
    z_max = settings.max_range
    ranges = np.array([scan.ranges for scan in scans])
    ranges = np.where(ranges < z_max, ranges, z_max)
    spec = settings.new_grid().spec
    title += (
        f": {len(scans)} scans x {angles.size} beams on {spec.width} x "
        f"{spec.height} cells"
    )
    poses = [scan.pose for scan in scans]
    return Work("log", title, spec, z_max, angles, poses, ranges)
