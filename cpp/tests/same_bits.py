#!/usr/bin/env python3
"""The same bits on other machines.

Builds the port with Debian's cross compilers (static, with all warnings as errors), runs it under qemu on
scenarios/*.log, noise-free and with noise, plain, fast and on two threads, and compares the log-odds' SHA-256 and the
pictures with scenarios/golden. Prints a table; ends with 1 where anything differs or cannot be built.

usage: same_bits.py [--install] [--only MACHINE]...
"""

from __future__ import annotations

import argparse
import hashlib
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from building import PORT, include_flags, run, unity

SCENARIOS = PORT.parent / "scenarios"
MODES = {"noise-free": ["--noise-free"], "seed-0": ["--seed", "0"]}
PATHS = {"plain": ["--plain"], "fast": [], "2 threads": ["--threads", "2"]}
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion"]


@dataclass(frozen=True)
class Machine:
    """Debian's name, the compiler and its package, qemu's name."""

    name: str
    compiler: str
    package: str
    qemu: str
    flags: tuple[str, ...] = ()
    note: str = ""


MACHINES = [
    Machine("amd64", "g++", "g++", "", note="this machine"),
    Machine(
        "arm64", "aarch64-linux-gnu-g++", "g++-aarch64-linux-gnu", "aarch64"
    ),
    Machine(
        "riscv64", "riscv64-linux-gnu-g++", "g++-riscv64-linux-gnu", "riscv64"
    ),
    Machine(
        "s390x",
        "s390x-linux-gnu-g++",
        "g++-s390x-linux-gnu",
        "s390x",
        note="big-endian",
    ),
    Machine(
        "ppc64el",
        "powerpc64le-linux-gnu-g++",
        "g++-powerpc64le-linux-gnu",
        "ppc64le",
    ),
    Machine(
        "armhf",
        "arm-linux-gnueabihf-g++",
        "g++-arm-linux-gnueabihf",
        "arm",
        note="32 bits",
    ),
    Machine(
        "i386",
        "i686-linux-gnu-g++",
        "g++-i686-linux-gnu",
        "i386",
        ("-msse2", "-mfpmath=sse"),
        note="32 bits",
    ),
]


def install(machines: list[Machine]) -> None:
    packages = [one.package for one in machines if one.package]
    env = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for command in (
        ["update"],
        ["install", "-y", "--no-install-recommends", "qemu-user", *packages],
    ):
        subprocess.run(["apt-get", "-q", *command], env=env, check=True)


def sha256_of(log_odds: Path) -> str:
    """Of the doubles in little-endian order, as in scenarios/golden."""
    digest = hashlib.sha256()
    with log_odds.open() as lines:
        next(lines)
        for line in lines:
            row = [float(text) for text in line.split()]
            digest.update(struct.pack(f"<{len(row)}d", *row))
    return digest.hexdigest()


def differences(out: Path, mode: str, scenarios: list[Path]) -> list[str]:
    """The scenarios whose map is not the golden one."""
    found = []
    for scenario in scenarios:
        golden = SCENARIOS / "golden" / f"{scenario.stem}.{mode}"
        hashes = Path(f"{golden}.sha256").read_text().split()
        picture = Path(f"{golden}.pgm").read_bytes()
        if (
            sha256_of(out / f"{scenario.stem}.logodds") != hashes[-1]
            or (out / f"{scenario.stem}.pgm").read_bytes() != picture
        ):
            found.append(f"{scenario.stem} {mode}")
    return found


def check(machine: Machine, folder: Path) -> tuple[bool, str]:
    """Whether all is well, and a word about it."""
    for command in (machine.compiler, f"qemu-{machine.qemu}"):
        if command != "qemu-" and shutil.which(command) is None:
            return False, f"no {command}: --install"
    program = folder / "occgrid"
    start = time.perf_counter()
    status, text = run(
        [
            machine.compiler,
            "-O2",
            "-static",
            "-ffp-contract=off",
            *machine.flags,
            *WARNINGS,
            "-Werror",
            *include_flags(),
            unity(folder),
            "-o",
            program,
        ]
    )
    if status != 0:
        return False, f"cannot be built: {text[-1500:]}"
    built = time.perf_counter() - start
    scenarios = sorted(SCENARIOS.glob("*.log"))
    wrong, maps = [], 0
    prefix = [f"qemu-{machine.qemu}"] if machine.qemu else []
    start = time.perf_counter()
    for mode, mode_words in MODES.items():
        for path, path_words in PATHS.items():
            out = folder / mode / path
            status, text = run(
                [
                    *prefix,
                    program,
                    *mode_words,
                    *path_words,
                    "--out",
                    out,
                    *scenarios,
                ]
            )
            if status != 0:
                return False, f"ended with {status}: {text[-500:]}"
            wrong += [
                f"{one} {path}" for one in differences(out, mode, scenarios)
            ]
            maps += len(scenarios)
    ran = time.perf_counter() - start
    word = f"{maps - len(wrong)} of {maps} maps identical"
    seconds = f"built in {built:.0f} s, ran in {ran:.0f} s"
    return not wrong, ", ".join([word, *wrong, seconds])


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--only", action="append", metavar="MACHINE")
    options = parser.parse_args()
    machines = [m for m in MACHINES if m.name in (options.only or [m.name])]
    if not machines:
        parser.error("no such machine")
    if options.install:
        install(machines)
    all_well = True
    for machine in machines:
        with tempfile.TemporaryDirectory() as temporary:
            well, word = check(machine, Path(temporary))
        all_well = all_well and well
        mark = "ok    " if well else "FAILED"
        print(
            f"{mark}  {machine.name:8} {machine.note:12}  {word}", flush=True
        )
    sys.exit(0 if all_well else 1)


if __name__ == "__main__":
    main()
