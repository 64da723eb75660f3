"""The machine and its tools, by name."""

from __future__ import annotations

import os
import platform
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np

from occgrid_bench.contestants import WOXI


def machine() -> dict[str, str]:
    """What a figure needs beside it to mean something."""
    cpu = re.search(r"model name\s*:\s*(.*)", _read("/proc/cpuinfo"))
    memory = re.search(r"MemTotal:\s*(\d+)", _read("/proc/meminfo"))
    system = re.search(r'PRETTY_NAME="(.*)"', _read("/etc/os-release"))
    named = {
        "processor": cpu[1] if cpu else platform.processor(),
        "cores": str(os.cpu_count()),
        "memory": f"{int(memory[1]) / 2**20:.0f} GiB" if memory else "",
        "system": system[1] if system else platform.system(),
        "kernel": platform.release(),
        "C++": _said("c++", "--version"),
        "Java": _said("java", "-version"),
        "Python": f"{sys.version.split()[0]}, NumPy {np.__version__}",
        "Node.js": _said("node", "--version"),
        "Octave": _said("octave-cli", "--version"),
        "woxi": _said(WOXI, "--version"),
        "MRPT": _package("libmrpt-maps-dev"),
        "OctoMap": _package("liboctomap-dev"),
    }
    return {name: value for name, value in named.items() if value}


def _read(path: str) -> str:
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError:
        return ""


@cache
def _said(*command: str) -> str:
    """The first line that a program says of itself."""
    if shutil.which(command[0]) is None:
        return ""
    done = subprocess.run(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return next(iter(done.stdout.splitlines()), "")


@cache
def _package(name: str) -> str:
    """The version of a Debian package that is installed."""
    said = _said("dpkg-query", "-W", "-f", "${Version}", name)
    return "" if "no packages" in said else said
