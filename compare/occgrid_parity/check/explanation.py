"""Explains a map that differs: where it first does, and which mistake draws it."""

from __future__ import annotations

from dataclasses import replace

from occgrid_parity.check.check_options import Options
from occgrid_parity.check.levels import EVIDENCE, case_for
from occgrid_parity.check.program_maps import (
    ComparedMap,
    PartialMap,
    ProgramMaps,
)
from occgrid_parity.explain.cause import find_cause
from occgrid_parity.explain.difference_record import report_deduced
from occgrid_parity.explain.findings import Cause, FirstDifference
from occgrid_parity.explain.first_difference import find_first_difference
from occgrid_parity.explain.mistaken_maps import Evidence


class Explanation:
    """Looks for the first difference and the cause, in this order: the first helps with the second.

    ``misread``: the program's maps have another size, because they are turned or transposed.
    """

    def __init__(
        self, maps: ProgramMaps, options: Options, misread: bool
    ) -> None:
        self.maps = maps
        self.runner = maps.runner
        self.options = options
        self.misread = misread
        self.short: Evidence | None = None

    def first_difference(
        self, differing: ComparedMap
    ) -> FirstDifference | None:
        """Where a map first differs."""
        observed = differing.observed
        if observed.pixels.shape != differing.drawn.pixels.shape:
            return _of_turned_map(differing)
        explained = find_first_difference(
            self.runner,
            differing.case,
            differing.mode,
            differing.drawn,
            self.options.save,
            # a map that is turned back compares otherwise as it was drawn
            differing.compared if observed is differing.drawn else None,
        )
        self.maps.runs += explained.runs
        if self.options.on_partial is not None:
            for scans, drawn in explained.partial.items():
                self.options.on_partial(
                    PartialMap(differing.case, differing.mode, scans, drawn)
                )
        if explained.short is not None:
            case, observed, compared, _ = explained.short
            self.short = Evidence(
                case, differing.mode, observed, compared.status
            )
        return explained.difference

    def cause(self) -> Cause:
        """The mistakes that draw all of the program's maps."""
        return find_cause(self._evidence(), self.short)

    def _evidence(self) -> list[Evidence]:
        return [
            Evidence(one.case, one.mode, one.drawn, one.compared.status)
            for one in self.maps.compared.values()
        ] + self._evidence_of_other_sizes()

    def _evidence_of_other_sizes(self) -> list[Evidence]:
        """Maps of another size: they say something of a mistake, too."""
        if not self.misread:
            return []
        known = [case_for(self.runner, name) for name in EVIDENCE]
        cases = {case.digest: case for case in known}
        return [
            Evidence(cases[digest], mode, outcome.observed, "differs")
            for (digest, mode), outcome in self.maps.outcomes.items()
            if outcome.observed is not None
            and (digest, mode) not in self.maps.compared
            and digest in cases
        ]


def _of_turned_map(differing: ComparedMap) -> FirstDifference | None:
    """Where a map that is turned back first differs; as it was drawn, it has other cells than the reference's."""
    found = report_deduced(
        differing.case, differing.mode, differing.observed, differing.compared
    )
    turned = (
        "your map has another width and height than the scenario says, so nothing was run again: this is your map "
        "turned back"
    )
    return found and replace(found, undetermined=[turned])
