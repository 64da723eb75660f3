"""Turns a CARMEN log into a scenario: a grid that fits its scans, on top of them."""

from __future__ import annotations

from occgrid.scenario import ScenarioError
from occgrid_parity.logs.conversion import ConversionError, Request
from occgrid_parity.logs.grid_fitting import Bounds, Fitted, fit
from occgrid_parity.logs.log_lines import log_scans
from occgrid_parity.logs.scenario_writing import write_scenario


def make_scenario(request: Request) -> tuple[Fitted, int]:
    """Writes the scenario; returns its grid and how many scans it has.

    The log is read twice and never held. Raises ConversionError where a line of it
    breaks a rule, where the grid would have too many cells and where no scan is left,
    or the scenario cannot be written, and OSError where the log cannot be read twice.
    """
    if request.output.exists() and request.output.samefile(request.log):
        raise ConversionError(f"{request.output}: is the log itself")
    bounds, kept, total = Bounds(), 0, 0
    try:
        for number, scan in log_scans(request):
            total = number + 1
            if scan is not None:
                bounds.add(scan, float(request.max_range))
                kept += 1
    except ScenarioError as error:
        raise ConversionError(str(error)) from error
    if not kept:
        raise ConversionError(
            f"{request.log}: none of its {total} scans is chosen"
        )
    fitted = fit(bounds, request)
    write_scenario(request, fitted, kept, total)
    return fitted, kept
