"""What an edition lacks: nothing is left out without a word."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any


class IncompleteError(RuntimeError):
    """Parts of the handouts cannot be made here; the text names each of them."""

    def __init__(self, parts: Iterable[str]) -> None:
        self.parts = list(parts)
        lines = "".join(f"\n  {part}" for part in self.parts)
        super().__init__(
            f"incomplete:{lines}\n--partial builds without them, and says so in the text"
        )


def missing_measurements(facts: Mapping[str, Any]) -> list[str]:
    """What could not be measured, each with its reason."""
    story = facts["story"]
    parts = [
        f"the library of {row['name']}: {row['problem']}"
        for row in story["libraries"]
        if row["problem"]
    ]
    parts += [
        f"the lesson as written in {one['name']}: {one['problem']}"
        for one in story["not_drawn"]
    ]
    parts += [
        f"the maps of {port['name']}: {port['problem']}"
        for port in facts["ports"]
        if port["problem"]
    ]
    return parts
