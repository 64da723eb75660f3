"""Tells how far a run is."""

from __future__ import annotations

from typing import Protocol


class Progress(Protocol):
    """Is told how far a run is."""

    def total(self, steps: int) -> None:
        """How many steps are still to come."""

    def begin(self, name: str) -> None:
        """Work on something has begun."""

    def end(self, name: str) -> None:
        """That work is over."""

    def step(self, text: str) -> None:
        """One step is done; the text says which and how it ended."""


class Silent:
    """Progress that nobody looks at."""

    def total(self, steps: int) -> None:
        """Says nothing."""

    def begin(self, name: str) -> None:
        """Says nothing."""

    def end(self, name: str) -> None:
        """Says nothing."""

    def step(self, text: str) -> None:
        """Says nothing."""
