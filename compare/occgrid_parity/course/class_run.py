"""Checks a whole class: one folder for each submission, side by side."""

from __future__ import annotations

import hashlib
import threading
import time
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.course.class_page import write_class_page
from occgrid_parity.course.class_store import ClassStore, suite_version
from occgrid_parity.course.class_summary import (
    MISTAKES,
    SUMMARY,
    Submission,
    mistakes_csv,
    summary_csv,
)
from occgrid_parity.course.gradebook import (
    CANVAS,
    MOODLE,
    Roster,
    canvas_csv,
    moodle_csv,
)
from occgrid_parity.course.submission_task import (
    Checked,
    Task,
    Wanted,
    check_task,
    handed_out_unrun,
)
from occgrid_parity.formats.archive import NOTHING, ArchiveError, pack
from occgrid_parity.processes.limits import LOST
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.progress import Progress
from occgrid_parity.processes.turns import Turns, at_most
from occgrid_parity.processes.wall import find_wall
from occgrid_parity.processes.worker_slots import WorkerLost, WorkerSlots

PAUSE = 3.0  # seconds from one summary to the next while the class is checked
MEBI = 2**20

Work = Callable[[Task, threading.Event], Checked]
"""work(task, stop): does a task somewhere."""


@dataclass(frozen=True)
class ClassPlan:
    """What to check of a class.

    ``folder`` has a folder for each submission, ``out`` gets the records, ``report`` the pages.
    """

    folder: Path
    out: Path
    wanted: Wanted
    jobs: int = 2
    report: Path | None = None
    roster: Roster | None = None

    def submissions(self) -> list[Path]:
        """The folders of the submissions, by name."""
        own = {self.out.resolve()}
        if self.report is not None:
            own.add(self.report.resolve())
        return sorted(
            path
            for path in self.folder.iterdir()
            if path.is_dir()
            and not path.name.startswith(".")
            and path.resolve() not in own
        )


class ClassRun:
    """A class that is being checked: ``found`` grows, and is written as it does."""

    def __init__(self, plan: ClassPlan, progress: Progress) -> None:
        self.plan = plan
        self.progress = progress
        self.places = plan.submissions()
        hidden = (
            plan.folder,
            plan.out,
            *([plan.report] if plan.report else []),
        )
        self.wanted = replace(
            plan.wanted,
            pages=plan.report is not None,
            out_of_sight=tuple(path.resolve() for path in hidden),
        )
        self.rules_digest = _digest(suite_version(), repr(self._what_counts()))
        self.store = ClassStore(plan.out, plan.report)
        self.found: dict[str, Submission] = {}
        self.taken_up = 0
        self.lock = threading.Lock()
        self.written = 0.0

    def _what_counts(self) -> tuple[object, ...]:
        """What the verdicts depend on, beside the submissions and the suite."""
        wanted = self.wanted
        cases = [
            [(case.name, case.digest) for case in some]
            for some in (wanted.cases, wanted.own, wanted.hidden)
        ]
        plain = replace(wanted, cases=(), own=(), hidden=(), out_of_sight=())
        return cases, plain, find_wall(wanted.sandbox).works

    def check(
        self, work: Work | None = None, jobs: int | None = None
    ) -> list[Submission]:
        """Checks every submission that has changed since the last run.

        ``work`` does a task, and ``jobs`` of them at a time; by default in processes of this machine, where others
        begin while some only wait. Whatever ends this, what has been found is written.
        """
        self.progress.total(len(self.places))
        slots = WorkerSlots(at_most(self.plan.jobs))
        turns = Turns(self.plan.jobs, slots.working)

        def here(task: Task, stop: threading.Event) -> Checked:
            return slots.run(check_task, task, stop)

        places = iter(self.places)

        def next_one(_: Path, stop: threading.Event) -> None:
            # who has a turn takes the next, so that they begin in order
            with turns.turn(stop) if work is None else nullcontext():
                self._one(next(places), stop, work or here)

        try:
            side_by_side(
                next_one, self.places, jobs or at_most(self.plan.jobs)
            )
            slots.close()
            self.write()
        except BaseException:  # also where a signal comes in the last lines
            slots.close()
            self.write()
            raise
        return self.submissions

    @property
    def submissions(self) -> list[Submission]:
        """What has been found so far, by name."""
        with self.lock:
            return [self.found[name] for name in sorted(self.found)]

    def _one(self, place: Path, stop: threading.Event, work: Work) -> None:
        name = place.name
        limit = self.wanted.rules.limits.submission_mib * MEBI
        try:
            if place.is_symlink():
                raise ArchiveError("it is a link to another folder")
            archive = pack(place, limit)
        except ArchiveError as error:
            task = Task(
                name, NOTHING, self.wanted, place, self.store.place(name)
            )
            checked = handed_out_unrun(task, "not readable", str(error))
            self._keep(checked, "")
            return
        digest = _digest(self.rules_digest, name, archive.digest)
        verdict = self.store.taken_up(name, digest)
        if verdict is not None:
            with self.lock:
                self.found[name] = Submission(name, verdict)
                self.taken_up += 1
            self.progress.step(f"{name}: {verdict.summary} (as before)")
            return
        self.progress.begin(name)
        task = Task(name, archive, self.wanted, place, self.store.place(name))
        try:
            checked = work(task, stop)
        except WorkerLost as error:
            checked = handed_out_unrun(task, LOST, str(error))
        self._keep(checked, digest)

    def _keep(self, checked: Checked, digest: str) -> None:
        self.store.keep(checked, digest)
        with self.lock:
            self.found[checked.name] = Submission(
                checked.name, checked.verdict
            )
        self.progress.end(checked.name)
        self.progress.step(f"{checked.name}: {checked.verdict.summary}")
        if time.monotonic() - self.written > PAUSE:
            self.written = time.monotonic()
            self.write()

    def write(self) -> None:
        """Writes what is known of the class so far."""
        found = self.submissions
        rules = self.wanted.rules
        with self.lock:
            self.store.write(SUMMARY, summary_csv(found, rules))
            self.store.write(MISTAKES, mistakes_csv(found))
            if self.plan.roster is not None:
                roster = self.plan.roster
                self.store.write(MOODLE, moodle_csv(found, roster, rules))
                self.store.write(CANVAS, canvas_csv(found, roster, rules))
            if self.plan.report is not None:
                rows = [(one.name, one.verdict) for one in found]
                write_class_page(
                    rows, self.plan.report, len(self.places), rules
                )


def _digest(*texts: str) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()
