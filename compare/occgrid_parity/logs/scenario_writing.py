"""Writes a scenario: the parameters on top of scans that are in a file already."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path
from typing import BinaryIO

from occgrid.scenario import ScenarioError, read_scenario
from occgrid_parity.logs.conversion import ConversionError, Request
from occgrid_parity.logs.grid_fitting import Fitted


def header(
    request: Request, fitted: Fitted, max_range: Decimal, kept: int, total: int
) -> str:
    """The scenario's first lines."""
    values = {
        "width": str(fitted.width),
        "height": str(fitted.height),
        "resolution": short(request.resolution),
        "origin_x": short(fitted.origin_x),
        "origin_y": short(fitted.origin_y),
        "max_range": short(max_range),
    }
    if request.min_range:
        values["min_range"] = short(request.min_range)
    values |= request.parameters
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


@contextmanager
def scan_lines(output: Path) -> Iterator[BinaryIO]:
    """A file beside the output that takes the scans until the grid is known; it is gone afterwards."""
    path = _beside(output, "scans")
    try:
        with path.open("w+b") as file:
            yield file
    except OSError as error:
        if error.filename not in (None, str(path)):
            raise  # it is not about our file
        raise _cannot_write(output, error) from error
    finally:
        path.unlink(missing_ok=True)


def write_scenario(output: Path, head: str, scans: BinaryIO) -> None:
    """Writes under another name, has the contract's reader look at it, and renames."""
    part = _beside(output, "part")
    try:
        scans.seek(0)
        with part.open("wb") as file:
            file.write(head.encode("ascii"))
            shutil.copyfileobj(scans, file, 1 << 20)
        with read_scenario(part):
            pass
        part.replace(output)
    except ScenarioError as error:
        raise ConversionError(
            f"{output}:{error.line}: {error.reason}"
        ) from error
    except OSError as error:
        raise _cannot_write(output, error) from error
    finally:
        part.unlink(missing_ok=True)


def _beside(output: Path, kind: str) -> Path:
    return output.with_name(f".{output.name}.{os.getpid()}.{kind}")


def _cannot_write(output: Path, error: OSError) -> ConversionError:
    return ConversionError(f"{output}: cannot be written: {error.strerror}")
