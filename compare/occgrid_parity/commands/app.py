"""The command ``occgrid-parity``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid import __version__
from occgrid.scenario import ScenarioError
from occgrid_parity.commands.check_command import check_command
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.commands.mistakes_command import mistakes_command
from occgrid_parity.compare.golden_results import (
    changes,
    make_golden,
    strays,
    write_golden,
)
from occgrid_parity.compare.matrix_run import (
    REFERENCE,
    Plan,
    build_ports,
    prepare_folder,
    run,
)
from occgrid_parity.compare.run_record import to_json, write_text
from occgrid_parity.formats.errors import MAX_CELLS
from occgrid_parity.logs.carmen import (
    ConversionError,
    Request,
    Selection,
    make_scenario,
    short,
)
from occgrid_parity.ports.building import as_it_is
from occgrid_parity.ports.declaration import (
    DECLARATION,
    Port,
    PortError,
    find_ports,
    read_port,
)
from occgrid_parity.report.junit import junit_xml
from occgrid_parity.report.run_page import write_page
from occgrid_parity.report.run_table import (
    explanations,
    footnotes,
    matrix_table,
    summary,
)
from occgrid_parity.suite.modes import DEFAULT_MODES, Mode, parse_mode
from occgrid_parity.suite.repository import find_root
from occgrid_parity.suite.scenarios import choose_scenarios, scenario_files

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)

WIDTH = 120

app.command("check")(check_command)
app.command("mistakes")(mistakes_command)

Root = Annotated[
    Path | None,
    typer.Option(
        "--root", metavar="DIR", help="The repository, if not this one."
    ),
]
Jobs = Annotated[
    int, typer.Option(min=1, help="How many processes side by side.")
]


def main() -> None:
    """The entry point of the command."""
    app(prog_name="occgrid-parity")


def _say_version(wanted: bool) -> None:
    """Prints the version and ends the command."""
    if wanted:
        typer.echo(f"occgrid-parity {__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool,
        typer.Option(
            "--version",
            is_eager=True,
            callback=_say_version,
            help="Print the version and end.",
        ),
    ] = False,
) -> None:
    """Builds the ports, runs them side by side and compares every bit of their maps."""


def _console() -> Console:
    """Standard output; wide enough for five ports where it is no terminal."""
    console = Console()
    return console if console.is_terminal else Console(width=WIDTH)


def _usage(error: Exception) -> typer.Exit:
    """Says what is wrong on standard error; status 2."""
    Console(stderr=True).print(
        f"occgrid-parity: {error}", markup=False, soft_wrap=True
    )
    return typer.Exit(2)


def _ports(root: Path, words: Sequence[str]) -> list[Port]:
    """The ports that the words name (names, folders, port.toml files), or all.

    Raises PortError for a word that names none.
    """
    known = {port.name: port for port in find_ports(root)}
    if not words:
        return list(known.values())
    chosen = []
    for word in words:
        path = Path(word)
        if word in known:
            chosen.append(known[word])
        elif (path / DECLARATION).is_file():
            chosen.append(read_port(path / DECLARATION))
        elif path.name == DECLARATION and path.is_file():
            chosen.append(read_port(path))
        else:
            raise PortError(
                f"{word!r} is neither a port ({', '.join(known)}) nor a folder with "
                f"{DECLARATION}"
            )
    names = [port.name for port in chosen]
    for name in names:
        if names.count(name) > 1:
            raise PortError(f"two ports are named {name}")
    return chosen


@app.command()
def build(
    ports: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PORT]...", help="Default: all."),
    ] = None,
    root: Root = None,
    jobs: Jobs = 2,
    allow_skipped: Annotated[
        bool,
        typer.Option(help="A port whose tools are missing is no failure."),
    ] = False,
) -> None:
    """Build the ports, as their port.toml says."""
    console = _console()
    try:
        found = find_root() if root is None else root
        chosen = _ports(found, ports or [])
    except (OSError, ValueError) as error:
        raise _usage(error) from error
    with ConsoleProgress(console) as progress:
        progress.total(len(chosen))
        built = build_ports(chosen, found / "build" / "ports", jobs, progress)
    failed = [
        b for b in built if b.problem and not (b.skipped and allow_skipped)
    ]
    for one in failed:
        said = f" (see {one.log})" if one.log is not None else ""
        word = "skipped: " if one.skipped else ""
        _print(console, f"{one.port.name}: {word}{one.problem}{said}")
    raise typer.Exit(1 if failed else 0)


@app.command("run")
def run_command(
    ports: Annotated[
        list[str] | None,
        typer.Option(
            "--port",
            metavar="NAME",
            help="A port, or a folder with port.toml.",
        ),
    ] = None,
    scenarios: Annotated[
        list[str] | None,
        typer.Option(
            "--scenario", metavar="NAME|FILE", help="A scenario, or built-in."
        ),
    ] = None,
    modes: Annotated[
        list[str] | None,
        typer.Option("--mode", metavar="MODE", help="noise-free or seed-N."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Default: build/parity.")
    ] = None,
    json_file: Annotated[
        Path | None,
        typer.Option("--json", metavar="FILE", help="A copy of the record."),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write a page that shows every map."),
    ] = None,
    junit: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the results as JUnit XML."),
    ] = None,
    root: Root = None,
    jobs: Jobs = 2,
    build_first: Annotated[
        bool, typer.Option("--build/--no-build", help="Build the ports first.")
    ] = True,
    allow_skipped: Annotated[
        bool,
        typer.Option(help="A port whose tools are missing is no failure."),
    ] = False,
) -> None:
    """Map scenarios with the ports and compare the maps, bit for bit.

    The python port is the reference, and always runs. Ends with 0 if all maps are
    identical, with 1 if one is not, with 2 for wrong usage.
    """
    console = _console()
    try:
        found = find_root() if root is None else root
        chosen = _ports(found, ports or [])
        if REFERENCE not in [port.name for port in chosen]:
            chosen = [*_ports(found, [REFERENCE]), *chosen]
        folder = (out or found / "build" / "parity").resolve()
        chosen_scenarios = choose_scenarios(found, scenarios or [])
        chosen_modes = list(dict.fromkeys(map(parse_mode, modes or [])))
        prepare_folder(folder)
    except (OSError, ValueError) as error:
        raise _usage(error) from error
    with ConsoleProgress(console) as progress:
        record = run(
            Plan(
                ports=chosen,
                scenarios=chosen_scenarios,
                modes=chosen_modes or DEFAULT_MODES,
                folder=folder,
                golden=found / "scenarios" / "golden",
                jobs=jobs,
                built=None if build_first else list(map(as_it_is, chosen)),
                progress=progress,
            )
        )
    if json_file is not None:
        write_text(json_file, to_json(record))
    if junit is not None:
        write_text(junit, junit_xml(record))
    console.print(matrix_table(record))
    lines = [*footnotes(record), *explanations(record), ""]
    lines.append(f"pictures and run.json: {folder}")
    if report is not None:
        lines.append(f"report: {write_page(record, folder, report)}")
    lines.append(summary(record))
    for line in lines:
        _print(console, line)
    raise typer.Exit(0 if record.is_identical(allow_skipped) else 1)


@app.command()
def golden(
    write: Annotated[
        bool, typer.Option("--write", help="Write what changed.")
    ] = False,
    root: Root = None,
) -> None:
    """Check the golden results in scenarios/golden, or write them anew."""
    console = _console()
    try:
        found = find_root() if root is None else root
    except OSError as error:
        raise _usage(error) from error
    folder = found / "scenarios" / "golden"
    scenarios = scenario_files(found)
    if not scenarios:
        raise _usage(ValueError(f"{found / 'scenarios'}: no scenario there"))
    wrong = 0
    for scenario in scenarios:
        for mode in DEFAULT_MODES:
            try:
                fresh = make_golden(scenario, mode)
            except ScenarioError as error:
                _print(console, str(error))
                raise typer.Exit(1) from error
            said = changes(folder, fresh)
            wrong += bool(said)
            if said and write:
                write_golden(folder, fresh)
            verb = "written: " if said and write else ""
            what = f"{len(fresh.scans)} scans as committed"
            _print(
                console,
                f"{_title(scenario.map, mode)}: {verb}{'; '.join(said) or what}",
            )
    for path in strays(folder, scenarios):
        wrong += 1
        if write:
            path.unlink()
        verb = "removed: " if write else ""
        _print(console, f"{path.name}: {verb}belongs to no scenario")
    raise typer.Exit(1 if wrong and not write else 0)


def _title(name: str, mode: Mode) -> str:
    return f"{name}, {mode.name}"


@app.command()
def scenario(
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
        raise _usage(error) from error
    console = Console(stderr=True)
    try:
        fitted, kept = make_scenario(request)
    except ConversionError as error:
        _print(console, str(error))
        raise typer.Exit(1) from error
    except OSError as error:
        _print(console, f"{error.filename}: {error.strerror}")
        raise typer.Exit(1) from error
    _print(
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


def _print(console: Console, text: str) -> None:
    """Text as it is: neither markup nor wrapped."""
    console.print(text, markup=False, highlight=False, soft_wrap=True)
