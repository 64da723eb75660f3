"""Who may begin: as many as there are processors for, and others while some of them only wait for a program.

A program that sleeps until its time is over would else keep a processor idle for two minutes. That costs nobody marks:
who has waited for a processor is given that time again (own_time.py). So it is done on Linux only.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import psutil

from occgrid_parity.processes.own_time import thread_times
from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.process_tree import descendants_quickly

SPARE = 2  # for each one at work, as many more can begin while it waits
LOOK = 0.2  # seconds between two looks whether to stop
SAMPLE = 1.0  # seconds between two looks at what processes do
IDLE = 3.0  # seconds in which a process and all that it has started do next to nothing, before others begin
BUSY = 0.1  # share of the time in which a thread runs or could run


def at_most(jobs: int) -> int:
    """How many pieces of work there are at a time at the most, with those that only wait."""
    return jobs * (1 + SPARE) if sys.platform == "linux" else jobs


class Turns:
    """Turns for pieces of work: ``jobs`` at a time, beside those that only wait.

    ``workers`` gives the numbers of the processes that work now.
    """

    def __init__(
        self, jobs: int, workers: Callable[[], Sequence[int]]
    ) -> None:
        self.jobs = jobs
        self.most = at_most(jobs)
        self.workers = workers
        self.taken = 0
        self.idleness = Idleness()
        self.change = threading.Condition()

    @contextmanager
    def turn(self, stop: threading.Event) -> Iterator[None]:
        """Waits for a turn, and has it. Raises Stopped when ``stop`` is set meanwhile."""
        with self.change:
            while self.taken >= self.jobs + self._waiting():
                if stop.is_set():
                    raise Stopped
                self.change.wait(LOOK)
            self.taken += 1
        try:
            yield
        finally:
            with self.change:
                self.taken -= 1
                self.change.notify()

    def _waiting(self) -> int:
        """How many of those that have a turn only wait, and may be doubled."""
        if self.most == self.jobs:
            return 0
        waiting = self.idleness.idle(self.workers())
        return min(waiting, self.most - self.jobs)


class Idleness:
    """Which processes have done next to nothing for a while, with all that they have started."""

    def __init__(self) -> None:
        self.sampled = time.monotonic()
        self.before: dict[str, int] = {}
        self.since: dict[int, float] = {}

    def idle(self, pids: Sequence[int]) -> int:
        """How many of the processes are idle."""
        now = time.monotonic()
        if now - self.sampled > SAMPLE:
            self._sample(pids, now)
        return sum(now - self.since.get(pid, now) > IDLE for pid in pids)

    def _sample(self, pids: Sequence[int], now: float) -> None:
        """Notes since when each of them is idle."""
        passed, self.sampled = now - self.sampled, now
        times: dict[str, int] = {}
        since: dict[int, float] = {}
        for pid in pids:
            own = {
                task: ran + waited
                for task, ran, waited in thread_times(_tree(pid))
            }
            busy = sum(
                spent - self.before.get(task, 0) for task, spent in own.items()
            )
            if busy < BUSY * passed * 1e9:
                since[pid] = self.since.get(pid, now)
            times |= own
        self.before, self.since = times, since


def _tree(pid: int) -> list[int]:
    """A process and whatever it has started."""
    try:
        found = descendants_quickly(psutil.Process(pid))
    except psutil.NoSuchProcess:
        return []
    return [pid, *(one.pid for one in found)]
