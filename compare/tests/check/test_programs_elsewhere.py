"""Programs in Python, JavaScript, Perl, awk and the shell: points lost, what is seen, causes named."""

from __future__ import annotations

import sys

import pytest

from occgrid_parity.suite.cases import scenario_folder

from ..check_helpers import PROGRAMS, check_words
from .many_programs import EVERY, QUIET, Expected, hold, need, quick, short

__all__ = ["quick", "short"]
pytestmark = [pytest.mark.usefixtures("quick"), pytest.mark.long]

# NumPy, with the lesson only
NUMPY = {
    "none": Expected(),
    "fancy-index": Expected("lesson"),
    "linspace": Expected("lesson"),
    "noise": Expected("lesson", said="two runs of lesson, noise-free differ"),
    "own-noise": Expected("lesson", said="add noise to every range"),
    "index-error": Expected(
        "runs file orientation added rounding lesson", said="IndexError"
    ),
}

# JavaScript, without noise; the picture on standard output
JAVASCRIPT = {
    "none": Expected(),
    "last-hit": Expected("simulated"),
    "starts-at-zero": Expected("prior", "starts-at-zero"),
    "bitwise": Expected(
        "no-return clamping outside simulated recorded formats", "truncation"
    ),
    "round": Expected(QUIET, "index-rounded"),
    "equal": Expected(QUIET, "ties-with-equality-in-y"),
    "ceil": Expected(QUIET.removeprefix("one-beam "), "pixel-rounded-up"),
    "parse-float": Expected("no-return mixed formats", "infinity-ignored"),
    "least-for-all": Expected("mixed", "min-range-for-all"),
}

# Python without NumPy, the cells in a dictionary; without noise
DICTIONARY = {
    "none": Expected(),
    "floor-division": Expected("recorded", "index-by-floor-division"),
    "reciprocal": Expected("recorded", "index-by-reciprocal"),
    "min_range-unread": Expected("mixed", "min-range-unread"),
    "p0-unread": Expected("prior", "p0-unread"),
    "fov-unread": Expected("no-return simulated mixed", "fov-unread"),
    "one-beam": Expected("formats", said="ZeroDivisionError"),
    "elif": Expected(QUIET),
    "wall-fields": Expected("no-return outside simulated mixed formats"),
}

# Perl draws the contract's noise, too
PERL = {
    "none": Expected(),
    "truncation": Expected(
        "no-return clamping outside simulated recorded formats noise",
        "truncation",
        "",
        (2, 4),
    ),
    "ties": Expected(EVERY, "ties-with-equality-in-y", "", (0, 0)),
    "maxrange": Expected(
        "no-return simulated mixed formats noise mixed-noise",
        "max-range-occupied",
        "",
        (0, 1),
    ),
    "alsofree": Expected("added " + EVERY, "hit-also-free", "", (0, 0)),
    "heading": Expected(
        "no-return clamping prior outside simulated recorded mixed formats noise mixed-noise",
        "heading-ignored",
        "",
        (0, 0),
    ),
    "clamp": Expected("clamping prior powers", "no-clamp", "", (0, 2)),
    "flipped": Expected("orientation", "y-flipped y-axis-down", "", (0, 0)),
}

# awk draws no noise, and prints its picture
AWK = {
    "none": Expected(),
    "rounded": Expected(QUIET, "index-rounded", "", (0, 0)),
    "last": Expected("added " + QUIET, "last-cell-missed", "", (0, 0)),
    "prior": Expected("prior", "prior-not-subtracted", "", (0, 0)),
}


@pytest.mark.parametrize("bug", NUMPY)
def test_a_program_with_numpy(bug: str) -> None:
    program = PROGRAMS / "mapper_numpy.py"
    verdict = check_words(f"{sys.executable} {program} {bug} {{out}}")
    hold(verdict, NUMPY[bug])
    assert verdict.maximum == 6


@pytest.mark.parametrize("bug", JAVASCRIPT)
@pytest.mark.usefixtures("short")
def test_a_program_in_javascript(bug: str) -> None:
    need("node")
    verdict = check_words(f"node {PROGRAMS / 'mapper.js'} {bug} {{scenario}}")
    hold(verdict, JAVASCRIPT[bug])
    assert verdict.maximum == 17


@pytest.mark.parametrize("bug", DICTIONARY)
@pytest.mark.usefixtures("short")
def test_a_program_in_plain_python(bug: str) -> None:
    program = PROGRAMS / "mapper_dict.py"
    verdict = check_words(
        f"{sys.executable} {program} {bug} {{out}} {{scenario}}"
    )
    hold(verdict, DICTIONARY[bug])
    assert verdict.maximum == 17


@pytest.mark.parametrize("bug", PERL)
@pytest.mark.usefixtures("short")
def test_a_program_in_perl(bug: str) -> None:
    need("perl")
    command = f"perl {PROGRAMS / 'lesson.pl'} --bug {bug}"
    verdict = check_words(f"{command} {{mode}} --out {{out}} {{scenario}}")
    hold(verdict, PERL[bug])
    assert verdict.maximum == 19


@pytest.mark.parametrize("bug", AWK)
@pytest.mark.usefixtures("short")
def test_a_program_in_awk(bug: str) -> None:
    need("awk")
    program = PROGRAMS / "lesson.awk"
    verdict = check_words(f"awk -v bug={bug} -f {program} {{scenario}}")
    hold(verdict, AWK[bug])
    assert verdict.maximum == 17


def test_a_copy_of_the_suites_own_picture() -> None:
    """It reads no scenario, so it cannot be told from a right program; but its picture is no work of its own."""
    picture = scenario_folder() / "golden" / "lesson.noise-free.pgm"
    verdict = check_words(f"cp {picture} {{pgm}}")
    hold(verdict, Expected(said="byte for byte"))
