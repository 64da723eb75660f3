"""A class in two tables: a line for each submission, and one for each mistake."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass

from occgrid_parity.check.verdict import Verdict
from occgrid_parity.course.points import score
from occgrid_parity.course.rules import NO_RULES, Rules

SUMMARY = "summary.csv"
MISTAKES = "mistakes.csv"

COLUMNS = (
    "submission", "verdict", "points", "maximum", "level", "word", "summary", "scenario", "scan", "beam", "cause",
    "compared", "runs", "seconds",
)  # fmt: skip


@dataclass(frozen=True)
class Submission:
    """One folder of a class, and what came of it."""

    name: str
    verdict: Verdict


def summary_csv(
    submissions: Sequence[Submission], rules: Rules = NO_RULES
) -> str:
    """One line for each submission, with a column for each level."""
    names = list(
        dict.fromkeys(
            level.name for one in submissions for level in one.verdict.levels
        )
    )
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*COLUMNS, *(f"level: {name}" for name in names)])
    for one in submissions:
        v = one.verdict
        level, d = v.failed_level, v.first_difference
        points, maximum = score(v, rules)
        statuses = {x.name: x.word or x.status for x in v.levels}
        writer.writerow(
            [
                one.name,
                v.overall,
                f"{points:g}",
                f"{maximum:g}",
                level.name if level else "",
                level.word if level else "",
                v.summary,
                d.scenario if d else "",
                "" if d is None or d.scan is None else d.scan,
                "" if d is None or d.beam is None else d.beam,
                named_mistake(v),
                v.compared,
                v.runs,
                v.seconds,
                *(statuses.get(name, "") for name in names),
            ]
        )
    return text.getvalue()


def named_mistake(verdict: Verdict) -> str:
    """The mistakes that draw exactly the submission's maps; empty without one."""
    found = verdict.cause.candidates if verdict.cause else []
    return " or ".join(one.name for one in found)


def mistakes_csv(submissions: Sequence[Submission]) -> str:
    """How many have each mistake, the most common first."""
    found: dict[str, list[str]] = {}
    titles: dict[str, str] = {}
    for one in submissions:
        name = named_mistake(one.verdict)
        if name and one.verdict.cause:
            found.setdefault(name, []).append(one.name)
            titles[name] = " or ".join(
                c.title for c in one.verdict.cause.candidates
            )
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["mistake", "title", "count", "of", "submissions"])
    for name in sorted(found, key=lambda name: (-len(found[name]), name)):
        who = found[name]
        writer.writerow(
            [name, titles[name], len(who), len(submissions), " ".join(who)]
        )
    return text.getvalue()
