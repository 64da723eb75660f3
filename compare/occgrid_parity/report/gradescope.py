"""results.json, as the Gradescope autograder reads it, from the verdict of a check."""

from __future__ import annotations

import json
from typing import Any

from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.check.verdict_text import MARKS, verdict_text


def gradescope_json(verdict: Verdict, points: float = 1.0) -> str:
    """One test per level, each worth ``points``; the whole verdict as the output.

    A level that cannot be judged gives no points. One that the command cannot be asked is worth none, for anybody.
    """
    tests = [_test(level, points) for level in verdict.levels]
    results = {
        "score": sum(test["score"] for test in tests),
        "execution_time": round(verdict.seconds, 1),
        "output": verdict_text(verdict),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "visible",
        "tests": tests,
    }
    return json.dumps(results, indent=1) + "\n"


def _test(level: Level, points: float) -> dict[str, Any]:
    said = [MARKS[level.status], level.word, level.message]
    return {
        "name": level.title,
        "score": points if level.good else 0.0,
        "max_score": points if level.counts else 0.0,
        **(
            {"status": "passed" if level.good else "failed"}
            if level.counts
            else {}
        ),
        "output": ": ".join(part for part in said if part),
        "output_format": "text",
    }
