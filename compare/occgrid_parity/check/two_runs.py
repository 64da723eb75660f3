"""Whether a program draws the same map twice."""

from __future__ import annotations

import numpy as np

from occgrid_parity.check.program_maps import ProgramMaps
from occgrid_parity.check.wording import plural
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode


def unsteady(
    maps: ProgramMaps, case: Case, mode: Mode, first: Observed
) -> str:
    """How a second run of a scenario differs from the first, in a sentence; empty where it does not."""
    maps.runs += 1
    outcome = maps.runner.run(case, mode)
    head = f"two runs of {case.name}, {mode.name}"
    again = outcome.observed
    if again is None:
        return f"{head} end differently: the second draws no map ({outcome.word}: {outcome.message})"
    if first.pixels.shape != again.pixels.shape:
        return f"{head} draw maps of different sizes"
    wrong = (first.pixels != again.pixels)[::-1]
    one, other = first.log_odds, again.log_odds
    if (
        one is not None
        and other is not None
        and one.shape == other.shape == wrong.shape
    ):
        wrong = wrong | ((one != other) & ~(np.isnan(one) & np.isnan(other)))
    if not wrong.any():
        return ""
    gy, gx = np.argwhere(wrong)[0].tolist()
    pixels = [int(seen.pixels[::-1][gy, gx]) for seen in (first, again)]
    cells = plural(int(wrong.sum()), "cell")
    return (
        f"{head} differ in {cells}; the first: gx={gx} gy={gy}, pixel {pixels[0]} and then {pixels[1]}. A program must "
        "draw the same map each time, so look for random numbers, memory that is not set, the time or the process "
        "number"
    )
