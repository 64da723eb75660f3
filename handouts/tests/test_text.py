"""The text: what the compiler must refuse, and how equations are prepared."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from built_handouts import REQUIRE_ALL
from occgrid_handouts.page_tree import Element
from occgrid_handouts.project import ROOT
from occgrid_handouts.speech import (
    SpeechError,
    missing_tool,
    without_formulas,
    words,
)
from occgrid_handouts.typesetting import (
    TEXT,
    Kind,
    TypesettingError,
    typeset,
    with_spoken_math,
    write_speech,
)
from occgrid_parity.ports.contributing import snippet_names

LIB = '#import "lib.typ": *\n'
# equations of the text link to these
TITLE = '#set document(title: "t")\n'


def compile_text(folder: Path, text: str, kind: Kind = "html") -> bytes:
    """A small text with the handouts' own means."""
    for name in ("lib.typ", "print.tmTheme", "wolfram.sublime-syntax"):
        (folder / name).write_bytes((TEXT / name).read_bytes())
    (folder / "matlab.sublime-syntax").write_bytes(
        (TEXT / "matlab.sublime-syntax").read_bytes()
    )
    part = {"file": "grid.py", "first": 3, "last": 4, "code": "x = 1\ny = 2"}
    facts = {
        "languages": {"python": {"name": "Python", "syntax": "python"}},
        "snippets": {"python": dict.fromkeys(snippet_names(ROOT), part)},
        "programs": {"python": {}},
    }
    (folder / "data.json").write_text(json.dumps(facts))
    written = LIB + TITLE + with_spoken_math(text)
    if kind == "pdf":
        write_speech(folder, equation_words(folder, written))
    (folder / "main.typ").write_text(written)
    return typeset(folder, "main.typ", "python", "student", kind, 0)


def equation_words(folder: Path, written: str) -> dict[str, str]:
    """How the equations of a text are read aloud."""
    problem = missing_tool(ROOT)
    if problem:
        pytest.fail(problem) if REQUIRE_ALL else pytest.skip(problem)
    (folder / "main.typ").write_text(f"{written}\n#formulas\n")
    page = typeset(folder, "main.typ", "python", "student", "html", 0)
    return words(ROOT, without_formulas(page.decode())[1])


def test_listing_has_file_and_real_line_numbers(tmp_path: Path) -> None:
    page = compile_text(tmp_path, '#listing("logit")').decode()
    assert "grid.py" in page
    assert 'data-n="3"' in page and 'data-n="4"' in page


def test_unknown_snippet_fails(tmp_path: Path) -> None:
    with pytest.raises(TypesettingError, match="unknown snippet lo-git"):
        compile_text(tmp_path, '#listing("lo-git")')


def test_unknown_equation_fails(tmp_path: Path) -> None:
    with pytest.raises(TypesettingError, match="unknown equation cel"):
        compile_text(tmp_path, '#to-equation("cel")')


def test_equations_out_of_order_fail(tmp_path: Path) -> None:
    with pytest.raises(TypesettingError, match="equation odds stands"):
        compile_text(tmp_path, '#eqn("odds", $ x $)')


def test_picture_without_alternative_text_fails(tmp_path: Path) -> None:
    square = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'
    (tmp_path / "a.svg").write_text(square)
    with pytest.raises(TypesettingError, match="missing alt text"):
        compile_text(tmp_path, '#image("a.svg")', "pdf")
    assert compile_text(tmp_path, '#image("a.svg", alt: "a")', "pdf")


def test_equation_without_alternative_text_fails(tmp_path: Path) -> None:
    assert compile_text(tmp_path, "$x$ is spoken", "pdf")
    (tmp_path / "main.typ").write_text(TITLE + "$x$ is not")
    with pytest.raises(TypesettingError, match="missing alt text"):
        typeset(tmp_path, "main.typ", "python", "student", "pdf", 0)


def test_inline_equations_are_found() -> None:
    text = "a $x$, b $ y $ c $z$ d ($w$)."
    assert with_spoken_math(text) == (
        'a #spoken-math("", $x$, ","); b $ y $ c #spoken-math("", $z$, ""); '
        'd #spoken-math("(", $w$, ").");'
    )


READ_ALOUD = {
    "m_i = 1": "m sub i, equals 1",
    "a \\/ r": "a divided by r",
    "(x - o_x) / r": (
        "the fraction with numerator x minus, o sub x, and denominator r, "
        "end fraction"
    ),
    "abs(d_i - z) <= alpha": (
        "the absolute value of, d sub i, minus z, end absolute value, "
        "is less than or equal to alpha"
    ),
    # not "the if of the absolute value"
    'cases(p & "if" abs(d) <= 1 "and" z < 2, q & "otherwise.")': (
        "2 cases, Case 1: p; if, the absolute value of d, "
        "end absolute value, is less than or equal to 1 and z is less than 2."
        " Case 2: q; otherwise"
    ),
    # a number above the line, and a power
    "phi^((k))": "phi superscript k",
    "z_t^((k)) > 0": "z sub t, superscript k is greater than 0",
    "O_0^t": "O sub 0, to the t-th power",
    "O_t (i) = O_(t-1) (i)": "O sub t, of i, equals, O sub t minus 1, of i",
    "p(m | x)": "p of, open paren, m given x, close paren",
    "sqrt(x) y": "the square root of x, end root, y",
    "Delta_x": "Delta sub x",
    "z_max": "z sub max",
}


def test_equations_are_read_aloud(tmp_path: Path) -> None:
    compile_text(tmp_path, "")
    text = "\n".join(f"${equation}$" for equation in READ_ALOUD)
    said = equation_words(tmp_path, LIB + with_spoken_math(text))
    assert list(said.values()) == list(READ_ALOUD.values())


def test_equation_without_words_is_refused(tmp_path: Path) -> None:
    compile_text(tmp_path, "$x$", "pdf")
    (tmp_path / "main.typ").write_text(
        LIB + TITLE + with_spoken_math("$y$ is new")
    )
    with pytest.raises(TypesettingError, match="no words for the equation"):
        typeset(tmp_path, "main.typ", "python", "student", "pdf", 0)


def test_converter_that_fails_is_noticed(tmp_path: Path) -> None:
    with pytest.raises(SpeechError, match=r"speak\.mjs"):
        words(tmp_path, {"x": Element("math", {}, ["x"])})


def test_no_vocabulary_of_the_workplace() -> None:
    folder = ROOT / "handouts"
    for path in sorted(folder.glob("**/*")):
        if path.is_file() and path.suffix in (".typ", ".py", ".m", ".wl"):
            text = path.read_text(encoding="utf-8")
            assert "/" + "work/" not in text, path
            assert "/" + "tmp/" not in text, path
