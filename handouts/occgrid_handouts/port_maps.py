"""The contract's result: the lesson as every port maps it, held against the Python port, bit for bit."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.fast import map_scenario_fast
from occgrid.scenario import read_scenario
from occgrid_handouts.languages import Language
from occgrid_handouts.machine import time_limit
from occgrid_handouts.platform_math import search_path
from occgrid_handouts.snippets import source_files
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.finding import find_ports

Array = npt.NDArray[np.float64]

SCENARIO = "scenarios/lesson.log"
KEPT = "build/lesson-maps"
BUILT_BY = ("port.toml", "CMakeLists.txt", "pom.xml")
MODES: Mapping[str, tuple[tuple[str, ...], int | None]] = {
    "noise_free": (("--noise-free",), None),
    "seed_0": (("--seed", "0"), 0),
}


@dataclass(frozen=True)
class PortMaps:
    """Cells that differ by mode, or why it was not measured."""

    name: str
    differing: Mapping[str, int]
    problem: str = ""

    def facts(self) -> dict[str, object]:
        """As the text takes it."""
        return {"name": self.name, "problem": self.problem, **self.differing}


def run_ports(
    root: Path, languages: Sequence[Language], jobs: int = 2
) -> list[PortMaps]:
    """Maps the lesson with the ports of these languages, as they are built; or takes the maps of an earlier run.

    The maps are kept in build/lesson-maps, so that the next build need not wait for the slowest port again.
    """
    expected = {}
    for mode, (_, seed) in MODES.items():
        with read_scenario(root / SCENARIO) as scenario:
            expected[mode] = map_scenario_fast(scenario, seed).log_odds
    ports = {port.name: port for port in find_ports(root)}

    def one(task: tuple[Language, str]) -> int | str:
        """Cells that differ, or why it was not measured."""
        language, mode = task
        port = ports.get(language.id)
        if port is None:
            return "no port"
        if port.skip_reason:
            return port.skip_reason
        file = earlier_map(root, language, mode)
        if file is None:
            folder = root / KEPT / language.id / mode
            problem = _run(port, root, folder, MODES[mode][0])
            if problem:
                return problem
            file = folder / "lesson.logodds"
        return count_differing(read_log_odds(file), expected[mode])

    # the last language is the slowest one: its modes side by side, first
    tasks = [(one, mode) for one in reversed(languages) for mode in MODES]
    with ThreadPoolExecutor(jobs) as pool:
        found = dict(zip(tasks, pool.map(one, tasks), strict=True))
    return [
        _port_maps(language, {mode: found[language, mode] for mode in MODES})
        for language in languages
    ]


def _port_maps(language: Language, found: Mapping[str, int | str]) -> PortMaps:
    problems = [said for said in found.values() if isinstance(said, str)]
    if problems:
        return PortMaps(language.name, {}, f"not measured: {problems[0]}")
    counts = {m: n for m, n in found.items() if isinstance(n, int)}
    return PortMaps(language.name, counts)


def earlier_map(root: Path, language: Language, mode: str) -> Path | None:
    """The map that an earlier build or ``occgrid-parity run`` left, if it is newer than what the port is made of."""
    of_run = root / "build/parity" / language.id / mode.replace("_", "-")
    inputs = [root / SCENARIO]
    inputs += [root / language.folder / name for name in BUILT_BY]
    inputs += source_files(root, language)
    newest = max(file.stat().st_mtime for file in inputs if file.is_file())
    for folder in (root / KEPT / language.id / mode, of_run):
        for file in sorted(folder.glob("**/lesson.logodds")):
            if file.stat().st_mtime > newest:
                return file
    return None


def read_log_odds(path: Path) -> Array:
    """The log-odds of a map, (height, width)."""
    with path.open(encoding="ascii") as file:
        _, _, width, height = file.readline().split()
        values = np.array(file.read().split(), dtype=np.float64)
    return values.reshape(int(height), int(width))


def count_differing(found: Array, expected: Array) -> int:
    """Cells that differ in some bit; all of them where the sizes differ."""
    if found.shape != expected.shape:
        return int(expected.size)
    return int((found.view(np.int64) != expected.view(np.int64)).sum())


def _run(port: Port, root: Path, folder: Path, words: Sequence[str]) -> str:
    """Runs a port on the lesson; says what went wrong, or nothing."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scenario = str(root / SCENARIO)
    # the Python port need not be installed
    python = [str(root / "python"), os.environ.get("PYTHONPATH", "")]
    environment = {
        **os.environ,
        "PATH": search_path(),
        "PYTHONPATH": os.pathsep.join(filter(None, python)),
    }
    command = port.command(
        port.run,
        mode=list(words),
        out=folder,
        scenario=[scenario],
        scenarios=[scenario],
    )
    try:
        done = subprocess.run(
            command,
            cwd=folder,
            env=environment,
            capture_output=True,
            text=True,
            timeout=time_limit(port.timeout),
        )
    except OSError:
        return f"occgrid-parity build {port.name}"
    except subprocess.TimeoutExpired as error:
        return f"took over {error.timeout:.0f} s"
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        return lines[-1] if lines else f"status {done.returncode}"
    return ""
