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
        help="The program's command, with {scenario}, {out} or {pgm}, {mode} or {seed}.",
    ),
]


PortFile = Annotated[
    Path | None,
    typer.Option("--port", metavar="FILE", help="The program's port.toml."),
]


ClassFolder = Annotated[
    Path | None,
    typer.Option(
        "--class",
        metavar="DIR",
        help="Many programs: a folder with port.toml each.",
    ),
]


Scenarios = Annotated[
    list[str] | None,
    typer.Option(
        "--scenario",
        metavar="NAME|FILE",
        help="Check on this only; may be repeated.",
    ),
]


Modes = Annotated[
    list[str] | None,
    typer.Option(
        "--mode", metavar="MODE", help="noise-free or seed-N, with --scenario."
    ),
]


Out = Annotated[
    Path,
    typer.Option(
        metavar="DIR", help="For the record and the minimal scenario."
    ),
]


JsonFile = Annotated[
    Path | None,
    typer.Option("--json", metavar="FILE", help="A copy of the record."),
]


Report = Annotated[
    Path | None,
    typer.Option(
        metavar="DIR",
        help="Write a page that shows every map that was compared; with --class, one each and their table.",
    ),
]


JUnit = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the levels as JUnit XML; with --class, NAME for each submission.",
    ),
]


Gradescope = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the levels as an autograder's results.json (Gradescope's form).",
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
    typer.Option("--max-output", min=1, help="MiB that one run may write."),
]


Memory = Annotated[
    int,
    typer.Option(
        "--max-memory", min=16, help="MiB of memory that one run may use."
    ),
]


Processes = Annotated[
    int,
    typer.Option(
        "--max-processes", min=1, help="Processes at a time in one run."
    ),
]


Explain = Annotated[
    bool,
    typer.Option(
        "--explain/--no-explain", help="Look for cause and first difference."
    ),
]


Jobs = Annotated[
    int, typer.Option(min=1, help="With --class: how many side by side.")
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
        help="With --class: a wall around each program where that works (auto, the default), always, or never.",
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
