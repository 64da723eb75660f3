"""The level about the YAML beside the map, for programs that write one."""

from __future__ import annotations

import math
from collections.abc import Iterable

from occgrid.map_writer import map_yaml
from occgrid_parity.check.levels import YAML
from occgrid_parity.check.program_maps import ComparedMap
from occgrid_parity.check.verdict import Level
from occgrid_parity.model.worlds import world_of

NUMBERS = (
    "resolution",
    "origin",
    "negate",
    "occupied_thresh",
    "free_thresh",
)
HALF_DIGIT = 0.5000001e-9  # the contract writes nine decimals


def check_yaml(maps: Iterable[ComparedMap]) -> Level:
    """The level. It is not checked where no map has a YAML."""
    maps = list(maps)
    if not any(one.observed.yaml is not None for one in maps):
        return Level(*YAML, "not checked")
    for one in maps:
        problem = _problem(one)
        if problem:
            message = f"{one.case.name}, {one.mode.name}: {problem}"
            return Level(*YAML, "failed", "wrong YAML", message)
    return Level(*YAML, "passed")


def _problem(one: ComparedMap) -> str:
    """What is wrong with the YAML of a map; empty where nothing is."""
    if one.observed.yaml is None:
        return "this map has no YAML beside it, others do"
    found = _fields(one.observed.yaml)
    name = found.get("image", "").strip("\"'")
    grid = world_of(one.case).settings.new_grid()
    expected = _fields(map_yaml(grid, f"{one.case.name}.pgm"))
    if name.rsplit("/", 1)[-1] != one.observed.source:
        return f"image is {name or 'missing'}, expected {one.observed.source}"
    if found.get("mode", "trinary") != "trinary":
        return f"mode is {found['mode']}, expected trinary"
    for key in NUMBERS:
        if key not in found:
            return f"{key} is missing"
        if not _same(found[key], expected[key]):
            return f"{key} is {found[key]}, expected {expected[key]}"
    return ""


def _fields(text: str) -> dict[str, str]:
    """The keys and their texts."""
    found = {}
    for line in text.splitlines():
        key, colon, value = line.partition(":")
        if colon and not key.lstrip().startswith("#"):
            found[key.strip()] = value.split(" #")[0].strip()
    return found


def _same(found: str, expected: str) -> bool:
    """Whether two numbers, or lists of numbers, are the same to nine decimals."""
    try:
        one, other = _numbers(found), _numbers(expected)
    except ValueError:
        return False
    return len(one) == len(other) and all(
        math.isclose(a, b, rel_tol=0.0, abs_tol=HALF_DIGIT)
        for a, b in zip(one, other, strict=True)
    )


def _numbers(text: str) -> list[float]:
    return [float(word) for word in text.strip("[] ").split(",")]
