"""Equations in other notations, running text in other markups, and the check of Wolfram expressions."""

from __future__ import annotations

import pytest

from occgrid_handouts.mathml import boxes, latex, wolfram_string
from occgrid_handouts.notebook import markdown
from occgrid_handouts.page_tree import Element, read_page
from occgrid_handouts.wolfram_syntax import SyntaxProblem, check_expression

CELL = (
    "<math><msub><mi>𝑔</mi><mi>𝑥</mi></msub><mo>=</mo><mrow><mo>⌊</mo>"
    "<mfrac><mrow><mi>𝑥</mi><mo>−</mo><mn>1</mn></mrow><mi>𝑟</mi></mfrac>"
    "<mo>⌋</mo></mrow></math>"
)
CASES = (
    "<math><mrow><mo>{</mo><mtable><mtr><mtd><mi>𝑝</mi></mtd><mtd>"
    "<mtext>if</mtext><mo>≤</mo></mtd></mtr></mtable></mrow></math>"
)
BRACE = (
    "<math><munder><munder><mi>𝑎</mi><mo>⏟</mo></munder><mi>𝑏</mi></munder>"
    "</math>"
)


def math(html: str) -> Element:
    found = read_page(html).find("math")
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("html", "text"),
    [
        (CELL, r"g_{x} = \left\lfloor \frac{x - 1}{r} \right\rfloor"),
        (CASES, r"\begin{cases}p & \text{if} \le\end{cases}"),
        (BRACE, r"\underbrace{a}_{b}"),
        ("<math><mo>log</mo><mi>𝑥</mi></math>", r"\log x"),
        (
            "<math><msubsup><mi>𝑧</mi><mi>𝑡</mi><mn>2</mn></msubsup></math>",
            "z_{t}^{2}",
        ),
    ],
)
def test_latex(html: str, text: str) -> None:
    assert latex(math(html)) == text


def test_boxes() -> None:
    assert boxes(math(CELL)) == (
        'RowBox[{SubscriptBox["g", "x"], "=", RowBox[{"\\:230a", '
        'FractionBox[RowBox[{"x", "\\:2212", "1"}], "r"], "\\:230b"}]}]'
    )


def test_unknown_element_is_refused() -> None:
    with pytest.raises(ValueError, match="<menclose> in an equation"):
        latex(math("<math><menclose></menclose></math>"))


def test_strings() -> None:
    assert wolfram_string('a "b" \\ é\n') == r'"a \"b\" \\ \:00e9\n"'


def test_markdown_escapes_what_it_would_take_for_markup() -> None:
    page = read_page("<p>a_b * $ <code>x_y</code> <strong>c</strong></p>")
    assert markdown(page) == r"a\_b \* \$ `x_y` **c**"


@pytest.mark.parametrize(
    "text",
    [
        'Notebook[{Cell["a", "Text"]}]',
        '(* c (* d *) *)\nNotebook[{Cell["]", "Te\\"xt"]}, a->1]\n',
        'Notebook[{Cell[BoxData["f[x] (* no comment"], "Input"]}]',
    ],
)
def test_good_expressions(text: str) -> None:
    check_expression(text, "Notebook")


@pytest.mark.parametrize(
    "text",
    [
        "Notebook[{]}",
        'Notebook[{Cell["a]}]',
        "Notebook[{}] Notebook[{}]",
        "Notebook[{}",
        'Notebook["a" "b"]',
        "Notebook[a, ]",
        "Cell[{}]",
        "Notebook[{}] (* open",
    ],
)
def test_bad_expressions(text: str) -> None:
    with pytest.raises(SyntaxProblem):
        check_expression(text, "Notebook")


def test_tags_that_do_not_pair_are_refused() -> None:
    with pytest.raises(ValueError, match="</b> closes <i>"):
        read_page("<b><i></b>")
    with pytest.raises(ValueError, match="<b> is never closed"):
        read_page("<b>")
