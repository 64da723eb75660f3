"""Both pages by axe-core: two widths, two schemes, all that can be opened open."""

from __future__ import annotations

from pathlib import Path

import pytest
from pages_in_browser import GOLDEN, WEB, Open, unavailable
from playwright.sync_api import Page

AXE = WEB / "node_modules" / "axe-core" / "axe.min.js"


def violations(page: Page) -> list[str]:
    if not AXE.is_file():
        unavailable("web/node_modules is missing: npm ci in web/")
    page.evaluate(AXE.read_text(encoding="utf-8"))
    results = page.evaluate("axe.run({ resultTypes: ['violations'] })")
    return [
        f"{one['id']}: {node['html'][:200]} {node['failureSummary']}"
        for one in results["violations"]
        for node in one["nodes"]
    ]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", ["play", "check"])
def test_axe_finds_nothing(
    open_page: Open, tmp_path: Path, name: str, width: int, scheme: str
) -> None:
    page = open_page(
        name,
        "#mistake=hit-also-free&scan=9&step=30" if name == "play" else "",
        viewport={"width": width, "height": 900},
        color_scheme=scheme,
    )
    page.evaluate(
        "document.querySelectorAll('details').forEach(d => { d.open = true; })"
    )
    if name == "check":
        page.locator("#scenario").select_option("asymmetric")
        # of another mode: the noise has moved cells
        page.set_input_files("#file", GOLDEN / "asymmetric.seed-0.pgm")
        page.locator("#verdict[data-status=differs]").wait_for()
    assert violations(page) == []
    width_needed = page.evaluate("document.documentElement.scrollWidth")
    assert width_needed == width


def test_axe_would_find_something(open_page: Open) -> None:
    page = open_page("play")
    page.evaluate(
        "document.querySelector('h1').innerHTML = '<img src=\"data:,\">'"
    )
    assert any("image-alt" in one for one in violations(page))


# What can be reached by the keyboard: of radio buttons with one name the chosen one only.
REACHABLE = """() => {
  const found = Array.from(document.querySelectorAll(
    "a[href], button, input, select, summary, [tabindex='0']"));
  window.reachable = found.filter((e) => !e.disabled && e.tabIndex >= 0
    && e.checkVisibility() && !(e.type === "radio" && !e.checked));
  window.reached = new Set();
  return reachable.length;
}"""
REACH = """() => {
  const e = document.activeElement;
  reached.add(e);
  const { outlineStyle, outlineWidth } = getComputedStyle(e);
  return [e.id || e.outerHTML.slice(0, 80), outlineStyle !== "none" && parseFloat(outlineWidth) >= 2];
}"""
LEFT = "reachable.filter((e) => !reached.has(e)).map((e) => e.outerHTML)"


@pytest.mark.parametrize("name", ["play", "check"])
def test_everything_is_reached_by_tab_and_seen(
    open_page: Open, name: str
) -> None:
    page = open_page(name, "#scan=9&step=30" if name == "play" else "")
    page.evaluate(
        "document.querySelectorAll('details').forEach(d => { d.open = true; })"
    )
    if name == "check":
        page.locator("#scenario").select_option("asymmetric")
        page.set_input_files("#file", GOLDEN / "asymmetric.seed-0.pgm")
        page.locator("#verdict[data-status=differs]").wait_for()
        page.evaluate("document.activeElement.blur()")
    count = page.evaluate(REACHABLE)
    assert count >= (100 if name == "play" else 10)
    page.evaluate("scrollTo(0, 0)")
    page.locator("h1").click()
    for _ in range(count):
        page.keyboard.press("Tab")
        which, outlined = page.evaluate(REACH)
        assert outlined, which
    assert page.evaluate(LEFT) == []


def test_play_by_the_keyboard_alone(open_page: Open) -> None:
    """Time, a line, a cell, a mistake: no pointer."""
    page = open_page("play", "#noise=free")
    page.locator("#scan").focus()
    page.keyboard.press("End")
    page.locator("#beam").focus()
    page.keyboard.press("ArrowLeft")
    assert page.evaluate("[occgridPage.lab.scan, occgridPage.lab.beam]") == [
        120,
        180,
    ]
    page.locator("#play").focus()
    page.keyboard.press("Space")
    page.wait_for_function("occgridPage.lab.atEnd && !occgridPage.lab.playing")
    page.locator("#cell-gx").focus()
    page.keyboard.type("7")
    page.keyboard.press("Tab")
    assert page.evaluate("occgridPage.lab.cell.gx") != 109
    page.locator("[data-mistake=no-clamp]").focus()
    page.keyboard.press("Space")
    assert page.evaluate("[...occgridPage.lab.mistakes]") == ["no-clamp"]
    page.locator("#wrong-view").focus()
    page.keyboard.press("ArrowUp")
    page.locator("#wrong-words", has_text="cell gx=110 gy=91:").wait_for()
