"""What the commands share: options, the console, and how wrong usage is reported."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

WIDTH = 120
Root = Annotated[
    Path | None,
    typer.Option(
        "--root", metavar="DIR", help="The repository, if not this one."
    ),
]
Jobs = Annotated[
    int, typer.Option(min=1, help="How many processes side by side.")
]
BuildFirst = Annotated[
    bool, typer.Option("--build/--no-build", help="Build the ports first.")
]
AllowSkipped = Annotated[
    bool, typer.Option(help="A port whose tools are missing is no failure.")
]


def wide_console() -> Console:
    """Standard output; wide enough for all ports where it is no terminal."""
    console = Console()
    return console if console.is_terminal else Console(width=WIDTH)


def wrong_usage(error: Exception) -> typer.Exit:
    """Says what is wrong on standard error; status 2."""
    Console(stderr=True).print(
        f"occgrid-parity: {error}", markup=False, soft_wrap=True
    )
    return typer.Exit(2)


def print_plain(console: Console, text: str) -> None:
    """Text as it is: neither markup nor wrapped."""
    console.print(text, markup=False, highlight=False, soft_wrap=True)
