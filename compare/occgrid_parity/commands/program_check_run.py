"""``occgrid-parity check`` of one program: its verdict, printed and written."""

from __future__ import annotations

from dataclasses import replace

from rich.console import Console

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.program_check import check_program
from occgrid_parity.check.program_maps import ComparedMap, PartialMap
from occgrid_parity.check.verdict import Verdict, to_json
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.commands.check_request import CheckRequest, Outputs
from occgrid_parity.commands.console import print_plain
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.programs.program import Program

VERDICT = "verdict.json"


def run_program_check(
    console: Console, program: Program, request: CheckRequest
) -> int:
    """Checks a program and says what came of it; returns the exit status."""
    outputs = request.outputs
    maps: list[ComparedMap] = []
    partial: list[PartialMap] = []
    options = Options(
        request.cases,
        request.modes,
        request.explain,
        outputs.folder,
        maps.append,
        partial.append,
    )
    limits = replace(request.limits, seconds=program.timeout)
    verdict = check_program(program, limits, options)
    write_records(verdict, outputs)
    page = None
    if outputs.report is not None:
        from occgrid_parity.report.check_page import write_check_page

        page = write_check_page(verdict, maps, outputs.report, partial)
    print_plain(console, verdict_text(verdict).rstrip())
    print_plain(console, f"record: {outputs.folder / VERDICT}")
    if page is not None:
        print_plain(console, f"report: {page}")
    return verdict.exit_status


def write_records(verdict: Verdict, outputs: Outputs) -> None:
    """The record in its folder, and in the forms that were asked for; their modules are imported only then."""
    for file in (outputs.folder / VERDICT, outputs.json_file):
        if file is not None:
            write_text(file, to_json(verdict))
    if outputs.junit is not None:
        from occgrid_parity.report.junit import verdict_junit_xml

        write_text(outputs.junit, verdict_junit_xml(verdict))
    if outputs.gradescope is not None:
        from occgrid_parity.report.gradescope import gradescope_json

        write_text(outputs.gradescope, gradescope_json(verdict))
