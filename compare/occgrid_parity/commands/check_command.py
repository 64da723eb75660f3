"""The command ``occgrid-parity check``."""

from __future__ import annotations

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
from occgrid_parity.commands.class_check_run import run_class_check
from occgrid_parity.commands.class_request import class_request
from occgrid_parity.commands.console import print_plain
from occgrid_parity.commands.program_check_run import run_program_check
from occgrid_parity.model.reference import golden_problem
from occgrid_parity.ports.port_file import DEFAULT_TIMEOUT
from occgrid_parity.processes.cluster import NoCluster
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
    """Check any program against the suite, and explain where it goes wrong.

    In the command, {scenario} becomes a scenario file, {out} an empty folder (the program's working folder, too), {pgm}
    the picture to write, {mode} --noise-free or --seed N, {seed} the seed alone, {port} the folder that you are in. A
    program without {scenario} is checked on the lesson that it has built in. Each level is worth a point. The exit
    status is 0 if all that can be checked is right, 1 if something is wrong, 2 for wrong usage.
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
        outputs.validate(class_folder)
        program = subject.program(timeout)
        problem = golden_problem(LESSON, NOISE_FREE)
        about_starter = [] if port is None else starter_lines(port)
        request = CheckRequest(
            outputs, limits, cases, modes, timeout, explain, jobs
        )
        of_class = (
            None
            if class_folder is None
            else class_request(
                class_folder,
                request,
                rules,
                None if sandbox is None else sandbox.value,
                build_timeout,
                roster,
                scheduler,
            )
        )
    except (OSError, ValueError, ScenarioError, NoWall, NoCluster) as error:
        print_plain(Console(stderr=True), str(error))
        raise typer.Exit(2) from error
    if problem is not None:
        print_plain(console, problem)
        raise typer.Exit(1)
    for line in about_starter:
        print_plain(console, line)
    if program is not None:
        raise typer.Exit(run_program_check(console, program, request))
    assert class_folder is not None and of_class is not None
    raise typer.Exit(run_class_check(console, class_folder, of_class))
