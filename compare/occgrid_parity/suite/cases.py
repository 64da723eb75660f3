"""The scenarios that programs are checked with, in the repository or in the installed package."""

from __future__ import annotations

import functools
import hashlib
from dataclasses import dataclass, field
from pathlib import Path

from occgrid_parity.suite.repository import find_root

LESSON = "lesson"
TWIN = "lesson-offset"
LAST_BITS = frozenset({"corners", "noise-corners"})
"""Scenarios that hang on the last bits of sin, cos and log: for ports, which owe these bits, and not for a check."""
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
