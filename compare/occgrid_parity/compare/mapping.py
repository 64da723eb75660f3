"""Runs one port over scenarios: in one process where it takes many, else one each."""

from __future__ import annotations

import shutil
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import Finished, run_process
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import ScenarioFile, count_scans


@dataclass(frozen=True)
class Mapped:
    """A process and the scenarios that it was given; their files lie in ``folder``."""

    port: Port
    mode: Mode
    scenarios: tuple[ScenarioFile, ...]
    folder: Path
    finished: Finished


class MapBatch(Protocol):
    """Maps a batch of scenarios as ``map_batch`` does."""

    def __call__(
        self,
        port: Port,
        mode: Mode,
        batch: Sequence[ScenarioFile],
        folder: Path,
        stop: threading.Event,
    ) -> list[Mapped]:
        """The processes that mapped them; their files are in ``folder``."""


def left_out(port: Port, scenario: ScenarioFile, mode: Mode) -> str | None:
    """Why a port does not map this one, or None where it does.

    A slow port maps by its plain program what has few scans, and the built-in lesson once.
    """
    most = port.plain_scans
    if most is None or not mode.plain:
        return None
    if scenario.path is None:
        if mode.seed is None:
            return None
    elif count_scans(scenario.path) <= most:
        return None
    return f"plain, it maps scenarios of at most {most} scans and the built-in lesson without noise"


def batches(
    port: Port, scenarios: Sequence[ScenarioFile], mode: Mode
) -> list[list[ScenarioFile]]:
    """The scenarios as they go to processes: the built-in lesson alone, those of a slow port a few at a time."""
    mapped = [one for one in scenarios if left_out(port, one, mode) is None]
    files = [scenario for scenario in mapped if scenario.path is not None]
    alone = [[scenario] for scenario in mapped if scenario.path is None]
    if not files:
        return alone
    at_once = port.scenarios_at_once or max(1, len(files))
    if not port.takes_many:
        at_once = 1
    return alone + [
        files[i : i + at_once] for i in range(0, len(files), at_once)
    ]


def map_batch(
    port: Port,
    mode: Mode,
    batch: Sequence[ScenarioFile],
    folder: Path,
    stop: threading.Event | None = None,
) -> list[Mapped]:
    """Maps a batch; where that fails, each scenario of it again in its own process.

    So one bad scenario does not take the results of the others with it. ``folder``
    is the port's and mode's; what is in it of earlier runs is removed.
    """
    if len(batch) == 1:
        return [_run(port, mode, batch, folder / _place(batch[0]), stop)]
    together = _run(
        port, mode, batch, folder / f"scenarios-from-{batch[0].name}", stop
    )
    if (
        together.finished.succeeded
        or together.finished.start_error is not None
    ):
        return [together]
    return [
        _run(port, mode, [one], folder / _place(one), stop) for one in batch
    ]


def _place(scenario: ScenarioFile) -> str:
    """The folder of a scenario that is mapped alone."""
    return "built-in" if scenario.path is None else f"scenario-{scenario.name}"


def _run(
    port: Port,
    mode: Mode,
    batch: Sequence[ScenarioFile],
    out: Path,
    stop: threading.Event | None,
) -> Mapped:
    """One process, with an empty folder to write into."""
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    files = [scenario.path for scenario in batch if scenario.path is not None]
    command = port.command(
        port.run, mode=mode.arguments, out=out, scenario=files, scenarios=files
    )
    finished = run_process(
        command,
        cwd=port.folder,
        stdout=out.with_name(f"{out.name}.stdout"),
        stderr=out.with_name(f"{out.name}.stderr"),
        time_limit=port.timeout * len(batch),
        stop=stop,
    )
    return Mapped(port, mode, tuple(batch), out, finished)
