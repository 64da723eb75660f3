"""What to make of a log: which scans, on what grid."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple, Protocol

from occgrid.sensor import Scan
from occgrid_parity.formats.errors import MAX_CELLS

MAX_RANGE = Decimal(30)
"""Metres; where neither the user nor the log says another."""


class ConversionError(ValueError):
    """A log that makes no scenario; the text is ``FILE:LINE: reason`` or tells what to change."""


class Selection(NamedTuple):
    """Which scans of a log are kept: every ``every``-th of first .. last - 1."""

    first: int = 0
    last: int | None = None
    every: int = 1

    def holds(self, scan: int) -> bool:
        """Whether that scan (numbered from 0) is kept."""
        below = self.last is None or scan < self.last
        return (
            self.first <= scan
            and below
            and (scan - self.first) % self.every == 0
        )


ALL_SCANS = Selection()


@dataclass(frozen=True)
class Request:
    """What to make of a log.

    ``resolution``, ``max_range``, ``min_range`` and ``margin`` are metres; without ``max_range`` it is
    30 m, or the sensor's own where a bag states a smaller one. ``parameters`` are further occgrid_
    parameters by name, as they are to stand in the file. ``topic`` and ``frame`` are for bags: the topic
    of the scans, and the frame that the map is drawn in.
    """

    log: Path
    output: Path
    resolution: Decimal = Decimal("0.1")
    max_range: Decimal | None = None
    min_range: Decimal = Decimal(0)
    margin: Decimal = Decimal(1)
    max_cells: int = MAX_CELLS
    selection: Selection = ALL_SCANS
    all_lines: bool = False
    parameters: Mapping[str, str] = field(default_factory=dict)
    topic: str | None = None
    frame: str | None = None


class Entry(NamedTuple):
    """A line of the scenario, without its end, and the scan in it where it has one."""

    text: bytes
    scan: Scan | None


class Source(Protocol):
    """A log of some kind. It is gone through once, and never held."""

    max_range: Decimal
    """Metres, for the scenario; set once entries() has given its first one."""

    def entries(self) -> Iterator[Entry]:
        """The chosen scans, and other lines where they are wanted, in order.

        Raises ConversionError or occgrid.scenario.ScenarioError where the log breaks a rule.
        """

    def total(self) -> int:
        """How many scans it has, chosen or not; to be asked after entries()."""

    def notes(self) -> list[str]:
        """What was taken and what was passed over, a line each; to be asked after entries()."""

    def warnings(self) -> list[str]:
        """What the user may have to look at, a line each; to be asked after entries()."""
