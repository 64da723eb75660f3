"""Checks a whole class: one folder for each submission, side by side, with a summary in CSV."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.class_summary import SUMMARY, Submission, summary_csv
from occgrid_parity.check.program_check import broken, check_program
from occgrid_parity.check.program_maps import ComparedMap
from occgrid_parity.check.verdict import Verdict, to_json
from occgrid_parity.check.verdict_text import verdict_text
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

OnChecked = Callable[[str, Verdict, list[ComparedMap]], None]
"""on_checked(name, verdict, maps) of a submission."""


@dataclass(frozen=True)
class ClassPlan:
    """What to check of a class.

    ``folder`` has a folder for each submission, ``out`` gets the records. ``cases`` and ``modes`` as in Options;
    ``timeout``, seconds for one run, goes before what port.toml says.
    """

    folder: Path
    out: Path
    limits: Limits
    jobs: int = 2
    cases: Sequence[Case] = ()
    modes: Sequence[Mode] = ()
    timeout: float | None = None

    def submissions(self) -> list[Path]:
        """The folders of the submissions, by name."""
        return sorted(
            path
            for path in self.folder.iterdir()
            if path.is_dir()
            and not path.name.startswith(".")
            and path.resolve() != self.out.resolve()
        )


def check_class(
    plan: ClassPlan, progress: Progress, on_checked: OnChecked | None = None
) -> list[Submission]:
    """Checks every submission; writes one record and text each, and the summary.

    ``on_checked`` is told of each submission and its maps, from several threads.
    """
    places = plan.submissions()
    progress.total(len(places))
    plan.out.mkdir(parents=True, exist_ok=True)

    def one(place: Path, stop: threading.Event) -> Submission:
        maps: list[ComparedMap] = []
        keep = None if on_checked is None else maps.append
        verdict = check_submission(plan, place, keep, stop)
        write_verdict(plan.out / place.name, verdict)
        if on_checked is not None:
            on_checked(place.name, verdict, maps)
        progress.step(f"{place.name}: {verdict.summary}")
        return Submission(place.name, verdict)

    found = side_by_side(one, places, plan.jobs)
    write_text(plan.out / SUMMARY, summary_csv(found))
    return found


def write_verdict(folder: Path, verdict: Verdict) -> None:
    """The verdict of one submission, as record and as text."""
    folder.mkdir(parents=True, exist_ok=True)
    write_text(folder / "verdict.json", to_json(verdict))
    write_text(folder / "verdict.txt", verdict_text(verdict))


def check_submission(
    plan: ClassPlan,
    place: Path,
    on_map: Callable[[ComparedMap], None] | None = None,
    stop: threading.Event | None = None,
) -> Verdict:
    """One submission. Whatever goes wrong is its verdict: the others go on."""
    blank = Program(place.name, ("?",), place, words="")
    runner = CommandRunner(blank, place, plan.limits)
    if not (place / DECLARATION).is_file():
        return broken(
            runner, "no port.toml", f"{place.name} has no {DECLARATION}"
        )
    try:
        program = program_from_port(place, plan.timeout)
    except PortError as error:
        return broken(runner, "bad port.toml", str(error))
    limits = replace(plan.limits, seconds=program.timeout)
    save = plan.out / place.name
    options = Options(plan.cases, plan.modes, save=save, on_map=on_map)
    try:
        return check_program(program, limits, options, stop)
    except Stopped:
        raise
    except (
        Exception
    ) as error:  # the harness's own fault must not end the class
        return broken(
            runner, "harness error", f"{type(error).__name__}: {error}"
        )
