"""What was measured, as JSON: one file for each part."""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from statistics import median
from typing import Any

from occgrid_bench.machine import machine
from occgrid_bench.statistics import deviation


@dataclass
class Series:
    """The seconds of one contestant, a value for each round."""

    name: str
    title: str
    group: str = "port"
    what: str = ""
    seconds: list[float] = field(default_factory=list)
    every: int = 1  # only each so-many-th scan was mapped, and the seconds are multiplied
    differing: int | None = None  # cells that differ from the contract's map
    skipped: str = ""  # why it was not measured
    extra: dict[str, float] = field(default_factory=dict)

    @property
    def median(self) -> float:
        return median(self.seconds)

    @property
    def spread(self) -> float:
        return deviation(self.seconds)


@dataclass
class Part:
    """One part of the benchmark: what, where, when, and how busy the machine was."""

    name: str
    title: str
    command: str
    rounds: int
    quick: bool
    series: list[Series] = field(default_factory=list)
    cells: int = 0  # crossed by the beams
    machine: dict[str, str] = field(default_factory=machine)
    started: str = field(
        default_factory=lambda: datetime.now(UTC).isoformat(timespec="seconds")
    )
    load_before: float = field(default_factory=lambda: os.getloadavg()[0])
    load_after: float = 0.0

    def find(self, name: str) -> Series | None:
        """A contestant that was measured."""
        return next(
            (s for s in self.series if s.name == name and s.seconds), None
        )

    def write(self, folder: Path) -> Path:
        """Write NAME.json."""
        self.load_after = os.getloadavg()[0]
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{self.name}.json"
        text = json.dumps(asdict(self), indent=1) + "\n"
        path.write_text(text, encoding="utf-8")
        return path


def read_part(path: Path) -> Part:
    """A part that was measured before."""
    values: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    values["series"] = [Series(**series) for series in values["series"]]
    return Part(**values)
