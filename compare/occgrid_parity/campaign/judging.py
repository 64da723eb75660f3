"""Holds maps against the reference's: those of ports bit for bit, those of other programs as a check does."""

from __future__ import annotations

import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid.fast import map_scenario_fast
from occgrid.map_writer import write_map
from occgrid.scenario import ScenarioError, read_scenario
from occgrid_parity.compare.mapping import Mapped, map_batch
from occgrid_parity.compare.matrix_run import Plan, run
from occgrid_parity.compare.run_record import Result
from occgrid_parity.explain.closeness import compare_with_reference
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.limits import Limits
from occgrid_parity.processes.process_group import Finished
from occgrid_parity.programs.program import Program
from occgrid_parity.programs.runner import CommandRunner
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import ScenarioFile, scenario_from

GOOD = "identical"
NOT_COMPARED = ("left out", "skipped")


@dataclass(frozen=True)
class Finding:
    """What came of a scenario: a status as in the record of a run, and what there is to say."""

    status: str
    reason: str = ""

    @property
    def is_wrong(self) -> bool:
        """Whether there is no map, or not the reference's."""
        return self.status not in (GOOD, *NOT_COMPARED)


Judge = Callable[[Sequence[Case], Mode], list[Finding]]
"""judge(cases, mode): what a program makes of scenarios, all of them valid."""


HERE = Port(
    "(reference)",
    "the Python port, in this process",
    Path(),
    ("{scenarios}",),
    timeout=60,
)
"""Stands for the reference in a run. No port can have its name."""


def judge_ports(
    built: Sequence[Built], cases: Sequence[Case], mode: Mode
) -> dict[str, list[Finding]]:
    """What each of the ports makes of the scenarios, against the maps that the reference draws in this process.

    The Python port can be among the ports: then its command is held against its functions.
    """
    with tempfile.TemporaryDirectory(prefix="occgrid-campaign-") as place:
        folder = Path(place)
        files = []
        for case in cases:
            file = folder / f"{case.name}.log"
            file.write_bytes(case.data)
            files.append(scenario_from(file))
        plan = Plan(
            ports=[HERE, *(one.port for one in built)],
            scenarios=files,
            folder=folder / "maps",
            modes=[mode],
            jobs=1,
            built=[Built(HERE), *built],
            reference=HERE.name,
            map_batch=_map_batch,
        )
        plan.folder.mkdir()
        record = run(plan)
        return {
            one.port.name: [
                _finding(record.result(one.port.name, file.name, mode.name))
                for file in files
            ]
            for one in built
        }


def _map_batch(
    port: Port,
    mode: Mode,
    batch: Sequence[ScenarioFile],
    folder: Path,
    stop: threading.Event,
) -> list[Mapped]:
    """Maps with a port, or in this process."""
    if port is not HERE:
        return map_batch(port, mode, batch, folder, stop)
    folder.mkdir(parents=True)
    for one in batch:
        assert one.path is not None
        with read_scenario(one.path) as scenario:
            grid = map_scenario_fast(scenario, mode.seed)
        write_map(folder, one.map, grid)
    finished = Finished((), 0, False, HERE.timeout, 0.0, folder, folder)
    return [Mapped(HERE, mode, tuple(batch), folder, finished)]


def _finding(result: Result) -> Finding:
    said = [
        f"{d.count} of {d.total} {d.unit} of {d.file} differ"
        for d in result.differences
        if d.total
    ]
    return Finding(result.status, "; ".join(said) or result.reason)


class ProgramJudge:
    """Judges a program that is no port: what rounding in its own libraries explains is as it should be."""

    def __init__(self, program: Program, folder: Path, limits: Limits) -> None:
        self.runner = CommandRunner(program, folder, limits)
        self.name = program.name

    def mode(self, mode: Mode) -> Mode:
        """The mode that the program can be asked for."""
        if mode.seed is not None and self.runner.takes_seeds:
            return replace(mode, plain=False)
        return self.runner.plain_mode

    def judge(self, cases: Sequence[Case], mode: Mode) -> list[Finding]:
        """What the program makes of the scenarios, one at a time."""
        return [self._one(case, self.mode(mode)) for case in cases]

    def _one(self, case: Case, mode: Mode) -> Finding:
        outcome = self.runner.run(case, mode)
        if outcome.observed is None:
            status = "timeout" if outcome.word == "hang" else "error"
            return Finding(status, f"{outcome.word}: {outcome.message}")
        observed = outcome.observed
        expected = reference_map(case, mode).pixels.shape
        if observed.pixels.shape != expected:
            return Finding("differs", "the size of its map is another one")
        compared = compare_with_reference(observed, case, mode)
        if compared.status != "differs":
            return Finding(GOOD, compared.status)
        count = int(compared.wrong.sum())
        return Finding("differs", f"{count} of {compared.wrong.size} cells")


def valid(case: Case) -> bool:
    """Whether the reference reads the scenario without an error."""
    try:
        world_of(case)
    except ScenarioError:
        return False
    return True
