"""What the pages' tests take from the harness: maps with planted mistakes, and the full check's comparison."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from occgrid_parity.explain.closeness import compare_with_reference
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model import arithmetic
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import case
from occgrid_parity.suite.modes import Mode

__all__ = ["MISTAKES", "Mapper", "World", "arithmetic", "closeness", "world"]

Pixels = npt.NDArray[np.int64]


def world(name: str) -> World:
    """A scenario of the suite."""
    return world_of(case(name))


def closeness(name: str, pixels: Pixels) -> str:
    """What the full check says of a picture without noise: identical, halves, edges or differs."""
    observed = Observed(pixels.astype(np.uint16), None, "")
    return str(compare_with_reference(observed, case(name), Mode(None)).status)
