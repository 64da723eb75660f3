"""The command ``occgrid-parity check``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Literal

import typer
from rich.console import Console

from occgrid.scenario import ScenarioError
from occgrid_parity.check.starter import starter_lines
from occgrid_parity.commands.check_arguments import (
    DEFAULT_OUT,
    BuildTimeout,
    ClassFolder,
    Explain,
    Gradescope,
    Jobs,
    JsonFile,
    JUnit,
    Memory,
    Modes,
    Out,
    Output,
    PortFile,
    Processes,
    Report,
    RosterFile,
    RulesFile,
    Run,
    SandboxChoice,
    Scenarios,
    Scheduler,
    Timeout,
)
from occgrid_parity.commands.check_request import (
    CheckRequest,
    Outputs,
    Subject,
    chosen_cases,
    chosen_modes,
)
from occgrid_parity.commands.console import print_plain
from occgrid_parity.commands.program_check_run import run_program_check
from occgrid_parity.model.reference import golden_problem
from occgrid_parity.ports.port_file import DEFAULT_TIMEOUT
from occgrid_parity.processes.limits import MEBI, Limits
from occgrid_parity.processes.wall import NoWall
from occgrid_parity.suite.cases import LESSON
from occgrid_parity.suite.modes import NOISE_FREE


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
    rules: RulesFile = None,
    sandbox: SandboxChoice = None,
    build_timeout: BuildTimeout = None,
    roster: RosterFile = None,
    scheduler: Scheduler = None,
) -> None:
    """Check a program against the suite, and explain where its maps go wrong.

    The command of --run may have these words in it:
    {scenario}: the scenario file to map
    {out}: an empty folder for the map, the working folder, too
    {pgm}: the picture to write
    {mode}: --noise-free or --seed N; {seed}: N alone
    {port}: the folder that you are in

    A program without {scenario} is checked on the lesson that it has built in.
    Every level is worth one point.
    Exit status: 0 if all is right, 1 if something is wrong, 2 for wrong usage.
    """
    console = Console()
    subject = Subject(run, port, class_folder)
    outputs = Outputs(out, json_file, report, junit, gradescope)
    limits = Limits(
        timeout or DEFAULT_TIMEOUT,
        max_output * MEBI,
        max_memory * MEBI,
        max_processes,
    )
    try:
        subject.validate()
        modes = chosen_modes(mode or [])
        cases = chosen_cases(scenario or [], modes)
        program = subject.program(timeout)
        outputs.validate(class_folder)
        problem = golden_problem(LESSON, NOISE_FREE)
        about_starter = [] if port is None else starter_lines(port)
        request = CheckRequest(
            outputs, limits, cases, modes, timeout, explain, jobs
        )
        run_class = None
        if class_folder is not None:
            run_class = _prepared_class(
                class_folder,
                request,
                rules,
                None if sandbox is None else sandbox.value,
                build_timeout,
                roster,
                scheduler,
            )
    except OSError as error:
        said = f"{error.filename}: {error.strerror}"
        print_plain(
            Console(stderr=True), said if error.filename else str(error)
        )
        raise typer.Exit(2) from error
    except (ValueError, ScenarioError, NoWall) as error:
        print_plain(Console(stderr=True), str(error))
        raise typer.Exit(2) from error
    if problem is not None:
        print_plain(console, problem)
        raise typer.Exit(1)
    for line in about_starter:
        print_plain(console, line)
    if program is not None:
        raise typer.Exit(run_program_check(console, program, request))
    assert run_class is not None
    raise typer.Exit(run_class(console))


def _prepared_class(
    folder: Path,
    request: CheckRequest,
    rules: Path | None,
    sandbox: Literal["auto", "require", "none"] | None,
    build_timeout: float | None,
    roster: Path | None,
    scheduler: str | None,
) -> Callable[[Console], int]:
    """Reads what a class needs; what is returned checks it.

    Only here are the modules of a class imported, which one program need not wait for.
    """
    from occgrid_parity.commands.class_check_run import run_class_check
    from occgrid_parity.commands.class_request import class_request

    of_class = class_request(
        folder, request, rules, sandbox, build_timeout, roster, scheduler
    )
    return lambda console: run_class_check(console, folder, of_class)
