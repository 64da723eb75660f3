"""Checks a whole class: one folder for each submission, side by side, with a summary in CSV."""

from __future__ import annotations

import csv
import io
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.check.verdict import Verdict, to_json
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.check.whole_check import (
    ComparedMap,
    Options,
    broken,
    check,
)
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.ports.declaration import DECLARATION
from occgrid_parity.ports.declaration_reader import PortError
from occgrid_parity.processes.limits import Limits
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.progress import Progress
from occgrid_parity.programs.program import Program, program_from_port
from occgrid_parity.programs.runner import CommandRunner
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

SUMMARY = "summary.csv"
COLUMNS = (
    "submission", "verdict", "level", "word", "summary", "scenario", "scan", "beam", "cause", "compared",
    "runs", "seconds",
)  # fmt: skip


@dataclass(frozen=True)
class Submission:
    """One folder of a class, and what came of it."""

    name: str
    verdict: Verdict


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
            return broken(runner, problem.word, problem.message)
        return check(runner, options)


def check_class(
    folder: Path,
    out: Path,
    limits: Limits,
    jobs: int,
    progress: Progress,
    cases: Sequence[Case] = (),
    modes: Sequence[Mode] = (),
    timeout: float | None = None,
    on_checked: Callable[[str, Verdict, list[ComparedMap]], None]
    | None = None,
) -> list[Submission]:
    """Checks every folder in ``folder``; writes one record and text each, and the summary, into ``out``.

    ``on_checked`` is told of each submission and its maps, from several threads.
    """
    places = sorted(
        p
        for p in folder.iterdir()
        if p.is_dir()
        and not p.name.startswith(".")
        and p.resolve() != out.resolve()
    )
    progress.total(len(places))
    out.mkdir(parents=True, exist_ok=True)

    def one(place: Path, stop: threading.Event) -> Submission:
        save = out / place.name
        maps: list[ComparedMap] = []
        keep = None if on_checked is None else maps.append
        options = Options(cases, modes, save=save, on_map=keep)
        verdict = check_submission(place, limits, options, timeout, stop)
        save.mkdir(parents=True, exist_ok=True)
        write_text(save / "verdict.json", to_json(verdict))
        write_text(save / "verdict.txt", verdict_text(verdict))
        if on_checked is not None:
            on_checked(place.name, verdict, maps)
        progress.step(f"{place.name}: {verdict.summary}")
        return Submission(place.name, verdict)

    found = side_by_side(one, places, jobs)
    write_text(out / SUMMARY, summary_csv(found))
    return found


def check_submission(
    place: Path,
    limits: Limits,
    options: Options,
    timeout: float | None,
    stop: threading.Event | None,
) -> Verdict:
    """One submission. Whatever goes wrong is its verdict: the others go on."""
    blank = Program(place.name, ("?",), place, words="")
    runner = CommandRunner(blank, place, limits)
    if not (place / DECLARATION).is_file():
        return broken(
            runner, "no port.toml", f"{place.name} has no {DECLARATION}"
        )
    try:
        program = program_from_port(place, timeout)
    except PortError as error:
        return broken(runner, "bad port.toml", str(error))
    own = Limits(
        program.timeout, limits.output, limits.memory, limits.processes
    )
    try:
        return check_program(program, own, options, stop)
    except Stopped:
        raise
    except (
        Exception
    ) as error:  # the harness's own fault must not end the class
        return broken(
            runner, "harness error", f"{type(error).__name__}: {error}"
        )


def summary_csv(submissions: Sequence[Submission]) -> str:
    """One line for each submission."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for one in submissions:
        v = one.verdict
        level, d = v.failed_level, v.first_difference
        causes = [c.name for c in v.cause.candidates] if v.cause else []
        writer.writerow(
            [
                one.name,
                v.overall,
                level.name if level else "",
                level.word if level else "",
                v.summary,
                d.scenario if d else "",
                "" if d is None or d.scan is None else d.scan,
                "" if d is None or d.beam is None else d.beam,
                " or ".join(causes),
                v.compared,
                v.runs,
                v.seconds,
            ]
        )
    return text.getvalue()
