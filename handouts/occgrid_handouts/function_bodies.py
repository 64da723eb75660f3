"""Takes the body out of a function: signature and documentation stay, and a line says what is to be written."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Callable

from occgrid_parity.ports.snippets import MAX_COLUMNS


class CutError(ValueError):
    """A function that is not where it should be; the text says which."""


def has_function(language: str, code: str, name: str) -> bool:
    """Whether the code defines the function, named in the language's own way."""
    return _HEADS[language](name).search(code) is not None


def without_body(
    language: str, code: str, name: str, task: str, said: str
) -> str:
    """The code with another body for the function. Raises CutError where it has no such function."""
    lines = code.split("\n")
    try:
        first, last, indent = _BODIES[language](code, lines, name)
    except (StopIteration, IndexError) as error:
        raise CutError(f"no function {name}") from error
    comment, statement = _STUBS[language]
    stub = _comment(comment, indent, f"To be written: {task}.")
    stub.append(indent + statement.replace("{said}", said))
    if language == "mathematica":
        # the line of the assignment has the beginning of the body, too
        stub.insert(0, lines[first][: lines[first].index(":=") + 2])
    return "\n".join([*lines[:first], *stub, *lines[last + 1 :]])


def _comment(marks: tuple[str, str], indent: str, text: str) -> list[str]:
    opening, closing = marks
    room = MAX_COLUMNS - len(indent) - len(opening) - len(closing)
    return [
        f"{indent}{opening}{line}{closing}"
        for line in textwrap.wrap(text, room)
    ]


_STUBS = {
    "python": (("# ", ""), 'raise SystemExit("{said}")'),
    "cpp": (("// ", ""), 'not_written("{said}");'),
    "java": (("// ", ""), 'throw NotWritten.yet("{said}");'),
    "matlab": (("% ", ""), "error('occgrid:exercise', '{said}');"),
    "mathematica": (("(* ", " *)"), 'notWritten["{said}"];'),
}

_HEADS: dict[str, Callable[[str], re.Pattern[str]]] = {
    "python": lambda name: re.compile(rf"(?m)^ *def {name}\("),
    "cpp": lambda name: re.compile(
        rf"(?m)^(?![ \n#/])[^\n;=]*?\b(?:OccupancyGrid::)?{name}\("
    ),
    "java": lambda name: re.compile(
        rf"(?m)^ *(?:public |private |static )+[\w<>\[\], ]+ {name}\("
    ),
    "matlab": lambda name: re.compile(rf"(?m)^ *function [^\n]*\b{name}\("),
    "mathematica": lambda name: re.compile(rf"(?m)^{name}\["),
}

# first and last line of the body, from 0, and its indentation
Body = tuple[int, int, str]


def _python_body(code: str, lines: list[str], name: str) -> Body:
    found = [
        node
        for node in ast.walk(ast.parse(code))
        if isinstance(node, ast.FunctionDef)
        and node.name == name
        and not node.decorator_list
    ]
    node = found[0]
    documentation = node.body[0]
    first = documentation.end_lineno
    assert first is not None and node.end_lineno is not None
    return first, node.end_lineno - 1, " " * documentation.col_offset


def _braced_body(language: str, code: str, name: str) -> Body:
    """Between the braces of a function of C++ or Java, each on the last column of a line or alone."""
    head = _HEADS[language](name).search(code)
    if head is None:
        raise IndexError(name)
    opening = code.index("{", _closing(code, head.end() - 1))
    closing = _closing(code, opening)
    first = code.count("\n", 0, opening) + 1
    last = code.count("\n", 0, closing) - 1
    line = code[: head.end()].split("\n")[-1]
    indent = line[: len(line) - len(line.lstrip())]
    return first, last, indent + ("  " if language == "cpp" else "    ")


def _closing(code: str, opening: int) -> int:
    """Where the bracket at ``opening`` is closed. There is none in the texts and comments of these functions."""
    kinds = {"(": ")", "{": "}", "[": "]"}
    left, right = code[opening], kinds[code[opening]]
    depth = 0
    for i in range(opening, len(code)):
        depth += (code[i] == left) - (code[i] == right)
        if depth == 0:
            return i
    raise IndexError(opening)


def _matlab_body(code: str, lines: list[str], name: str) -> Body:
    head = _HEADS["matlab"](name).search(code)
    if head is None:
        raise IndexError(name)
    start = code.count("\n", 0, head.end())
    indent = lines[start][: len(lines[start]) - len(lines[start].lstrip())]
    last = next(
        i for i in range(start, len(lines)) if lines[i] == f"{indent}end"
    )
    first = start
    while lines[first].rstrip().endswith("..."):
        first += 1
    first += 1
    while lines[first].lstrip().startswith("%"):
        first += 1
    return first, last - 1, indent + "    "


# not that of a condition, /;
_ENDS = re.compile(r"(?<!/);\n")


def _wolfram_body(code: str, lines: list[str], name: str) -> Body:
    """After the := of a definition, up to the semicolon that ends it at a line's end."""
    head = _HEADS["mathematica"](name).search(code)
    if head is None:
        raise IndexError(name)
    assignment = code.index(":=", head.end())
    depth = 0
    for i in range(assignment, len(code)):
        depth += (code[i] in "[{(") - (code[i] in "]})")
        if depth == 0 and _ENDS.match(code, i):
            break
    else:
        raise IndexError(name)
    first = code.count("\n", 0, assignment)
    return first, code.count("\n", 0, i), "  "


_BODIES: dict[str, Callable[[str, list[str], str], Body]] = {
    "python": _python_body,
    "cpp": lambda code, lines, name: _braced_body("cpp", code, name),
    "java": lambda code, lines, name: _braced_body("java", code, name),
    "matlab": _matlab_body,
    "mathematica": _wolfram_body,
}
