"""In how many cells a map is not the reference's: exactly, or only whether they are too many."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np

from occgrid_parity.explain.closeness import differing
from occgrid_parity.model.mapper_steps import Drawn
from occgrid_parity.model.reference import lowest_rows, reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

PART = 8  # so much of a map is drawn first


def wrong_cells(
    observed: Observed, case: Case, mode: Mode, enough: int = sys.maxsize
) -> int:
    """How many cells are wrong; where there are ``enough`` of them, that many or more.

    A map of the right size. Cells do not depend on each other, so a part of the map with enough wrong cells settles it.
    """
    rows = world_of(case).settings.height // PART
    if rows and enough < rows * observed.pixels.shape[1]:
        found = _lowest(observed, rows)
        wrong = count_wrong(found, lowest_rows(case, mode, rows))
        if wrong >= enough:
            return wrong
    return count_wrong(observed, reference_map(case, mode))


def count_wrong(observed: Observed, drawn: Drawn) -> int:
    """In how many cells two maps differ."""
    return int(np.count_nonzero(differing(observed, drawn)))


def _lowest(observed: Observed, rows: int) -> Observed:
    log_odds = observed.log_odds
    return replace(
        observed,
        pixels=observed.pixels[-rows:],
        log_odds=None if log_odds is None else log_odds[:rows],
    )
