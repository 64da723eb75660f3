"""The time that a program has had: without that in which it could have run, and others had the processor.

Only Linux says how long a thread has waited for a processor. Elsewhere all of the time counts.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from pathlib import Path

COUNTED = 0.1  # share of the time that counts even where a program says that it always waits
PROCESSORS = os.cpu_count() or 1


class OwnTime:
    """The time since the start, as far as it counts; ``look`` at the processes of the program now and then."""

    def __init__(self) -> None:
        self.looked = time.monotonic()
        self.before = 0.0
        self.times: dict[str, tuple[int, int]] = {}

    @property
    def seconds(self) -> float:
        """What counts so far; since the last look, all does."""
        return self.before + time.monotonic() - self.looked

    def look(self, pids: Iterable[int]) -> None:
        """Takes off what the thread that has waited longest since the last look has waited.

        Threads of the program that wait for each other take nothing off: it has had the processors that they ran on.
        """
        now = time.monotonic()
        times = {task: (ran, wait) for task, ran, wait in thread_times(pids)}
        ran, longest = 0, 0
        for task, (own_ran, own_wait) in times.items():
            ran_before, wait_before = self.times.get(task, (0, 0))
            ran += own_ran - ran_before
            longest = max(longest, own_wait - wait_before)
        passed = now - self.looked
        had = min(ran / 1e9 / PROCESSORS, passed)
        self.before += max(passed - longest / 1e9, had, COUNTED * passed)
        self.looked, self.times = now, times


def thread_times(pids: Iterable[int]) -> Iterator[tuple[str, int, int]]:
    """Each thread of the processes, and how many nanoseconds it has run, and has waited for a processor."""
    for pid in pids:
        try:
            tasks = list(Path(f"/proc/{pid}/task").iterdir())
        except OSError:
            continue
        for task in tasks:
            try:
                words = (task / "schedstat").read_bytes().split()
            except OSError:
                continue
            if len(words) > 1:
                yield task.name, int(words[0]), int(words[1])
