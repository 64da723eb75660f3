"""The command ``occgrid-parity mistakes``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table

from occgrid_parity.formats.text_files import write_text
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.report.mistakes_page import PAGE, page, table
from occgrid_parity.suite.repository import find_root

Write = Annotated[bool, typer.Option("--write", help=f"Write {PAGE}.")]
Root = Annotated[
    Path | None,
    typer.Option(
        "--root", metavar="DIR", help="The repository, if not this one."
    ),
]


def mistakes_command(write: Write = False, root: Root = None) -> None:
    """List the mistakes that `occgrid-parity check` knows, or write the page about them."""
    console = Console()
    if write:
        folder = (find_root() if root is None else root) / Path(PAGE).parent
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / Path(PAGE).name
        write_text(file, page(table()))
        console.print(str(file), markup=False, highlight=False, soft_wrap=True)
        return
    shown = Table("name", "mistake")
    for name, mistake in MISTAKES.items():
        shown.add_row(name, mistake.title)
    console.print(shown)
