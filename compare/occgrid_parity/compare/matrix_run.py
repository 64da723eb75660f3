"""A run: builds the ports, maps side by side, compares, and records what it found."""

from __future__ import annotations

import platform
import shutil
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

from occgrid_parity.compare.mapping import (
    MapBatch,
    Mapped,
    batches,
    map_batch,
)
from occgrid_parity.compare.run_record import (
    RECORD_FILE,
    SCHEMA,
    PortRecord,
    ProcessRecord,
    RunRecord,
    ScenarioRecord,
    to_json,
)
from occgrid_parity.compare.run_results import ComparisonBasis, results_of_run
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.ports.building import Built, build_ports
from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.progress import Progress, Silent
from occgrid_parity.suite.modes import PORT_MODES, Mode
from occgrid_parity.suite.scenarios import ScenarioFile

REFERENCE = "python"
MARKER = ".parity-run"


@dataclass(frozen=True)
class Plan:
    """What a run is to do.

    ``golden`` is the folder of the committed results. With ``built``, which has every
    port of ``ports``, nothing is built. ``map_batch`` maps scenarios, here or elsewhere.
    """

    ports: Sequence[Port]
    scenarios: Sequence[ScenarioFile]
    folder: Path
    modes: Sequence[Mode] = PORT_MODES
    golden: Path | None = None
    jobs: int = 2
    built: Sequence[Built] | None = None
    reference: str = REFERENCE
    progress: Progress = field(default_factory=Silent)
    map_batch: MapBatch = map_batch


def prepare_folder(folder: Path) -> None:
    """Makes the folder of a run, and empties that of an earlier one.

    Raises FileExistsError where it has files in it that are not a run's, and OSError
    where it cannot be made.
    """
    if (
        folder.exists()
        and not (folder / MARKER).is_file()
        and any(folder.iterdir())
    ):
        raise FileExistsError(
            f"{folder}: is not empty and not the folder of a run"
        )
    if folder.exists():
        for entry in folder.iterdir():
            if entry.is_dir() and not entry.is_symlink():
                shutil.rmtree(entry)
            elif entry.name != MARKER:
                entry.unlink()
    folder.mkdir(parents=True, exist_ok=True)
    (folder / MARKER).write_text("This folder is emptied by the next run.\n")


def run(plan: Plan) -> RunRecord:
    """Runs the plan and leaves its record beside the maps, as run.json.

    The plan's folder must be fresh (see prepare_folder). Raises ValueError where the
    reference port is not among the ports.
    """
    if plan.reference not in [port.name for port in plan.ports]:
        raise ValueError(
            f"the reference port {plan.reference} is not among the ports"
        )
    started, clock = datetime.now(UTC), time.monotonic()
    plan.progress.total(_steps(plan))
    built = plan.built
    if built is None:
        logs = plan.folder / "build"
        built = build_ports(plan.ports, logs, plan.jobs, plan.progress)
    mapped = _map_all(plan, [b.port for b in built if not b.problem])
    basis = ComparisonBasis(plan.reference, plan.folder, plan.golden)
    record = RunRecord(
        schema=SCHEMA,
        started=started.isoformat(timespec="seconds"),
        seconds=time.monotonic() - clock,
        machine=f"{platform.system()} {platform.machine()}",
        folder=str(plan.folder),
        reference=plan.reference,
        modes=[mode.name for mode in plan.modes],
        ports=[_port_record(plan, one) for one in built],
        scenarios=[
            ScenarioRecord(
                s.name, s.map, None if s.path is None else str(s.path)
            )
            for s in plan.scenarios
        ],
        results=results_of_run(
            basis, built, plan.scenarios, plan.modes, mapped
        ),
        processes=[_process_record(plan, one) for one in mapped],
    )
    write_text(plan.folder / RECORD_FILE, to_json(record))
    return record


def _map_all(plan: Plan, ports: Sequence[Port]) -> list[Mapped]:
    """All processes of the run, the slowest ports first."""
    slow_first = sorted(ports, key=lambda port: -port.timeout)
    work = [
        (port, mode, batch)
        for port in slow_first
        for mode in plan.modes
        for batch in batches(port, plan.scenarios, mode)
    ]

    def run_one(
        item: tuple[Port, Mode, list[ScenarioFile]], stop: threading.Event
    ) -> list[Mapped]:
        port, mode, batch = item
        mapped = plan.map_batch(
            port, mode, batch, plan.folder / port.name / mode.name, stop
        )
        what = batch[0].name if len(batch) == 1 else f"{len(batch)} scenarios"
        failed = [one for one in mapped if not one.finished.succeeded]
        said = failed[0].finished.failure() if failed else "mapped"
        seconds = sum(one.finished.seconds for one in mapped)
        plan.progress.step(
            f"{port.name}, {mode.name}, {what}: {said} ({seconds:.1f} s)"
        )
        return mapped

    return [
        one for some in side_by_side(run_one, work, plan.jobs) for one in some
    ]


def _steps(plan: Plan) -> int:
    """How many steps the run tells its progress, if nothing goes wrong."""
    builds = len(plan.ports) if plan.built is None else 0
    return builds + sum(
        len(batches(port, plan.scenarios, mode))
        for port in plan.ports
        for mode in plan.modes
    )


def _port_record(plan: Plan, built: Built) -> PortRecord:
    return PortRecord(
        name=built.port.name,
        language=built.port.language,
        reference=built.port.name == plan.reference,
        version=built.version,
        build_seconds=built.seconds,
        skipped=built.skipped,
        problem=built.problem,
    )


def _process_record(plan: Plan, one: Mapped) -> ProcessRecord:
    def relative(path: Path) -> str:
        return path.relative_to(plan.folder).as_posix()

    return ProcessRecord(
        port=one.port.name,
        mode=one.mode.name,
        scenarios=[scenario.name for scenario in one.scenarios],
        command=list(one.finished.command),
        folder=relative(one.folder),
        stdout=relative(one.finished.stdout),
        stderr=relative(one.finished.stderr),
        seconds=one.finished.seconds,
        time_limit=one.finished.time_limit,
        exit_status=one.finished.exit_status,
        timed_out=one.finished.timed_out,
    )
