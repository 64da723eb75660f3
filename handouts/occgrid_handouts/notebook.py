"""The handout as a Jupyter notebook that has been run from top to bottom."""

from __future__ import annotations

import base64
import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

from occgrid_handouts.blocks import (
    Block,
    Bullets,
    Command,
    Figure,
    Formula,
    Heading,
    Listing,
    NoteTitle,
    Paragraph,
    Program,
    Table,
)
from occgrid_handouts.machine import time_limit
from occgrid_handouts.mathml import latex
from occgrid_handouts.page_tree import Element

SETUP = """\
# The notebook lies beside the folder python, or in a folder below.
import os
import sys
from pathlib import Path
from typing import Any

here = Path.cwd()
places = (here, *here.parents)
root = next(p for p in places if (p / "python" / "occgrid").is_dir())
os.chdir(root)
sys.path.insert(0, str(root / "python"))"""

# for one cell, on an idle desktop computer
SECONDS = 30

# nbformat has no types
V4: Any = nbformat.v4
WRITES: Any = nbformat.writes


def make_notebook(
    title: str, stamp: str, blocks: Sequence[Block]
) -> nbformat.NotebookNode:
    """Cells in the order of the page: its text, and its programs as code."""
    notebook: nbformat.NotebookNode = V4.new_notebook()
    notebook.metadata["kernelspec"] = {
        "display_name": "Python 3",
        "language": "python",
        "name": "python3",
    }
    cells = [
        V4.new_markdown_cell(f"# {title}\n\n{stamp}"),
        V4.new_code_cell(SETUP),
    ]
    waiting: list[str] = []
    pictures: dict[str, bytes] = {}

    def flush() -> None:
        if waiting:
            cell = V4.new_markdown_cell("\n\n".join(waiting))
            if pictures:
                cell["attachments"] = {
                    name: {
                        "image/svg+xml": base64.b64encode(svg).decode("ascii")
                    }
                    for name, svg in pictures.items()
                }
            cells.append(cell)
            waiting.clear()
            pictures.clear()

    figures = 0
    for block in blocks:
        if isinstance(block, Program):
            flush()
            cells.append(V4.new_code_cell(block.code))
            continue
        if isinstance(block, Heading | Figure):
            flush()
        if isinstance(block, Figure):
            for picture in block.pictures:
                figures += 1
                name = f"figure-{figures}.svg"
                pictures[name] = picture.svg
                waiting.append(f"![{picture.alt}](attachment:{name})")
            waiting.append(f"*{markdown(block.caption)}*")
        else:
            waiting.append(block_markdown(block))
    flush()
    for i, cell in enumerate(cells):
        cell["id"] = f"cell-{i}"
    notebook.cells = cells
    return notebook


def run_notebook(notebook: nbformat.NotebookNode, folder: Path) -> None:
    """Executes all cells in a folder. Raises nbclient's CellExecutionError where one fails."""
    with _quiet_kernel() as sockets:
        client = NotebookClient(
            notebook,
            kernel_name="python3",
            timeout=round(time_limit(SECONDS)),
            record_timing=False,
            coalesce_streams=True,
            resources={"metadata": {"path": str(folder)}},
        )
        # a kernel of the client's own, which it ends, on files and not on the network
        manager = client.create_kernel_manager()
        manager.transport = "ipc"
        manager.ip = f"{sockets}/kernel"
        client.execute()


@contextmanager
def _quiet_kernel() -> Iterator[str]:
    """A kernel that leaves nothing in the home folder and draws pictures that are the same at every build."""
    with tempfile.TemporaryDirectory() as folder:
        settings = {
            "IPYTHONDIR": folder,
            "JUPYTER_RUNTIME_DIR": folder,
            "JUPYTER_PLATFORM_DIRS": "1",
            "MPLCONFIGDIR": folder,
            "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        }
        kept = {name: os.environ.get(name) for name in settings}
        os.environ.update(settings)
        try:
            yield folder
        finally:
            for name, value in kept.items():
                if value is None:
                    del os.environ[name]
                else:
                    os.environ[name] = value


def notebook_text(notebook: nbformat.NotebookNode) -> str:
    """The notebook's file."""
    return str(WRITES(notebook)) + "\n"


# --- Markdown ---


def block_markdown(block: Block) -> str:
    """A block as Markdown."""
    match block:
        case Heading(level, text):
            return f"{'#' * (level + 1)} {text}"
        case Paragraph(content):
            return markdown(content)
        case NoteTitle(text):
            return f"**{text}**"
        case Bullets(items):
            return "\n".join(
                f"- **{markdown(term)}:** {markdown(item)}"
                if term is not None
                else f"- {markdown(item)}"
                for term, item in items
            )
        case Formula(math, number, in_code):
            tag = rf" \tag{{{number.strip('()')}}}" if number else ""
            said = f"\n\n*{in_code}*" if in_code else ""
            return f"$${latex(math)}{tag}$${said}"
        case Listing(head, code):
            return f"*{head}*\n\n```python\n{code}\n```"
        case Command(text):
            return f"```sh\n{text}\n```"
        case Table(rows, caption):
            lines = [
                "| " + " | ".join(_table_cell(c) for c in row) + " |"
                for row in rows
            ]
            lines.insert(1, "|" + " --- |" * len(rows[0]))
            return "\n".join([*lines, "", f"*{markdown(caption)}*"])
    raise TypeError(f"{type(block).__name__} is no text")


def _table_cell(cell: Element) -> str:
    text = markdown(cell).replace("|", r"\|")
    span = int(cell.attributes.get("colspan", "1"))
    return text + " |" * (span - 1)


def markdown(element: Element | str) -> str:
    """Running text as Markdown."""
    if isinstance(element, str):
        return _escape(" ".join(element.split(" ")).replace("\n", " "))
    inside = "".join(map(markdown, element.children))
    match element.tag:
        case "math":
            return f"${latex(element)}$"
        case "code":
            return f"`{element.text()}`"
        case "strong":
            return f"**{inside}**"
        case "em":
            return f"*{inside}*"
        case "p":
            return inside.strip()
    return inside


def _escape(text: str) -> str:
    return "".join("\\" + c if c in "\\`*_$" else c for c in text)
