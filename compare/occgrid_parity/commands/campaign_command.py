"""The command ``occgrid-parity campaign``."""

from __future__ import annotations

import os
import shlex
import threading
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from occgrid_parity.campaign.block_work import BlockFindings, Subjects
from occgrid_parity.campaign.campaign_record import (
    RECORD_FILE,
    CampaignRecord,
    ProgramRecord,
)
from occgrid_parity.campaign.campaign_run import Campaign, CampaignPlan, Do
from occgrid_parity.commands.check_arguments import Scheduler
from occgrid_parity.commands.console import (
    AllowSkipped,
    BuildFirst,
    Root,
    print_plain,
    wide_console,
    wrong_usage,
)
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.commands.interruption import Interrupted, interruptible
from occgrid_parity.compare.matrix_run import prepare_folder
from occgrid_parity.formats.archive import ArchiveError
from occgrid_parity.ports.building import as_it_is, build_ports
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.finding import choose_ports, is_program
from occgrid_parity.ports.parcels import parcel
from occgrid_parity.ports.port_file import DEFAULT_TIMEOUT
from occgrid_parity.processes.cluster import Cluster, NoCluster
from occgrid_parity.processes.limits import Limits
from occgrid_parity.processes.progress import Silent
from occgrid_parity.processes.worker_slots import WorkerSlots
from occgrid_parity.programs.program import (
    Program,
    program_from_command,
    program_from_port,
)
from occgrid_parity.programs.runner import CommandRunner
from occgrid_parity.report.campaign_page import write_campaign_page
from occgrid_parity.report.campaign_table import campaign_lines
from occgrid_parity.suite.repository import find_root

OWN_FOLDER = Path("occgrid-parity-campaign")


def campaign_command(
    ports: Annotated[
        list[str] | None,
        typer.Option(
            "--port",
            metavar="NAME|DIR",
            help="A port, or a folder with port.toml: without language in it, it is a program as for check.",
        ),
    ] = None,
    run: Annotated[
        str | None,
        typer.Option(
            "--run",
            metavar="'CMD'",
            help="A program's command, as for check: with {scenario}.",
        ),
    ] = None,
    worlds: Annotated[
        int, typer.Option(min=1, help="How many worlds.")
    ] = 1000,
    seed: Annotated[
        int, typer.Option(min=0, help="Another seed, other worlds.")
    ] = 0,
    first: Annotated[
        int, typer.Option(min=0, help="The number of the first world.")
    ] = 0,
    only: Annotated[
        int | None,
        typer.Option(
            "--world", min=0, metavar="N", help="This world and no other."
        ),
    ] = None,
    shorten: Annotated[
        int,
        typer.Option(
            min=0, help="How many differences of each program are shortened."
        ),
    ] = 5,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help=f"Default: build/campaign, outside a repository {OWN_FOLDER}.",
        ),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write a page."),
    ] = None,
    root: Root = None,
    jobs: Annotated[
        int | None,
        typer.Option(min=1, help="How many side by side (all cores)."),
    ] = None,
    timeout: Annotated[
        float | None,
        typer.Option(
            min=0.1, help="Seconds for one world, in place of each port's own."
        ),
    ] = None,
    scheduler: Scheduler = None,
    build_first: BuildFirst = True,
    allow_skipped: AllowSkipped = False,
) -> None:
    """Map random worlds and logs, thousands of them, and shorten what differs.

    A world is known by the seed and its number: --world N maps it again.
    A port must draw the reference's map in every bit. For any other program
    (--run), rounding in its own libraries is no difference.
    Without --port and --run, all ports are compared.

    Exit status: 0 if no map differs, 1 if one does, 2 for wrong usage.
    """
    console = wide_console()
    try:
        home = _home(root)
        chosen, program = _chosen(home, ports or [], run, timeout)
        if timeout is not None:
            chosen = [replace(port, timeout=timeout) for port in chosen]
        if scheduler is not None and program is not None:
            raise ValueError("--scheduler goes with ports only")
        default = OWN_FOLDER if home is None else home / "build" / "campaign"
        folder = (out or default).resolve()
        prepare_folder(folder)
        cluster = None if scheduler is None else Cluster(scheduler)
        records, subjects = _subjects(
            console, chosen, program, folder, cluster, build_first
        )
    except (OSError, ValueError, NoCluster, ArchiveError) as error:
        raise wrong_usage(error) from error
    plan = CampaignPlan(
        seed=seed,
        first=first if only is None else only,
        worlds=worlds if only is None else 1,
        subjects=subjects,
        programs=records,
        folder=folder,
        again=_again(home, chosen, program, seed),
        jobs=_jobs(jobs, cluster),
        shorten=shorten,
    )
    status, record = _run(console, plan, cluster)
    page = None if report is None else write_campaign_page(record, report)
    for line in campaign_lines(record):
        print_plain(console, line)
    print_plain(console, f"record: {folder / RECORD_FILE}")
    if page is not None:
        print_plain(console, f"report: {page}")
    good = record.is_identical(allow_skipped)
    raise typer.Exit(status or (0 if good else 1))


