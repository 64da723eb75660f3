"""A font for the equations of the HTML pages, cut down to their characters, so that a page looks right anywhere.

A browser needs a font with a MATH table to set MathML well, and not every system has one. "DejaVu Math TeX Gyre"
(Debian's package fonts-dejavu-extra, free to embed) goes into each page where it is installed; where it is not, the
page asks for the usual fonts of other systems.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable
from io import BytesIO
from pathlib import Path

from fontTools.subset import (  # type: ignore[import-untyped]
    Options,
    Subsetter,
)
from fontTools.ttLib import TTFont  # type: ignore[import-untyped]

NAME = "DejaVuMathTeXGyre.ttf"
FOLDERS = (
    Path("/usr/share/fonts"),
    Path("/usr/local/share/fonts"),
    Path("~/.fonts"),
    Path("~/.local/share/fonts"),
)
PLACE = "/* math-font */"

_MATH = re.compile(r"<math\b.*?</math>", re.DOTALL)
_TAG = re.compile(r"<[^>]*>")


def find_font() -> Path | None:
    """The font's file, if it is installed."""
    for folder in FOLDERS:
        for path in sorted(folder.expanduser().glob(f"**/{NAME}")):
            return path
    return None


def math_characters(pages: Iterable[str]) -> set[str]:
    """The characters of all equations."""
    found: set[str] = set()
    for page in pages:
        for equation in _MATH.findall(page):
            found |= set(_TAG.sub("", equation))
    # a root, its bar and braces below are drawn without a character
    return found | set("()[]{}|√‾⏟")


def font_face(characters: set[str]) -> str:
    """A CSS rule with the font inside, or nothing where it is not installed."""
    path = find_font()
    if path is None:
        return ""
    options = Options()
    options.flavor = "woff"
    options.recalc_timestamp = False
    options.layout_features = ["*"]
    options.notdef_outline = True
    options.drop_tables += ["FFTM"]
    font = TTFont(path, recalcTimestamp=False)
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=sorted(map(ord, characters)))
    subsetter.subset(font)
    font.flavor = "woff"
    file = BytesIO()
    font.save(file)
    text = base64.b64encode(file.getvalue()).decode("ascii")
    return (
        '@font-face { font-family: "Handout Math"; '
        f"src: url(data:font/woff;base64,{text}) format('woff'); }}"
    )


def with_math_font(pages: dict[str, str]) -> dict[str, str]:
    """The pages by name, each that has equations with the font in place."""
    face = font_face(math_characters(pages.values()))
    return {
        name: page.replace(PLACE, face if "<math" in page else "")
        for name, page in pages.items()
    }
