"""Trials under watch: which lines they run, how long they take, and an end to those that do not end."""

from __future__ import annotations

import resource
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any

from occgrid_mutants.trials import Modules, Trial

Line = tuple[str, int]  # file and number


class TooLong(BaseException):
    """The time is over. Not an Exception, so that no port takes it for one of its own."""


@dataclass(frozen=True)
class Measured:
    """A trial of the port as it is."""

    trial: Trial
    lines: frozenset[Line]
    seconds: float  # of processor time

    @property
    def limit(self) -> float:
        """How long a changed port may take: much longer, since to be slow is no mistake."""
        return 2.0 + 20.0 * self.seconds


def measure(trial: Trial, modules: Modules) -> Measured:
    """Runs a trial with the port as it is, twice. Raises ValueError where that does not pass."""
    start = time.process_time()
    right = trial.right(modules)
    seconds = time.process_time() - start
    if not right:
        raise ValueError(f"the port as it is fails: {trial.name}")
    return Measured(trial, frozenset(_lines(trial, modules)), seconds)


def _lines(trial: Trial, modules: Modules) -> set[Line]:
    lines: set[Line] = set()
    code = modules["grid"].OccupancyGrid.update_cell.__code__
    folder = code.co_filename.rpartition("/")[0]

    def trace(
        frame: FrameType, event: str, _: Any
    ) -> Callable[..., Any] | None:
        name = frame.f_code.co_filename
        if not name.startswith(folder):
            return None
        if event == "line":
            lines.add((name, frame.f_lineno))
        return trace

    sys.settrace(trace)
    try:
        trial.right(modules)
    finally:
        sys.settrace(None)
    if not lines:
        raise ValueError(f"{trial.name} runs no line of the port")
    return lines


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raises TooLong after so much processor time, whatever else the machine does."""

    def end(number: int, frame: FrameType | None) -> None:
        raise TooLong

    before = signal.signal(signal.SIGPROF, end)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def bound_memory(mebibytes: int = 3072) -> None:
    """A changed size must not take the machine's memory."""
    resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20, mebibytes << 20))


def failure(measured: Measured, modules: Modules) -> str | None:
    """What is wrong with a changed port in a trial, or None where it does right."""
    try:
        with time_limit(measured.limit):
            right = measured.trial.right(modules)
    except TooLong:
        return "does not end"
    except Exception as error:
        return type(error).__name__
    return None if right else "differs"
