"""What a report shows: a case is one scenario in one mode, with every port's map."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from occgrid.grid import GridSpec
from occgrid.scenario import ScenarioError
from occgrid_parity.compare.run_record import (
    Result,
    RunRecord,
    ScenarioRecord,
    Status,
)
from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.map_files import read_map
from occgrid_parity.report.frames import Frames, lesson_or_file, record_frames
from occgrid_parity.report.packing import pack, pack_log_odds
from occgrid_parity.report.run_table import explain_result, shown_status
from occgrid_parity.suite.modes import Mode, parse_mode


@dataclass(frozen=True)
class DrawnMap:
    """What is shown of a map.

    ``pixels`` (height, width), largest y first; ``log_odds`` the same shape, smallest
    y first, None where the program writes none.
    """

    pixels: NDArray[np.unsignedinteger]
    log_odds: NDArray[np.float64] | None

    @functools.cached_property
    def packed(self) -> dict[str, int | str | None]:
        """The map as the page's script wants it."""
        height, width = self.pixels.shape
        own = self.log_odds
        return {
            "width": int(width),
            "height": int(height),
            "pixels": pack(self.pixels.astype(np.uint8).tobytes()),
            "logOdds": None if own is None else pack_log_odds(own),
        }


Tone = Literal["good", "near", "bad", "off", "grey"]
ORDER: tuple[Tone, ...] = ("bad", "near", "good", "grey", "off")
TONES: dict[Status, Tone] = {
    "identical": "good",
    "skipped": "off",
    "left out": "off",
}


@dataclass(frozen=True)
class PortMap:
    """One port in one case: its result, in words, and the map that it drew.

    ``map`` is an index into the case's maps, None where the port drew none.
    ``shown`` stands in the table, on a ground of the colour that ``tone`` means.
    """

    result: Result
    words: list[str]
    map: int | None
    shown: str
    tone: Tone


@dataclass(frozen=True)
class CaseView:
    """One scenario in one mode. ``maps`` has each different map once, the reference's first.

    ``about`` is the scenario's own first comment, ``walls`` x0, y0, x1, y1 each. ``frames`` are the reference's
    pictures as the scans come in, None where there is nothing to show. ``partial`` are maps that were drawn of the
    first scans only: how many, and the index of the map.
    """

    scenario: str
    mode: Mode
    about: str
    spec: GridSpec | None
    ports: list[PortMap]
    maps: list[DrawnMap] = field(default_factory=list)
    frames: Frames | None = None
    walls: list[tuple[float, ...]] = field(default_factory=list)
    partial: dict[int, int] = field(default_factory=dict)

    @property
    def worst(self) -> PortMap:
        """What the case is known by: its worst map, of equals the last."""
        return min(reversed(self.ports), key=lambda one: ORDER.index(one.tone))

    @property
    def failed(self) -> bool:
        """Whether any port did anything but draw the expected map."""
        return any(port.tone == "bad" for port in self.ports)


def case_views(record: RunRecord, folder: Path) -> Iterator[CaseView]:
    """The cases of a run, one at a time; ``folder`` is the run's, wherever it lies now.

    A map that cannot be read is left out: its result says why already.
    """
    for scenario in record.scenarios:
        for mode in record.modes:
            yield _case(record, folder, scenario, parse_mode(mode))


def _case(
    record: RunRecord, folder: Path, scenario: ScenarioRecord, mode: Mode
) -> CaseView:
    results = [
        record.result(port.name, scenario.name, mode.name)
        for port in record.ports
    ]
    maps: list[DrawnMap] = []
    ports = {}
    # the reference first: what it drew is what is expected
    for result in sorted(results, key=lambda r: r.port != record.reference):
        found = _read(folder, result, scenario.map)
        index = None if found is None else place(maps, found)
        ports[result.port] = PortMap(
            result,
            explain_result(result),
            index,
            shown_status(result),
            TONES.get(result.status, "bad"),
        )
    about, spec, walls, frames = _scenario(scenario, mode)
    return CaseView(
        scenario=scenario.name,
        mode=mode,
        about=about,
        spec=spec,
        ports=[ports[result.port] for result in results],
        maps=maps,
        frames=frames if maps else None,
        walls=walls,
    )


def _read(folder: Path, result: Result, name: str) -> DrawnMap | None:
    if result.picture is None:
        return None
    try:
        found = read_map((folder / result.picture).parent, name)
    except OutputError:
        return None
    return DrawnMap(found.pixels, found.log_odds)


def place(maps: list[DrawnMap], found: DrawnMap) -> int:
    """The index of a map among the different ones; it is added where it is new."""
    for index, known in enumerate(maps):
        if _same(known.pixels, found.pixels) and _same(
            known.log_odds, found.log_odds
        ):
            return index
    maps.append(found)
    return len(maps) - 1


def _same(
    a: NDArray[np.generic] | None, b: NDArray[np.generic] | None
) -> bool:
    if a is None or b is None:
        return a is b
    return a.shape == b.shape and a.tobytes() == b.tobytes()


def _scenario(
    scenario: ScenarioRecord, mode: Mode
) -> tuple[str, GridSpec | None, list[tuple[float, ...]], Frames | None]:
    """What a scenario says of itself, its grid, its walls and its frames, where it can be read."""
    path = None if scenario.file is None else Path(scenario.file)
    about = (
        "The lesson, as every port has it built in."
        if path is None
        else _first_comment(path)
    )
    spec: GridSpec | None = None
    walls: list[tuple[float, ...]] = []
    try:
        with lesson_or_file(path) as readable:
            spec = readable.settings.new_grid().spec
            walls = [tuple(wall) for wall in readable.walls]
            return about, spec, walls, record_frames(readable, mode.seed)
    except ScenarioError:
        return about, spec, walls, None


def _first_comment(path: Path) -> str:
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            line = file.readline(1000).strip()
    except OSError:
        return ""
    return line.removeprefix("#").strip() if line.startswith("#") else ""
