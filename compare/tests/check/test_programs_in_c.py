"""Programs in C, right ones and ones with one mistake each: points lost, what is seen, causes named.

No wrong program passes, no right one loses a point, and no cause is named that is not the mistake. A mistake costs the
levels whose maps it spoils, and no others.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from ..check_helpers import check_words
from .many_programs import EVERY, Expected, hold, quick, short

__all__ = ["quick", "short"]
pytestmark = pytest.mark.usefixtures("quick")

# the C mapper: it reads scenarios and draws the contract's noise
C = {
    "none": Expected(),
    "half-down": Expected("rounding", "pixel-half-down", "rounds up to 128"),
    "banner": Expected(said="before the picture"),
    "yaml": Expected(),
    "yaml-thresholds": Expected("yaml", said="occupied_thresh"),
    "prior": Expected("prior", "prior-not-subtracted"),
    "break-outside": Expected("outside", "robot-outside-skipped"),
    "limits-ten": Expected("clamping prior powers", "limits-of-ten"),
    "half-step": Expected(
        "no-return outside simulated mixed formats noise mixed-noise",
        "bearings-half-a-step-off",
    ),
    "fov-n": Expected(
        "no-return outside simulated mixed formats noise mixed-noise",
        "last-bearing-missing",
    ),
    "p-0.70": Expected("added", said="probability of 0.70"),
    "twice": Expected(
        "added prior powers formats", said="probability of 0.90"
    ),
    "log-odds": Expected(),
    "float": Expected("log-odds", said="single precision"),
    "digits": Expected("log-odds", said="6 significant digits"),
    "probabilities": Expected("log-odds", said="holds probabilities"),
    "base-10": Expected("added log-odds " + EVERY, said="to base 10"),
    "octant": Expected(
        "octants no-return prior simulated recorded mixed formats noise mixed-noise"
    ),
    "odometry": Expected("mixed mixed-noise", "odometry-for-pose"),
    "robot-pose": Expected("mixed mixed-noise", "robot-pose-for-laser"),
    "recorded-noise": Expected("mixed-noise", "noise-on-recorded-scans"),
    "scans-apart": Expected("mixed-noise", "simulated-scans-numbered-apart"),
    "no-half": Expected("noise", "noise-of-whole-words"),
    "no-noise": Expected("noise mixed-noise", "no-noise"),
    "step-n-1": Expected("recorded", "flaser-step-n-minus-1"),
    "flipped": Expected("orientation", "y-flipped y-axis-down"),
    "bare-param": Expected("formats", said="PARAM without a value"),
    "comment-anywhere": Expected(
        "mixed mixed-noise", said="wrong number of values"
    ),
    "maximum-100": Expected(
        EVERY.removeprefix("one-beam "), said="maximum is 100"
    ),
    "ros": Expected("added " + EVERY, said="0, 205 and 254"),
    "last-wall": Expected(
        "no-return outside simulated mixed formats noise mixed-noise"
    ),
    "coarse-parallel": Expected("simulated", "coarse-parallel-test"),
    "no-end": Expected("simulated"),
    "no-beginning": Expected("simulated"),
    "sign-clamp": Expected("clamping powers"),
    "short-range": Expected(
        "no-return simulated recorded mixed noise mixed-noise"
    ),
    "remissions": Expected("recorded formats"),
    "min-range": Expected("mixed", "min-range-unread"),
    "infinity": Expected("no-return mixed formats", "infinity-ignored"),
    "below-zero": Expected("noise", "noise-not-clamped"),
    "last-beam": Expected(EVERY, "last-beam-left-out"),
    "crash": Expected(
        "runs file orientation added rounding bad-input " + EVERY,
        said="SIGABRT",
    ),
    "first-scan": Expected(
        "one-beam octants no-return prior outside simulated recorded mixed formats noise mixed-noise bad-input",
        said="are exactly the reference's without the first scan",
    ),
    "half-file": Expected(
        "file orientation added rounding bad-input " + EVERY,
        said="half a file",
    ),
}

WITH_LOG_ODDS = ("log-odds", "float", "digits", "probabilities", "base-10")

# the C mapper, with the lesson it has built in and nothing else
C_LESSON = {
    "lesson-119": Expected("lesson", said="after 119 of 120 scans"),
    "lesson-from-1": Expected(
        "lesson",
        said="your map of lesson is exactly the reference's without the first scan",
    ),
    "lesson-even": Expected("lesson", said="every other scan (0, 2, 4, ...)"),
    "lesson-121": Expected(
        "lesson", said="the first pose once more at the end"
    ),
    "lesson-late": Expected("lesson", said="every pose one step late"),
    "lesson-reversed": Expected("lesson", said="the scans in reverse order"),
    "lesson-t-1": Expected("lesson", said="ang = 2 pi t / (T - 1)"),
    "lesson-whole": Expected("lesson", said="t / T is always 0"),
    "lesson-heading": Expected("lesson", said="the heading ang (it should be"),
    "lesson-backward": Expected("lesson", said="the heading ang - pi/2"),
    "lesson-circle": Expected("lesson", said="a circle of radius 4 m"),
    "lesson-wall": Expected(
        "lesson", said="without the wall from (-8, 2) to (-2, 2)"
    ),
}


@pytest.mark.parametrize("bug", C)
@pytest.mark.usefixtures("short")
def test_a_program_in_c(mapper: Path, bug: str) -> None:
    verdict = check_words(f"{mapper} {bug} {{mode}} {{out}} {{scenario}}")
    hold(verdict, C[bug])
    writes_more = bug.startswith("yaml") or bug in WITH_LOG_ODDS
    assert verdict.maximum == 19 + writes_more, "wherever it fails"


@pytest.mark.parametrize("bug", C_LESSON)
def test_a_program_in_c_that_knows_only_the_lesson(
    mapper: Path, bug: str
) -> None:
    verdict = check_words(f"{mapper} {bug} --noise-free {{out}}")
    hold(verdict, C_LESSON[bug])
    assert verdict.maximum == 6
