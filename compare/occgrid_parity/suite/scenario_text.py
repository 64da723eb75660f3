"""The scenarios that programs are checked with, in the repository or in the installed package."""

from __future__ import annotations

import functools
import hashlib
from dataclasses import dataclass, field
from pathlib import Path

from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario
from occgrid_parity.formats.log_odds import hash_log_odds
from occgrid_parity.suite.golden import read_golden
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.repository import find_root

LESSON = "lesson"
TWIN = "lesson-offset"
INSTALLED = Path(__file__).resolve().parents[1] / "scenarios"


@functools.cache
def scenario_folder() -> Path:
    """Where the scenarios lie: beside the installed package, else in the repository.

    Raises FileNotFoundError where there is neither.
    """
    if any(INSTALLED.glob("*.log")):
        return INSTALLED
    return find_root(INSTALLED.parent) / "scenarios"


@dataclass(frozen=True)
class Case:
    """A scenario as text. Without ``is_file`` it is the lesson that programs have built in."""

    name: str
    data: bytes = field(repr=False)
    is_file: bool = True

    @functools.cached_property
    def digest(self) -> str:
        """Tells scenarios apart, whatever their names."""
        return hashlib.sha256(self.data).hexdigest()


@functools.cache
def case(name: str) -> Case:
    """A scenario of the suite. Raises OSError where it is not there."""
    return Case(name, (scenario_folder() / f"{name}.log").read_bytes())


def built_in() -> Case:
    """The lesson, for a program that has only that."""
    return Case(LESSON, case(LESSON).data, is_file=False)


def case_from(path: Path) -> Case:
    """A scenario in any file. Raises OSError where it cannot be read."""
    return Case(path.stem, path.read_bytes())


def golden_problem(name: str, mode: Mode) -> str | None:
    """Why the reference on this machine is not the committed result; None where it is, or none is committed.

    The Python port is the reference of every check, so it is held to the results that came with it first.
    """
    folder = scenario_folder() / "golden"
    golden = read_golden(folder, name, mode)
    if golden is None:
        return None
    with read_scenario(scenario_folder() / f"{name}.log") as scenario:
        grid = map_scenario(scenario, mode.seed)
    if hash_log_odds(grid.log_odds) == golden.scans[-1]:
        return None
    return (
        f"the Python port's map of {name} ({mode.name}) is not the committed one: nothing can be checked on this "
        "machine"
    )
