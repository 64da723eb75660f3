"""One self-contained HTML page of a run: the matrix, and each case down to the cell."""

from __future__ import annotations

import functools
import json
from collections import Counter
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from importlib import resources
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from occgrid_parity.compare.run_record import RunRecord, to_json
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.report.case_views import CaseView, case_views
from occgrid_parity.report.run_table import footnotes, summary

PAGE_FILE = "index.html"


def write_page(record: RunRecord, run_folder: Path, target: Path) -> Path:
    """Write the page of a run into a folder, which is made where it is missing.

    ``run_folder`` holds the maps of the record. Returns the page's file.
    """
    page = target / PAGE_FILE
    text = render(
        "page.html",
        record,
        case_views(record, run_folder),
        footnotes(record),
        summary=summary(record),
    )
    target.mkdir(parents=True, exist_ok=True)
    write_text(page, text)
    write_text(target / "run.json", to_json(record))
    return page


@functools.cache
def environment() -> Environment:
    """The templates."""
    made = Environment(
        loader=PackageLoader("occgrid_parity.report", "assets"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters["moment"] = _moment
    return made


def _moment(text: str) -> str:
    """A time of a record, as people write it."""
    return (
        datetime.fromisoformat(text)
        .astimezone(UTC)
        .strftime("%Y-%m-%d %H:%M UTC")
    )


def render(
    template: str,
    record: RunRecord,
    cases: Iterable[CaseView],
    footnotes: Sequence[str],
    start: str = "",
    **more: object,
) -> str:
    """The page as text; nothing in it is loaded from elsewhere.

    ``start`` is JSON: number (of a case), port, gx and gy of what to show first; empty: the first failure. ``more``
    is what the template wants beside the maps.
    """
    shown = sorted(enumerate(cases), key=lambda item: not item[1].failed)
    failed = Counter(case.mode.name for _, case in shown if case.failed)
    return (
        environment()
        .get_template(template)
        .render(
            record=record,
            cases=[(number, case) for number, case in shown],
            data={
                number: _json(_case(record, case)) for number, case in shown
            },
            failed=failed,
            footnotes=footnotes,
            start=start,
            style=Markup(asset("page.css")),
            script=Markup(asset("page.js")),
            **more,
        )
    )


def asset(name: str) -> str:
    """A file of the page's own."""
    return (
        resources.files("occgrid_parity.report") / "assets" / name
    ).read_text(encoding="utf-8")


def _json(data: Any) -> Markup:
    """JSON inside a script element: no text in it can end the element."""
    return Markup(
        json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
    )


def _case(record: RunRecord, case: CaseView) -> dict[str, Any]:
    """A case as the page's script wants it."""
    spec = case.spec
    return {
        "scenario": case.scenario,
        "mode": case.mode.name,
        "reference": record.reference,
        "resolution": None if spec is None else spec.resolution,
        "origin": None if spec is None else [spec.origin_x, spec.origin_y],
        "walls": case.walls,
        "partial": case.partial,
        "ports": [
            {
                "name": port.result.port,
                "words": port.words,
                "map": port.map,
                "shown": port.shown,
                "tone": port.tone,
            }
            for port in case.ports
        ],
        "maps": [drawn.packed for drawn in case.maps],
        "frames": None
        if case.frames is None
        else {
            "scans": case.frames.scans,
            "total": case.frames.total,
            "poses": case.frames.poses,
            "pixels": case.frames.pixels,
        },
    }
