"""How fast this machine is right now, and time limits that fit it."""

from __future__ import annotations

import time
from functools import cache

# What the loop below takes on a desktop computer that has nothing else to do.
NOMINAL_SECONDS = 0.06
LOOPS = 1_000_000


@cache
def slowness() -> float:
    """How many times longer than on an idle desktop computer work takes here, from 1 up."""
    started = time.monotonic()
    total = 0
    for i in range(LOOPS):
        total += i & 3
    return max(1.0, (time.monotonic() - started) / NOMINAL_SECONDS)


def time_limit(seconds: float) -> float:
    """A limit for what takes well under ``seconds`` on an idle desktop computer.

    Three times what the measured speed asks for: the load may grow while the work is done.
    """
    return 3.0 * seconds * slowness()
