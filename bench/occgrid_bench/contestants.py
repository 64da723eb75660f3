"""Who takes part, how each is started, and what its figure means."""

from __future__ import annotations

import shutil
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from occgrid_bench.building import JAVA_PORT
from occgrid_bench.folders import BENCH, CLASSES, PROGRAMS, ROOT

Group = Literal["lesson", "port", "floor", "peer"]
# how its log-odds compare with the contract's: bit for bit, by the count of cells, or not at all
Check = Literal["bits", "count", "none"]

OCTAVE = ("octave-cli", "--no-history", "--norc", "--quiet")
JAVA = ("java", "-cp", f"{CLASSES}:{JAVA_PORT}")
REFERENCE = "lesson-cpp"


@dataclass(frozen=True)
class Contestant:
    """One that maps the work; {work} and {log_odds} in its command become files."""

    name: str
    title: str
    group: Group
    command: tuple[str, ...]
    speed: float  # crossed cells per second, roughly: how much of a work fits a round
    what: str  # what the figure is
    needs: str = ""  # a program or file that must be there
    install: str = ""
    check: Check = "bits"
    warm_up: float = 0.1  # seconds of maps that do not count
    fresh: bool = False  # a process of its own for each map
    one_shot: bool = False  # does not answer requests: prints its seconds

    def missing(self) -> str:
        """What to install, or nothing."""
        need = self.needs or self.command[0]
        there = shutil.which(need) or Path(need).exists()
        return "" if there else f"install {self.install or need}"


def _python(script: str, *arguments: str) -> tuple[str, ...]:
    return (sys.executable, str(BENCH / script), "{work}", *arguments)


def _octave(script: str, *arguments: str) -> tuple[str, ...]:
    return (*OCTAVE, str(BENCH / script), "{work}", *arguments)


def _program(name: str, *arguments: str) -> tuple[str, ...]:
    return (str(PROGRAMS / name), "{work}", *arguments)


def _node(script: str, *arguments: str) -> tuple[str, ...]:
    return ("node", str(BENCH / script), "{work}", *arguments)


WOXI = str(ROOT / ".venv" / "bin" / "woxi")

