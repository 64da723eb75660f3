"""What the tests with many programs share: what a program must lose, and how it is run quickly.

Programs are started without the supervisor, which has its own tests, and without the scenarios of the whole lesson but
for those that know nothing else, so that one program takes a second or two.
"""

from __future__ import annotations

import shutil
import subprocess
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

from ..check_helpers import names
from ..conftest import unavailable


class Expected(NamedTuple):
    """What a program must lose, and what must be said.

    ``lost`` are its levels without a point; ``causes`` those named, none where it is empty; ``said`` is a part of an
    observation, of a note or of the summary; ``where`` scan and beam of the first difference, if it matters.
    """

    lost: str = ""
    causes: str = ""
    said: str = ""
    where: tuple[int, int] | None = None


SHORT = [p for p in levels.LEVELS if {*p.scenarios} - {TWIN, LESSON}]
EVERY = " ".join(plan.name for plan in SHORT)
QUIET = " ".join(plan.name for plan in SHORT if not plan.noisy)


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


@pytest.fixture
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
    if expected.where is not None:
        found = verdict.first_difference
        assert found is not None and found.how == "runs"
        assert (found.scan, found.beam) == expected.where
        assert found.runs <= 15
    said = [verdict.summary, *verdict.observations, *verdict.notes]
    assert any(expected.said in text for text in said), said
