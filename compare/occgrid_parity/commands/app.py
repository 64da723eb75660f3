"""The command ``occgrid-parity``."""

from __future__ import annotations

from typing import Annotated

import typer

from occgrid import __version__
from occgrid_parity.commands.build_command import build_command
from occgrid_parity.commands.campaign_command import campaign_command
from occgrid_parity.commands.check_command import check_command
from occgrid_parity.commands.golden_command import golden_command
from occgrid_parity.commands.mistakes_command import mistakes_command
from occgrid_parity.commands.run_command import run_command
from occgrid_parity.commands.scenario_command import scenario_command

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


app.command("check")(check_command)
app.command("mistakes")(mistakes_command)
app.command("build")(build_command)
app.command("run")(run_command)
app.command("campaign")(campaign_command)
app.command("golden")(golden_command)
app.command("scenario")(scenario_command)


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