CONTESTANTS = [
    Contestant(
        REFERENCE,
        "lesson's algorithm, C++",
        "lesson",
        _program("cpp_lesson"),
        5e7,
        "a growing list of cells per beam, borders checked at each update",
        check="count",
    ),
    Contestant(
        "cpp",
        "C++ port",
        "port",
        _program("cpp_port"),
        4e8,
        "update_grid_from_scans, all scans in one call",
    ),
    Contestant(
        "cpp-plain",
        "C++ port, plain",
        "port",
        _program("cpp_port", "plain"),
        1e8,
        "update_grid_from_scan, scan after scan",
    ),
    Contestant(
        "java",
        "Java port, warm",
        "port",
        (*JAVA, "PortDriver", "{work}"),
        3e8,
        "updateGridFromScans, all scans in one call",
        install="openjdk-17-jdk-headless",
        warm_up=2.0,
    ),
    Contestant(
        "java-plain",
        "Java port, plain, warm",
        "port",
        (*JAVA, "PortDriver", "{work}", "plain"),
        5e7,
        "updateGridFromScan, scan after scan",
        install="openjdk-17-jdk-headless",
        warm_up=2.0,
    ),
    Contestant(
        "java-cold",
        "Java port, cold",
        "port",
        (*JAVA, "PortDriver", "{work}"),
        4e7,
        "the first map of a new virtual machine",
        install="openjdk-17-jdk-headless",
        fresh=True,
    ),
    Contestant(
        "web",
        "JavaScript port, warm",
        "port",
        _node("web/port_driver.mjs"),
        1e8,
        "updateGridFromScans, all scans in one call",
        install="nodejs",
        warm_up=1.0,
    ),
    Contestant(
        "web-plain",
        "JavaScript port, plain, warm",
        "port",
        _node("web/port_driver.mjs", "plain"),
        2e7,
        "updateGridFromScan, scan after scan",
        install="nodejs",
        warm_up=1.0,
    ),
    Contestant(
        "python",
        "NumPy port, whole log",
        "port",
        _python("python/port_driver.py", "log"),
        4e7,
        "update_grid_from_scans, all scans in one call",
    ),
    Contestant(
        "python-scan",
        "NumPy port, per scan",
        "port",
        _python("python/port_driver.py", "scan"),
        1.2e7,
        "update_grid_from_scans, scan after scan",
    ),
    Contestant(
        "python-plain",
        "NumPy port, plain",
        "port",
        _python("python/port_driver.py", "plain"),
        1.2e6,
        "update_grid_from_scan, scan after scan",
    ),
    Contestant(
        "octave",
        "Octave port, whole log",
        "port",
        _octave("matlab/port_driver.m", "log"),
        1e7,
        "update_grid_from_scans, batches of 8192 beams, as the port maps a log",
        install="octave",
    ),
    Contestant(
        "octave-scan",
        "Octave port, per scan",
        "port",
        _octave("matlab/port_driver.m", "scan"),
        2e6,
        "update_grid_from_scans, scan after scan",
        install="octave",
    ),
    Contestant(
        "octave-plain",
        "Octave port, plain",
        "port",
        _octave("matlab/port_driver.m", "plain"),
        1.2e5,
        "update_grid_from_scan, scan after scan",
        install="octave",
    ),
    Contestant(
        "woxi",
        "Wolfram port on woxi",
        "port",
        (
            WOXI,
            "run",
            str(BENCH / "mathematica" / "port_driver.wls"),
            "{work}",
            "{log_odds}",
        ),
        1e5,
        "UpdateGridFromScans, all scans in one call, each time in a new process",
        install="woxi==0.3.0 (pip)",
        one_shot=True,
    ),
    Contestant(
        "lesson-java",
        "lesson's algorithm, Java, warm",
        "lesson",
        (*JAVA, "LessonDriver", "{work}"),
        5e7,
        "a list of arrays per beam",
        install="openjdk-17-jdk-headless",
        check="count",
        warm_up=2.0,
    ),
    Contestant(
        "lesson-web",
        "lesson's algorithm, JavaScript, warm",
        "lesson",
        _node("baseline/web/lesson_driver.mjs"),
        3e7,
        "a list of arrays per beam",
        install="nodejs",
        check="count",
        warm_up=1.0,
    ),
    Contestant(
        "lesson-python",
        "lesson's algorithm, Python",
        "lesson",
        _python("baseline/python/lesson_driver.py"),
        2e6,
        "a list of tuples per beam, a NumPy array indexed cell by cell",
        check="count",
    ),
    Contestant(
        "lesson-octave",
        "lesson's algorithm, Octave",
        "lesson",
        _octave("baseline/matlab/lesson_driver.m"),
        1.2e5,
        "a matrix grown by one row for each cell of a beam",
        install="octave",
        check="count",
    ),
    Contestant(
        "floor-list",
        "floor: list of updates",
        "floor",
        _program("floor", "list"),
        1e9,
        "cells and increments known beforehand: read, add, clamp, store",
    ),
    Contestant(
        "floor-ends",
        "floor: beams' ends",
        "floor",
        _program("floor", "ends"),
        2e9,
        "sin and cos by portable_math, floor",
        check="none",
    ),
    Contestant(
        "mrpt",
        "MRPT, COccupancyGridMap2D",
        "peer",
        _program("mrpt"),
        3e8,
        "insertObservation. Cells of 8 bits, float ranges; its line steps in fixed point and is not Bresenham's; "
        "its grid grows to hold every beam",
        install="libmrpt-maps-dev",
        check="none",
    ),
    Contestant(
        "octomap-rays",
        "OctoMap, insertRay",
        "peer",
        _program("octomap_peer", "rays"),
        7e6,
        "beam by beam. A sparse tree of float cells; other traversal, 3D",
        install="liboctomap-dev",
        check="none",
    ),
    Contestant(
        "octomap",
        "OctoMap, insertPointCloud",
        "peer",
        _program("octomap_peer", "cloud"),
        7e6,
        "scan by scan: a cell once per scan, however many beams cross it, so fewer updates. A sparse tree of float "
        "cells; other traversal, 3D",
        install="liboctomap-dev",
        check="none",
    ),
]
