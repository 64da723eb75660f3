"""The command ``occgrid-parity check``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid.scenario import ScenarioError
from occgrid_parity.check.class_run import SUMMARY, check_class, check_program
from occgrid_parity.check.verdict import Verdict, to_json
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.check.whole_check import ComparedMap, Options
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.model.reference import golden_problem
from occgrid_parity.model.worlds import world_of
from occgrid_parity.processes.limits import MEBI, Limits
from occgrid_parity.programs.program import (
    DEFAULT_TIMEOUT,
    Program,
    program_from_command,
    program_from_port,
)
from occgrid_parity.report.check_page import write_check_page
from occgrid_parity.report.class_page import write_class_page
from occgrid_parity.report.gradescope import gradescope_json
from occgrid_parity.report.junit import verdict_junit_xml
from occgrid_parity.suite.cases import LESSON, Case, case, case_from
from occgrid_parity.suite.modes import NOISE_FREE, Mode, parse_mode

DEFAULT_OUT = Path("occgrid-parity-check")
VERDICT = "verdict.json"

Run = Annotated[
    str | None,
    typer.Option(
        "--run",
        metavar="'CMD'",
        help="The program's command, with {scenario}, {out} or {pgm}, {mode} or {seed}.",
    ),
]
PortFile = Annotated[
    Path | None,
    typer.Option("--port", metavar="FILE", help="The program's port.toml."),
]
ClassFolder = Annotated[
    Path | None,
    typer.Option(
        "--class",
        metavar="DIR",
        help="Many programs: a folder with port.toml each.",
    ),
]
Scenarios = Annotated[
    list[str] | None,
    typer.Option(
        "--scenario",
        metavar="NAME|FILE",
        help="Check on this only; may be repeated.",
    ),
]
Modes = Annotated[
    list[str] | None,
    typer.Option(
        "--mode", metavar="MODE", help="noise-free or seed-N, with --scenario."
    ),
]
Out = Annotated[
    Path,
    typer.Option(
        metavar="DIR", help="For the record and the minimal scenario."
    ),
]
JsonFile = Annotated[
    Path | None,
    typer.Option("--json", metavar="FILE", help="A copy of the record."),
]
Report = Annotated[
    Path | None,
    typer.Option(
        metavar="DIR",
        help="Write a page that shows every map that was compared; with --class, one each and their table.",
    ),
]
JUnit = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="Write the levels as JUnit XML."),
]
Gradescope = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the levels as an autograder's results.json (Gradescope's form).",
    ),
]
Timeout = Annotated[
    float | None,
    typer.Option(
        min=0.1,
        help=f"Seconds for one run (default: port.toml's, or {DEFAULT_TIMEOUT:g}).",
    ),
]
Output = Annotated[
    int,
    typer.Option("--max-output", min=1, help="MiB that one run may write."),
]
Memory = Annotated[
    int,
    typer.Option(
        "--max-memory", min=16, help="MiB of memory that one run may use."
    ),
]
Processes = Annotated[
    int,
    typer.Option(
        "--max-processes", min=1, help="Processes at a time in one run."
    ),
]
Explain = Annotated[
    bool,
    typer.Option(
        "--explain/--no-explain", help="Look for cause and first difference."
    ),
]
Jobs = Annotated[
    int, typer.Option(min=1, help="With --class: how many side by side.")
]


def check_command(
    run: Run = None,
    port: PortFile = None,
    class_folder: ClassFolder = None,
    scenario: Scenarios = None,
    mode: Modes = None,
    out: Out = DEFAULT_OUT,
    json_file: JsonFile = None,
    report: Report = None,
    junit: JUnit = None,
    gradescope: Gradescope = None,
    timeout: Timeout = None,
    max_output: Output = 256,
    max_memory: Memory = 2048,
    max_processes: Processes = 64,
    explain: Explain = True,
    jobs: Jobs = 2,
) -> None:
    """Check any program against the suite, and explain the first difference.

    {scenario} is the scenario file, {out} an empty folder, which is the program's working folder too, {pgm} the
    picture to write, {mode} --noise-free or --seed N, {seed} the seed alone, {port} the folder you are in. A program
    without {scenario} is checked on the lesson it has built in. Ends with 0 where all that can be checked is identical
    or differs only at cell edges, with 1 where it differs or fails, with 2 for wrong usage.
    """
    console = Console()
    limits = Limits(
        timeout or DEFAULT_TIMEOUT,
        max_output * MEBI,
        max_memory * MEBI,
        max_processes,
    )
    try:
        if sum(x is not None for x in (run, port, class_folder)) != 1:
            raise ValueError(
                "say one of --run 'CMD', --port FILE, --class DIR"
            )
        cases = [_case(word) for word in scenario or []]
        modes = [parse_mode(word) for word in mode or []]
        if modes and not cases:
            raise ValueError("--mode goes with --scenario")
        if class_folder is not None and (junit or gradescope or json_file):
            raise ValueError(
                "--json, --junit and --gradescope are for one program"
            )
        if class_folder is not None and not class_folder.is_dir():
            raise ValueError(f"{class_folder} is no folder")
        program = _program(run, port, timeout)
        problem = golden_problem(LESSON, NOISE_FREE)
    except (OSError, ValueError, ScenarioError) as error:
        Console(stderr=True).print(
            str(error), markup=False, highlight=False, soft_wrap=True
        )
        raise typer.Exit(2) from error
    if problem is not None:
        _print(console, problem)
        raise typer.Exit(1)
    if class_folder is not None:
        _check_class(
            console,
            class_folder,
            out,
            report,
            limits,
            jobs,
            cases,
            modes,
            timeout,
        )
    assert program is not None
    own = Limits(
        program.timeout, limits.output, limits.memory, limits.processes
    )
    maps: list[ComparedMap] = []
    options = Options(cases, modes, explain, out, maps.append)
    verdict = check_program(program, own, options)
    out.mkdir(parents=True, exist_ok=True)
    for file in (out / VERDICT, json_file):
        if file is not None:
            write_text(file, to_json(verdict))
    if junit is not None:
        write_text(junit, verdict_junit_xml(verdict))
    if gradescope is not None:
        write_text(gradescope, gradescope_json(verdict))
    page = None if report is None else write_check_page(verdict, maps, report)
    _print(console, verdict_text(verdict).rstrip())
    _print(console, f"record: {out / VERDICT}")
    if page is not None:
        _print(console, f"report: {page}")
    raise typer.Exit(verdict.exit_status)


def _check_class(
    console: Console,
    folder: Path,
    out: Path,
    report: Path | None,
    limits: Limits,
    jobs: int,
    cases: list[Case],
    modes: list[Mode],
    timeout: float | None,
) -> None:
    """Checks a class and ends the command."""

    def write_page(
        name: str, verdict: Verdict, maps: list[ComparedMap]
    ) -> None:
        assert report is not None
        write_check_page(verdict, maps, report / name)

    with ConsoleProgress(console) as progress:
        found = check_class(
            folder,
            out,
            limits,
            jobs,
            progress,
            cases,
            modes,
            timeout,
            None if report is None else write_page,
        )
    good = sum(one.verdict.exit_status == 0 for one in found)
    _print(
        console,
        f"{good} of {len(found)} are as they should be; {out / SUMMARY}",
    )
    if report is not None:
        page = write_class_page(
            [(one.name, one.verdict) for one in found], report
        )
        _print(console, f"report: {page}")
    raise typer.Exit(0 if found and good == len(found) else 1)


def _program(
    run: str | None, port: Path | None, timeout: float | None
) -> Program | None:
    if run is not None:
        return program_from_command(
            run, Path.cwd(), timeout or DEFAULT_TIMEOUT
        )
    return None if port is None else program_from_port(port, timeout)


def _case(word: str) -> Case:
    """A scenario by its name in the suite or by its file; it must be a valid one."""
    path = Path(word)
    found = case_from(path) if path.is_file() else case(word)
    world_of(found)
    return found


def _print(console: Console, text: str) -> None:
    console.print(text, markup=False, highlight=False, soft_wrap=True)
