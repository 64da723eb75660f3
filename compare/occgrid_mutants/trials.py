"""What a changed port is put to: scenarios with golden results, then vectors and bad input."""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import numpy as np

Modules = dict[str, ModuleType]

# The plain program takes seconds for these: of each it maps the first scans, without noise.
LARGE = {"lesson": 3, "lesson-offset": 3, "many-beams": 1}
# The results of a table of vectors are its last columns: one, or so many.
RESULTS = {
    "beam_endpoints": 2,
    "clip_ray": 2,
    "philox": 4,
    "read_ranges": 3,
    "world_to_grid": 2,
}
MODES = (("noise-free", None), ("seed-0", 0))
# The lesson that needs no file, where a trial names its scenario.
BUILT_IN = "built in"


@dataclass(frozen=True)
class Trial:
    """``right`` says whether a port does right; what it raises counts as wrong.

    ``scenario`` is the name of the file that is mapped, BUILT_IN, or empty. ``from_scans`` answers the same of a port
    in which only module fast is changed: it need not read and simulate the scans again.
    """

    name: str
    right: Callable[[Modules], bool] = field(repr=False)
    scenario: str = ""
    from_scans: Callable[[Modules], bool] | None = field(
        repr=False, default=None
    )


@dataclass(frozen=True)
class _Golden:
    scans: list[str]
    picture: bytes


def scenario_files(root: Path) -> list[Path]:
    """All scenarios, the shortest first."""
    return sorted(
        (root / "scenarios").glob("*.log"), key=lambda f: f.stat().st_size
    )


def scenario_trials(root: Path) -> list[Trial]:
    """Each scenario, without noise and with it, by the plain program and by the fast one; small ones first."""
    files = scenario_files(root)
    small = [f for f in files if f.stem not in LARGE]
    large = [f for f in files if f.stem in LARGE]
    trials = []
    for file in [*small, *large]:
        for mode, seed in MODES:
            golden = _read_golden(root, file.stem, mode)
            most = LARGE.get(file.stem)
            if most is None or seed is None:
                trials.append(_plain(file, mode, seed, golden, most))
            trials.append(_fast(file, mode, seed, golden))
    golden = _read_golden(root, "lesson", "noise-free")
    trials.append(_built_in(golden))
    return trials


def unit_trials(root: Path) -> list[Trial]:
    """The shared vectors, function by function, and the files of bad input."""
    probe = compile(
        (root / "python/tests/probe.py").read_text("utf-8"), "probe", "exec"
    )
    trials = []
    for table in sorted((root / "scenarios/vectors").glob("*.csv")):
        trials.append(_vectors(table, probe))
    for line in (
        (root / "scenarios/bad/expected.txt").read_text("ascii").splitlines()
    ):
        name, number, reason = line.split(":", 2)
        trials.append(
            _bad(root / "scenarios/bad" / name, int(number), reason[1:])
        )
    return [*trials, _built_in_is_its_file(root / "scenarios/lesson.log")]


def _read_golden(root: Path, name: str, mode: str) -> _Golden:
    stem = root / "scenarios/golden" / f"{name}.{mode}"
    lines = Path(f"{stem}.sha256").read_text("ascii").splitlines()
    return _Golden(
        [line.split()[2] for line in lines], Path(f"{stem}.pgm").read_bytes()
    )


def _hash(log_odds: Any) -> str:
    return hashlib.sha256(
        np.ascontiguousarray(log_odds, dtype="<f8").tobytes()
    ).hexdigest()


def _is_golden(modules: Modules, grid: Any, golden: _Golden) -> bool:
    if _hash(grid.log_odds) != golden.scans[-1]:
        return False
    picture = "".join(modules["map_writer"].map_pgm(grid))
    return picture.encode() == golden.picture


class _Enough(Exception):
    """As many scans are mapped as are asked for."""


class _Differs(Exception):
    """The map after a scan is not the golden one."""


