"""One verdict from those on the suite and on the instructor's scenarios, and what a student sees of it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from occgrid_parity.check.levels import FILE, ORIENTATION, RUNS
from occgrid_parity.check.verdict import Level, Overall, Verdict

FIRST = (RUNS[0], FILE[0], ORIENTATION[0])
ORDER: tuple[Overall, ...] = ("identical", "edges", "differs", "failed")


def one_level(verdict: Verdict, name: str, title: str) -> Level:
    """What a verdict says about a few scenarios, as one level."""
    failed = verdict.failed_level
    levels = [x for x in verdict.levels if x.name not in FIRST]
    cases = [case for level in levels for case in level.cases]
    if failed is not None:
        return Level(name, title, "failed", failed.word, failed.message, cases)
    statuses = [level.status for level in levels]
    said = "; ".join(level.message for level in levels if level.message)
    for status in ("edges", "halves", "identical"):
        if status in statuses:
            return Level(name, title, status, message=said, cases=cases)
    return Level(name, title, "not checked", message=said)


def merged(
    first: Verdict, others: Sequence[tuple[Level, Verdict]], hidden: str
) -> Verdict:
    """The first verdict with a level for each of the others.

    ``hidden`` begins the titles of levels whose details a student must not see.
    """
    whole = replace(
        first,
        levels=[*first.levels, *(level for level, _ in others)],
        runs=first.runs + sum(v.runs for _, v in others),
        seconds=round(first.seconds + sum(v.seconds for _, v in others), 3),
        notes=list(
            dict.fromkeys(
                [*first.notes, *(n for _, v in others for n in v.notes)]
            )
        ),
        not_checked=list(
            dict.fromkeys(
                [
                    *first.not_checked,
                    *(n for _, v in others for n in v.not_checked),
                ]
            )
        ),
    )
    for level, verdict in others:
        if ORDER.index(verdict.overall) <= ORDER.index(whole.overall):
            continue
        secret = level.title.startswith(hidden)
        whole = replace(whole, overall=verdict.overall)
        if whole.first_difference is None and verdict.exit_status != 0:
            whole = replace(
                whole,
                summary=f"{level.title}: {level.word}"
                if secret
                else f"{level.title}: {verdict.summary}",
                first_difference=None if secret else verdict.first_difference,
                cause=None if secret else verdict.cause,
            )
    return whole


def for_student(verdict: Verdict, hidden: Collection[str]) -> Verdict:
    """The verdict without the details of hidden levels."""
    return replace(
        verdict,
        levels=[
            replace(level, name="hidden", message="", cases=[])
            if level.name in hidden
            else level
            for level in verdict.levels
        ],
    )
