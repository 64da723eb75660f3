"""What was found out about a map that differs: the first difference and the likely cause."""

from __future__ import annotations

from dataclasses import dataclass, field

from occgrid_parity.compare.cell_values import CellValue


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
