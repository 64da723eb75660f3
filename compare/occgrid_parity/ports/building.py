"""Builds a port by the commands of its declaration."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.process_group import (
    Finished,
    first_line,
    run_process,
)
from occgrid_parity.processes.progress import Progress


@dataclass(frozen=True)
class Built:
    """How a build ended: ``problem`` is empty where it went well."""

    port: Port
    seconds: float = 0.0
    skipped: bool = False
    problem: str = ""
    version: str | None = None
    log: Path | None = None


def as_it_is(port: Port) -> Built:
    """The port without building it, for who has built it before."""
    reason = port.skip_reason
    return Built(port, skipped=reason is not None, problem=reason or "")


def build_port(
    port: Port, logs: Path, stop: threading.Event | None = None
) -> Built:
    """Builds a port and asks for its version; what it printed lies in ``logs``.

    A port that needs a command that is not there is skipped.
    """
    reason = port.skip_reason
    if reason is not None:
        return Built(port, skipped=True, problem=reason)
    logs.mkdir(parents=True, exist_ok=True)
    seconds = 0.0
    for number, template in enumerate(port.build, 1):
        stdout = logs / f"{port.name}.build-{number}.stdout"
        finished = run_process(
            port.command(template),
            cwd=port.folder,
            stdout=stdout,
            stderr=stdout.with_suffix(".stderr"),
            time_limit=port.build_timeout,
            stop=stop,
        )
        seconds += finished.seconds
        if not finished.succeeded:
            problem = f"build failed: {_failure(finished)}"
            return Built(port, seconds, problem=problem, log=finished.stderr)
    return Built(port, seconds, version=_version(port, logs, stop))


def _failure(finished: Finished) -> str:
    """The failure, with the first line that speaks of an error where there is one."""
    for path in (finished.stderr, finished.stdout):
        text = path.read_bytes().decode("utf-8", "replace")
        for line in text.splitlines():
            if "error" in line.lower():
                words = " ".join(finished.command)
                return f"{line.strip()[:300]} ({words})"
    return f"{finished.failure()} ({' '.join(finished.command)})"


def _version(
    port: Port, logs: Path, stop: threading.Event | None
) -> str | None:
    """The first line of the version, None where the port does not tell it."""
    if not port.version:
        return None
    stdout = logs / f"{port.name}.version.stdout"
    finished = run_process(
        port.command(port.version),
        cwd=port.folder,
        stdout=stdout,
        stderr=stdout.with_suffix(".stderr"),
        time_limit=port.timeout,
        stop=stop,
    )
    return first_line(stdout) or None if finished.succeeded else None


def build_ports(
    ports: Sequence[Port], logs: Path, jobs: int, progress: Progress
) -> list[Built]:
    """Builds ports side by side."""

    def build(port: Port, stop: threading.Event) -> Built:
        built = build_port(port, logs, stop)
        said = built.problem or f"built in {built.seconds:.1f} s"
        progress.step(f"{port.name}: {said}")
        return built

    return side_by_side(build, ports, jobs)
