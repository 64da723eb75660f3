"""The scenarios of a run: files, and the lesson that every port has built in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.formats.map_files import scenario_name

BUILT_IN_NAME = "lesson (built in)"
BUILT_IN_MAP = "lesson"
BUILT_IN_WORD = "built-in"


@dataclass(frozen=True)
class ScenarioFile:
    """One scenario: ``name`` in tables, ``map`` the NAME of its files.

    ``path`` is None for the lesson that is built in: a port maps it when it is given
    no scenario.
    """

    name: str
    map: str
    path: Path | None


BUILT_IN = ScenarioFile(BUILT_IN_NAME, BUILT_IN_MAP, None)


def scenario_from(path: Path) -> ScenarioFile:
    """The scenario in a file."""
    name = scenario_name(path.name)
    return ScenarioFile(name, name, path.resolve())


def scenario_files(root: Path) -> list[ScenarioFile]:
    """The scenarios of the repository, by name."""
    return [
        scenario_from(path)
        for path in sorted((root / "scenarios").glob("*.log"))
    ]


def choose_scenarios(root: Path, words: Sequence[str]) -> list[ScenarioFile]:
    """The scenarios that the words name: files, names in scenarios/ with or without .log, ``built-in``.

    Without words: the built-in lesson and all of scenarios/. Raises ValueError for a
    word that names none, and where two files make maps of the same name.
    """
    known = {scenario.name: scenario for scenario in scenario_files(root)}
    if not words:
        return [BUILT_IN, *known.values()]
    chosen: dict[str, ScenarioFile] = {}
    for word in words:
        if word in (BUILT_IN_NAME, BUILT_IN_WORD):
            scenario = BUILT_IN
        elif word.removesuffix(".log") in known and not Path(word).is_file():
            scenario = known[word.removesuffix(".log")]
        elif Path(word).is_file():
            scenario = scenario_from(Path(word))
        else:
            names = ", ".join([BUILT_IN_WORD, *known])
            raise ValueError(
                f"{word!r} is neither a file nor a scenario: {names}"
            )
        other = chosen.setdefault(scenario.name, scenario)
        if other != scenario:
            raise ValueError(
                f"{other.path} and {scenario.path} are both named {scenario.name}"
            )
    return list(chosen.values())


def count_scans(path: Path) -> int:
    """How many scans a scenario has: its POSE, FLASER and ROBOTLASER1 lines."""
    with path.open("rb") as file:
        return sum(
            line.split(None, 1)[:1]
            in ([b"POSE"], [b"FLASER"], [b"ROBOTLASER1"])
            for line in file
        )
