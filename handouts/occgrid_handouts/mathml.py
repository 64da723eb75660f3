"""Equations of a page in other notations: LaTeX for notebooks and comments, boxes for Mathematica."""

from __future__ import annotations

import re
import unicodedata

from occgrid_handouts.page_tree import Element

_LATEX = {
    "η": r"\eta",
    "α": r"\alpha",
    "θ": r"\theta",
    "φ": r"\varphi",
    "ϕ": r"\phi",
    "π": r"\pi",
    "τ": r"\tau",
    "ω": r"\omega",
    "Δ": r"\Delta",
    "ℓ": r"\ell",
    "∈": r"\in",
    "∏": r"\prod",
    "≤": r"\le",
    "≥": r"\ge",
    "≈": r"\approx",
    "∝": r"\propto",
    "→": r"\to",
    "←": r"\leftarrow",
    "⋅": r"\cdot",
    "·": r"\cdot",
    "×": r"\times",
    "÷": r"\div",
    "−": "-",
    "…": r"\ldots",
    "⌊": r"\lfloor",
    "⌋": r"\rfloor",
    "{": r"\{",
    "}": r"\}",
    "|": r"\mid",
    "∣": r"\mid",
    "∎": r"\blacksquare",
    "∕": "/",
}
_FUNCTIONS = {"log", "exp", "cos", "sin", "min", "max"}
_FENCES = {"(": ")", "{": "}", "[": "]", "⌊": "⌋", "|": "|"}


def plain(text: str) -> str:
    """Letters of mathematical alphabets as ordinary ones."""
    return "".join(
        unicodedata.normalize("NFKC", c) if ord(c) > 0xFFFF or c == "ℎ" else c
        for c in text
    )


def children(element: Element) -> list[Element]:
    """The parts of an equation's element."""
    return element.elements()


def is_cases(element: Element) -> bool:
    """Whether it is the table behind a brace."""
    return element.tag == "mtable"


# --- LaTeX ---


def latex(element: Element) -> str:
    """An equation as LaTeX."""
    text = _latex(element)
    # the bar of a condition brings its own space, and so does punctuation
    text = re.sub(r"(?: ?\\,)* ?\\mid(?: ?\\,)*", r" \\mid", text)
    text = re.sub(r" +([,.;)])", r"\1", text)
    text = re.sub(r"\( +", "(", text)
    return re.sub(r"  +", " ", text).strip()


def _latex(element: Element) -> str:
    parts = children(element)
    match element.tag:
        case "math" | "mrow" | "mtd" | "mstyle" | "mpadded":
            return _row(parts)
        case "mi":
            return _identifier(plain(element.text()))
        case "mn":
            return plain(element.text())
        case "mtext":
            return rf"\text{{{element.text()}}}"
        case "mo":
            return _identifier(plain(element.text()))
        case "mspace":
            width = element.attributes.get("width", "0em")
            return r"\quad" if float(width.rstrip("em")) >= 1.0 else r"\,"
        case "msub":
            return f"{_base(parts[0])}_{{{_latex(parts[1])}}}"
        case "msup":
            return f"{_base(parts[0])}^{{{_latex(parts[1])}}}"
        case "msubsup" | "munderover":
            low, high = _latex(parts[1]), _latex(parts[2])
            return f"{_base(parts[0])}_{{{low}}}^{{{high}}}"
        case "mfrac":
            return rf"\frac{{{_latex(parts[0])}}}{{{_latex(parts[1])}}}"
        case "msqrt":
            return rf"\sqrt{{{_row(parts)}}}"
        case "munder":
            return _under(parts)
        case "mtable":
            rows = [
                " & ".join(_latex(cell) for cell in children(row))
                for row in parts
            ]
            body = r" \\ ".join(rows)
            return rf"\begin{{cases}}{body}\end{{cases}}"
    raise ValueError(f"<{element.tag}> in an equation")


