"""A page as a list of blocks: headings, paragraphs, formulas, listings, figures. One reader for three writers."""

from __future__ import annotations

import base64
from dataclasses import dataclass

from occgrid_handouts.page_tree import Element

SIDE_BY_SIDE = "The same code in"


@dataclass(frozen=True)
class Heading:
    """``level`` 1 is a section; ``number`` as the page has it."""

    level: int
    text: str


@dataclass(frozen=True)
class Paragraph:
    """Running text: an element with inline children."""

    content: Element


@dataclass(frozen=True)
class Bullets:
    """A list of items, or of terms with their descriptions."""

    items: tuple[tuple[Element | None, Element], ...]


@dataclass(frozen=True)
class Formula:
    """A displayed equation, its number and where the code is; both may be empty."""

    math: Element
    number: str
    in_code: str


@dataclass(frozen=True)
class Listing:
    """A snippet of the sources."""

    head: str
    code: str


@dataclass(frozen=True)
class Program:
    """A program that the reader runs."""

    name: str
    head: str
    code: str


@dataclass(frozen=True)
class Command:
    """Lines for a terminal."""

    text: str


@dataclass(frozen=True)
class Picture:
    """An image and its description."""

    alt: str
    svg: bytes


@dataclass(frozen=True)
class Figure:
    """Pictures with a caption."""

    pictures: tuple[Picture, ...]
    caption: Element


@dataclass(frozen=True)
class Table:
    """Rows of cells, the first row their heads."""

    rows: tuple[tuple[Element, ...], ...]
    caption: Element


@dataclass(frozen=True)
class NoteTitle:
    """The title of a box; its text follows as blocks of its own."""

    text: str


Block = (
    Heading
    | Paragraph
    | Bullets
    | Formula
    | Listing
    | Program
    | Command
    | Figure
    | Table
    | NoteTitle
)


def read_blocks(page: Element) -> list[Block]:
    """The blocks of a page's main part, without its appendix of tabs."""
    main = page.find("main")
    if main is None:
        raise ValueError("the page has no main part")
    blocks = _blocks(main)
    for i, block in enumerate(blocks):
        if isinstance(block, Heading) and SIDE_BY_SIDE in block.text:
            return blocks[:i]
    return blocks


def _blocks(parent: Element) -> list[Block]:
    """The blocks in an element; text and inline elements that stand between blocks are paragraphs."""
    found: list[Block] = []
    loose: list[Element | str] = []

    def flush() -> None:
        paragraph = Element("p", {}, list(loose))
        if paragraph.text().strip():
            found.append(Paragraph(paragraph))
        loose.clear()

    for child in parent.children:
        if isinstance(child, str) or _is_inline(child):
            loose.append(child)
        else:
            flush()
            found.extend(_of_element(child))
    flush()
    return found


def _is_inline(element: Element) -> bool:
    if element.tag == "math":
        return element.attributes.get("display") != "block"
    return element.tag in ("strong", "em", "code", "a", "span", "br")


def _of_element(element: Element) -> list[Block]:
    match element.tag:
        case "h2" | "h3" | "h4":
            return [Heading(int(element.tag[1]) - 1, _flat(element))]
        case "p":
            if element.has_class("head"):
                return [NoteTitle(_flat(element))]
            return [Paragraph(element)]
        case "math":
            return [Formula(element, "", "")]
        case "ul" | "ol":
            items = [(None, item) for item in element.elements()]
            return [Bullets(tuple(items))]
        case "dl":
            return [_terms(element)]
        case "figure":
            return [_figure(element)]
        case "section":
            return [_listing(element)]
        case "aside":
            return _blocks(element)
        case "div" if element.has_class("equation"):
            return [_formula(element)]
        case "div" if element.has_class("command"):
            return [Command(element.text().strip("\n"))]
        case "div" if element.has_class("tabs"):
            return []
    raise ValueError(f"<{element.tag}> among the blocks of a page")


def _flat(element: Element) -> str:
    return " ".join(element.text().split())


def _terms(element: Element) -> Bullets:
    items: list[tuple[Element | None, Element]] = []
    term: Element | None = None
    for part in element.elements():
        if part.tag == "dt":
            term = part
        else:
            items.append((term, part))
    return Bullets(tuple(items))


def _formula(element: Element) -> Formula:
    math = element.find("math")
    if math is None:
        raise ValueError("an equation without mathematics")
    number = in_code = ""
    for part in element.elements():
        if part.has_class("number"):
            number = _flat(part)
        elif part.has_class("in-code"):
            in_code = _flat(part)
    return Formula(math, number, in_code)


def _listing(element: Element) -> Listing | Program:
    head, code = element.elements()
    lines = code.text().strip("\n")
    name = element.attributes.get("id", "")
    if name.startswith("try-"):
        return Program(name.removeprefix("try-"), _flat(head), lines)
    return Listing(_flat(head), lines)


def _figure(element: Element) -> Figure | Table:
    caption = element.find("figcaption")
    if caption is None:
        raise ValueError("a figure without a caption")
    table = element.find("table")
    if table is not None:
        rows = [e for e in table.walk() if e.tag == "tr"]
        return Table(tuple(tuple(r.elements()) for r in rows), caption)
    pictures = []
    for part in element.walk():
        if part.tag == "img":
            data = part.attributes["src"].split(",", 1)[1]
            svg = base64.b64decode(data)
            pictures.append(Picture(part.attributes["alt"], svg))
        elif part.attributes.get("role") == "img":
            drawing = part.find("svg")
            if drawing is None:
                raise ValueError("a drawing without its picture")
            alt = part.attributes["aria-label"]
            pictures.append(Picture(alt, drawing.html().encode()))
    return Figure(tuple(pictures), caption)
