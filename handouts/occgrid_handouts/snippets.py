"""Named snippets of the ports' sources (CONTRIBUTING.md, "Snippets")."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from occgrid_handouts.languages import Language

MAX_COLUMNS = 79

# in the order of CONTRIBUTING.md
NAMES = (
    "portable-sin",
    "portable-exp",
    "portable-log",
    "philox",
    "normal-deviate",
    "range-noise",
    "grid-spec",
    "logit",
    "sigmoid",
    "world-to-grid",
    "update-cell",
    "probability-grid",
    "bresenham",
    "box-world",
    "ray-segment-intersection",
    "simulate-lidar-scan",
    "beam-angles",
    "flaser-angles",
    "read-ranges",
    "beam-endpoints",
    "update-grid-from-scan",
    "lesson-settings",
    "lesson-world",
    "lesson-poses",
    "map-scenario",
    "clip-ray",
    "update-grid-from-scans",
    "pixel",
    "map-pgm",
)

_COMMENT = r"\s*(?:#|//|%|\(\*)\s*"
_BEGIN = re.compile(_COMMENT + r"\[snippet: ([^\]]*)\]\s*(?:\*\))?\s*")
_END = re.compile(_COMMENT + r"\[/snippet\]\s*(?:\*\))?\s*")


class SnippetError(ValueError):
    """A marker or a name that cannot be used; the text says where."""


@dataclass(frozen=True)
class Snippet:
    """A part of a source file: lines ``first`` to ``last``, counted from 1.

    ``file`` is relative to the repository's root; the indentation that all lines of ``code`` share is taken away.
    """

    name: str
    file: str
    first: int
    last: int
    code: str


def read_snippets(root: Path, language: Language) -> dict[str, Snippet]:
    """All snippets of a port by name, in the order of its files. Raises SnippetError."""
    found: dict[str, Snippet] = {}
    for path in source_files(root, language):
        file = path.relative_to(root).as_posix()
        for snippet in parse_snippets(file, path.read_text(encoding="utf-8")):
            if snippet.name in found:
                raise SnippetError(
                    f"{file}:{snippet.first}: snippet {snippet.name} is also "
                    f"in {found[snippet.name].file}"
                )
            found[snippet.name] = snippet
    return found


def source_files(root: Path, language: Language) -> list[Path]:
    """The tested sources of a port."""
    return sorted(
        {path for pattern in language.sources for path in root.glob(pattern)}
    )


def parse_snippets(file: str, text: str) -> list[Snippet]:
    """The snippets of one source file. Raises SnippetError where markers do not pair or a line is too long."""
    snippets: list[Snippet] = []
    name, begin = "", 0
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if match := _BEGIN.fullmatch(line):
            if name:
                raise SnippetError(f"{file}:{number}: {name} is still open")
            name, begin = match[1].strip(), number
            if not name:
                raise SnippetError(f"{file}:{number}: a snippet has no name")
        elif _END.fullmatch(line):
            if not name:
                raise SnippetError(f"{file}:{number}: no snippet is open")
            snippets.append(_cut(file, name, lines, begin, number))
            name = ""
        elif name and len(line) > MAX_COLUMNS:
            raise SnippetError(
                f"{file}:{number}: {len(line)} columns in snippet {name}, "
                f"{MAX_COLUMNS} fit"
            )
    if name:
        raise SnippetError(f"{file}:{begin}: {name} is never closed")
    return snippets


def _cut(
    file: str, name: str, lines: list[str], begin: int, end: int
) -> Snippet:
    """The lines between two markers, without blank ones at their ends."""
    first, last = begin + 1, end - 1
    while first <= last and not lines[first - 1].strip():
        first += 1
    while first <= last and not lines[last - 1].strip():
        last -= 1
    if first > last:
        raise SnippetError(f"{file}:{begin}: snippet {name} is empty")
    code = textwrap.dedent("\n".join(lines[first - 1 : last])).expandtabs(4)
    return Snippet(name, file, first, last, code)


def require(
    language: Language, found: dict[str, Snippet], names: Iterable[str]
) -> None:
    """Raises SnippetError where a port lacks a snippet, or has one that is not in the list."""
    missing = [name for name in names if name not in found]
    if missing:
        raise SnippetError(
            f"{language.folder}: no snippet {', '.join(missing)}"
        )
    unknown = [name for name in found if name not in NAMES]
    if unknown:
        raise SnippetError(
            f"{language.folder}: unknown snippet {', '.join(unknown)}"
        )
