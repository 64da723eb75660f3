"""What a submission is worth."""

from __future__ import annotations

import json
from typing import NamedTuple

from occgrid_parity.check.verdict import Verdict
from occgrid_parity.course.rules import NO_RULES, Rules
from occgrid_parity.report.gradescope import gradescope_json


class Score(NamedTuple):
    """Points of a submission, and how many there were to have."""

    points: float
    maximum: float


def results_json(verdict: Verdict, shown: Verdict, rules: Rules) -> str:
    """results.json in Gradescope's form, with the points of the rules.

    ``shown`` is the verdict as the student sees it. Where there are rules, a level that the command cannot be asked
    counts like one that was not reached.
    """
    results = json.loads(gradescope_json(shown))
    for level, test in zip(verdict.levels, results["tests"], strict=True):
        worth = rules.points_of(level.name)
        if rules != NO_RULES and test["max_score"] == 0:
            test["max_score"] = 1.0
            test["status"] = "failed"
        test["score"] *= worth
        test["max_score"] *= worth
    results["score"] = sum(test["score"] for test in results["tests"])
    return json.dumps(results, indent=1) + "\n"


def score(verdict: Verdict, rules: Rules) -> Score:
    """The points of a verdict."""
    tests = json.loads(results_json(verdict, verdict, rules))["tests"]
    return Score(
        sum(test["score"] for test in tests),
        sum(test["max_score"] for test in tests),
    )
