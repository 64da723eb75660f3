"""What the reader gives for each scenario. A change of the reader that gives the same cannot alter its map."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from occgrid_mutants.calls import Bits, bits
from occgrid_mutants.sites import Site
from occgrid_mutants.trials import BUILT_IN

MODULE = "scenario"
# Elsewhere: what only the reader's result runs.
FUNCTIONS = ("grid.OccupancyGrid.__init__", "grid.GridSpec")


def tells(site: Site) -> bool:
    """Whether what is read tells all that a change can alter."""
    return (
        site.module == MODULE or f"{site.module}.{site.function}" in FUNCTIONS
    )


class Readings:
    """Name, settings, empty map, walls and scans of every scenario file, and of the built-in one."""

    def __init__(
        self, files: list[Path], modules: Mapping[str, ModuleType]
    ) -> None:
        self._files = files
        self._given = {
            place: self._read(place, modules) for place in self._places()
        }

    def differing(self, modules: Mapping[str, ModuleType]) -> set[str]:
        """The scenarios that a changed port reads otherwise, by the names of their files, and BUILT_IN."""
        found = set()
        for place, given in self._given.items():
            try:
                same = self._read(place, modules) == given
            except Exception:
                same = False
            if not same:
                found.add(_stem(place))
        return found

    def _places(self) -> list[Path | None]:
        return [*self._files, None]

    def _read(
        self, place: Path | None, modules: Mapping[str, ModuleType]
    ) -> Bits:
        if place is None:
            opened = modules["lesson"].lesson_scenario()
        else:
            opened = modules[MODULE].read_scenario(place)
        with opened as scenario:
            return _content(scenario)


def _stem(place: Path | None) -> str:
    return BUILT_IN if place is None else place.stem


def _content(scenario: Any) -> Bits:
    grid = scenario.settings.new_grid()
    return (
        scenario.name,
        bits(scenario.settings),
        *(bits(value) for _, value in sorted(vars(grid).items())),
        bits(scenario.walls),
        bits(list(scenario.scans)),
    )
