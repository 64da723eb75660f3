"""Medians and spread."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median


def deviation(values: Sequence[float]) -> float:
    """The median absolute deviation from the median."""
    middle = median(values)
    return median(abs(value - middle) for value in values)


def ratio(values: Sequence[float], reference: Sequence[float]) -> float:
    """The median of value / reference of the same round, over the rounds that both have.

    A slow contestant has only the first rounds.
    """
    rounds = min(len(values), len(reference))
    pairs = zip(values[:rounds], reference[:rounds], strict=True)
    return median(value / other for value, other in pairs)
