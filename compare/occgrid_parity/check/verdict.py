"""What a check found, as plain data: JSON that the terminal's text and every report are made from.

Doubles stand as the texts of their ``repr`` and of their bits (see occgrid_parity.compare.run_record.CellValue).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from occgrid_parity.explain.findings import Cause, FirstDifference
from occgrid_parity.formats.json_records import json_text, record_from_json

SCHEMA = 1

LevelStatus = Literal[
    "identical",
    "halves",
    "edges",
    "passed",
    "failed",
    "not checked",
    "not reached",
]
Overall = Literal["identical", "edges", "differs", "failed"]


@dataclass(frozen=True)
class CaseResult:
    """One scenario in one mode: how its map compares with the reference's.

    ``edge_beams`` are [scan, beam] each; ``steps`` the program's own log-odds steps (free, occupied) where they are
    not the contract's.
    """

    scenario: str
    mode: str
    status: str
    seconds: float
    message: str = ""
    cells: int = 0
    total: int = 0
    halves: int = 0
    edge_beams: list[list[int]] = field(default_factory=list)
    steps: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Level:
    """One step of the check; ``word`` says in a word or two what failed."""

    name: str
    title: str
    status: LevelStatus
    word: str = ""
    message: str = ""
    cases: list[CaseResult] = field(default_factory=list)


@dataclass(frozen=True)
class Verdict:
    """A whole check."""

    schema: int
    program: str
    command: str
    overall: Overall
    summary: str
    compared: str
    seconds: float
    runs: int
    levels: list[Level]
    first_difference: FirstDifference | None = None
    cause: Cause | None = None
    not_checked: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def failed_level(self) -> Level | None:
        """The level that stopped the check."""
        return next((x for x in self.levels if x.status == "failed"), None)

    @property
    def exit_status(self) -> int:
        """0 where all that could be checked is as it should be, else 1."""
        return 0 if self.overall in ("identical", "edges") else 1


def to_json(verdict: Verdict) -> str:
    """The verdict as JSON text."""
    return json_text(verdict)


def from_json(text: str) -> Verdict:
    """The verdict in JSON text. Raises ValueError where it is of another schema."""
    return record_from_json(Verdict, SCHEMA, text)
