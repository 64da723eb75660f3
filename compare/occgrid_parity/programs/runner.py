"""Runs the program that is checked on one scenario at a time, each in a fresh folder."""

from __future__ import annotations

import hashlib
import shutil
import threading
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Protocol

from occgrid_parity.formats.plain_text import clean
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.probing import run_probe
from occgrid_parity.processes.limits import LOST, Limits, run_limited
from occgrid_parity.processes.wall import NONE, Wall
from occgrid_parity.programs.command_words import join_words
from occgrid_parity.programs.observed_map import Observed, Unreadable, find_map
from occgrid_parity.programs.program import Program
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.vectors import FUNCTIONS

SHOWN = 65536  # bytes that are kept of what a run prints


@dataclass(frozen=True)
class Outcome:
    """How one run went: the map, or what went wrong in a word or two and at length.

    ``status`` is the exit status where the program ended by itself; ``printed`` what it said on standard error, then on
    standard output, its beginning at the most.
    """

    seconds: float
    observed: Observed | None = None
    word: str = ""
    message: str = ""
    ran: bool = True
    notes: tuple[str, ...] = ()
    status: int | None = None
    printed: str = field(default="", repr=False)


class Runner(Protocol):
    """Something that draws maps."""

    name: str
    words: str
    option: str
    reads_scenarios: bool
    takes_seeds: bool
    plain_mode: Mode

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of the shared vectors that the program can be asked for."""

    def run(self, case: Case, mode: Mode) -> Outcome:
        """The map of one scenario."""

    def probe(self, function: str, questions: Sequence[str]) -> list[str]:
        """What the program's function gives; raises occgrid_parity.ports.probing.ProbeError where it gives nothing."""


class CommandRunner:
    """A program that is started for every run.

    Everything that a run writes lies in a folder of its own below ``folder``; the scenario is a read-only copy.
    """

    def __init__(
        self,
        program: Program,
        folder: Path,
        limits: Limits,
        stop: threading.Event | None = None,
        wall: Wall = NONE,
    ) -> None:
        self.program = replace(program, python=wall.python)
        self.wall = wall
        self.folder = folder
        self.limits = limits
        self.stop = stop
        self.name = program.name
        self.words = program.words
        self.option = program.option
        self.reads_scenarios = program.reads_scenarios
        self.takes_seeds = program.takes_seeds
        self.plain_mode = program.plain_mode
        self.number = 0

    def build(self) -> Outcome | None:
        """Runs the program's build commands; what went wrong, or None."""
        for number, template in enumerate(self.program.build, 1):
            program = replace(self.program, command=template)
            ended = run_limited(
                program.arguments(None, self.folder, self.folder, Mode(None)),
                cwd=self.program.folder,
                folder=self.folder / f"build-{number}",
                watch=self.folder / f"build-{number}",
                limits=Limits(
                    self.program.build_timeout,
                    self.limits.output,
                    2 * self.limits.memory,
                    8 * self.limits.processes,
                ),
                stop=self.stop,
                wall=self.wall,
                writable=[self.program.folder],
            )
            if ended.word:
                message = f"{join_words(template)}: {ended.message}"
                return Outcome(
                    ended.seconds,
                    None,
                    "does not build",
                    message,
                    False,
                    ended.notes,
                )
        return None

    def run(self, case: Case, mode: Mode) -> Outcome:
        """Runs the program, and once more where nobody knows how the run ended.

        Raises occgrid_parity.processes.process_group.Stopped when it is asked to stop.
        """
        outcome = self._run_once(case, mode)
        return outcome if outcome.word != LOST else self._run_once(case, mode)

    def _run_once(self, case: Case, mode: Mode) -> Outcome:
        self.number += 1
        folder = self.folder / f"{self.number:03d}-{case.name}.{mode.name}"
        if folder.exists():
            shutil.rmtree(folder)
        out = folder / "out"
        out.mkdir(parents=True)
        scenario = self._copy(case, folder) if case.is_file else None
        pgm = out / f"{case.name}.pgm"
        ended = run_limited(
            self.program.arguments(scenario, out, pgm, mode),
            cwd=self.program.cwd or out,
            folder=folder,
            watch=out,
            limits=self.limits,
            stop=self.stop,
            wall=self.wall,
            readable=[
                self.program.folder,
                *([] if scenario is None else [scenario.parent]),
            ],
            writable=[out],
        )
        notes = [*ended.notes]
        if ended.left and ended.status is not None:
            left, them = "a process", "it"
            if ended.left > 1:
                left, them = f"{ended.left} processes", "them"
            notes.append(f"it left {left} running; the check ended {them}")
        if scenario is not None and not _is(scenario, case):
            notes.append("it changed its copy of the scenario file")
        printed = _beginning(ended.stderr) + _beginning(ended.stdout)
        if ended.word:
            return Outcome(
                ended.seconds,
                None,
                ended.word,
                clean(ended.message),
                False,
                tuple(notes),
                ended.status,
                printed,
            )
        found = find_map(out, pgm, ended.stdout)
        if isinstance(found, Unreadable):
            return Outcome(
                ended.seconds,
                None,
                found.word,
                clean(found.message),
                True,
                tuple(notes),
                0,
                printed,
            )
        notes += found.remarks
        return Outcome(ended.seconds, found, notes=tuple(notes), status=0)

    @property
    def functions(self) -> tuple[str, ...]:
        """Every function of the shared vectors where port.toml has a probe."""
        return FUNCTIONS if self.program.probe else ()

    def probe(self, function: str, questions: Sequence[str]) -> list[str]:
        """What the program's function gives. Raises ProbeError where it gives nothing."""
        port = Port(
            self.name,
            "",
            self.program.folder,
            self.program.command,
            self.limits.seconds,
            probe=self.program.probe,
        )
        folder = self.folder / "probe"
        folder.mkdir(exist_ok=True)
        return run_probe(port, function, questions, folder, self.stop)

    def _copy(self, case: Case, folder: Path) -> Path:
        """A read-only copy of the scenario in a read-only folder."""
        place = folder / "scenario"
        place.mkdir()
        copy = place / f"{case.name}.log"
        copy.write_bytes(case.data)
        copy.chmod(0o444)
        place.chmod(0o555)
        return copy


def _beginning(file: Path) -> str:
    """What was printed into a file, its beginning at the most."""
    with file.open("rb") as printed:
        return printed.read(SHOWN).decode("utf-8", "replace")


def _is(path: Path, case: Case) -> bool:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest() == case.digest
    except OSError:
        return False
