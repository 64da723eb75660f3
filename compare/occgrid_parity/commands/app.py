"""The command ``occgrid-parity``."""

from __future__ import annotations

from importlib import import_module
from typing import Annotated

import typer
from typer.core import TyperGroup

from occgrid import __version__

COMMANDS = (
    "check",
    "mistakes",
    "build",
    "run",
    "campaign",
    "golden",
    "scenario",
)


class Commands(TyperGroup):
    """The commands. Each is in a module of its own, which is imported only when it is asked for."""

    def list_commands(self, ctx: typer.Context) -> list[str]:  # type: ignore[override]
        """Their names, as the help lists them."""
        return list(COMMANDS)

    def get_command(  # type: ignore[override]
        self, ctx: typer.Context, cmd_name: str
    ) -> object:
        """One of them, None where there is no such command."""
        if cmd_name not in COMMANDS:
            return None
        name = f"{cmd_name}_command"
        module = import_module(f"occgrid_parity.commands.{name}")
        one = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
        one.command(cmd_name)(getattr(module, name))
        return typer.main.get_command(one)


app = typer.Typer(
    cls=Commands,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


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
