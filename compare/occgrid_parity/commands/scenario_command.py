"""The command ``occgrid-parity scenario``."""

from __future__ import annotations

import re
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid.scenario import ScenarioError
from occgrid_parity.commands.console import print_plain, wrong_usage
from occgrid_parity.formats.errors import MAX_CELLS
from occgrid_parity.logs.conversion import ConversionError, Request, Selection
from occgrid_parity.logs.making import Made, make_scenario
from occgrid_parity.logs.preview import check_picture_name, draw_preview
from occgrid_parity.logs.scenario_writing import short


def scenario_command(
    log: Annotated[
        Path,
        typer.Argument(
            help="A CARMEN log (.gz, too), or a ROS bag: .bag, .mcap, .db3 or a folder."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="FILE", help="The scenario."),
    ],
    resolution: Annotated[
        str, typer.Option(help="Side of a cell, metres.")
    ] = "0.1",
    max_range: Annotated[
        str | None,
        typer.Option(
            help="Readings from here on are no return, metres. Default: 30, or the bag's own."
        ),
    ] = None,
    min_range: Annotated[
        str, typer.Option(help="Readings below are dropped, metres.")
    ] = "0",
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
        str,
        typer.Option(
            help="A beam without return: ignore it, or free up to --max-range."
        ),
    ] = "ignore",
    topic: Annotated[
        str | None,
        typer.Option(help="Of a bag: the scans. Default: the only ones."),
    ] = None,
    frame: Annotated[
        str | None,
        typer.Option(
            help="Of a bag: the frame of the map. Default: map, else odom."
        ),
    ] = None,
    preview: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Draw the map, as .png for one."),
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
    """Turn a laser log or a ROS bag into a scenario, and say what was seen in it."""
    given = {"p0": p0, "p_occ": p_occ, "p_free": p_free}
    given |= {"l_min": l_min, "l_max": l_max, "no_return": no_return}
    try:
        request = Request(
            log=log,
            output=output,
            resolution=_decimal("--resolution", resolution, above_zero=True),
            max_range=None
            if max_range is None
            else _decimal("--max-range", max_range, above_zero=True),
            min_range=_decimal("--min-range", min_range, above_zero=False),
            margin=_decimal("--margin", margin, above_zero=False),
            max_cells=max_cells,
            selection=_selection(scans, every),
            all_lines=all_lines,
            parameters={
                k: _word(k, v) for k, v in given.items() if v is not None
            },
            topic=topic,
            frame=frame,
        )
        if preview is not None:
            check_picture_name(preview)
    except ValueError as error:
        raise wrong_usage(error) from error
    console = Console(stderr=True)
    try:
        made = make_scenario(request)
        _show(console, request, made)
        if preview is not None:
            draw_preview(output, preview)
            print_plain(console, f"{preview}: the map")
    except (ConversionError, ScenarioError) as error:
        print_plain(console, str(error))
        raise typer.Exit(1) from error
    except OSError as error:
        print_plain(console, f"{error.filename}: {error.strerror}")
        raise typer.Exit(1) from error


def _show(console: Console, request: Request, made: Made) -> None:
    """What was written, what was seen, and what to look at."""
    fitted = made.fitted
    print_plain(
        console,
        f"{request.output}: {made.scans} scans on {fitted.width} x {fitted.height} cells of "
        f"{short(request.resolution)} m from ({short(fitted.origin_x)}, "
        f"{short(fitted.origin_y)})",
    )
    for note in made.notes:
        print_plain(console, note)
    for warning in made.warnings:
        print_plain(console, f"warning: {warning}")


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