def _home(root: Path | None) -> Path | None:
    """The repository, where there is one."""
    try:
        return find_root() if root is None else root
    except FileNotFoundError:
        return None


def _chosen(
    home: Path | None,
    words: Sequence[str],
    run: str | None,
    timeout: float | None,
) -> tuple[list[Port], Program | None]:
    """Ports, and the program that is none.

    Raises ValueError or PortError where words or command name nothing.
    """
    programs: list[Program] = []
    if run is not None:
        programs.append(
            program_from_command(run, Path.cwd(), timeout or DEFAULT_TIMEOUT)
        )
    named = []
    for word in words:
        if is_program(Path(word)):
            programs.append(program_from_port(Path(word), timeout))
        else:
            named.append(word)
    if len(programs) > 1:
        raise ValueError("one program that is no port at a time")
    program = programs[0] if programs else None
    if program is not None and not program.reads_scenarios:
        raise ValueError("the program's command needs {scenario}")
    if program is not None and not named:
        return [], program
    if home is None:
        raise ValueError("no repository with ports here: say --root DIR")
    return choose_ports(home, named), program


def _subjects(
    console: Console,
    ports: Sequence[Port],
    program: Program | None,
    folder: Path,
    cluster: Cluster | None,
    build_first: bool,
) -> tuple[list[ProgramRecord], Subjects]:
    """What is asked, built where it is asked here.

    Raises ValueError where it cannot be built.
    """
    limits = Limits()
    records: list[ProgramRecord] = []
    if program is not None:
        limits = replace(limits, seconds=program.timeout)
        runner = CommandRunner(program, folder / "build", limits)
        problem = runner.build()
        if problem is not None:
            raise ValueError(f"{program.name}: {problem.message}")
        records.append(
            ProgramRecord(program.name, "a program that is no port")
        )
    if cluster is not None:
        there = [ProgramRecord(port.name, port.language) for port in ports]
        parcels = tuple(map(parcel, ports))
        return [*there, *records], Subjects(parcels, program, limits)
    built = (
        build_ports(ports, folder / "build", 1, Silent())
        if build_first
        else list(map(as_it_is, ports))
    )
    for one in built:
        if one.problem and not one.skipped:
            raise ValueError(f"{one.port.name}: {one.problem}")
        if one.skipped:
            print_plain(console, f"{one.port.name}: {one.problem}")
    here = [
        ProgramRecord(one.port.name, one.port.language, one.version or "")
        for one in built
    ]
    found = tuple(one.port for one in built)
    return [*here, *records], Subjects(found, program, limits)


def _again(
    home: Path | None,
    ports: Sequence[Port],
    program: Program | None,
    seed: int,
) -> dict[str, str]:
    """For each program the command that maps a world again, but for its number."""
    options = {}
    for port in ports:
        is_ours = port.folder.parent == home
        word = port.name if is_ours else shlex.quote(str(port.folder))
        options[port.name] = f"--port {word}"
    if program is not None:
        options[program.name] = program.option
    return {
        name: f"occgrid-parity campaign {option} --seed {seed}"
        for name, option in options.items()
    }


def _jobs(jobs: int | None, cluster: Cluster | None) -> int:
    if jobs is not None:
        return jobs
    return cluster.jobs if cluster is not None else os.cpu_count() or 1


def _run(
    console: Console, plan: CampaignPlan, cluster: Cluster | None
) -> tuple[int, CampaignRecord]:
    """The exit status that an interruption asks for, else 0, and the record."""
    slots = WorkerSlots(plan.jobs)
    do: Do = slots.run
    if cluster is not None:
        print_plain(console, f"dashboard: {cluster.dashboard}")
        do = partial(_do_there, cluster)
    progress = ConsoleProgress(console)
    campaign = Campaign(plan, progress)
    try:
        with progress, interruptible():
            return 0, campaign.run(do)
    except Interrupted as interrupted:
        print_plain(
            console,
            f"stopped: {campaign.done} of {plan.worlds} worlds are mapped",
        )
        return 128 + interrupted.number, campaign.record
    finally:
        slots.close()
        if cluster is not None:
            cluster.close()


def _do_there(
    cluster: Cluster, work: Any, argument: Any, stop: threading.Event
) -> Any:
    return cluster.run(work, argument, stop, _lacks_a_port)


def _lacks_a_port(result: object) -> bool:
    return isinstance(result, BlockFindings) and result.lacks_a_port
