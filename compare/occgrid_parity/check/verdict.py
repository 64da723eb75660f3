"""What a check found, as plain data: JSON that the terminal's text and every report are made from.

Doubles stand as the texts of their ``repr`` and of their bits (see occgrid_parity.compare.run_record.CellValue).
"""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field
from typing import Literal

from occgrid_parity.compare.run_record import CellValue, _value

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
class BeamCell:
    """A cell of a beam; ``kind`` is free or occupied."""

    gx: int
    gy: int
    kind: str


@dataclass(frozen=True)
class Endpoint:
    """Where the contract's beam ends, metres: 17 digits and hexadecimal; its distance from the nearest cell edge.

    ``rounding`` is the bound on what rounding can move it, metres.
    """

    x: str
    y: str
    x_hex: str
    y_hex: str
    range: str
    hit: bool
    edge_distance: float
    rounding: float


@dataclass(frozen=True)
class FirstDifference:
    """Where a program's map first differs.

    ``how`` is "runs" where the program was run on shortened scenarios, "deduced" where only finished maps were
    looked at; then ``scan`` and ``beam`` are the earliest that can be at fault. ``candidates`` are beams of the scan
    of which one is at fault, where ``beam`` is None. ``patch`` is the drawing of the cells around the difference.
    """

    scenario: str
    mode: str
    how: str
    runs: int
    scan: int | None
    beam: int | None
    gx: int
    gy: int
    found: CellValue
    expected: CellValue
    candidates: list[int] = field(default_factory=list)
    endpoint: Endpoint | None = None
    expected_cells: list[BeamCell] = field(default_factory=list)
    found_cells: list[BeamCell] = field(default_factory=list)
    patch: list[str] = field(default_factory=list)
    scenario_file: str | None = None
    command: str = ""
    undetermined: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Likely:
    """A mistake of the catalogue that draws the program's maps."""

    name: str
    title: str
    lesson: str
    where: str


@dataclass(frozen=True)
class Cause:
    """The mistakes that reproduce the program's maps; empty where none does.

    ``maps`` are those that were compared ("octants, noise-free"); ``arithmetic`` is portable or platform, whichever
    sines and logarithms reproduce them; ``message`` says the rest in words.
    """

    candidates: list[Likely]
    maps: list[str]
    tried: int
    arithmetic: str = ""
    message: str = ""


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
    return json.dumps(dataclasses.asdict(verdict), indent=1) + "\n"


def from_json(text: str) -> Verdict:
    """The verdict in JSON text. Raises ValueError where it is of another schema."""
    data = json.loads(text)
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        raise ValueError(f"not a verdict of schema {SCHEMA}")
    try:
        verdict = _value(Verdict, data)
    except (KeyError, TypeError) as error:
        raise ValueError(
            f"not a verdict of schema {SCHEMA}: {error}"
        ) from error
    assert isinstance(verdict, Verdict)
    return verdict
