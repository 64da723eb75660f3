"""``occgrid-parity check --class``: many programs, their verdicts and the table of them."""

from __future__ import annotations

import threading
from functools import partial
from pathlib import Path

from rich.console import Console

from occgrid_parity.commands.class_request import ClassRequest
from occgrid_parity.commands.console import print_plain
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.commands.interruption import Interrupted, interruptible
from occgrid_parity.course.class_run import ClassPlan, ClassRun
from occgrid_parity.course.class_summary import MISTAKES, SUMMARY
from occgrid_parity.course.gradebook import CANVAS, MOODLE
from occgrid_parity.course.submission_task import (
    Checked,
    Task,
    check_task,
    needs_another_machine,
)
from occgrid_parity.processes.cluster import Cluster
from occgrid_parity.report.run_page import PAGE_FILE


def run_class_check(
    console: Console, folder: Path, request: ClassRequest
) -> int:
    """Checks every program of a folder; returns the exit status: 0 where all are as they should be."""
    plan = ClassPlan(
        folder,
        request.out,
        request.wanted,
        request.jobs,
        request.report,
        request.roster,
    )
    print_plain(console, request.rules_text)
    progress = ConsoleProgress(console)
    run = ClassRun(plan, progress)
    try:
        with progress, interruptible():
            if request.cluster is None:
                found = run.check()
            else:
                cluster = request.cluster
                print_plain(console, f"dashboard: {cluster.dashboard}")
                found = run.check(partial(check_on, cluster), cluster.jobs)
    except Interrupted as interrupted:
        print_plain(
            console,
            f"stopped: {len(run.found)} of {len(run.places)} are checked and written to {plan.out}. The same command "
            "again goes on from there.",
        )
        return 128 + interrupted.number
    good = sum(one.verdict.exit_status == 0 for one in found)
    if run.taken_up:
        print_plain(
            console,
            f"{run.taken_up} of {len(found)} have not changed and were taken over from an earlier run",
        )
    print_plain(
        console,
        f"{good} of {len(found)} are as they should be; {plan.out / SUMMARY}, {plan.out / MISTAKES}",
    )
    if plan.roster is not None:
        missing = plan.roster.missing(found)
        if missing:
            print_plain(console, f"not in the roster: {', '.join(missing)}")
        print_plain(
            console, f"gradebooks: {plan.out / MOODLE}, {plan.out / CANVAS}"
        )
    if plan.report is not None:
        print_plain(console, f"report: {plan.report / PAGE_FILE}")
    return 0 if found and good == len(found) else 1


def check_on(cluster: Cluster, task: Task, stop: threading.Event) -> Checked:
    """Checks a submission on a machine of the cluster, on another one where that lacks what the submission needs."""
    return cluster.run(check_task, task, stop, needs_another_machine)
