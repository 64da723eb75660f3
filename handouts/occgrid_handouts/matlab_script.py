"""The handout as a script with %% sections, for MATLAB and GNU Octave."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

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
from occgrid_handouts.mathml import latex
from occgrid_handouts.page_tree import Element

COLUMNS = 75

SETUP = """\
% The script lies beside the folder matlab, or in a folder below.
root = fileparts(mfilename('fullpath'));
if isempty(root)
    root = pwd;
end
while ~exist(fullfile(root, 'matlab', '+occgrid'), 'dir') && ...
        ~strcmp(root, fileparts(root))
    root = fileparts(root);
end
cd(root);
addpath(fullfile(root, 'matlab'));"""


def script_text(title: str, stamp: str, blocks: Sequence[Block]) -> str:
    """The script's file: the page's text as comments, its programs as code."""
    lines = [f"%% {title}", f"% {stamp}", "", SETUP, ""]
    for block in blocks:
        lines += _lines(block)
        lines.append("")
    text = "\n".join(lines)
    while "\n\n\n" in text:
        text = text.replace("\n\n\n", "\n\n")
    return text.rstrip("\n") + "\n"


def _lines(block: Block) -> list[str]:
    match block:
        case Heading(_, text):
            return [f"%% {text}"]
        case Paragraph(content):
            return _comment(running(content))
        case NoteTitle(text):
            return [f"% *{text}*", "%"]
        case Bullets(items):
            lines = []
            for term, item in items:
                label = f"*{running(term)}:* " if term is not None else ""
                lines += _comment(label + running(item), "* ")
            return lines
        case Formula(math, number, in_code):
            lines = _comment(f"$${latex(math)}$$ {number}".rstrip())
            return [*lines, *(_comment(in_code) if in_code else [])]
        case Listing(head, code):
            body = [f"%   {line}".rstrip() for line in code.splitlines()]
            return [*_comment(head), "%", *body]
        case Program(_, head, code):
            return [*_comment(head), code]
        case Command(text):
            return [f"%   {line}" for line in text.splitlines()]
        case Figure(pictures, caption):
            lines = _comment(running(caption))
            for picture in pictures:
                lines += _comment(f"[Picture: {picture.alt}]")
            return lines
        case Table(rows, caption):
            texts = [[running(cell) for cell in row] for row in rows]
            columns = max(map(len, texts))
            widths = [
                max(len(row[i]) for row in texts if len(row) == columns)
                for i in range(columns)
            ]
            body = [
                "%   "
                + "  ".join(
                    text.ljust(width)
                    for text, width in zip(row, widths, strict=False)
                ).rstrip()
                for row in texts
            ]
            return [*_comment(running(caption)), "%", *body]
    raise TypeError(f"{type(block).__name__} has no lines")


def _comment(text: str, bullet: str = "") -> list[str]:
    return textwrap.wrap(
        text,
        COLUMNS,
        initial_indent="% " + bullet,
        subsequent_indent="% " + " " * len(bullet),
        break_long_words=False,
        break_on_hyphens=False,
    )


def running(element: Element | str) -> str:
    """Running text in the markup of MATLAB's publish."""
    if isinstance(element, str):
        return element.replace("\n", " ")
    inside = "".join(map(running, element.children))
    match element.tag:
        case "math":
            return f"${latex(element)}$"
        case "strong":
            return f"*{inside}*"
        case "em":
            return f"_{inside}_"
        case "code":
            return f"|{inside}|"
        case "p":
            return inside.strip()
    return inside
