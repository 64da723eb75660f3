"""Named snippets of the ports' sources, as CONTRIBUTING.md describes them."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass

MAX_COLUMNS = 79

_MARKER = re.compile(r"\[/?snippet\b")
_COMMENT = r"\s*(?:#|//|%|\(\*)\s*"
_BEGIN = re.compile(_COMMENT + r"\[snippet: ([a-z0-9-]+)\]\s*(?:\*\))?\s*")
_END = re.compile(_COMMENT + r"\[/snippet\]\s*(?:\*\))?\s*")


class SnippetError(ValueError):
    """A marker or a name that cannot be used; the text says where."""


@dataclass(frozen=True)
class Snippet:
    """A part of a source file: lines ``first`` to ``last``, counted from 1.

    ``file`` is the name that the parser was given; the indentation that all lines of ``code`` share is taken away.
    """

    name: str
    file: str
    first: int
    last: int
    code: str


def parse_snippets(file: str, text: str) -> list[Snippet]:
    """The snippets of one source file, in its order.

    Raises SnippetError where a marker is no comment of its own line, where markers do not pair, where a name comes
    twice and where a line is too long or has a tab.
    """
    snippets: list[Snippet] = []
    name, begin = "", 0
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        place = f"{file}:{number}"
        if match := _BEGIN.fullmatch(line):
            if name:
                raise SnippetError(f"{place}: {name} is still open")
            name, begin = match[1], number
            if any(name == one.name for one in snippets):
                raise SnippetError(f"{place}: snippet {name} a second time")
        elif _END.fullmatch(line):
            if not name:
                raise SnippetError(f"{place}: no snippet is open")
            snippets.append(_cut(file, name, lines, begin, number))
            name = ""
        elif _MARKER.search(line):
            raise SnippetError(
                f"{place}: a marker is a comment on a line of its own, "
                "[snippet: a-name] or [/snippet]"
            )
        elif name and len(line) > MAX_COLUMNS:
            raise SnippetError(
                f"{place}: {len(line)} columns in snippet {name}, "
                f"{MAX_COLUMNS} fit"
            )
        elif name and "\t" in line:
            raise SnippetError(f"{place}: a tab in snippet {name}")
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
    code = textwrap.dedent("\n".join(lines[first - 1 : last]))
    return Snippet(name, file, first, last, code)
