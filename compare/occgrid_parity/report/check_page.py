"""The page of a check: the verdict, and every map of the program beside the reference's."""

from __future__ import annotations

import json
import platform
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from occgrid.scenario import Scenario
from occgrid_parity.check.program_maps import ComparedMap
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.check.verdict_text import (
    HALVES,
    MARKS,
    beam_lines,
    how_text,
    place_text,
    verdict_status,
    verdict_word,
)
from occgrid_parity.check.wording import plural
from occgrid_parity.compare.run_record import (
    SCHEMA,
    PortRecord,
    Result,
    RunRecord,
    ScenarioRecord,
    Status,
)
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
from occgrid_parity.report.frames import record_frames
from occgrid_parity.report.run_page import PAGE_FILE, render

EXPECTED = "reference"
TONES: dict[str, Tone] = {
    "identical": "good",
    "passed": "good",
    "halves": "good",
    "edges": "near",
    "differs": "bad",
    "failed": "bad",
}


def write_check_page(
    verdict: Verdict, maps: list[ComparedMap], target: Path
) -> Path:
    """Write the page of a check into a folder, made where it is missing; returns its file.

    ``maps`` are the maps that the check has compared.
    """
    difference = verdict.first_difference
    remarks = [f"not checked: {said}" for said in verdict.not_checked]
    remarks += [f"note: {said}" for said in verdict.notes]
    if any(level.status == "halves" for level in verdict.levels):
        remarks.insert(0, f"* {HALVES}")
    text = render(
        "check.html",
        _record(verdict, maps),
        [_case(verdict, one) for one in maps],
        ["reference: what the contract says, drawn by the Python port"],
        _start(verdict, maps),
        verdict=verdict,
        word=verdict_word(verdict),
        tone=TONES[verdict_status(verdict)],
        runs=plural(verdict.runs, "run"),
        place=place_text(difference) if difference else "",
        how=how_text(difference) if difference else "",
        beam="\n".join(beam_lines(difference)) if difference else "",
        levels=[
            (level, MARKS[level.status], TONES.get(level.status, "off"))
            for level in verdict.levels
        ],
        remarks=remarks,
    )
    target.mkdir(parents=True, exist_ok=True)
    page = target / PAGE_FILE
    write_text(page, text)
    return page


def _start(verdict: Verdict, maps: list[ComparedMap]) -> str:
    """What the page shows first: the cell of the first difference, if its map is here."""
    difference = verdict.first_difference
    if difference is None:
        return ""
    for number, one in enumerate(maps):
        names = (one.case.name, one.mode.name)
        if names == (difference.scenario, difference.mode):
            cell = {"gx": difference.gx, "gy": difference.gy}
            return json.dumps({"number": number, "port": 1, **cell})
    return ""


def _record(verdict: Verdict, maps: list[ComparedMap]) -> RunRecord:
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


def _case(verdict: Verdict, one: ComparedMap) -> CaseView:
    world = world_of(one.case)
    drawn = reference_map(one.case, one.mode)
    maps: list[DrawnMap] = []
    expected, found = _results(verdict, one)
    pixels = one.observed.pixels.astype(np.uint16)
    own = DrawnMap(pixels, one.observed.log_odds)
    words = [f"{one.case.name}, {one.mode.name}: {one.result.message}"]
    ports = [
        PortMap(
            expected,
            ["what the contract says"],
            place(
                maps, DrawnMap(drawn.pixels.astype(np.uint16), drawn.log_odds)
            ),
            EXPECTED,
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
    scenario = Scenario(
        one.case.name, world.settings, list(world.walls), iter(world.scans)
    )
    return CaseView(
        scenario=one.case.name,
        mode=one.mode,
        about="",
        spec=world.settings.new_grid().spec,
        ports=ports,
        maps=maps,
        frames=record_frames(scenario, one.mode.seed),
    )
