"""The levels about p_occ and p_free, about how grey values are rounded, and about how the log-odds are written.

Each of these mistakes shows in every map. So that it costs one level only, the other levels look at the maps as if it
were not there: they compare with the scenario that has the program's own probabilities, take a grey value halfway
between two levels on either side, or compare the pictures alone.
"""

from __future__ import annotations

from collections.abc import Sequence

from occgrid_parity.check.levels import ADDED, LOG_ODDS, ROUNDING
from occgrid_parity.check.program_maps import ComparedMap, ProgramMaps
from occgrid_parity.check.verdict import Level
from occgrid_parity.check.wording import listed, parameters
from occgrid_parity.explain.closeness import compare_with_reference
from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.explain.seen import log_odds_fault
from occgrid_parity.explain.single_updates import (
    has_single_updates,
    rounded_down,
    single_updates,
    with_parameters,
)


def check_added(maps: ProgramMaps, first: Sequence[ComparedMap]) -> Level:
    """What one update adds to a cell; ``first`` are the maps that are looked at."""
    if not first:
        return Level(*ADDED, "grey", message="there is no map to look at")
    wrong = [one for one in first if one.compared.status == "differs"]
    if not wrong:
        return Level(*ADDED, "passed")
    updates = single_updates([_evidence(one) for one in wrong])
    others = {one.name: one for one in updates if not one.is_right}
    own = {name: one.p for name, one in others.items() if one.p is not None}
    if own and all(_fits(one, own) for one in wrong):
        maps.take_own_parameters(own)
        message = (
            f"{listed([others[name].words for name in own])}. The other levels look at your maps with "
            f"{parameters(own)}"
        )
        return Level(*ADDED, "failed", "other probabilities", message)
    if len(wrong) < len(first) or any(
        has_single_updates(_evidence(one)) for one in wrong
    ):
        return Level(*ADDED, "passed")
    message = "your maps differ in other ways, too, so the probabilities cannot be read from them"
    return Level(*ADDED, "grey", message=message)


def check_rounding(_: ProgramMaps, first: Sequence[ComparedMap]) -> Level:
    """Whether cells with a probability of one half are rounded up: there no last bit of exp or log decides."""
    if not first:
        return Level(*ROUNDING, "grey", message="there is no map to look at")
    if not any(rounded_down(_evidence(one)) for one in first):
        return Level(*ROUNDING, "passed")
    message = (
        "cells that no beam has touched have grey level 127. Their value of (1 - p) * 255 is exactly 127.5, which "
        "rounds up to 128 (SPEC.md section 2.6)"
    )
    return Level(*ROUNDING, "failed", "rounding", message)


def check_log_odds(maps: ProgramMaps, first: Sequence[ComparedMap]) -> Level:
    """How the log-odds are written; not checked where the program writes none."""
    written = [one for one in first if one.observed.log_odds is not None]
    if not written:
        return Level(*LOG_ODDS, "not checked")
    message = log_odds_fault([_evidence(one) for one in written])
    if not message:
        return Level(*LOG_ODDS, "passed")
    maps.leave_log_odds_out()
    message += ". The other levels look at your pictures only"
    return Level(*LOG_ODDS, "failed", "log-odds", message)


def _evidence(one: ComparedMap) -> Evidence:
    return Evidence(one.case, one.mode, one.observed, one.compared.status)


def _fits(one: ComparedMap, own: dict[str, float]) -> bool:
    """Whether a map is that of the scenario with other probabilities, in its picture."""
    case = with_parameters(one.case, own)
    observed = one.observed
    compared = compare_with_reference(
        observed, case, one.mode, own_poses=not one.case.is_file
    )
    return compared.status != "differs"
