"""Time and memory against scans, beams, resolution and grid size."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from occgrid.grid import GridSpec
from occgrid.lesson import lesson_poses
from occgrid_bench.commands import missing, port_command, run_command
from occgrid_bench.comparison import Effort, compare
from occgrid_bench.contestants import CONTESTANTS
from occgrid_bench.folders import WORK
from occgrid_bench.record import Series
from occgrid_bench.work import Work, lesson_spec, simulated

# a port, and the longest map of it that is worth waiting for, in seconds
PATIENCE = {
    "cpp": 60.0,
    "java": 60.0,
    "web": 60.0,
    "python": 30.0,
    "octave": 12.0,
    "woxi": 6.0,
}
QUICK_PATIENCE = {
    "cpp": 2.0,
    "java": 2.0,
    "web": 2.0,
    "python": 1.0,
    "octave": 0.6,
}
FOLDERS = {"octave": "matlab", "woxi": "mathematica"}


def scans(times: float) -> Work:
    """The lesson's round so many times; less than once: its first scans."""
    poses = lesson_poses()
    count = round(len(poses) * times)
    repeated = [poses[i % len(poses)] for i in range(count)]
    return simulated(
        f"scans-{times:g}",
        f"the lesson's round {times:g} times: {count} scans x 181 beams on 220 x 180 cells",
        lesson_spec(),
        repeated,
    )


def beams(count: float) -> Work:
    """The lesson with another number of beams."""
    return simulated(
        f"beams-{count:g}", "", lesson_spec(), lesson_poses(), int(count)
    )


def resolution(metres: float) -> Work:
    """The lesson with other cells on the same ground."""
    old = lesson_spec()
    spec = replace(
        old,
        width=round(old.width * old.resolution / metres),
        height=round(old.height * old.resolution / metres),
        resolution=metres,
    )
    return simulated(f"resolution-{metres:g}", "", spec, lesson_poses())


def grid(times: float) -> Work:
    """The lesson on a grid that reaches so many times as far in each direction."""
    old = lesson_spec()
    width, height = round(old.width * times), round(old.height * times)
    spec = GridSpec(
        width,
        height,
        old.resolution,
        old.origin_x * times,
        old.origin_y * times,
    )
    return simulated(f"grid-{times:g}", "", spec, lesson_poses())


AXES: dict[str, tuple[Callable[[float], Work], list[float], list[float]]] = {
    "scans": (scans, [0.25, 0.5, 1, 2, 4, 8, 16, 32, 64], [1, 4]),
    "beams": (beams, [46, 91, 181, 361, 721, 1441, 2881], [91, 361]),
    "resolution": (resolution, [0.2, 0.1, 0.05, 0.04, 0.02], [0.2, 0.05]),
    "grid": (grid, [1, 2, 4, 8, 16], [1, 4]),
}


def measure_growth(effort: Effort, quick: bool) -> list[Series]:
    """A series for each axis, value and port: time of mapping, peak memory of the command on the same as a log."""
    patience = QUICK_PATIENCE if quick else PATIENCE
    known = {c.name: c for c in CONTESTANTS}
    found = []
    for axis, (make, values, quick_values) in AXES.items():
        for value in quick_values if quick else values:
            work = make(value)
            chosen = [
                known[name]
                for name, seconds in patience.items()
                if work.cells / known[name].speed < seconds
            ]
            measured = compare(work, chosen, effort)
            for series in measured:
                if not series.skipped:
                    effort.say(f"growth: {work.name}: {series.title}: memory")
                    _measure_command(series, work)
                series.extra |= {
                    "value": value,
                    "crossed": work.cells,
                    "grid": work.spec.width * work.spec.height,
                }
                series.name = f"{axis}/{series.name}"
            found += measured
            for path in WORK.glob(f"{work.name}.*"):
                path.unlink()
    return found


def _measure_command(series: Series, work: Work) -> None:
    port = FOLDERS.get(series.name, series.name)
    if not missing(port):
        run = run_command(port_command(port, work.write_log(WORK)))
        series.extra["command_seconds"] = run.seconds
        series.extra["peak_mib"] = run.peak
