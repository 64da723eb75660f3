"""Writes a scenario: the parameters on top of the lines of a log."""

from __future__ import annotations

import os
from collections.abc import Iterator
from decimal import Decimal

from occgrid.scenario import ScenarioError, read_scenario
from occgrid_parity.logs.conversion import ConversionError, Request
from occgrid_parity.logs.grid_fitting import Fitted
from occgrid_parity.logs.log_lines import SCAN_KEYWORDS, log_lines


def header(request: Request, fitted: Fitted, kept: int, total: int) -> str:
    """The scenario's first lines."""
    values = {
        "width": str(fitted.width),
        "height": str(fitted.height),
        "resolution": short(request.resolution),
        "origin_x": short(fitted.origin_x),
        "origin_y": short(fitted.origin_y),
        "max_range": short(request.max_range),
        **request.parameters,
    }
    lines = [f"# {ascii(request.log.name)[1:-1]}: {kept} of its {total} scans"]
    lines += [
        f"PARAM occgrid_{name} {value}" for name, value in values.items()
    ]
    return "\n".join(lines) + "\n"


def short(value: Decimal) -> str:
    """A decimal without exponent and without zeros that say nothing."""
    text = f"{value:f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def write_scenario(
    request: Request, fitted: Fitted, kept: int, total: int
) -> None:
    """Writes under another name, has the contract's reader look at it, and renames."""
    output = request.output
    part = output.with_name(f".{output.name}.{os.getpid()}.part")
    try:
        with part.open("wb") as file:
            file.write(header(request, fitted, kept, total).encode("ascii"))
            for raw in _kept_lines(request):
                file.write(raw if raw.endswith(b"\n") else raw + b"\n")
        with read_scenario(part):
            pass
        part.replace(output)
    except ScenarioError as error:
        raise ConversionError(
            f"{output}:{error.line}: {error.reason}"
        ) from error
    except OSError as error:
        reason = f"{output}: cannot be written: {error.strerror}"
        raise ConversionError(reason) from error
    finally:
        part.unlink(missing_ok=True)


def _kept_lines(request: Request) -> Iterator[bytes]:
    number = 0
    for keyword, raw in log_lines(request):
        if keyword in SCAN_KEYWORDS:
            if request.selection.holds(number):
                yield raw
            number += 1
        elif request.all_lines:
            yield raw
