"""The command ``occgrid-parity run``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid_parity.commands.check_arguments import Scheduler
from occgrid_parity.commands.console import (
    AllowSkipped,
    BuildFirst,
    Jobs,
    Root,
    print_plain,
    wide_console,
    wrong_usage,
)
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.compare.far_mapping import FarPorts
from occgrid_parity.compare.matrix_run import (
    REFERENCE,
    Plan,
    prepare_folder,
    run,
)
from occgrid_parity.compare.run_record import RunRecord, to_json
from occgrid_parity.formats.archive import ArchiveError
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.ports.building import as_it_is
from occgrid_parity.ports.finding import choose_ports
from occgrid_parity.processes.cluster import Cluster, NoCluster
from occgrid_parity.report.junit import junit_xml
from occgrid_parity.report.run_page import write_page
from occgrid_parity.report.run_table import (
    explanations,
    footnotes,
    matrix_table,
    summary,
)
from occgrid_parity.suite.modes import PORT_MODES, parse_mode
from occgrid_parity.suite.repository import find_root
from occgrid_parity.suite.scenarios import choose_scenarios


def run_command(
    ports: Annotated[
        list[str] | None,
        typer.Option(
            "--port",
            metavar="NAME",
            help="A port, or a folder with port.toml.",
        ),
    ] = None,
    scenarios: Annotated[
        list[str] | None,
        typer.Option(
            "--scenario", metavar="NAME|FILE", help="A scenario, or built-in."
        ),
    ] = None,
    modes: Annotated[
        list[str] | None,
        typer.Option("--mode", metavar="MODE", help="noise-free or seed-N."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Default: build/parity.")
    ] = None,
    json_file: Annotated[
        Path | None,
        typer.Option("--json", metavar="FILE", help="A copy of the record."),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write a page that shows every map."),
    ] = None,
    junit: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the results as JUnit XML."),
    ] = None,
    root: Root = None,
    jobs: Jobs = 2,
    timeout: Annotated[
        float | None,
        typer.Option(
            min=0.001,
            help="Seconds for one scenario, in place of each port's own.",
        ),
    ] = None,
    build_first: BuildFirst = True,
    allow_skipped: AllowSkipped = False,
    scheduler: Scheduler = None,
) -> None:
    """Map scenarios with the ports and compare the maps, bit for bit.

    The Python port is the reference, and always runs. Where it has no map of a
    scenario, the others are compared with each other and with the golden result.

    Exit status: 0 if all maps are identical, 1 if one is not, 2 for wrong usage.
    """
    console = wide_console()
    try:
        found = find_root() if root is None else root
        chosen = choose_ports(found, ports or [])
        if REFERENCE not in [port.name for port in chosen]:
            chosen = [*choose_ports(found, [REFERENCE]), *chosen]
        if timeout is not None:
            chosen = [replace(port, timeout=timeout) for port in chosen]
        folder = (out or found / "build" / "parity").resolve()
        chosen_scenarios = choose_scenarios(found, scenarios or [])
        chosen_modes = list(dict.fromkeys(map(parse_mode, modes or [])))
        prepare_folder(folder)
        cluster = None if scheduler is None else Cluster(scheduler)
        far = None if cluster is None else FarPorts(cluster, chosen)
    except (OSError, ValueError, NoCluster, ArchiveError) as error:
        raise wrong_usage(error) from error
    with ConsoleProgress(console) as progress:
        plan = Plan(
            ports=chosen,
            scenarios=chosen_scenarios,
            modes=chosen_modes or PORT_MODES,
            folder=folder,
            golden=found / "scenarios" / "golden",
            jobs=jobs,
            built=None if build_first else list(map(as_it_is, chosen)),
            progress=progress,
        )
        if cluster is not None and far is not None:
            print_plain(console, f"dashboard: {cluster.dashboard}")
            plan = replace(
                plan,
                jobs=cluster.jobs,
                built=far.build(progress),
                map_batch=far.map_batch,
            )
        record = run(plan)
    if cluster is not None:
        cluster.close()
    write_copies(record, json_file, junit)
    page = None if report is None else write_page(record, folder, report)
    show(console, record, folder, page)
    raise typer.Exit(0 if record.is_identical(allow_skipped) else 1)


def write_copies(
    record: RunRecord, json_file: Path | None, junit: Path | None
) -> None:
    """The record in the files that were asked for."""
    if json_file is not None:
        write_text(json_file, to_json(record))
    if junit is not None:
        write_text(junit, junit_xml(record))


def show(
    console: Console, record: RunRecord, folder: Path, page: Path | None
) -> None:
    """The table, what differs, where all of it lies, and the summary."""
    console.print(matrix_table(record))
    lines = [*footnotes(record), *explanations(record), ""]
    lines.append(f"pictures and run.json: {folder}")
    if page is not None:
        lines.append(f"report: {page}")
    lines.append(summary(record))
    for line in lines:
        print_plain(console, line)
