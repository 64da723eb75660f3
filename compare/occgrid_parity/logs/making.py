"""Turns a log into a scenario: a grid that fits its scans, on top of them."""

from __future__ import annotations

from dataclasses import dataclass

from occgrid.scenario import ScenarioError
from occgrid_parity.logs.conversion import ConversionError, Request, Source
from occgrid_parity.logs.grid_fitting import Bounds, Fitted, fit
from occgrid_parity.logs.opening import open_log
from occgrid_parity.logs.readings import Readings
from occgrid_parity.logs.scenario_writing import (
    header,
    scan_lines,
    write_scenario,
)


@dataclass(frozen=True)
class Made:
    """A scenario that was written: its grid and scans, and what the log was seen to hold."""

    fitted: Fitted
    scans: int
    notes: list[str]
    warnings: list[str]


def make_scenario(request: Request) -> Made:
    """Writes the scenario.

    The log is read once and never held: its scans wait in a file beside the output. Raises ConversionError
    where the log breaks a rule, where the grid would have too many cells and where no scan is left,
    or the scenario cannot be written, and OSError where the log cannot be read.
    """
    if request.output.exists() and request.output.samefile(request.log):
        raise ConversionError(f"{request.output}: is the log itself")
    try:
        return _make(request, open_log(request))
    except ScenarioError as error:
        raise ConversionError(str(error)) from error


def _make(request: Request, source: Source) -> Made:
    bounds: Bounds | None = None
    readings = Readings()
    with scan_lines(request.output) as file:
        for entry in source.entries():
            if entry.scan is not None:
                if bounds is None:
                    bounds = Bounds(
                        float(source.max_range), float(request.min_range)
                    )
                bounds.add(entry.scan)
                readings.add(entry.scan)
            file.write(entry.text + b"\n")
        if bounds is None:
            raise ConversionError(
                f"{request.log}: none of its {source.total():,} scans is chosen"
            )
        bounds.finish()
        fitted = fit(bounds, request)
        head = header(
            request, fitted, source.max_range, readings.scans, source.total()
        )
        write_scenario(request.output, head, file)
    max_range = float(source.max_range)
    return Made(
        fitted,
        readings.scans,
        [
            *source.notes(),
            *readings.notes(max_range, float(request.min_range)),
        ],
        [*source.warnings(), *readings.warnings(request, max_range)],
    )
