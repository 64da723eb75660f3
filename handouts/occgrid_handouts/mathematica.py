"""The handout as a Mathematica notebook: one Notebook[...] expression."""

from __future__ import annotations

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
from occgrid_handouts.mathml import boxes, wolfram_string
from occgrid_handouts.page_tree import Element

SETUP = """\
(* The notebook lies beside the folder mathematica, or in a folder below. *)
package = FileNameJoin[{"mathematica", "OccupancyGrid.wl"}];
root = NestWhile[ParentDirectory, NotebookDirectory[],
  (! FileExistsQ[FileNameJoin[{#, package}]]) && # =!= ParentDirectory[#] &];
SetDirectory[root];
Get[package];"""


def notebook_expression(
    title: str, stamp: str, blocks: Sequence[Block]
) -> str:
    """The notebook's file."""
    cells = [
        _cell(wolfram_string(title), "Title"),
        _cell(wolfram_string(stamp), "Subtitle"),
        _input(SETUP),
    ]
    for block in blocks:
        cells += _cells(block)
    body = ",\n\n".join(cells)
    return (
        "(* Content-type: application/vnd.wolfram.mathematica *)\n\n"
        f"Notebook[{{\n\n{body}\n\n}},\n"
        'WindowSize->{900, 1000},\nStyleDefinitions->"Default.nb"]\n'
    )


def _cells(block: Block) -> list[str]:
    match block:
        case Heading(level, text):
            style = "Section" if level == 1 else "Subsection"
            return [_cell(wolfram_string(text), style)]
        case Paragraph(content):
            return [_cell(text_data([content]), "Text")]
        case NoteTitle(text):
            title = f'StyleBox[{wolfram_string(text)}, FontWeight->"Bold"]'
            return [_cell(f"TextData[{{{title}}}]", "Text")]
        case Bullets(items):
            cells = []
            for term, item in items:
                parts = [item]
                if term is not None:
                    label = Element("strong", {}, [*term.children, ": "])
                    parts = [label, item]
                cells.append(_cell(text_data(parts), "Item"))
            return cells
        case Formula(math, number, in_code):
            form = f"BoxData[FormBox[{boxes(math)}, TraditionalForm]]"
            style = "DisplayFormulaNumbered" if number else "DisplayFormula"
            cells = [_cell(form, style)]
            if in_code:
                cells.append(_cell(wolfram_string(in_code), "Caption"))
            return cells
        case Listing(head, code):
            return [
                _cell(wolfram_string(head), "Caption"),
                _cell(wolfram_string(code), "Program"),
            ]
        case Program(_, _, code):
            return [_input(code)]
        case Command(text):
            return [_cell(wolfram_string(text), "Program")]
        case Figure(pictures, caption):
            # pictures are on the page and in print; here stands what they show
            said = [
                _cell(wolfram_string(f"[Picture: {p.alt}]"), "Text")
                for p in pictures
            ]
            return [*said, _cell(text_data([caption]), "Caption")]
        case Table(rows, caption):
            lines = [
                "{"
                + ", ".join(
                    f'Cell[{text_data([c])}, "Text"]'
                    + ', "\\[SpanFromLeft]"'
                    * (int(c.attributes.get("colspan", "1")) - 1)
                    for c in row
                )
                + "}"
                for row in rows
            ]
            grid = "GridBox[{" + ", ".join(lines) + "}]"
            return [
                _cell(f"BoxData[{grid}]", "Text"),
                _cell(text_data([caption]), "Caption"),
            ]
    raise TypeError(f"{type(block).__name__} has no cell")


def _cell(content: str, style: str) -> str:
    return f'Cell[{content}, "{style}"]'


def _input(code: str) -> str:
    """An input cell; the front end makes boxes of its text when it is opened."""
    return f'Cell[BoxData[{wolfram_string(code)}], "Input"]'


def text_data(parts: Sequence[Element]) -> str:
    """Running text with formulas in it."""
    pieces: list[str] = []
    for part in parts:
        _collect(part, pieces, "")
    return f"TextData[{{{', '.join(pieces) or wolfram_string('')}}}]"


def _collect(element: Element | str, pieces: list[str], style: str) -> None:
    if isinstance(element, str):
        text = wolfram_string(element.replace("\n", " "))
        if element:
            pieces.append(f"StyleBox[{text}, {style}]" if style else text)
        return
    match element.tag:
        case "math":
            form = f"FormBox[{boxes(element)}, TraditionalForm]"
            pieces.append(f"Cell[BoxData[{form}]]")
            return
        case "strong":
            style = 'FontWeight->"Bold"'
        case "em":
            style = 'FontSlant->"Italic"'
        case "code":
            style = 'FontFamily->"Source Code Pro"'
    for child in element.children:
        _collect(child, pieces, style)
