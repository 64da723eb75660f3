"""What is asked again: which answers count as the same, and that there is no other way to a map."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from occgrid_mutants import port_modules, readings
from occgrid_mutants.calls import FUNCTIONS, VALUES, WHOLE, Calls, bits
from occgrid_mutants.readings import Readings
from occgrid_mutants.sites import Site, sites
from occgrid_mutants.trials import scenario_files

ROOT = Path(__file__).resolve().parents[3]
TREES = {
    name: port_modules.parse(path)
    for name, path in port_modules.sources(ROOT).items()
}
ASKED = {"first": "log", "second": "sin", "third": "exp"}


@pytest.fixture
def modules() -> Iterator[dict[str, ModuleType]]:
    with port_modules.loaded(port_modules.compiled(ROOT)) as modules:
        yield modules


@pytest.fixture
def calls(modules: dict[str, ModuleType]) -> Calls:
    """Of three trials, each of which asks one function."""
    found = Calls()
    for trial, function in ASKED.items():
        with found.recorded(modules, trial):
            getattr(modules["portable_math"], function)(np.array([0.2, 0.7]))
    return found


def a_site(module: str, function: str) -> Site:
    return next(
        s for s in sites(module, TREES[module]) if s.function == function
    )


def differing(
    calls: Calls, function: str, modules: dict[str, ModuleType]
) -> set[str] | None:
    site = a_site("portable_math", function)
    return calls.differing(site, TREES["portable_math"], set(ASKED), modules)


def test_only_who_asked_can_differ(
    calls: Calls, modules: dict[str, ModuleType]
) -> None:
    module: Any = modules["portable_math"]
    for function in ("log", "exp", "S1", "_flat"):
        assert differing(calls, function, modules) == set()
    right = module.log

    def in_place(x: Any) -> Any:
        answer = right(x)
        x += 1.0
        return answer

    def in_its_argument(x: Any) -> Any:
        x[...] = right(x)
        return x

    for wrong in (
        lambda x: np.nextafter(right(x), 9.0),  # another bit
        lambda x: right(x).reshape(1, -1),  # another shape
        lambda x: right(x).no_such_thing,
        in_place,
        in_its_argument,
    ):
        module.log = wrong
        assert differing(calls, "log", modules) == {"first"}
        # it matters which function a constant is for
        assert differing(calls, "LG1", modules) == {"first"}
        assert differing(calls, "P1", modules) == set()
    module.log = right
    module.pi = np.nextafter(module.pi, 4.0)
    assert differing(calls, "P1", modules) is None


def test_other_functions_are_not_told_by_asking(
    calls: Calls, modules: dict[str, ModuleType]
) -> None:
    for module, function in (
        ("grid", "OccupancyGrid.update_cell"),
        ("sensor", "update_grid_from_scan"),
        ("fast", "clip_ray"),
    ):
        site = a_site(module, function)
        found = calls.differing(site, TREES[module], set(ASKED), modules)
        assert found is None


def test_no_map_hangs_on_anything_else_in_these_modules() -> None:
    """What the other modules take from one of WHOLE: the functions that are asked, VALUES, and types."""
    types = {"Array", "Mask", "Words", "Pose", "Segment"}
    taken: dict[str, set[str]] = {name: set() for name in WHOLE}
    for name, tree in TREES.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                place = node.module.removeprefix("occgrid.")
                if place in taken:
                    taken[place] |= {alias.name for alias in node.names}
            if (
                isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name)
                and node.value.id in taken
                and node.value.id != name
            ):
                taken[node.value.id].add(node.attr)
    for place, names in taken.items():
        known = {*FUNCTIONS[place], *VALUES.get(place, ()), *types}
        assert names <= known, place
        assert names - types, place


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (0.0, -0.0),
        (1.0, 1),
        (1, True),
        (np.float64(1.0), 1.0),
        (np.zeros(2), np.zeros((2, 1))),
        (np.zeros(99), -np.zeros(99)),
        ((1, 2), [1, 2]),
        (None, ""),
    ],
)
def test_values_that_are_not_the_same(one: object, other: object) -> None:
    assert bits(one) == bits(one)
    assert bits(one) != bits(other)


def test_a_scenario_that_is_read_otherwise_is_named(
    modules: dict[str, ModuleType],
) -> None:
    assert readings.tells(a_site("scenario", "ScenarioReader.flaser"))
    assert readings.tells(a_site("grid", "OccupancyGrid.__init__"))
    assert not readings.tells(a_site("grid", "OccupancyGrid.update_cell"))
    files = scenario_files(ROOT)
    known = Readings(files, modules)
    assert known.differing(modules) == set()
    scenario: Any = modules["scenario"]
    right = scenario.flaser_angles
    scenario.flaser_angles = lambda n: right(n) + 1e-9
    with_flaser = {
        file.stem for file in files if b"\nFLASER" in file.read_bytes()
    }
    assert known.differing(modules) == with_flaser
