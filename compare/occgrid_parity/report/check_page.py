"""The page of a check: the verdict, and every map of the program beside the reference's."""

from __future__ import annotations

import functools
import json
import platform
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from occgrid.scenario import Scenario
from occgrid.sensor import Scan
from occgrid_parity.check.program_maps import ComparedMap, PartialMap
from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.check.verdict_text import (
    MARKS,
    beam_lines,
    cause_title,
    halves_words,
    how_text,
    place_text,
    verdict_status,
    verdict_word,
)
from occgrid_parity.check.wording import plural
from occgrid_parity.compare.cell_values import CellValue
from occgrid_parity.compare.run_record import (
    SCHEMA,
    PortRecord,
    Result,
    RunRecord,
    ScenarioRecord,
    Status,
)
from occgrid_parity.explain.findings import FirstDifference
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.report.case_views import (
    CaseView,
    DrawnMap,
    PortMap,
    Tone,
    place,
)
from occgrid_parity.report.frames import Frames, record_frames
from occgrid_parity.report.run_page import PAGE_FILE, render
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

KEPT = 32  # scenarios: their pictures are the same on all pages of a class
EXPECTED = "reference"
TONES: dict[str, Tone] = {
    "identical": "good",
    "passed": "good",
    "halves": "good",
    "edges": "near",
    "differs": "bad",
    "failed": "bad",
    "not checked": "off",
    "grey": "grey",
}


def write_check_page(
    verdict: Verdict,
    maps: Sequence[ComparedMap],
    target: Path,
    partial: Sequence[PartialMap] = (),
) -> Path:
    """Write the page of a check into a folder, made where it is missing; returns its file.

    ``maps`` are the maps that the check has compared, ``partial`` those of the first scans only.
    """
    difference = verdict.first_difference
    remarks = [f"not checked: {said}" for said in verdict.not_checked]
    remarks += [f"note: {said}" for said in verdict.notes]
    if any(level.status == "halves" for level in verdict.levels):
        remarks.insert(0, f"* {halves_words(verdict)}")
    start = _start(verdict, maps)
    text = render(
        "check.html",
        _record(verdict, maps),
        [_case(verdict, one, partial) for one in maps],
        ["reference: what the contract says, drawn by the Python port"],
        start,
        difference_shown="gx" in start,
        verdict=verdict,
        word=verdict_word(verdict),
        tone=TONES[verdict_status(verdict)],
        runs=plural(verdict.runs, "run"),
        cause_title=cause_title(verdict.cause) if verdict.cause else "",
        place=place_text(difference) if difference else "",
        how=how_text(difference) if difference else "",
        beam="\n".join(beam_lines(difference)) if difference else "",
        cell=_cell(difference) if difference else [],
        levels=[
            (level, MARKS[level.status], TONES[level.status], _said(level))
            for level in verdict.levels
        ],
        remarks=remarks,
    )
    target.mkdir(parents=True, exist_ok=True)
    page = target / PAGE_FILE
    write_text(page, text)
    return page


def _cell(difference: FirstDifference) -> list[tuple[str, str, str]]:
    """What is known of the cell of the first difference: name, expected, found."""
    expected, found = difference.expected, difference.found
    values = (
        ("P(occupied)", expected.probability, found.probability),
        ("log-odds", expected.log_odds, found.log_odds),
        ("its bits", _bits(expected), _bits(found)),
        ("pixel", expected.pixel, found.pixel),
    )
    return [
        (name, "" if a is None else str(a), "" if b is None else str(b))
        for name, a, b in values
        if a is not None or b is not None
    ]


def _bits(value: CellValue) -> str | None:
    return None if value.bits is None else f"0x{value.bits}"


def _said(level: Level) -> list[str]:
    """A level's message, a line for each of its maps where it is about several."""
    maps = [f"{x.scenario}, {x.mode}: {x.message}" for x in level.cases]
    lines = [said for said in maps if said in level.message]
    return lines if "; ".join(lines) == level.message else [level.message]


