"""From the text to PDF and HTML: the typst compiler, the same bytes at every build."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Literal

import typst

TEXT = Path(__file__).resolve().parents[1] / "text"


Kind = Literal["pdf", "html"]


class TypesettingError(RuntimeError):
    """The compiler refused the text, or warned about it."""


_EQUATION = re.compile(r"(\(?)(\$[^$]*\$)([.,;:)]*)")


def with_spoken_math(text: str) -> str:
    """The text with every inline equation in a call that adds how it is read aloud.

    PDF/UA wants that of each of them, and a show rule comes too late: the tag is made of the equation as it is written.
    """

    def replaced(match: re.Match[str]) -> str:
        # a displayed equation has a space inside its dollar signs
        before, equation, after = match.groups()
        if not equation[1:2].strip():
            return match[0]
        # punctuation goes along, so that no line begins with it, nor ends with a parenthesis that opens
        return f'#spoken-math("{before}", {equation}, "{after}");'

    return _EQUATION.sub(replaced, text)


def prepare(folder: Path, facts: Mapping[str, object]) -> None:
    """Lays the text and its facts side by side, where the figures already are in ``figures``."""
    shutil.copytree(TEXT, folder, dirs_exist_ok=True)
    for chapter in sorted(folder.glob("*.typ")):
        if chapter.name != "lib.typ":
            text = chapter.read_text(encoding="utf-8")
            chapter.write_text(with_spoken_math(text), encoding="utf-8")
    text = json.dumps(facts, ensure_ascii=False, indent=1)
    (folder / "data.json").write_text(text, encoding="utf-8")


def write_speech(folder: Path, words: Mapping[str, str]) -> None:
    """Lays beside the text how its equations are read aloud, which PDFs need."""
    text = json.dumps(words, ensure_ascii=False, indent=1)
    (folder / "speech.json").write_text(text, encoding="utf-8")


def typeset(
    folder: Path,
    main: str,
    language: str,
    edition: str,
    kind: Kind,
    seconds: int,
) -> bytes:
    """The handout as "pdf" (tagged, PDF/UA-1) or "html"; ``main`` is its text in the folder."""
    inputs = {"language": language, "edition": edition, "format": kind}
    try:
        made, warnings = typst.compile_with_warnings(
            str(folder / main),
            root=str(folder),
            format=kind,
            sys_inputs=inputs,
            pdf_standards=["ua-1"] if kind == "pdf" else [],
            timestamp=seconds,
            ignore_system_fonts=True,
        )
    except typst.TypstError as error:
        raise TypesettingError(
            f"{language} {kind}: {_explained(error)}"
        ) from error
    serious = [w for w in warnings if "html export is under" not in str(w)]
    if serious:
        said = "; ".join(_explained(warning) for warning in serious)
        raise TypesettingError(f"{language} {kind}: {said}")
    if not isinstance(made, bytes):
        raise TypesettingError(f"{language} {kind}: no output")
    return with_own_names(made) if kind == "html" else made


def with_own_names(page: bytes) -> bytes:
    """The page with other names for the glyphs of each drawing: a name may occur once in a page."""
    drawings = iter(range(page.count(b"<svg") + 1))

    def renamed(match: re.Match[bytes]) -> bytes:
        prefix = b"d%d-" % next(drawings)
        drawing = match[0].replace(b' id="', b' id="' + prefix)
        return drawing.replace(b'href="#', b'href="#' + prefix)

    return re.sub(rb"<svg\b.*?</svg>", renamed, page, flags=re.DOTALL)


def _explained(said: Exception) -> str:
    """A message with its hints and the places that it came by."""
    parts = [str(said)]
    parts += [str(hint) for hint in getattr(said, "hints", None) or []]
    parts += [str(trace) for trace in getattr(said, "trace", None) or []]
    return "\n  ".join(parts)
