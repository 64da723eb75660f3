"""Runs the program that is checked on one scenario at a time, each in a fresh folder."""

from __future__ import annotations

import hashlib
import shlex
import shutil
import threading
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from occgrid_parity.processes.limits import Limits, run_limited
from occgrid_parity.processes.wall import NONE, Wall
from occgrid_parity.programs.observed_map import Observed, Unreadable, find_map
from occgrid_parity.programs.program import Program
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode


@dataclass(frozen=True)
class Outcome:
    """How one run went: the map, or what went wrong in a word or two and at length."""

    seconds: float
    observed: Observed | None = None
    word: str = ""
    message: str = ""
    ran: bool = True
    notes: tuple[str, ...] = ()


class Runner(Protocol):
    """Something that draws maps."""

    name: str
    words: str
    option: str
    reads_scenarios: bool
    takes_seeds: bool
    plain_mode: Mode

    def run(self, case: Case, mode: Mode) -> Outcome:
        """The map of one scenario."""


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
                message = f"{shlex.join(template)}: {ended.message}"
                return Outcome(
                    ended.seconds, None, "does not build", message, False
                )
        return None

    def run(self, case: Case, mode: Mode) -> Outcome:
        """Runs the program once. Raises occgrid_parity.processes.process_group.Stopped when it is asked to stop."""
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
        notes = []
        if ended.left:
            one = "a process" if ended.left == 1 else f"{ended.left} processes"
            notes.append(
                f"forks: it left {one} running when it ended; ended, too"
            )
        if scenario is not None and not _is(scenario, case):
            notes.append("it changed its copy of the scenario file")
        if ended.word:
            return Outcome(
                ended.seconds,
                None,
                ended.word,
                ended.message,
                False,
                tuple(notes),
            )
        found = find_map(out, pgm, ended.stdout)
        if isinstance(found, Unreadable):
            return Outcome(
                ended.seconds,
                None,
                found.word,
                found.message,
                True,
                tuple(notes),
            )
        return Outcome(ended.seconds, found, notes=tuple(notes))

    def _copy(self, case: Case, folder: Path) -> Path:
        """A read-only copy of the scenario in a read-only folder."""
        place = folder / "scenario"
        place.mkdir()
        copy = place / f"{case.name}.log"
        copy.write_bytes(case.data)
        copy.chmod(0o444)
        place.chmod(0o555)
        return copy


def _is(path: Path, case: Case) -> bool:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest() == case.digest
    except OSError:
        return False