def _plain(
    file: Path, mode: str, seed: int | None, golden: _Golden, most: int | None
) -> Trial:
    """map_scenario, with a look at the map after every scan."""

    def right(modules: Modules) -> bool:
        mapper: Any = modules["mapper"]
        update = mapper.update_grid_from_scan
        expected = iter(golden.scans)
        seen = itertools.count(1)

        def watched(grid: Any, *args: Any, **kwargs: Any) -> Any:
            answer = update(grid, *args, **kwargs)
            if _hash(grid.log_odds) != next(expected, ""):
                raise _Differs
            if next(seen) == most:
                raise _Enough
            return answer

        mapper.update_grid_from_scan = watched
        try:
            with modules["scenario"].read_scenario(file) as scenario:
                grid = mapper.map_scenario(scenario, seed)
        except _Enough:
            return True
        except _Differs:
            return False
        finally:
            mapper.update_grid_from_scan = update
        return next(expected, None) is None and _is_golden(
            modules, grid, golden
        )

    return Trial(f"{file.stem}, {mode}, plain", right, file.stem)


def _fast(file: Path, mode: str, seed: int | None, golden: _Golden) -> Trial:
    kept: list[Any] = []  # the scenario and its scans, of the port as it is

    def right(modules: Modules) -> bool:
        with modules["scenario"].read_scenario(file) as scenario:
            if not kept:
                scans = modules["mapper"].simulated_scans(scenario, seed)
                kept.extend((scenario, list(scans)))
            grid = modules["fast"].map_scenario_fast(scenario, seed)
        return _is_golden(modules, grid, golden)

    def right_from_scans(modules: Modules) -> bool:
        fast: Any = modules["fast"]
        scenario, scans = kept

        def again(*asked: Any) -> Iterator[Any]:
            if asked != (scenario, seed):
                raise ValueError("other scans are asked for")
            return iter(scans)

        simulated = fast.simulated_scans
        fast.simulated_scans = again
        try:
            grid = fast.map_scenario_fast(scenario, seed)
        finally:
            fast.simulated_scans = simulated
        return _is_golden(modules, grid, golden)

    return Trial(f"{file.stem}, {mode}", right, file.stem, right_from_scans)


def _built_in(golden: _Golden) -> Trial:
    def right(modules: Modules) -> bool:
        with modules["lesson"].lesson_scenario() as scenario:
            grid = modules["fast"].map_scenario_fast(scenario, None)
            return scenario.name == "lesson" and _is_golden(
                modules, grid, golden
            )

    return Trial("lesson (built in), noise-free", right, BUILT_IN)


def _built_in_is_its_file(file: Path) -> Trial:
    def right(modules: Modules) -> bool:
        built_in = modules["lesson"].lesson_scenario()
        with modules["scenario"].read_scenario(file) as scenario:
            return (
                bool(scenario.settings == built_in.settings)
                and scenario.walls == built_in.walls
                and list(scenario.scans) == built_in.scans
            )

    return Trial(
        "lesson numbers: the built-in ones are those of its file", right
    )


def _vectors(table: Path, probe: CodeType) -> Trial:
    lines = table.read_text("ascii").splitlines()
    rows = [line.split(",") for line in lines[1:]]
    function = table.stem
    results = RESULTS.get(function, 1)
    questions = [row[:-results] for row in rows]
    expected = [" ".join(row[-results:]) for row in rows]

    def right(modules: Modules) -> bool:
        room: dict[str, Any] = {"__name__": "probe"}
        exec(probe, room)
        return list(room["ANSWERS"][function](questions)) == expected

    return Trial(f"vectors of {function}", right)


def _bad(file: Path, line: int, reason: str) -> Trial:
    def right(modules: Modules) -> bool:
        scenario_module = modules["scenario"]
        try:
            with scenario_module.read_scenario(file) as scenario:
                for _ in scenario.scans:
                    pass
        except scenario_module.ScenarioError as error:
            return (error.line, error.reason) == (line, reason)
        return False

    return Trial(f"bad input {file.stem}", right)
