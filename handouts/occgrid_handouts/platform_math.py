"""Runs the programs of handouts/platform_math: each language's own sin, cos, exp and log."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid_handouts.machine import time_limit

Array = npt.NDArray[np.float64]

FUNCTIONS = ("sin", "cos", "exp", "log")
# for one library, on an idle desktop computer
SECONDS = 30


@dataclass(frozen=True)
class Platform:
    """A mathematics library that a program of the folder lays open.

    ``commands`` are run in turn, with {folder} the program's folder and {work} its own; ``needs`` are the commands that
    must be there, any of those between bars, and ``install`` says what brings them.
    """

    id: str
    name: str
    commands: tuple[tuple[str, ...], ...]
    needs: tuple[str, ...] = ()
    install: str = ""


def search_path() -> str:
    """PATH, and the folder of this Python before it, where pip puts woxi."""
    beside = str(Path(sys.executable).parent)
    return os.pathsep.join([beside, os.environ.get("PATH", os.defpath)])


def wolfram_command() -> list[str]:
    """How to run a script: on a Wolfram kernel where there is one, else on woxi."""
    kernel = shutil.which("wolframscript", path=search_path())
    if kernel:
        return [kernel, "-file"]
    return [shutil.which("woxi", path=search_path()) or "woxi", "run"]


ON_WOXI = wolfram_command()[-1] == "run"

PLATFORMS = (
    Platform(
        "python",
        "Python math",
        ((sys.executable, "{folder}/platform_math.py", "{work}"),),
    ),
    Platform(
        "numpy",
        "NumPy",
        ((sys.executable, "{folder}/platform_math_numpy.py", "{work}"),),
    ),
    Platform(
        "cpp",
        "C++ std",
        (
            ("g++", "-O2", "{folder}/platform_math.cpp", "-o", "{work}/own"),
            ("{work}/own", "{work}"),
        ),
        ("g++",),
        "g++",
    ),
    Platform(
        "java",
        "Java Math",
        (
            ("javac", "-d", "{work}", "{folder}/PlatformMath.java"),
            ("java", "-cp", "{work}", "PlatformMath", "{work}"),
        ),
        ("javac", "java"),
        "openjdk-17-jdk-headless",
    ),
    Platform(
        "strict",
        "Java StrictMath",
        (
            ("javac", "-d", "{work}", "{folder}/PlatformMath.java"),
            ("java", "-cp", "{work}", "PlatformMath", "{work}", "strict"),
        ),
        ("javac", "java"),
        "openjdk-17-jdk-headless",
    ),
    Platform(
        "octave",
        "GNU Octave",
        (("octave-cli", "--norc", "-q", "{folder}/platform_math.m"),),
        ("octave-cli",),
        "octave",
    ),
    Platform(
        "wolfram",
        "Wolfram (woxi)" if ON_WOXI else "Wolfram (kernel)",
        (("{wolfram}", "{folder}/platform_math.wls"),),
        ("wolframscript|woxi",),
        "woxi (pip) or a Wolfram kernel",
    ),
)


@dataclass(frozen=True)
class Measured:
    """What one library gave: results by function, or why there are none."""

    platform: Platform
    results: Mapping[str, Array]
    problem: str = ""


def measure(
    programs: Path,
    work: Path,
    arguments: Mapping[str, Array],
    jobs: int = 2,
    platforms: Sequence[Platform] = PLATFORMS,
) -> list[Measured]:
    """The platforms' results for arguments (n,) by function name."""

    def one(platform: Platform) -> Measured:
        folder = work / platform.id
        folder.mkdir(parents=True)
        for function in FUNCTIONS:
            text = "".join(f"{x!r}\n" for x in arguments[function].tolist())
            (folder / f"{function}.txt").write_text(text, encoding="ascii")
        return _run(platform, programs, folder, arguments)

    with ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(one, platforms))


def missing(platform: Platform) -> str:
    """``not measured: install ...`` where a command is missing, else nothing."""
    for need in platform.needs:
        if not any(
            shutil.which(c, path=search_path()) for c in need.split("|")
        ):
            return f"not measured: install {platform.install}"
    return ""


def _run(
    platform: Platform,
    programs: Path,
    work: Path,
    arguments: Mapping[str, Array],
) -> Measured:
    problem = missing(platform)
    if problem:
        return Measured(platform, {}, problem)
    environment = {
        **os.environ,
        "PATH": search_path(),
        "PLATFORM_MATH": str(work),
    }
    for template in platform.commands:
        command = [
            part.replace("{folder}", str(programs)).replace(
                "{work}", str(work)
            )
            for part in template
        ]
        if command[0] == "{wolfram}":
            command[:1] = wolfram_command()
        try:
            done = subprocess.run(
                command,
                cwd=work,
                env=environment,
                capture_output=True,
                text=True,
                timeout=time_limit(SECONDS),
            )
        except subprocess.TimeoutExpired as error:
            return Measured(
                platform, {}, f"not measured: took over {error.timeout:.0f} s"
            )
        if done.returncode != 0:
            last = (done.stderr.strip() or done.stdout.strip()).splitlines()
            said = last[-1] if last else f"status {done.returncode}"
            return Measured(platform, {}, f"not measured: {said}")
    results = {}
    for function in FUNCTIONS:
        texts = (work / f"{function}.out").read_text().split()
        if len(texts) != arguments[function].size:
            return Measured(
                platform,
                {},
                f"not measured: {len(texts)} results of {function}, not "
                f"{arguments[function].size}",
            )
        results[function] = np.array(list(map(float, texts)))
    return Measured(platform, results)
