"""Checks one program: builds it, and runs it in a temporary folder."""

from __future__ import annotations

import tempfile
import threading
from collections.abc import Sequence
from pathlib import Path

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.grey import levels_of_broken
from occgrid_parity.check.verdict import SCHEMA, Verdict
from occgrid_parity.check.whole_check import check
from occgrid_parity.processes.limits import Limits
from occgrid_parity.programs.program import Program
from occgrid_parity.programs.runner import CommandRunner, Runner


def check_program(
    program: Program,
    limits: Limits,
    options: Options,
    stop: threading.Event | None = None,
) -> Verdict:
    """Builds and checks a program in a temporary folder."""
    with tempfile.TemporaryDirectory(prefix="occgrid-parity-check-") as folder:
        runner = CommandRunner(program, Path(folder), limits, stop)
        problem = runner.build()
        if problem is not None:
            return broken(runner, problem.word, problem.message, problem.notes)
        return check(runner, options)


def broken(
    runner: Runner, word: str, message: str, notes: Sequence[str] = ()
) -> Verdict:
    """The verdict on a program that could not even be run."""
    return Verdict(
        schema=SCHEMA,
        program=runner.name,
        command=runner.words,
        overall="failed",
        summary=f"{word}: {message}",
        compared="nothing",
        seconds=0.0,
        runs=0,
        levels=levels_of_broken(runner, word, message),
        notes=list(notes),
    )
