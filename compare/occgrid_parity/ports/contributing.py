"""The tables of CONTRIBUTING.md that say what every port has: its modules, functions and snippets."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

PAGE = "CONTRIBUTING.md"
_SIGNATURE = re.compile(r"`(?P<name>\w+)(?:\((?P<parameters>[^`]*)\))?`")


@dataclass(frozen=True)
class Signature:
    """A public name and its parameters, in Python's case; None where the page gives none."""

    name: str
    parameters: tuple[str, ...] | None

    def __str__(self) -> str:
        if self.parameters is None:
            return self.name
        return f"{self.name}({', '.join(self.parameters)})"


def read_table(root: Path, section: str) -> list[list[str]]:
    """The rows of the first table below a heading of the page, without its head; each a list of cells.

    Raises ValueError where the section or its table is missing, or a row is too short.
    """
    text = (root / PAGE).read_text(encoding="utf-8")
    _, found, after = text.partition(f"\n## {section}\n")
    lines = after.partition("\n## ")[0].splitlines()
    first = next((i for i, line in enumerate(lines) if line[:1] == "|"), None)
    if not found or first is None:
        raise ValueError(f"{PAGE}: no table in a section {section!r}")
    rows = []
    for line in lines[first:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    for row in rows:
        if len(row) != len(rows[0]):
            raise ValueError(
                f"{PAGE}: {section}: not {len(rows[0])} cells: {row}"
            )
    return rows[2:]


def module_functions(root: Path) -> dict[str, list[Signature]]:
    """Every module and its public names, in the order of the page."""
    return {
        module: signatures(functions)
        for module, functions in read_table(root, "Modules")
    }


def signatures(cell: str) -> list[Signature]:
    """What stands in backquotes: `name` or `name(first, second)`."""
    return [
        Signature(match["name"], parameter_names(match["parameters"]))
        for match in _SIGNATURE.finditer(cell)
    ]


def parameter_names(text: str | None) -> tuple[str, ...] | None:
    """The names between commas: none in an empty text."""
    if text is None:
        return None
    return tuple(word.strip() for word in text.split(",") if word.strip())


def module_snippets(root: Path) -> dict[str, list[str]]:
    """The snippets of each module that has some, in the order of the page."""
    return {
        module: re.findall(r"`([a-z0-9-]+)`", names)
        for module, names in read_table(root, "Snippets")
    }


def snippet_names(root: Path) -> list[str]:
    """All snippets, in the order of the page."""
    return [name for names in module_snippets(root).values() for name in names]
