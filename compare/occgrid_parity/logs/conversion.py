"""What to make of a log: which scans, on what grid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple

from occgrid_parity.formats.errors import MAX_CELLS


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

    ``resolution``, ``max_range`` and ``margin`` are metres. ``parameters`` are further
    occgrid_ parameters by name, as they are to stand in the file.
    """

    log: Path
    output: Path
    resolution: Decimal = Decimal("0.1")
    max_range: Decimal = Decimal(30)
    margin: Decimal = Decimal(1)
    max_cells: int = MAX_CELLS
    selection: Selection = ALL_SCANS
    all_lines: bool = False
    parameters: Mapping[str, str] = field(default_factory=dict)
