"""One cell of a map, in words that no reader can round."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class CellValue:
    """One cell of one map; None where the map at hand does not say."""

    pixel: int | None = None
    log_odds: str | None = None
    bits: str | None = None
    probability: str | None = None


def cell_value(pixel: int, log_odds: float) -> CellValue:
    """Pixel, log-odds with its bits, probability with six digits."""
    z = math.exp(-abs(log_odds))
    p = (1.0 if log_odds >= 0.0 else z) / (1.0 + z)
    word = int(np.float64(log_odds).view(np.uint64))
    return CellValue(pixel, repr(log_odds), f"{word:016x}", f"{p:.6g}")
