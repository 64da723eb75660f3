"""The results of a run: each map beside the reference port's and the golden one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.compare.map_comparison import compare_golden, compare_maps
from occgrid_parity.compare.mapping import Mapped, left_out
from occgrid_parity.compare.run_record import Difference, Result, Status
from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.map_files import MapOutput, read_map, same_files
from occgrid_parity.ports.building import Built
from occgrid_parity.suite.golden import read_golden
from occgrid_parity.suite.modes import Mode
from occgrid_parity.suite.scenarios import ScenarioFile

Places = Mapping[tuple[str, str, str], tuple[int, Mapped]]
"""The process, and its index, of a port, scenario and mode (by their names)."""


@dataclass(frozen=True)
class ComparisonBasis:
    """What the maps are held against; ``folder`` is the run's, ``golden`` as in Plan."""

    reference: str
    folder: Path
    golden: Path | None


def results_of_run(
    basis: ComparisonBasis,
    built: Sequence[Built],
    scenarios: Sequence[ScenarioFile],
    modes: Sequence[Mode],
    mapped: Sequence[Mapped],
) -> list[Result]:
    """One result for each scenario, mode and port; one reference is held at a time."""
    places = {
        (one.port.name, scenario.name, one.mode.name): (index, one)
        for index, one in enumerate(mapped)
        for scenario in one.scenarios
    }
    results = []
    for scenario in scenarios:
        for mode in modes:
            one_map = _CaseComparison(basis, scenario, mode, places)
            results += [one_map.result(one) for one in built]
    return results


class _CaseComparison:
    """Compares the ports' maps of one scenario in one mode."""

    def __init__(
        self,
        basis: ComparisonBasis,
        scenario: ScenarioFile,
        mode: Mode,
        places: Places,
    ) -> None:
        self.basis, self.scenario, self.mode, self.places = (
            basis,
            scenario,
            mode,
            places,
        )
        self.reference: MapOutput | None = None
        self.reference_folder: Path | None = None
        self.no_reference = "it has not run"
        place = places.get((basis.reference, scenario.name, mode.name))
        if place is not None:
            try:
                self.reference = self.read(place[1])
                self.reference_folder = place[1].folder
            except (OutputError, _Failed) as error:
                self.no_reference = str(error)
        self.golden, self.golden_error = None, ""
        if basis.golden is not None:
            try:
                self.golden = read_golden(basis.golden, scenario.map, mode)
            except (OutputError, OSError) as error:
                self.golden_error = f"golden result: {error}"

    def read(self, one: Mapped) -> MapOutput:
        """The map that a process wrote; raises OutputError or _Failed without one.

        Files that are the reference's byte for byte are not read once more.
        """
        if not one.finished.succeeded:
            raise _Failed(one.finished.failure())
        folder, name = one.folder, self.scenario.map
        if self.reference is not None and self.reference_folder is not None:
            if same_files(folder, self.reference_folder, name):
                return self.reference
        return read_map(folder, name)

    def result(self, built: Built) -> Result:
        """What is to say of one port."""
        name = built.port.name
        blank = Result(name, self.scenario.name, self.mode.name, "error")
        if built.problem:
            status: Status = "skipped" if built.skipped else "error"
            return replace(blank, status=status, reason=built.problem)
        if (
            reason := left_out(built.port, self.scenario, self.mode)
        ) is not None:
            return replace(blank, status="left out", reason=reason)
        index, one = self.places[(name, self.scenario.name, self.mode.name)]
        blank = replace(blank, process=index)
        try:
            found = self.read(one)
        except _Failed as error:
            status = "timeout" if one.finished.timed_out else "error"
            return replace(blank, status=status, reason=str(error))
        except OutputError as error:
            return replace(blank, reason=str(error))
        picture = (one.folder / f"{found.name}.pgm").relative_to(
            self.basis.folder
        )
        height, width = found.pixels.shape
        blank = replace(
            blank,
            picture=picture.as_posix(),
            width=int(width),
            height=int(height),
        )
        if self.reference is None:
            reason = f"no map of the reference {self.basis.reference}: {self.no_reference}"
            return replace(blank, reason=reason)
        if self.golden_error:
            return replace(blank, reason=self.golden_error)
        return self.compared(found, blank)

    def compared(self, found: MapOutput, blank: Result) -> Result:
        """The result of the comparisons, with the reference and with golden."""
        assert self.reference is not None
        with_what: list[str] = []
        differences: list[Difference] = []
        if blank.port != self.basis.reference:
            with_what.append(self.basis.reference)
            differences += compare_maps(
                found, self.reference, self.basis.reference
            )
        if self.golden is not None:
            with_what.append("golden")
            differences += compare_golden(found, self.golden)
        files = dict.fromkeys(f"{d.file} ({d.against})" for d in differences)
        return replace(
            blank,
            status="differs" if differences else "identical",
            reason=", ".join(files),
            compared_with=with_what,
            differences=differences,
        )


class _Failed(Exception):
    """A process that did not end well; the text says how it did."""
