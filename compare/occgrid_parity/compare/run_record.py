"""What a run found, as plain data: JSON that every table and report is made from.

All paths in a record are relative to the folder of the run (its ``folder``), with
``/``. Doubles stand as the texts of their ``repr`` and of their 64 bits, so that no
reader of the JSON can round them.
"""

from __future__ import annotations

import json
import typing
from dataclasses import dataclass, field
from typing import Literal

from occgrid_parity.compare.cell_values import CellValue
from occgrid_parity.formats.json_records import from_plain, json_text

SCHEMA = 1
RECORD_FILE = "run.json"

Status = Literal[
    "identical", "differs", "error", "timeout", "skipped", "left out"
]
STATUSES: tuple[Status, ...] = typing.get_args(Status)


@dataclass(frozen=True)
class CellDifference:
    """One cell that differs."""

    gx: int
    gy: int
    found: CellValue
    expected: CellValue


@dataclass(frozen=True)
class Difference:
    """How one file of a map differs from what it is compared with.

    ``against`` is the reference port's name or ``golden``; ``count`` of ``total``
    values (cells, pixels or lines) differ and ``cells`` are the first of them;
    ``detail`` says the rest in words.
    """

    file: str
    against: str
    expected_file: str
    unit: str
    count: int
    total: int
    cells: list[CellDifference] = field(default_factory=list)
    detail: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class ProcessRecord:
    """One process of a port: what it was asked, and how it ended."""

    port: str
    mode: str
    scenarios: list[str]
    command: list[str]
    folder: str
    stdout: str
    stderr: str
    seconds: float
    time_limit: float
    exit_status: int | None
    timed_out: bool


@dataclass(frozen=True)
class Result:
    """One port, one scenario, one mode.

    ``left out``: the port's declaration says that it is too slow for this one (see Port.plain_scans).

    ``process`` is the index of its process in the run's list; ``compared_with`` says
    which results it was held against (the reference port compares with golden only).
    """

    port: str
    scenario: str
    mode: str
    status: Status
    reason: str = ""
    process: int | None = None
    picture: str | None = None
    width: int | None = None
    height: int | None = None
    compared_with: list[str] = field(default_factory=list)
    differences: list[Difference] = field(default_factory=list)


@dataclass(frozen=True)
class PortRecord:
    """One port of the run. ``problem`` says why it ran nothing, where it did not."""

    name: str
    language: str
    reference: bool
    version: str | None = None
    build_seconds: float | None = None
    skipped: bool = False
    problem: str = ""


@dataclass(frozen=True)
class ScenarioRecord:
    """One scenario: ``name`` as the table shows it, ``map`` as its files are named."""

    name: str
    map: str
    file: str | None


@dataclass(frozen=True)
class RunRecord:
    """A whole run."""

    schema: int
    started: str
    seconds: float
    machine: str
    folder: str
    reference: str
    modes: list[str]
    ports: list[PortRecord]
    scenarios: list[ScenarioRecord]
    results: list[Result]
    processes: list[ProcessRecord]

    def result(self, port: str, scenario: str, mode: str) -> Result:
        """The result of that port, scenario and mode; KeyError without one."""
        for result in self.results:
            if (result.port, result.scenario, result.mode) == (
                port,
                scenario,
                mode,
            ):
                return result
        raise KeyError((port, scenario, mode))

    def counts(self) -> dict[Status, int]:
        """How many results have each status."""
        return {s: sum(r.status == s for r in self.results) for s in STATUSES}

    def is_identical(self, allow_skipped: bool = False) -> bool:
        """Whether every result is ``identical`` or left out (or skipped, where that is allowed).

        A run in which nothing was compared with anything is not.
        """
        allowed = {"identical", "left out"}
        if allow_skipped:
            allowed.add("skipped")
        return all(
            result.status in allowed for result in self.results
        ) and any(result.compared_with for result in self.results)


def to_json(record: RunRecord) -> str:
    """The record as JSON text."""
    return json_text(record)


def from_json(text: str) -> RunRecord:
    """The record in JSON text. Raises ValueError where it is of another schema."""
    data = json.loads(text)
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        found = data.get("schema") if isinstance(data, dict) else None
        raise ValueError(f"a record of schema {found!r}, expected {SCHEMA}")
    try:
        record = from_plain(RunRecord, data)
    except (KeyError, TypeError) as error:
        raise ValueError(
            f"not a record of schema {SCHEMA}: {error}"
        ) from error
    assert isinstance(record, RunRecord)
    return record
