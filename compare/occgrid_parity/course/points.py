"""What a submission is worth."""

from __future__ import annotations

import json
from typing import NamedTuple

from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.course.rules import NO_RULES, Rules
from occgrid_parity.report.gradescope import gradescope_json


class Score(NamedTuple):
    """Points of a submission, and how many there were to have."""

    points: float
    maximum: float


def results_json(verdict: Verdict, shown: Verdict, rules: Rules) -> str:
    """results.json in Gradescope's form, with the points of the rules.

    ``shown`` is the verdict as the student sees it.
    """
    results = json.loads(gradescope_json(shown))
    for level, test in zip(verdict.levels, results["tests"], strict=True):
        test["score"], test["max_score"] = _worth(level, rules)
        if rules != NO_RULES and not level.counts:
            test["status"] = "failed"
    results["score"] = sum(test["score"] for test in results["tests"])
    return json.dumps(results, indent=1) + "\n"


def score(verdict: Verdict, rules: Rules) -> Score:
    """The points of a verdict."""
    levels = [_worth(level, rules) for level in verdict.levels]
    return Score(
        sum(one.points for one in levels), sum(one.maximum for one in levels)
    )


def _worth(level: Level, rules: Rules) -> Score:
    """The points of a level; by rules, one that the command cannot be asked counts like one that was not reached."""
    worth = rules.points_of(level.name)
    counts = level.counts or rules != NO_RULES
    return Score(worth if level.good else 0.0, worth if counts else 0.0)
