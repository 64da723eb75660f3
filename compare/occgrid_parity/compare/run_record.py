"""What a run found, as plain data: JSON that every table and report is made from.

All paths in a record are relative to the folder of the run (its ``folder``), with
``/``. Doubles stand as the texts of their ``repr`` and of their 64 bits, so that no
reader of the JSON can round them.
"""

from __future__ import annotations

import dataclasses
import json
import os
import types
import typing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

SCHEMA = 1
RECORD_FILE = "run.json"

Status = Literal["identical", "differs", "error", "timeout", "skipped"]
STATUSES: tuple[Status, ...] = typing.get_args(Status)


@dataclass(frozen=True)
class CellValue:
    """One cell of one map; None where the map at hand does not say."""

    pixel: int | None = None
    log_odds: str | None = None
    bits: str | None = None
    probability: str | None = None


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
        """Whether every result is ``identical`` (or skipped, where that is allowed).

        A run in which nothing was compared with anything is not.
        """
        allowed = {"identical", "skipped"} if allow_skipped else {"identical"}
        return all(
            result.status in allowed for result in self.results
        ) and any(result.compared_with for result in self.results)


def to_json(record: RunRecord) -> str:
    """The record as JSON text."""
    return json.dumps(dataclasses.asdict(record), indent=1) + "\n"


def from_json(text: str) -> RunRecord:
    """The record in JSON text. Raises ValueError where it is of another schema."""
    data = json.loads(text)
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        found = data.get("schema") if isinstance(data, dict) else None
        raise ValueError(f"a record of schema {found!r}, expected {SCHEMA}")
    try:
        record = _value(RunRecord, data)
    except (KeyError, TypeError) as error:
        raise ValueError(
            f"not a record of schema {SCHEMA}: {error}"
        ) from error
    assert isinstance(record, RunRecord)
    return record


def _value(kind: Any, data: Any) -> Any:
    """Plain JSON data as a value of the annotated type."""
    if dataclasses.is_dataclass(kind) and isinstance(kind, type):
        hints = typing.get_type_hints(kind)
        return kind(
            **{key: _value(hints[key], value) for key, value in data.items()}
        )
    origin, arguments = typing.get_origin(kind), typing.get_args(kind)
    if origin is list:
        return [_value(arguments[0], item) for item in data]
    if origin is types.UnionType and data is not None:
        return _value(arguments[0], data)
    return data


def write_text(path: Path, text: str) -> None:
    """Writes a file under another name beside it and renames it when it is whole."""
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        part.write_text(text, encoding="utf-8", newline="\n")
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