def _row(parts: list[Element]) -> str:
    """Parts side by side; fences around something tall grow with it."""
    texts = [p.text() if p.tag == "mo" else "" for p in parts]
    if len(parts) == 2 and texts[0] == "{" and is_cases(parts[1]):
        return _latex(parts[1])
    if len(parts) > 2 and _FENCES.get(texts[0]) == texts[-1]:
        inside = " ".join(map(_latex, parts[1:-1]))
        first, last = _fence(texts[0]), _fence(texts[-1])
        tall = any(e.tag == "mfrac" for p in parts for e in p.walk())
        if tall:
            return rf"\left{first} {inside} \right{last}"
        return f"{first} {inside} {last}"
    return " ".join(map(_latex, parts))


def _fence(text: str) -> str:
    return "|" if text == "|" else _LATEX.get(text, text)


def _identifier(text: str) -> str:
    if text in _FUNCTIONS:
        return f"\\{text}"
    if len(text) > 1 and text not in _LATEX:
        return rf"\operatorname{{{text}}}"
    return _symbol(text)


def _symbol(text: str) -> str:
    return "".join(_LATEX.get(c, c) for c in text)


def _base(element: Element) -> str:
    text = _latex(element)
    simple = element.tag in ("mi", "mn", "mo")
    return text if simple else f"{{{text}}}"


def _under(parts: list[Element]) -> str:
    inner = parts[0]
    if inner.tag == "munder" and "⏟" in children(inner)[1].text():
        body, label = _latex(children(inner)[0]), _latex(parts[1])
        return rf"\underbrace{{{body}}}_{{{label}}}"
    if "⏟" in parts[1].text():
        return rf"\underbrace{{{_latex(inner)}}}"
    return f"{_base(inner)}_{{{_latex(parts[1])}}}"


# --- boxes ---


def boxes(element: Element) -> str:
    """An equation as the boxes of a Mathematica notebook."""
    parts = children(element)
    match element.tag:
        case "math" | "mrow" | "mtd" | "mstyle" | "mpadded":
            return _row_box(list(map(boxes, parts)))
        case "mi" | "mn" | "mo":
            return wolfram_string(plain(element.text()))
        case "mtext":
            return wolfram_string(element.text())
        case "mspace":
            return '" "'
        case "msub" | "munder":
            name = (
                "SubscriptBox" if element.tag == "msub" else "UnderscriptBox"
            )
            return f"{name}[{boxes(parts[0])}, {boxes(parts[1])}]"
        case "msup":
            return f"SuperscriptBox[{boxes(parts[0])}, {boxes(parts[1])}]"
        case "msubsup" | "munderover":
            name = (
                "SubsuperscriptBox"
                if element.tag == "msubsup"
                else "UnderoverscriptBox"
            )
            return f"{name}[{', '.join(map(boxes, parts))}]"
        case "mfrac":
            return f"FractionBox[{boxes(parts[0])}, {boxes(parts[1])}]"
        case "msqrt":
            return f"SqrtBox[{_row_box(list(map(boxes, parts)))}]"
        case "mtable":
            rows = [
                "{" + ", ".join(map(boxes, children(row))) + "}"
                for row in parts
            ]
            return "GridBox[{" + ", ".join(rows) + "}]"
    raise ValueError(f"<{element.tag}> in an equation")


def _row_box(parts: list[str]) -> str:
    return parts[0] if len(parts) == 1 else f"RowBox[{{{', '.join(parts)}}}]"


def wolfram_string(text: str) -> str:
    """A string of the Wolfram Language, in ASCII."""
    shown = []
    for character in plain(text):
        if character in '"\\':
            shown.append("\\" + character)
        elif character == "\n":
            shown.append("\\n")
        elif character == "\t":
            shown.append("\\t")
        elif " " <= character <= "~":
            shown.append(character)
        else:
            shown.append(f"\\:{ord(character):04x}")
    return '"' + "".join(shown) + '"'
