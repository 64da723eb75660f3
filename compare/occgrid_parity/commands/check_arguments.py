"""The options of ``occgrid-parity check``."""

from __future__ import annotations

import enum
from pathlib import Path
from typing import Annotated

import typer

from occgrid_parity.ports.port_file import DEFAULT_TIMEOUT

DEFAULT_OUT = Path("occgrid-parity-check")


Run = Annotated[
    str | None,
    typer.Option(
        "--run",
        metavar="'CMD'",
        help="The command that runs your program, with {scenario}, {out} or {pgm}, {mode} or {seed} where they belong.",
    ),
]


PortFile = Annotated[
    Path | None,
    typer.Option(
        "--port",
        metavar="FILE",
        help="The port.toml that says how to run your program.",
    ),
]


ClassFolder = Annotated[
    Path | None,
    typer.Option(
        "--class",
        metavar="DIR",
        help="Check a whole class: each folder in DIR is a submission.",
    ),
]


Scenarios = Annotated[
    list[str] | None,
    typer.Option(
        "--scenario",
        metavar="NAME|FILE",
        help="Check only this scenario of the suite, or this file. May be repeated.",
    ),
]


Modes = Annotated[
    list[str] | None,
    typer.Option(
        "--mode",
        metavar="MODE",
        help="With --scenario: noise-free or seed-N. May be repeated.",
    ),
]


Out = Annotated[
    Path,
    typer.Option(
        metavar="DIR",
        help="Folder for verdict.json and for the scenario that shows the first difference.",
    ),
]


JsonFile = Annotated[
    Path | None,
    typer.Option(
        "--json",
        metavar="FILE",
        help="Write the verdict as JSON to this file, too.",
    ),
]


Report = Annotated[
    Path | None,
    typer.Option(
        metavar="DIR",
        help="Write a web page with the verdict and every map; with --class, one for each submission, and a table.",
    ),
]


JUnit = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the levels as JUnit XML; with --class, a file of this name for each submission.",
    ),
]


Gradescope = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the points as Gradescope's results.json; with --class, one for each submission.",
    ),
]


Timeout = Annotated[
    float | None,
    typer.Option(
        min=0.1,
        help=f"Seconds for one run (default: port.toml's, or {DEFAULT_TIMEOUT:g}).",
    ),
]


Output = Annotated[
    int,
    typer.Option(
        "--max-output", min=1, help="How many MiB one run may write and print."
    ),
]


Memory = Annotated[
    int,
    typer.Option(
        "--max-memory", min=16, help="How many MiB of memory one run may use."
    ),
]


Processes = Annotated[
    int,
    typer.Option(
        "--max-processes",
        min=1,
        help="How many processes one run may have at a time.",
    ),
]


Explain = Annotated[
    bool,
    typer.Option(
        "--explain/--no-explain",
        help="Find out where a wrong map first differs, and why.",
    ),
]


Jobs = Annotated[
    int,
    typer.Option(
        min=1, help="With --class: how many submissions side by side."
    ),
]


class SandboxWord(enum.Enum):
    """Whether programs run behind a wall."""

    AUTO = "auto"
    REQUIRE = "require"
    NONE = "none"


SandboxChoice = Annotated[
    SandboxWord | None,
    typer.Option(
        "--sandbox",
        help="With --class: shut each program in if the system can (auto, the default), always, or never.",
    ),
]


RulesFile = Annotated[
    Path | None,
    typer.Option(
        "--rules",
        metavar="FILE",
        help="With --class: the instructor's rules (default: DIR/class.toml).",
    ),
]


BuildTimeout = Annotated[
    float | None,
    typer.Option(
        min=0.1,
        help="With --class: seconds for each build command (default: class.toml's, or 300).",
    ),
]


RosterFile = Annotated[
    Path | None,
    typer.Option(
        "--roster",
        metavar="FILE",
        help="With --class: a CSV file with a column submission; writes moodle.csv and canvas.csv.",
    ),
]


Scheduler = Annotated[
    str | None,
    typer.Option(
        "--scheduler",
        metavar="ADDRESS",
        help="A Dask cluster that does the work (of check: with --class), such as tcp://host:8786.",
    ),
]
