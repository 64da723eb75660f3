"""class.toml: what the instructor decides about a class."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Annotated

import msgspec

from occgrid_parity.processes.wall import Sandbox

RULES = "class.toml"
STUDENTS_KEYS = ("name", "run", "build", "timeout", "needs", "build_timeout")
"""What a port.toml of a class may say."""

WORDS = {
    "float": "a number",
    "int": "a whole number",
    "str": "a text",
    "bool": "true or false",
    "array": "a list",
    "object": "a table",
    "null": "nothing",
}
"""What msgspec calls the kinds of values, and what a reader of the file calls them."""

Positive = Annotated[float, msgspec.Meta(gt=0)]
Count = Annotated[int, msgspec.Meta(ge=1)]
Seed = Annotated[int, msgspec.Meta(ge=0, le=2**32 - 1)]
Command = Annotated[list[str], msgspec.Meta(min_length=1)]


class RulesError(ValueError):
    """A class.toml that cannot be used; the text names the file and the key."""


class Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of class.toml. A key that it does not have is an error."""


class ProgramRules(Part, frozen=True):
    """How a submission is built and run.

    ``run`` and ``build`` hold for all and go before what a student says. ``allow`` are the keys that a student's
    port.toml may have; by default all that the instructor does not give. ``readable`` are folders that programs see
    behind the wall beside the system's, ``environment`` what is in their environment.
    """

    run: Command | None = None
    build: list[Command] | None = None
    allow: list[str] | None = None
    readable: list[str] = []
    environment: dict[str, str] = {}

    @property
    def allowed(self) -> tuple[str, ...]:
        """The keys of a port.toml that count."""
        if self.allow is not None:
            return tuple(self.allow)
        given = ("run",) * (self.run is not None) + ("build",) * (
            self.build is not None or self.run is not None
        )
        return tuple(key for key in STUDENTS_KEYS if key not in given)


class LimitRules(Part, frozen=True):
    """What one run may use, one build, and one submission. None: the command line's."""

    seconds: Positive | None = None
    build_seconds: Positive | None = None
    output_mib: Count | None = None
    memory_mib: Count | None = None
    processes: Count | None = None
    submission_mib: Count = 64


class CheckRules(Part, frozen=True):
    """What is mapped beside the levels of the suite.

    ``scenarios`` are files of the instructor, from the folder of class.toml on; ``hidden`` are such files of which a
    student is told only whether they are right. ``seeds`` are for noise on the suite's scenarios. Without ``suite``
    only these count.
    """

    suite: bool = True
    scenarios: list[str] = []
    hidden: list[str] = []
    seeds: list[Seed] = []
    explain: bool = True


class Rules(Part, frozen=True):
    """A whole class.toml.

    ``assignment`` is its name in a gradebook. ``points`` are those of a level, by its name; without the table each
    gives one.
    """

    assignment: str = "Occupancy grid mapping"
    sandbox: Sandbox | None = None
    program: ProgramRules = ProgramRules()
    limits: LimitRules = LimitRules()
    check: CheckRules = CheckRules()
    points: dict[str, float] = {}

    def points_of(self, level: str) -> float:
        """What a level is worth."""
        return self.points.get(level, 0.0) if self.points else 1.0


NO_RULES = Rules()


def read_rules(path: Path) -> Rules:
    """The rules in a file. Raises RulesError where it cannot be used."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise RulesError(f"{path}: {error.strerror}") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise RulesError(f"{path}: {error}") from error
    try:
        rules = msgspec.convert(table, Rules)
    except msgspec.ValidationError as error:
        raise RulesError(f"{path}: {_plain(str(error))}") from error
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


def _plain(said: str) -> str:
    """An error of msgspec with the key first."""
    match = re.fullmatch(r"(.*?) - at `(?:key in )?\$\.?(.*)`", said)
    if match is None:
        unknown = re.fullmatch(
            r"Object contains unknown field `(.*)`( - at `\$`)?", said
        )
        return f"unknown key {unknown[1]}" if unknown else said
    what, key = match.groups()
    unknown = re.fullmatch(r"Object contains unknown field `(.*)`", what)
    if unknown:
        key = f"{key}." if key else ""
        return f"unknown key {key}{unknown[1]}"
    for word, plain in WORDS.items():
        what = re.sub(rf"`{word}( \| null)?`", plain, what)
    return f"{key}: {what[0].lower()}{what[1:]}"
