"""The command ``occgrid-parity scenario``."""

from __future__ import annotations

import re
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid_parity.commands.console import print_plain, wrong_usage
from occgrid_parity.formats.errors import MAX_CELLS
from occgrid_parity.logs.conversion import ConversionError, Request, Selection
from occgrid_parity.logs.making import make_scenario
from occgrid_parity.logs.scenario_writing import short


def scenario_command(
    log: Annotated[
        Path, typer.Argument(help="A CARMEN log with recorded scans.")
    ],
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="FILE", help="The scenario."),
    ],
    resolution: Annotated[
        str, typer.Option(help="Side of a cell, metres.")
    ] = "0.1",
    max_range: Annotated[
        str, typer.Option(help="Of the sensor, metres.")
    ] = "30",
    margin: Annotated[
        str, typer.Option(help="Around the hits, metres.")
    ] = "1",
    p0: Annotated[str | None, typer.Option(help="Prior probability.")] = None,
    p_occ: Annotated[
        str | None, typer.Option(help="Of a cell that was hit.")
    ] = None,
    p_free: Annotated[
        str | None, typer.Option(help="Of a cell on a beam.")
    ] = None,
    l_min: Annotated[str | None, typer.Option(help="Least log-odds.")] = None,
    l_max: Annotated[
        str | None, typer.Option(help="Largest log-odds.")
    ] = None,
    no_return: Annotated[
        str | None, typer.Option(help="free or ignore: a beam without return.")
    ] = None,
    scans: Annotated[
        str, typer.Option(metavar="A:B", help="Only scans A to B - 1, from 0.")
    ] = ":",
    every: Annotated[
        int, typer.Option(min=1, help="Of these, every N-th.")
    ] = 1,
    all_lines: Annotated[
        bool, typer.Option(help="Keep the log's other lines, too.")
    ] = False,
    max_cells: Annotated[
        int, typer.Option(min=1, max=MAX_CELLS, help="Refuse a larger grid.")
    ] = MAX_CELLS,
) -> None:
    """Turn a CARMEN log into a scenario: a grid around its scans on top of them."""
    given = {"p0": p0, "p_occ": p_occ, "p_free": p_free}
    given |= {"l_min": l_min, "l_max": l_max, "no_return": no_return}
    try:
        request = Request(
            log=log,
            output=output,
            resolution=_decimal("--resolution", resolution, above_zero=True),
            max_range=_decimal("--max-range", max_range, above_zero=True),
            margin=_decimal("--margin", margin, above_zero=False),
            max_cells=max_cells,
            selection=_selection(scans, every),
            all_lines=all_lines,
            parameters={
                k: _word(k, v) for k, v in given.items() if v is not None
            },
        )
    except ValueError as error:
        raise wrong_usage(error) from error
    console = Console(stderr=True)
    try:
        fitted, kept = make_scenario(request)
    except ConversionError as error:
        print_plain(console, str(error))
        raise typer.Exit(1) from error
    except OSError as error:
        print_plain(console, f"{error.filename}: {error.strerror}")
        raise typer.Exit(1) from error
    print_plain(
        console,
        f"{output}: {kept} scans on {fitted.width} x {fitted.height} cells of "
        f"{short(request.resolution)} m from ({short(fitted.origin_x)}, "
        f"{short(fitted.origin_y)})",
    )


def _decimal(option: str, text: str, above_zero: bool) -> Decimal:
    try:
        value = Decimal(text)
    except InvalidOperation:
        value = Decimal("NaN")
    if not value.is_finite() or value < 0 or (above_zero and value == 0):
        least = "above 0" if above_zero else "from 0"
        raise ValueError(f"{option} {text!r} is not a number {least}")
    if value.adjusted() > 9 or int(value.as_tuple().exponent) < -15:
        raise ValueError(f"{option} {text!r} is out of reach")
    return value


def _word(name: str, text: str) -> str:
    if not re.fullmatch(r"[!-~]+", text) or text.startswith("#"):
        raise ValueError(
            f"--{name.replace('_', '-')} {text!r} is not one word"
        )
    return text


def _selection(scans: str, every: int) -> Selection:
    match = re.fullmatch(r"([0-9]{0,9}):([0-9]{0,9})", scans)
    if match is None:
        raise ValueError(
            f"--scans {scans!r} is not A:B with whole numbers A and B"
        )
    first, last = match[1], match[2]
    return Selection(int(first or 0), int(last) if last else None, every)
