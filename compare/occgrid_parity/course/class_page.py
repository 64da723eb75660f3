"""The pages of a class: one for each submission, and one that leads to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from urllib.parse import quote

from markupsafe import Markup

from occgrid_parity.check.verdict import Verdict
from occgrid_parity.check.verdict_text import (
    HALVES,
    MARKS,
    place_text,
    verdict_status,
    verdict_word,
)
from occgrid_parity.course.points import score
from occgrid_parity.course.rules import NO_RULES, Rules
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.report.check_page import TONES
from occgrid_parity.report.run_page import PAGE_FILE, asset, environment


@dataclass(frozen=True)
class Row:
    """A submission in the table; ``page`` is the address of its own page from here."""

    name: str
    page: str
    verdict: str
    tone: str
    points: str
    level: str
    place: str
    cause: str
    summary: str
    failed: bool


def write_class_page(
    submissions: Sequence[tuple[str, Verdict]],
    target: Path,
    total: int,
    rules: Rules = NO_RULES,
) -> Path:
    """Write the table of a class into a folder that holds the submissions' pages; returns its file.

    ``total`` is how many submissions there are, with those that are not checked yet.
    Failures come first; among them, and among the others, the order is the given one.
    """
    rows = sorted(
        (_row(name, verdict, rules) for name, verdict in submissions),
        key=lambda row: not row.failed,
    )
    text = (
        environment()
        .get_template("class.html")
        .render(
            rows=rows,
            total=total,
            good=sum(not row.failed for row in rows),
            causes=_causes(submissions),
            note=f"* {HALVES}"
            if any(row.verdict == MARKS["halves"] for row in rows)
            else "",
            started=datetime.now(UTC).isoformat(timespec="seconds"),
            style=Markup(asset("page.css")),
            script=Markup(asset("class.js")),
        )
    )
    target.mkdir(parents=True, exist_ok=True)
    page = target / PAGE_FILE
    write_text(page, text)
    return page


def _row(name: str, verdict: Verdict, rules: Rules) -> Row:
    points, maximum = score(verdict, rules)
    level, difference = verdict.failed_level, verdict.first_difference
    return Row(
        name=name,
        page=f"submissions/{quote(name)}/{PAGE_FILE}",
        verdict=verdict_word(verdict),
        tone=TONES[verdict_status(verdict)],
        points=f"{points:g} of {maximum:g}",
        level=level.title if level else "",
        place=f"{difference.scenario}, {difference.mode}: {place_text(difference)}"
        if difference
        else "",
        cause=" or ".join(_titles(verdict)),
        summary=verdict.summary,
        failed=verdict.exit_status != 0,
    )


def _titles(verdict: Verdict) -> list[str]:
    candidates = verdict.cause.candidates if verdict.cause else []
    return [one.title for one in candidates]


def _causes(
    submissions: Sequence[tuple[str, Verdict]],
) -> list[tuple[str, list[str]]]:
    """Mistakes, the most common first, with the submissions that have them."""
    found: dict[str, list[str]] = {}
    for name, verdict in submissions:
        if verdict.cause and verdict.cause.candidates:
            found.setdefault(" or ".join(_titles(verdict)), []).append(name)
    return sorted(found.items(), key=lambda item: (-len(item[1]), item[0]))
