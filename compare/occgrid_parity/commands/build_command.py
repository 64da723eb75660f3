"""The command ``occgrid-parity build``."""

from __future__ import annotations

from typing import Annotated

import typer

from occgrid_parity.commands.console import (
    AllowSkipped,
    Jobs,
    Root,
    print_plain,
    wide_console,
    wrong_usage,
)
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.ports.building import build_ports
from occgrid_parity.ports.finding import choose_ports
from occgrid_parity.suite.repository import find_root


def build_command(
    ports: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PORT]...", help="Default: all."),
    ] = None,
    root: Root = None,
    jobs: Jobs = 2,
    allow_skipped: AllowSkipped = False,
) -> None:
    """Build the ports, as their port.toml says."""
    console = wide_console()
    try:
        found = find_root() if root is None else root
        chosen = choose_ports(found, ports or [])
    except (OSError, ValueError) as error:
        raise wrong_usage(error) from error
    with ConsoleProgress(console) as progress:
        progress.total(len(chosen))
        built = build_ports(chosen, found / "build" / "ports", jobs, progress)
    failed = [
        b for b in built if b.problem and not (b.skipped and allow_skipped)
    ]
    for one in failed:
        said = f" (see {one.log})" if one.log is not None else ""
        word = "skipped: " if one.skipped else ""
        print_plain(console, f"{one.port.name}: {word}{one.problem}{said}")
    raise typer.Exit(1 if failed else 0)
