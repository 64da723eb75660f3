"""Turns a CARMEN log into a scenario: fits a grid to its scans and writes it on top."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from decimal import ROUND_FLOOR, ROUND_UP, Decimal, localcontext
from pathlib import Path
from typing import NamedTuple

import numpy as np

from occgrid.grid import GridSpec, OccupancyGrid

# the reader of a whole scenario wants its PARAM lines, which a bare log does not have;
# its scan lines are read by the same code here
from occgrid.scenario import ScenarioError, _Reader, read_scenario
from occgrid.sensor import Scan, beam_endpoints, read_ranges
from occgrid_parity.formats.errors import MAX_CELLS

SCAN_KEYWORDS = (b"FLASER", b"ROBOTLASER1")
OURS = (b"WALL", b"POSE")


class ConversionError(ValueError):
    """A log that makes no scenario; the text is ``FILE:LINE: reason`` or tells what to change."""


class Selection(NamedTuple):
    """Which scans of a log are kept: every ``every``-th of first .. last - 1."""

    first: int = 0
    last: int | None = None
    every: int = 1

    def holds(self, scan: int) -> bool:
        """Whether that scan (numbered from 0) is kept."""
        below = self.last is None or scan < self.last
        return (
            self.first <= scan
            and below
            and (scan - self.first) % self.every == 0
        )


ALL_SCANS = Selection()


@dataclass(frozen=True)
class Request:
    """What to make of a log.

    ``resolution``, ``max_range`` and ``margin`` are metres. ``parameters`` are further
    occgrid_ parameters by name, as they are to stand in the file.
    """

    log: Path
    output: Path
    resolution: Decimal = Decimal("0.1")
    max_range: Decimal = Decimal(30)
    margin: Decimal = Decimal(1)
    max_cells: int = MAX_CELLS
    selection: Selection = ALL_SCANS
    all_lines: bool = False
    parameters: Mapping[str, str] = field(default_factory=dict)


class Fitted(NamedTuple):
    """A grid that holds a log's scans; the origin is a multiple of the resolution."""

    width: int
    height: int
    origin_x: Decimal
    origin_y: Decimal


class Bounds:
    """The box around the hits and the positions of scans, metres."""

    def __init__(self) -> None:
        self.low = np.full(2, np.inf)
        self.high = np.full(2, -np.inf)

    def add(self, scan: Scan, max_range: float) -> None:
        """Takes in the scan's position and where its hits end."""
        pose = scan.pose
        z, hit, _ = read_ranges(scan.ranges, max_range, "ignore")
        n = int(hit.sum())
        x, y, theta = (
            np.full(n, value) for value in (pose.x, pose.y, pose.theta)
        )
        ex, ey = beam_endpoints(x, y, theta, scan.angles[hit], z[hit])
        points = np.array([[*ex, pose.x], [*ey, pose.y]])
        self.low = np.minimum(self.low, points.min(axis=1))
        self.high = np.maximum(self.high, points.max(axis=1))


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
        for number, scan in _scans(request):
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
    _write(request, fitted, kept, total)
    return fitted, kept


def _scans(request: Request) -> Iterator[tuple[int, Scan | None]]:
    """Number and content of every scan; without content where it is not chosen."""
    reader = _Reader(str(request.log))
    number = 0
    try:
        for keyword, raw in _lines(request):
            reader.line += 1
            if keyword in OURS or _is_parameter(raw):
                reader.fail("this is a scenario already, not a log")
            if keyword not in SCAN_KEYWORDS:
                continue
            if not request.selection.holds(number):
                yield number, None
            else:
                line = raw.strip(b"\r\n\t ")
                if not all(byte == 9 or 32 <= byte < 127 for byte in line):
                    reader.fail("not plain ASCII text")
                values = line.decode("ascii").split()[1:]
                if keyword == b"FLASER":
                    yield number, reader.flaser(values)
                else:
                    yield number, reader.robotlaser1(values)
            number += 1
        if number == 0:
            reader.fail("no scan")
    finally:
        reader.close()


def _lines(request: Request) -> Iterator[tuple[bytes, bytes]]:
    """Keyword (empty where there is none) and raw text of every line."""
    with request.log.open("rb") as file:
        for raw in file:
            words = raw[:80].split(maxsplit=1)
            yield (words[0] if words else b""), raw


def _is_parameter(raw: bytes) -> bool:
    words = raw[:200].split(maxsplit=2)
    return (
        len(words) > 1
        and words[0] == b"PARAM"
        and words[1].startswith(b"occgrid_")
    )


def fit(bounds: Bounds, request: Request) -> Fitted:
    """The smallest grid around the bounds and the margin.

    Raises ConversionError where it has more than ``max_cells`` cells.
    """
    (x, width), (y, height) = (
        _fit_axis(low, high, request)
        for low, high in zip(bounds.low, bounds.high, strict=True)
    )
    cells = width * height
    if cells > request.max_cells:
        with localcontext(prec=2, rounding=ROUND_UP):
            enough = (
                request.resolution
                * (Decimal(cells) / request.max_cells).sqrt()
            )
        raise ConversionError(
            f"{request.log}: a grid of {width} x {height} = {cells} cells, more than "
            f"{request.max_cells}: choose a larger --resolution (about {enough:f}), a "
            "smaller --max-range, fewer --scans or a larger --max-cells"
        )
    return Fitted(width, height, x, y)


def _fit_axis(
    low: float, high: float, request: Request
) -> tuple[Decimal, int]:
    """Origin and number of cells along one axis."""
    resolution, margin = request.resolution, request.margin
    with localcontext(prec=60, rounding=ROUND_FLOOR):
        first = int(((Decimal(low) - margin) / resolution).to_integral_value())
        last = int(((Decimal(high) + margin) / resolution).to_integral_value())
        origin = first * resolution
        # the mapper divides doubles: at an edge it may see the next cell
        last = max(last, first + _cell(high, origin, resolution))
    return origin, last - first + 1


def _cell(value: float, origin: Decimal, resolution: Decimal) -> int:
    """The cell of a coordinate as the mapper computes it."""
    spec = GridSpec(1, 1, float(resolution), float(origin), 0.0)
    gx, _ = OccupancyGrid(spec).world_to_grid(np.array([value]), np.zeros(1))
    return int(gx[0])


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


def _write(request: Request, fitted: Fitted, kept: int, total: int) -> None:
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
    for keyword, raw in _lines(request):
        if keyword in SCAN_KEYWORDS:
            if request.selection.holds(number):
                yield raw
            number += 1
        elif request.all_lines:
            yield raw