def _start(verdict: Verdict, maps: Sequence[ComparedMap]) -> str:
    """What the page shows first: the map of the first difference, else the first that differs, else the first."""
    difference = verdict.first_difference
    if difference is not None:
        for number, one in enumerate(maps):
            names = (one.case.name, one.mode.name)
            if names == (difference.scenario, difference.mode):
                return json.dumps(
                    {"number": number, "port": 1, **_beam(difference, one)}
                )
    wrong = [
        number
        for number, one in enumerate(maps)
        if one.compared.status == "differs"
    ]
    if not maps:
        return ""
    return json.dumps({"number": (wrong or [0])[0], "port": 1})


def _beam(difference: FirstDifference, one: ComparedMap) -> dict[str, object]:
    """The cell of the first difference, and the beam with the robot that it starts from, where they are known."""
    found: dict[str, object] = {"gx": difference.gx, "gy": difference.gy}
    if difference.scan is None:
        return found
    scan = world_of(one.case).scans[difference.scan]
    found["scan"] = difference.scan
    found["robot"] = scan.pose if isinstance(scan, Scan) else scan
    end = difference.endpoint
    if end is not None:
        found["end"] = [float(end.x), float(end.y)]
    return found


def _record(verdict: Verdict, maps: Sequence[ComparedMap]) -> RunRecord:
    """The check in the form of a run of two: the reference and the program."""
    names = list(dict.fromkeys(one.case.name for one in maps))
    modes = list(dict.fromkeys(one.mode.name for one in maps))
    return RunRecord(
        schema=SCHEMA,
        started=datetime.now(UTC).isoformat(timespec="seconds"),
        seconds=verdict.seconds,
        machine=f"{platform.system()} {platform.machine()}",
        folder="",
        reference=EXPECTED,
        modes=modes,
        ports=[
            PortRecord(EXPECTED, "the suite", reference=True),
            PortRecord(verdict.program, verdict.command, reference=False),
        ],
        scenarios=[ScenarioRecord(name, name, None) for name in names],
        results=[result for one in maps for result in _results(verdict, one)],
        processes=[],
    )


def _results(verdict: Verdict, one: ComparedMap) -> tuple[Result, Result]:
    """The reference's result, which is given, and the program's."""
    said = one.result.message
    status: Status = (
        "differs" if one.compared.status == "differs" else "identical"
    )
    key = (one.case.name, one.mode.name)
    return (
        Result(EXPECTED, *key, "identical"),
        Result(
            verdict.program,
            *key,
            status,
            reason=said,
            compared_with=[EXPECTED],
        ),
    )


def _case(
    verdict: Verdict, one: ComparedMap, partial: Sequence[PartialMap]
) -> CaseView:
    world = world_of(one.case)
    maps: list[DrawnMap] = []
    expected, found = _results(verdict, one)
    pixels = one.observed.pixels.astype(np.uint16)
    own = DrawnMap(pixels, one.observed.log_odds)
    words = [f"{one.case.name}, {one.mode.name}: {one.result.message}"]
    ports = [
        PortMap(
            expected,
            ["what the contract says"],
            place(maps, _reference(one.case, one.mode)),
            "expected",
            "good",
        ),
        PortMap(
            found,
            words,
            place(maps, own),
            MARKS.get(one.compared.status, one.compared.status),
            TONES[one.compared.status],
        ),
    ]
    first = {
        some.scans: place(
            maps,
            DrawnMap(
                some.observed.pixels.astype(np.uint16), some.observed.log_odds
            ),
        )
        for some in partial
        if (some.case.digest, some.mode) == (one.case.digest, one.mode)
    }
    return CaseView(
        scenario=one.case.name,
        mode=one.mode,
        about="",
        spec=world.settings.new_grid().spec,
        ports=ports,
        maps=maps,
        frames=_frames(one.case, one.mode, frozenset(first)),
        walls=[tuple(wall) for wall in world.walls],
        partial=first,
    )


@functools.lru_cache(KEPT)
def _reference(case: Case, mode: Mode) -> DrawnMap:
    drawn = reference_map(case, mode)
    return DrawnMap(drawn.pixels.astype(np.uint16), drawn.log_odds)


@functools.lru_cache(KEPT)
def _frames(case: Case, mode: Mode, wanted: frozenset[int]) -> Frames:
    world = world_of(case)
    scenario = Scenario(
        case.name, world.settings, list(world.walls), iter(world.scans)
    )
    return record_frames(scenario, mode.seed, wanted)
