"""Where a map first differs, found by running the program on shorter scenarios, or worked out from the map alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from occgrid_parity.explain.closeness import (
    Compared,
    compare_with_reference,
)
from occgrid_parity.explain.difference_record import (
    BeamView,
    TouchingBeams,
    report_deduced,
    report_found,
)
from occgrid_parity.explain.difference_search import (
    SearchFailed,
    Trial,
    search,
)
from occgrid_parity.explain.findings import FirstDifference
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.programs.runner import Runner
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

MINIMAL = "first-difference.log"


class _Trials:
    """Runs the program on shortened scenarios and counts the runs."""

    def __init__(self, runner: Runner, mode: Mode) -> None:
        self.runner = runner
        self.mode = mode
        self.runs = 0
        self.known: dict[str, Trial] = {}

    def compare(
        self, case: Case, observed: Observed, known: Compared | None = None
    ) -> Trial:
        compared = known or compare_with_reference(observed, case, self.mode)
        differs = compared.status == "differs"
        return Trial(case, observed, compared, differs)

    def attempt(self, case: Case) -> Trial:
        if case.digest not in self.known:
            self.runs += 1
            outcome = self.runner.run(case, self.mode)
            if outcome.observed is None:
                raise SearchFailed(
                    f"on a part of the scenario the program fails ({outcome.word}: {outcome.message})"
                )
            expected = reference_map(case, self.mode).pixels.shape
            if outcome.observed.pixels.shape != expected:
                raise SearchFailed(
                    "on a part of the scenario its map has another size"
                )
            self.known[case.digest] = self.compare(case, outcome.observed)
        return self.known[case.digest]


class Explained(NamedTuple):
    """The first difference, how many runs it took, and of the maps that show it the one with the fewest scans.

    ``partial`` are the maps that the program drew of the first scans only, by their number.
    """

    difference: FirstDifference | None
    runs: int = 0
    short: Trial | None = None
    partial: Mapping[int, Observed] = MappingProxyType({})


def find_first_difference(
    runner: Runner,
    case: Case,
    mode: Mode,
    observed: Observed,
    save: Path | None,
    known: Compared | None = None,
) -> Explained:
    """Where the map first differs.

    ``known`` is how the map compares, if that is known already. The minimal scenario is written into ``save``.
    """
    if not case.is_file:
        known = known or compare_with_reference(
            observed, case, mode, own_poses=True
        )
        return Explained(report_deduced(case, mode, observed, known))
    trials = _Trials(runner, mode)
    whole = trials.compare(case, observed, known)
    try:
        view = BeamView(case, mode)
        guess = TouchingBeams(view)
        found = search(case, mode, whole, trials.attempt, guess)
    except SearchFailed as failed:
        deduced = report_deduced(case, mode, observed, whole.compared)
        if deduced is not None:
            deduced = replace(
                deduced, undetermined=[str(failed)], runs=trials.runs
            )
        return Explained(deduced, trials.runs)
    report = report_found(view, case, mode, found, trials.runs)
    if save is not None:
        save.mkdir(parents=True, exist_ok=True)
        file = save / MINIMAL
        file.write_bytes(found.trial.case.data)
        command = f"occgrid-parity check {runner.option} --scenario {file} --mode {mode.name}"
        report = replace(report, scenario_file=str(file), command=command)
    shown = [found.trial, found.prefix or found.trial]
    short = min(shown, key=lambda trial: len(world_of(trial.case).scans))
    partial = {n: trial.observed for n, trial in found.prefixes.items()}
    return Explained(report, trials.runs, short, partial)
