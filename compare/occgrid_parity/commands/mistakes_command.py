"""The command ``occgrid-parity mistakes``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table

from occgrid_parity.commands.console import Root, print_plain
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.report.mistakes_page import PAGE, page, table
from occgrid_parity.suite.repository import find_root

Write = Annotated[bool, typer.Option("--write", help=f"Write {PAGE}.")]


def mistakes_command(write: Write = False, root: Root = None) -> None:
    """List the mistakes that `occgrid-parity check` knows, or write the page about them."""
    console = Console()
    if write:
        folder = (find_root() if root is None else root) / Path(PAGE).parent
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / Path(PAGE).name
        write_text(file, page(table()))
        print_plain(console, str(file))
        return
    shown = Table("name", "mistake")
    for name, mistake in MISTAKES.items():
        shown.add_row(name, mistake.title)
    console.print(shown)
