"""A class in one table: a line of CSV for each submission."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass

from occgrid_parity.check.verdict import Verdict

SUMMARY = "summary.csv"


COLUMNS = (
    "submission", "verdict", "level", "word", "summary", "scenario", "scan", "beam", "cause", "compared",
    "runs", "seconds",
)  # fmt: skip


@dataclass(frozen=True)
class Submission:
    """One folder of a class, and what came of it."""

    name: str
    verdict: Verdict


def summary_csv(submissions: Sequence[Submission]) -> str:
    """One line for each submission."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for one in submissions:
        v = one.verdict
        level, d = v.failed_level, v.first_difference
        causes = [c.name for c in v.cause.candidates] if v.cause else []
        writer.writerow(
            [
                one.name,
                v.overall,
                level.name if level else "",
                level.word if level else "",
                v.summary,
                d.scenario if d else "",
                "" if d is None or d.scan is None else d.scan,
                "" if d is None or d.beam is None else d.beam,
                " or ".join(causes),
                v.compared,
                v.runs,
                v.seconds,
            ]
        )
    return text.getvalue()
