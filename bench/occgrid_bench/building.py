"""Builds what is measured: the ports, and the benchmark's own programs in C++ and Java."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from occgrid_bench.folders import BENCH, CLASSES, OUT, ROOT

JAVA_PORT = ROOT / "java" / "target" / "classes"


class BuildError(Exception):
    """Something could not be built; its text says what was said."""


def build(ports: bool) -> None:
    """Build everything that the installed tools can; the ports, too, if asked for."""
    if shutil.which("cmake"):
        target = str(OUT / "cpp")
        _run(["cmake", "-S", str(BENCH), "-B", target])
        _run(["cmake", "--build", target, "--parallel", "2"])
        if ports:
            port = str(ROOT / "cpp")
            _run(["cmake", "-S", port, "-B", f"{port}/build"])
            _run(["cmake", "--build", f"{port}/build", "--parallel", "2"])
    if shutil.which("javac"):
        if ports or not JAVA_PORT.is_dir():
            pom = str(ROOT / "java" / "pom.xml")
            maven = ["mvn", "-q", "-B", "-ntp", "-f", pom, "-DskipTests"]
            _run([*maven, "package"])
        CLASSES.mkdir(parents=True, exist_ok=True)
        sources = [
            *sorted((BENCH / "java").glob("*.java")),
            *sorted((BENCH / "baseline" / "java").glob("*.java")),
        ]
        _run(["javac", "-cp", JAVA_PORT, "-d", CLASSES, *sources])


def _run(command: Sequence[str | Path]) -> None:
    words = list(map(str, command))
    done = subprocess.run(
        words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if done.returncode != 0:
        raise BuildError(f"{' '.join(words)}\n{done.stdout}")
