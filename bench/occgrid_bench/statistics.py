"""Medians and spread."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median


def deviation(values: Sequence[float]) -> float:
    """The median absolute deviation from the median."""
    middle = median(values)
    return median(abs(value - middle) for value in values)


def ratio(values: Sequence[float], reference: Sequence[float]) -> float:
    """The median over the rounds of value / reference of the same round."""
    return median(
        value / other for value, other in zip(values, reference, strict=False)
    )
