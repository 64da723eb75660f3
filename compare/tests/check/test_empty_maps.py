"""A program that draws nothing from one kind of scan is told so; empty maps of other sorts say nothing."""

from __future__ import annotations

import numpy as np
import pytest

from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.explain.seen import observations
from occgrid_parity.model.reference import reference_map
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import case
from occgrid_parity.suite.modes import NOISE_FREE


def evidence(name: str, empty: bool) -> Evidence:
    """The reference's map, or one of the prior alone."""
    pixels = reference_map(case(name), NOISE_FREE).pixels.astype(np.uint16)
    if empty:
        prior = np.full_like(pixels, 128)
        seen = Observed(prior, None, "")
        return Evidence(case(name), NOISE_FREE, seen, "differs")
    seen = Observed(pixels, None, "")
    return Evidence(case(name), NOISE_FREE, seen, "identical")


ALL = "one-beam octants prior robotlaser1 asymmetric flaser mixed"
EMPTY = "are empty: all cells have the same grey level, as if no scan had been read"
KIND = (
    f"your maps of one-beam, octants, prior and 1 more {EMPTY}. Their scans are all ROBOTLASER1 lines: your program "
    "draws nothing from these (SPEC.md section 5.3)"
)


@pytest.mark.parametrize(
    ("empty", "said"),
    [
        ("", []),
        (ALL, [f"your maps of one-beam, octants, prior and 4 more {EMPTY}"]),
        ("one-beam octants prior robotlaser1", [KIND]),
        ("one-beam octants prior", []),  # not all of the kind
        ("mixed flaser", []),  # more kinds than one
    ],
)
def test_empty_maps(empty: str, said: list[str]) -> None:
    maps = [evidence(name, name in empty.split()) for name in ALL.split()]
    assert observations(maps, reads_scenarios=True) == said
