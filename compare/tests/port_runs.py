"""What the tests of the command line share: a port run with any arguments, in a folder of its own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import Finished, run_process

from .conftest import PORTS

PLACEHOLDERS = ("{mode}", "--out", "{out}", "{scenario}", "{scenarios}")

each_port = pytest.mark.parametrize("name", [port.name for port in PORTS])


def command_line(port: Port, *arguments: str | Path) -> list[str]:
    """The port's program, with these arguments in place of its template's."""
    begin = min(i for i, word in enumerate(port.run) if word in PLACEHOLDERS)
    assert set(port.run[begin:]) <= set(PLACEHOLDERS)
    return [*port.command(port.run[:begin]), *map(str, arguments)]


def run_port(
    port: Port,
    folder: Path,
    *arguments: str | Path,
    within: Sequence[str] = (),
    environment: Mapping[str, str] | None = None,
) -> Finished:
    """Runs the port in a folder; ``within`` is a command that its command line is handed to."""
    return run_process(
        [*within, *command_line(port, *arguments)],
        cwd=folder,
        stdout=folder / f"{port.name}.stdout",
        stderr=folder / f"{port.name}.stderr",
        time_limit=port.timeout,
        environment=environment,
    )


def shell(script: str, *arguments: str) -> list[str]:
    """A shell script that is handed the words after it as well."""
    return ["sh", "-c", script, "sh", *arguments]


def files(folder: Path) -> list[str]:
    """The names in a folder, in order."""
    return sorted(path.name for path in folder.iterdir())
