"""The pages in a browser: nothing leaves the page, what scrolls is reached with the keyboard, tabs are remembered."""

from __future__ import annotations

from urllib.parse import parse_qsl

import pytest
from playwright.sync_api import Browser, Page

from built_handouts import WIDTHS, Handouts

# What reaches over the right edge, unless it lies in a box that scrolls.
OVER_THE_EDGE = """() => {
  const width = document.documentElement.clientWidth, over = [];
  for (const e of document.querySelectorAll("body *")) {
    if (e.closest("math, svg") || e.getBoundingClientRect().right <= width + 1) continue;
    let p = e.parentElement;
    while (p && getComputedStyle(p).overflowX !== "auto") p = p.parentElement;
    if (!p) over.push(`${e.tagName} ${e.className}: ${e.textContent.slice(0, 40)}`);
  }
  return over;
}"""

# The boxes that scroll sideways, marked, and how many there are.
MARK_SCROLLING = """() => {
  const boxes = [...document.querySelectorAll("body *")].filter(e =>
    getComputedStyle(e).overflowX === "auto" && e.scrollWidth > e.clientWidth);
  boxes.forEach(box => box.classList.add("scrolls"));
  return boxes.length;
}"""

# The tables that scroll sideways: what stands in the last column is not seen at once.
SCROLLING_TABLES = """() =>
  [...document.querySelectorAll(".wide")].filter(box => box.scrollWidth > box.clientWidth).map(box => box.innerText)
"""


def open_page(
    browser: Browser, handouts: Handouts, name: str, width: int
) -> Page:
    page = browser.new_page(viewport={"width": width, "height": 900})
    page.goto(f"{handouts.folder.as_uri()}/{name}")
    return page


@pytest.mark.parametrize("width", WIDTHS)
def test_nothing_leaves_a_page(
    handouts: Handouts, browser: Browser, width: int
) -> None:
    for name in handouts.pages():
        page = open_page(browser, handouts, name, width)
        assert page.evaluate(OVER_THE_EDGE) == [], name
        assert page.evaluate(SCROLLING_TABLES) == [], name
        page.close()


def test_element_over_the_edge_is_noticed(
    handouts: Handouts, browser: Browser
) -> None:
    page = open_page(browser, handouts, "student/index.html", 390)
    page.evaluate(
        "document.body.insertAdjacentHTML('beforeend',"
        " '<p style=\\'width: 50rem\\'>wide</p>')"
    )
    assert page.evaluate(OVER_THE_EDGE) == ["P : wide"]
    page.close()


def test_what_scrolls_is_reached_with_the_keyboard(
    handouts: Handouts, browser: Browser
) -> None:
    """Long equations and code: each gets the focus once, and an arrow key moves it."""
    page = open_page(browser, handouts, "student/python.html", 390)
    boxes = page.evaluate(MARK_SCROLLING)
    assert page.locator(".formula.scrolls").count() > 3
    reached = 0
    for _ in range(1000):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement === document.body"):
            break
        focused = page.locator(".scrolls:focus")
        reached += focused.count()
        if focused.count() and "formula" in str(
            focused.get_attribute("class")
        ):
            assert focused.get_attribute("aria-label") == "Equation"
            page.keyboard.press("ArrowRight")
            page.wait_for_function("document.activeElement.scrollLeft > 0")
    assert reached == boxes
    page.close()


def test_language_of_the_tabs_is_remembered(
    handouts: Handouts, browser: Browser
) -> None:
    page = open_page(browser, handouts, "student/python.html", 1280)
    chosen = page.locator("[role=tab][aria-selected=true]").first
    assert chosen.get_attribute("data-language") == "python"
    page.locator("[role=tab][data-language=cpp]").first.click()
    page.reload()
    assert chosen.get_attribute("data-language") == "cpp"
    page.close()


def test_links_to_play_open_the_state_that_they_ask_for(
    handouts: Handouts, browser: Browser
) -> None:
    if not (handouts.folder / "student" / "play.html").is_file():
        pytest.skip("this build could not make play.html")
    targets = {
        element.attributes.get("href", "")
        for name in handouts.pages()
        for element in handouts.page(name).walk()
        if element.tag == "a"
    }
    states = {
        target.removeprefix("play.html#")
        for target in targets
        if target.startswith("play.html#")
    }
    assert len(states) == 6
    for state in sorted(states):
        page = open_page(browser, handouts, f"student/play.html#{state}", 1280)
        page.wait_for_function("window.occgridPage !== undefined")
        expected = set(parse_qsl(state))
        for _ in range(100):
            shown = page.evaluate("occgridPage.address()").removeprefix("#")
            if expected <= set(parse_qsl(shown)):
                break
            page.wait_for_timeout(100)
        assert expected <= set(parse_qsl(shown)), (state, shown)
        page.close()
