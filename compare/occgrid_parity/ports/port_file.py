"""What a port.toml may say: the one of a port, and the one of a student's program, which needs no more than ``run``."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Annotated, TypeVar

import msgspec

from occgrid_parity.formats.toml_records import (
    Count,
    Positive,
    SettingsError,
    Table,
    Text,
    read_record,
)
from occgrid_parity.processes.process_group import search_path

DECLARATION = "port.toml"
DEFAULT_TIMEOUT = 60.0
BUILD_TIMEOUT = 900.0
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")
LIST_PLACEHOLDERS = ("mode", "scenario", "scenarios")
NO_COMMAND = re.compile(
    r": (?:run|build|version|probe)[][0-9]*(?:: expected| is missing)"
)

Command = Annotated[tuple[str, ...], msgspec.Meta(min_length=1)]
Alternatives = Text | Annotated[tuple[Text, ...], msgspec.Meta(min_length=1)]


class PortError(SettingsError):
    """A declaration that cannot be used; the text names the file and the key."""


class Need(Table, frozen=True):
    """``command``: what must be on the PATH, or several of which one must be; ``install``: the package that has it."""

    command: Alternatives
    install: Text

    def is_missing(self) -> bool:
        """Whether none of the commands is there."""
        names = self.command
        path = search_path()
        return all(
            shutil.which(name, path=path) is None
            for name in ((names,) if isinstance(names, str) else names)
        )


class NeedsFile(msgspec.Struct, frozen=True, kw_only=True):
    """What a port.toml needs, whatever else it says."""

    needs: tuple[Need, ...] = ()

    @property
    def missing(self) -> str:
        """The packages to install, between commas; empty where nothing is missing."""
        packages = [n.install for n in self.needs if n.is_missing()]
        return ", ".join(dict.fromkeys(packages))


class ProgramFile(NeedsFile, frozen=True, kw_only=True):
    """The port.toml of a student's program. Keys that it does not know do not count."""

    run: Command
    name: str = ""
    build: tuple[Command, ...] = ()
    probe: Command = ()
    timeout: Positive = DEFAULT_TIMEOUT
    build_timeout: Positive = BUILD_TIMEOUT

    def __post_init__(self) -> None:
        for key, command in self.commands():
            for word in command:
                for name in LIST_PLACEHOLDERS:
                    if "{" + name + "}" in word and word != f"{{{name}}}":
                        raise ValueError(
                            f"{key}: {{{name}}} must be an argument of its own"
                        )

    def commands(self) -> list[tuple[str, tuple[str, ...]]]:
        """Every command, with its key."""
        build = [("build", command) for command in self.build]
        return [("run", self.run), *build, ("probe", self.probe)]


class PortFile(
    ProgramFile, frozen=True, kw_only=True, forbid_unknown_fields=True
):
    """The port.toml of a port."""

    name: Text
    language: Text
    timeout: Positive
    version: Command = ()
    log_scans: Count | None = None
    plain_scans: Count | None = None
    scenarios_at_once: Count | None = None
    probe_lines: Count | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if not NAME.fullmatch(self.name):
            raise ValueError(
                f"name {self.name!r} does not make a folder's name"
            )
        if not any(w in self.run for w in ("{scenario}", "{scenarios}")):
            raise ValueError("run has no argument {scenarios} or {scenario}")
        for word in ("{mode}", "{out}"):
            if not any(word in argument for argument in self.run):
                raise ValueError(f"run has no {word}")

    def commands(self) -> list[tuple[str, tuple[str, ...]]]:
        """Every command, with its key."""
        return [*super().commands(), ("version", self.version)]


K = TypeVar("K", bound=NeedsFile)


def read_port_file(path: Path, kind: type[K]) -> K:
    """The declaration in a file. Raises PortError where it cannot be used."""
    try:
        return read_record(path, kind, PortError)
    except PortError as error:
        if not NO_COMMAND.search(str(error)):
            raise
        raise PortError(f"{error} (a command is a list of texts)") from error
