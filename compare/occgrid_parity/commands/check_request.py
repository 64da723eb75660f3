"""What the options of ``occgrid-parity check`` ask for, and whether they go together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.model.worlds import world_of
from occgrid_parity.ports.port_file import DEFAULT_TIMEOUT
from occgrid_parity.processes.limits import Limits
from occgrid_parity.programs.program import (
    Program,
    program_from_command,
    program_from_port,
)
from occgrid_parity.suite.cases import Case, case, case_from
from occgrid_parity.suite.modes import Mode, parse_mode


@dataclass(frozen=True)
class Subject:
    """What is checked: one of a command's text, a port.toml, a folder of submissions."""

    run: str | None
    port: Path | None
    class_folder: Path | None

    def validate(self) -> None:
        """Raises ValueError where it is not one of the three."""
        given = (self.run, self.port, self.class_folder)
        if sum(one is not None for one in given) != 1:
            raise ValueError(
                "say one of --run 'CMD', --port FILE, --class DIR"
            )

    def program(self, timeout: float | None) -> Program | None:
        """The program; None for a class. Raises ValueError where it cannot be one."""
        if self.run is not None:
            return program_from_command(
                self.run, Path.cwd(), timeout or DEFAULT_TIMEOUT
            )
        return (
            None
            if self.port is None
            else program_from_port(self.port, timeout)
        )


@dataclass(frozen=True)
class Outputs:
    """The files to write; ``folder`` is for the record and the minimal scenario."""

    folder: Path
    json_file: Path | None = None
    report: Path | None = None
    junit: Path | None = None
    gradescope: Path | None = None

    def validate(self, class_folder: Path | None) -> None:
        """Makes the folder for one program's record.

        Raises OSError where that fails, ValueError where a class is asked for what only one program has, or a file is
        to be written where there is no folder.
        """
        for file in (self.json_file, self.junit, self.gradescope):
            if file is not None and not self._has_folder(file):
                raise ValueError(f"{file}: there is no folder {file.parent}")
        if class_folder is None:
            self.folder.mkdir(parents=True, exist_ok=True)
            return
        if self.json_file:
            raise ValueError("--json is for one program")
        if not class_folder.is_dir():
            raise ValueError(f"{class_folder} is no folder")

    def _has_folder(self, file: Path) -> bool:
        """Whether the file's folder is there, or will be made for the record."""
        folder = file.parent.resolve()
        return folder.is_dir() or folder == self.folder.resolve()


@dataclass(frozen=True)
class CheckRequest:
    """How to check, whatever is checked."""

    outputs: Outputs
    limits: Limits
    cases: Sequence[Case]
    modes: Sequence[Mode]
    timeout: float | None
    explain: bool
    jobs: int


def chosen_cases(words: Sequence[str], modes: Sequence[Mode]) -> list[Case]:
    """Scenarios by their names in the suite or by their files; they must be valid ones.

    Raises OSError, ValueError or ScenarioError where one is not, and ValueError for modes without scenarios.
    """
    cases = [_case(word) for word in words]
    if modes and not cases:
        raise ValueError("--mode goes with --scenario")
    return cases


def chosen_modes(words: Sequence[str]) -> list[Mode]:
    """Modes by their names. Raises ValueError where one is none."""
    return [parse_mode(word) for word in words]


def _case(word: str) -> Case:
    path = Path(word)
    try:
        found = case_from(path) if path.is_file() else case(word)
    except FileNotFoundError as error:
        raise ValueError(
            f"{word}: no file, and no scenario of the suite has this name"
        ) from error
    world_of(found)
    return found
