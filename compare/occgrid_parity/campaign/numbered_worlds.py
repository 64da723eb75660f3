"""The worlds of a campaign: seed and number say which scenario it is, and how it is mapped.

Worlds come in blocks, whose scenarios are mapped in one mode, so that a program that takes many is started once for a
block. The blocks go through the modes in turns: without noise and with it, by a port's fast version and by its plain
one.
"""

from __future__ import annotations

import random

from occgrid_parity.campaign.random_scenarios import scenario_text
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import LARGEST_SEED, Mode

BLOCK = 32


def world(seed: int, number: int) -> Case:
    """The scenario of a world."""
    text = scenario_text(number, seed)
    return Case(f"world-{number}", text.encode("ascii"))


def mode_of(seed: int, number: int) -> Mode:
    """How a world is mapped."""
    block = number // BLOCK
    source = random.Random(f"{seed} block {block}")
    noise = source.randint(0, LARGEST_SEED) if block % 2 else None
    return Mode(noise, plain=block % 4 > 1)


def blocks(first: int, count: int) -> list[range]:
    """The numbers of ``count`` worlds, a range for each block."""
    end = first + count
    found = []
    while first < end:
        last = min(end, (first // BLOCK + 1) * BLOCK)
        found.append(range(first, last))
        first = last
    return found
