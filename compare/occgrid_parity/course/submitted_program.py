"""The program of a submission: what the instructor gives, and what the student may say."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from occgrid_parity.course.rules import ProgramRules
from occgrid_parity.formats.toml_records import read_toml
from occgrid_parity.ports.port_file import (
    DECLARATION,
    DEFAULT_TIMEOUT,
    NeedsFile,
    PortError,
    read_port_file,
)
from occgrid_parity.programs.command_words import join_words
from occgrid_parity.programs.program import Program, program_from_port

DECIDED = ("build_timeout",)
"""Keys of a port.toml that never count in a class."""


class ToolMissing(Exception):
    """This machine has not what the submission needs; the text says what to install."""


def submitted_program(
    folder: Path, given: ProgramRules, timeout: float | None
) -> tuple[Program, list[str]]:
    """The program in a folder, and a line for each of the student's keys that does not count.

    Without ``timeout`` a student may ask for less time, not for more.
    Raises PortError where there is no such program, and ToolMissing where this machine cannot run it.
    """
    file = folder / DECLARATION
    notes: list[str] = []
    missing = file.is_file() and read_port_file(file, NeedsFile).missing
    if missing:
        raise ToolMissing(f"install {missing}")
    if given.run is None:
        program = program_from_port(file, timeout)
        keys = read_toml(file, PortError)
        allowed = [key for key in given.allowed if key not in DECIDED]
        notes += _ignored(keys, allowed)
        if "run" not in allowed:
            raise PortError(
                f"{file}: run is needed, and class.toml neither gives it nor allows it"
            )
        if "build" not in allowed:
            program = replace(program, build=())
        if timeout is None:
            seconds = program.timeout if "timeout" in allowed else None
            timeout = min(seconds or DEFAULT_TIMEOUT, DEFAULT_TIMEOUT)
    else:
        program = Program(
            folder.name,
            tuple(given.run),
            folder,
            words=join_words(given.run),
            option=f"--port {join_words([str(file)])}",
        )
        if program.has("out", "pgm"):
            program = replace(program, cwd=folder)
        else:
            program = replace(
                program,
                command=tuple(_in_folder(word, folder) for word in given.run),
            )
        if file.is_file():
            keys = read_toml(file, PortError)
            notes += _ignored(keys, [k for k in given.allowed if k != "run"])
            if "build" in given.allowed and "build" in keys:
                own = program_from_port(file)
                program = replace(program, build=own.build)
    if given.build is not None:
        build = tuple(tuple(command) for command in given.build)
        program = replace(program, build=build)
    return (
        replace(program, name=folder.name, timeout=timeout or DEFAULT_TIMEOUT),
        notes,
    )


def _ignored(keys: Iterable[str], allowed: list[str]) -> list[str]:
    return [
        f"{key} in {DECLARATION} does not count: the instructor decides it"
        for key in keys
        if key not in allowed
        and key in ("run", "build", "timeout", "build_timeout")
    ]


def _in_folder(word: str, folder: Path) -> str:
    """A word that names a file of the submission as its full path."""
    path = folder / word
    if "{" in word or word.startswith("-") or not path.is_file():
        return word
    return str(path)
