"""The time that a program has had: without that in which it could have run, and others had the processor.

Only Linux says how long a thread has waited for a processor. Elsewhere all of the time counts.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from pathlib import Path

COUNTED = 0.1  # share of the time that counts even where a program says that it always waits


class OwnTime:
    """The time since the start, as far as it counts; ``look`` at the processes of the program now and then."""

    def __init__(self) -> None:
        self.looked = time.monotonic()
        self.before = 0.0
        self.waits: dict[str, int] = {}

    @property
    def seconds(self) -> float:
        """What counts so far; since the last look, all does."""
        return self.before + time.monotonic() - self.looked

    def look(self, pids: Iterable[int]) -> None:
        """Takes off what the thread that has waited longest since the last look has waited."""
        now = time.monotonic()
        waits = {task: wait for task, _, wait in thread_times(pids)}
        longest = max(
            (wait - self.waits.get(task, 0) for task, wait in waits.items()),
            default=0,
        )
        passed = now - self.looked
        self.before += max(passed - longest / 1e9, COUNTED * passed)
        self.looked, self.waits = now, waits


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
