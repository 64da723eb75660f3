"""How equations are read aloud: Speech Rule Engine makes words of the MathML that the pages have.

The PDFs need these words: PDF/UA wants an alternative text for each equation. On a page a screen reader reads the
MathML itself.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from occgrid_handouts.machine import time_limit
from occgrid_handouts.page_tree import Element, read_page
from occgrid_handouts.platform_math import search_path

FOLDER = "handouts/speech"
SECONDS = 30

_FORMULAS = re.compile(r'<template id="formulas">(.*?)</template>', re.DOTALL)
# the equation is a part of a sentence, but its last comma or period is not a part of the equation
_LAST_MARK = re.compile(r",? (?:comma|period)$")


class SpeechError(RuntimeError):
    """The converter did not make words of the equations."""


def without_formulas(page: str) -> tuple[str, dict[str, Element]]:
    """A page without its list of equations, and the list: each equation by the text that it was written as."""
    found: dict[str, Element] = {}

    def kept(match: re.Match[str]) -> str:
        for entry in read_page(match[1]).elements():
            (equation,) = entry.elements()
            found[entry.attributes["data-key"]] = equation
        return ""

    return _FORMULAS.sub(kept, page), found


def readable(element: Element) -> Element:
    """An equation as the converter understands it; the compiler writes some things in another way."""
    parts = [
        readable(child) if isinstance(child, Element) else child
        for child in element.children
    ]
    text = element.text()
    match element.tag:
        case "mi" if text == "/":
            return Element("mo", {}, ["/"])
        case "mi" if text == "Δ":  # the letter, not a triangle
            return Element("mi", {}, ["𝛥"])
        case "msup" | "msubsup" if _in_parentheses(element.elements()[-1]):
            return _with_superscript(element)
        case "mrow" | "mtd" | "math":
            parts = _wide_beside_text(parts)
    return Element(element.tag, element.attributes, parts)


def _in_parentheses(element: Element) -> bool:
    text = element.text()
    return element.tag == "mrow" and text[:1] == "(" and text[-1:] == ")"


def _with_superscript(element: Element) -> Element:
    """A number in parentheses above the line is no power."""
    *base, above = map(readable, element.elements())
    below = Element("msub", {}, [*base]) if len(base) == 2 else base[0]
    word = Element("mtext", {}, ["superscript"])
    return Element("mrow", {}, [below, word, *above.children[1:-1]])


def _wide_beside_text(parts: Sequence[Element | str]) -> list[Element | str]:
    """The spaces beside words are wide: a word before a parenthesis would be taken for a function."""
    tags = [part.tag if isinstance(part, Element) else "" for part in parts]
    wide: list[Element | str] = []
    for i, part in enumerate(parts):
        beside = "mtext" in (tags[i - 1] if i else "", *tags[i + 1 : i + 2])
        if tags[i] == "mspace" and beside:
            wide.append(Element("mspace", {"width": "1em"}))
        else:
            wide.append(part)
    return wide


def words(root: Path, equations: Mapping[str, Element]) -> dict[str, str]:
    """The words for each equation. Raises SpeechError."""
    written = {key: readable(e).html() for key, e in equations.items()}
    distinct = sorted(set(written.values()))
    spoken = dict(zip(distinct, _speak(root, distinct), strict=True))
    return {key: spoken[text] for key, text in written.items()}


def _speak(root: Path, equations: Sequence[str]) -> list[str]:
    folder = root / FOLDER
    node = shutil.which("node", path=search_path()) or "node"
    try:
        done = subprocess.run(
            [node, str(folder / "speak.mjs")],
            input=json.dumps(equations),
            capture_output=True,
            text=True,
            timeout=time_limit(SECONDS),
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise SpeechError(f"{FOLDER}/speak.mjs: {error}") from error
    if done.returncode != 0:
        raise SpeechError(f"{FOLDER}/speak.mjs: {done.stderr.strip()}")
    return [_LAST_MARK.sub("", said) for said in json.loads(done.stdout)]


def missing_tool(root: Path) -> str:
    """What is to be installed for words, or nothing."""
    if shutil.which("node", path=search_path()) is None:
        return "install nodejs"
    if not (root / FOLDER / "node_modules").is_dir():
        return f"run npm ci in {FOLDER}/"
    return ""
