"""class.toml: what the instructor decides about a class."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import msgspec

from occgrid_parity.formats.toml_records import (
    Count,
    Positive,
    SettingsError,
    Table,
    read_record,
)
from occgrid_parity.processes.wall import Sandbox

RULES = "class.toml"
STUDENTS_KEYS = ("name", "run", "build", "timeout", "needs", "build_timeout")
"""What a port.toml of a class may say."""

Seed = Annotated[int, msgspec.Meta(ge=0, le=2**32 - 1)]
Command = Annotated[list[str], msgspec.Meta(min_length=1)]


class RulesError(SettingsError):
    """A class.toml that cannot be used; the text names the file and the key."""


class ProgramRules(Table, frozen=True):
    """How a submission is built and run.

    ``run`` and ``build`` hold for all and go before what a student says. ``allow`` are the keys that a student's
    port.toml may have; by default all that the instructor does not give. ``readable`` are folders that programs see
    behind the wall beside the system's, ``environment`` what is in their environment.
    """

    run: Command | None = None
    build: list[Command] | None = None
    allow: list[str] | None = None
    readable: tuple[str, ...] = ()
    environment: dict[str, str] = msgspec.field(default_factory=dict)

    @property
    def allowed(self) -> tuple[str, ...]:
        """The keys of a port.toml that count."""
        if self.allow is not None:
            return tuple(self.allow)
        given = ("run",) * (self.run is not None) + ("build",) * (
            self.build is not None or self.run is not None
        )
        return tuple(key for key in STUDENTS_KEYS if key not in given)


class LimitRules(Table, frozen=True):
    """What one run may use, one build, and one submission. None: the command line's."""

    seconds: Positive | None = None
    build_seconds: Positive | None = None
    output_mib: Count | None = None
    memory_mib: Count | None = None
    processes: Count | None = None
    submission_mib: Count = 64


class CheckRules(Table, frozen=True):
    """What is mapped beside the levels of the suite.

    ``scenarios`` are files of the instructor, from the folder of class.toml on; ``hidden`` are such files of which a
    student is told only whether they are right. ``seeds`` are for noise on the suite's scenarios. Without ``suite``
    only these count.
    """

    suite: bool = True
    scenarios: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()
    seeds: tuple[Seed, ...] = ()
    explain: bool = True


class Rules(Table, frozen=True):
    """A whole class.toml.

    ``assignment`` is its name in a gradebook. ``points`` are those of a level, by its name; without the table each
    gives one.
    """

    assignment: str = "Occupancy grid mapping"
    sandbox: Sandbox | None = None
    program: ProgramRules = ProgramRules()
    limits: LimitRules = LimitRules()
    check: CheckRules = CheckRules()
    points: dict[str, float] = msgspec.field(default_factory=dict)

    def points_of(self, level: str) -> float:
        """What a level is worth."""
        return self.points.get(level, 0.0) if self.points else 1.0


NO_RULES = Rules()


def read_rules(path: Path) -> Rules:
    """The rules in a file. Raises RulesError where it cannot be used."""
    rules = read_record(path, Rules, RulesError)
    for level, points in rules.points.items():
        if not points >= 0:
            raise RulesError(f"{path}: points.{level}: expected a number >= 0")
    unknown = sorted(set(rules.program.allow or ()) - set(STUDENTS_KEYS))
    if unknown:
        raise RulesError(
            f"{path}: program.allow: {', '.join(unknown)} is not a key of port.toml ({', '.join(STUDENTS_KEYS)})"
        )
    for key, files in (
        ("scenarios", rules.check.scenarios),
        ("hidden", rules.check.hidden),
    ):
        for file in files:
            if not (path.parent / file).is_file():
                raise RulesError(
                    f"{path}: check.{key}: there is no file {file}"
                )
    for place in rules.program.readable:
        if not Path(place).is_absolute() or not Path(place).exists():
            raise RulesError(
                f"{path}: program.readable: {place} must be the full path of a folder that is there"
            )
    if not rules.check.suite and not (
        rules.check.scenarios or rules.check.hidden
    ):
        raise RulesError(
            f"{path}: check.suite: without it there must be check.scenarios or check.hidden"
        )
    return rules
