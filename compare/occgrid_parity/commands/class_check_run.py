"""``occgrid-parity check --class``: many programs, their verdicts and the table of them."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from occgrid_parity.check.class_run import ClassPlan, OnChecked, check_class
from occgrid_parity.check.class_summary import SUMMARY
from occgrid_parity.check.program_maps import ComparedMap
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.commands.check_request import CheckRequest
from occgrid_parity.commands.console import print_plain
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.report.check_page import write_check_page
from occgrid_parity.report.class_page import write_class_page


def run_class_check(
    console: Console, folder: Path, request: CheckRequest
) -> int:
    """Checks every program of a folder; returns the exit status: 0 where all are as they should be."""
    out, report = request.outputs.folder, request.outputs.report
    plan = ClassPlan(
        folder,
        out,
        request.limits,
        request.jobs,
        request.cases,
        request.modes,
        request.timeout,
    )
    on_checked = None if report is None else page_writer(report)
    with ConsoleProgress(console) as progress:
        found = check_class(plan, progress, on_checked)
    good = sum(one.verdict.exit_status == 0 for one in found)
    print_plain(
        console,
        f"{good} of {len(found)} are as they should be; {out / SUMMARY}",
    )
    if report is not None:
        rows = [(one.name, one.verdict) for one in found]
        print_plain(console, f"report: {write_class_page(rows, report)}")
    return 0 if found and good == len(found) else 1


def page_writer(report: Path) -> OnChecked:
    """Writes the page of each submission into a folder of its own, as soon as it is checked."""

    def write_page(
        name: str, verdict: Verdict, maps: list[ComparedMap]
    ) -> None:
        write_check_page(verdict, maps, report / name)

    return write_page
