"""Programs in five languages, right ones and ones with one mistake each: points lost, what is seen, causes named.

No wrong program passes, no right one loses a point, and no cause is named that is not the mistake.

They are started without the supervisor, which has its own tests, and without the scenarios of the whole lesson but for
those that know nothing else, so that one program takes a second or two.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import pytest

from occgrid_parity.check import levels
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.processes.limits import Ended, Limits, what_went_wrong
from occgrid_parity.processes.wall import NONE
from occgrid_parity.suite.cases import LESSON, TWIN

from ..check_helpers import PROGRAMS, check_words, names
from ..conftest import unavailable


class Expected(NamedTuple):
    """What a program must lose, and what must be said.

    ``lost`` are its levels without a point; ``causes`` those named, none where it is empty; ``said`` is a part of an
    observation, of a note or of the summary.
    """

    lost: str = ""
    causes: str = ""
    said: str = ""


SHORT = [p for p in levels.LEVELS if {*p.scenarios} - {TWIN, LESSON}]
EVERY = " ".join(plan.name for plan in SHORT)
QUIET = " ".join(plan.name for plan in SHORT if not plan.noisy)

# the C mapper: it reads scenarios and draws the contract's noise
C = {
    "none": Expected(),
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
    "octant": Expected(
        "octants no-return prior simulated recorded formats noise mixed-noise"
    ),
    "odometry": Expected("mixed mixed-noise", "odometry-for-pose"),
    "robot-pose": Expected("mixed mixed-noise", "robot-pose-for-laser"),
    "recorded-noise": Expected("mixed-noise", "noise-on-recorded-scans"),
    "scans-apart": Expected("mixed-noise", "simulated-scans-numbered-apart"),
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
    "ros": Expected(EVERY, said="0, 205 and 254"),
    "twice": Expected(EVERY),
    "last-wall": Expected(
        "no-return outside simulated mixed formats noise mixed-noise"
    ),
    "sign-clamp": Expected("clamping powers"),
    "short-range": Expected(
        "no-return simulated recorded mixed noise mixed-noise"
    ),
    "remissions": Expected("recorded formats"),
    "crash": Expected(
        "runs file orientation bad-input " + EVERY, said="SIGABRT"
    ),
    "half-file": Expected(
        "file orientation bad-input " + EVERY, said="half a file"
    ),
}

# the C mapper, with the lesson it has built in and nothing else
C_LESSON = {
    "lesson-119": Expected("lesson", said="after 119 of 120 scans"),
}

# NumPy, with the lesson only
NUMPY = {
    "none": Expected(),
}

# JavaScript, without noise; the picture on standard output
JAVASCRIPT = {
    "none": Expected(),
    "last-hit": Expected("simulated"),
    "starts-at-zero": Expected("prior", "starts-at-zero"),
    "bitwise": Expected(
        "no-return clamping outside simulated recorded formats", "truncation"
    ),
    "ceil": Expected(QUIET.removeprefix("one-beam ")),
}

PERL = {
    "none": Expected(),
}

AWK = {
    "none": Expected(),
}


def light(
    command: Sequence[str],
    *,
    cwd: Path,
    folder: Path,
    watch: Path,
    limits: Limits,
    stop: threading.Event | None = None,
    **_: object,
) -> Ended:
    """Runs a command as run_limited does, without a watch over what it does."""
    folder.mkdir(parents=True, exist_ok=True)
    stdout, stderr = folder / "stdout", folder / "stderr"
    started = time.monotonic()
    with stdout.open("wb") as out, stderr.open("wb") as err:
        status = subprocess.run(
            command,
            cwd=cwd,
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=err,
            timeout=limits.seconds,
        ).returncode
    told = {"word": "", "status": status, "start_error": 0}
    word, message = what_went_wrong(
        told, command, limits, stdout, stderr, NONE
    )
    seconds = time.monotonic() - started
    return Ended(word, message, seconds, stdout, stderr, status=status)


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Programs start at once."""
    monkeypatch.setattr("occgrid_parity.programs.runner.run_limited", light)


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """The levels without the scenarios of the whole lesson."""
    plans = [
        replace(
            plan,
            scenarios=tuple(
                name for name in plan.scenarios if name not in (TWIN, LESSON)
            ),
        )
        for plan in levels.LEVELS
    ]
    kept = tuple(plan for plan in plans if plan.scenarios)
    monkeypatch.setattr(levels, "LEVELS", kept)


@pytest.fixture(scope="module")
def mapper(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The C mapper, built."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        unavailable("install gcc")
    target = tmp_path_factory.mktemp("c") / "mapper"
    options = ["-O2", "-ffp-contract=off", "-o", str(target)]
    source = str(PROGRAMS / "mapper.c")
    subprocess.run([str(compiler), *options, source, "-lm"], check=True)
    return target


def need(command: str) -> None:
    if shutil.which(command) is None:
        unavailable(f"install {command}")


def hold(verdict: Verdict, expected: Expected) -> None:
    """The verdict must be what was expected, in every point."""
    lost = {x.name for x in verdict.levels if x.counts and not x.good}
    assert lost == set(expected.lost.split())
    assert verdict.maximum - verdict.score == len(lost)
    assert verdict.exit_status == (1 if lost else 0)
    assert set(names(verdict)) == set(expected.causes.split())
    said = [verdict.summary, *verdict.observations, *verdict.notes]
    assert any(expected.said in text for text in said), said


@pytest.mark.parametrize("bug", C)
@pytest.mark.usefixtures("short")
def test_a_program_in_c(mapper: Path, bug: str) -> None:
    verdict = check_words(f"{mapper} {bug} {{mode}} {{out}} {{scenario}}")
    hold(verdict, C[bug])
    counted = 18 if bug.startswith("yaml") else 17
    assert verdict.maximum == counted, "wherever it fails"


@pytest.mark.parametrize("bug", C_LESSON)
def test_a_program_in_c_that_knows_only_the_lesson(
    mapper: Path, bug: str
) -> None:
    verdict = check_words(f"{mapper} {bug} --noise-free {{out}}")
    hold(verdict, C_LESSON[bug])
    assert verdict.maximum == 4


@pytest.mark.parametrize("bug", NUMPY)
def test_a_program_with_numpy(bug: str) -> None:
    program = PROGRAMS / "mapper_numpy.py"
    verdict = check_words(f"{sys.executable} {program} {bug} {{out}}")
    hold(verdict, NUMPY[bug])
    assert verdict.maximum == 4


@pytest.mark.parametrize("bug", JAVASCRIPT)
@pytest.mark.usefixtures("short")
def test_a_program_in_javascript(bug: str) -> None:
    need("node")
    verdict = check_words(f"node {PROGRAMS / 'mapper.js'} {bug} {{scenario}}")
    hold(verdict, JAVASCRIPT[bug])
    assert verdict.maximum == 15


@pytest.mark.parametrize("bug", PERL)
@pytest.mark.usefixtures("short")
def test_a_program_in_perl(bug: str) -> None:
    need("perl")
    command = f"perl {PROGRAMS / 'lesson.pl'} --bug {bug}"
    verdict = check_words(f"{command} {{mode}} --out {{out}} {{scenario}}")
    hold(verdict, PERL[bug])
    assert verdict.maximum == 17


@pytest.mark.parametrize("bug", AWK)
@pytest.mark.usefixtures("short")
def test_a_program_in_awk(bug: str) -> None:
    need("awk")
    program = PROGRAMS / "lesson.awk"
    verdict = check_words(f"awk -v bug={bug} -f {program} {{scenario}}")
    hold(verdict, AWK[bug])
    assert verdict.maximum == 15
