"""The mistakes of play.html: they are the catalogue's, and differ from the right map in the same number of cells."""

from __future__ import annotations

import re

import numpy as np
import pytest
from harness_parts import (
    MISTAKES,
    READING,
    SCENARIOS,
    SEED,
    Mapper,
    seed_of,
    with_mistakes,
    world,
)
from pages_in_browser import ROOT, Open
from playwright.sync_api import Page

COUNTS = """name => {
  const { lab, render } = occgridPage;
  lab.mistakes = new Set([name]);
  render();
  return document.querySelector("#difference-words").textContent;
}"""


def open_scenario(open_page: Open, name: str) -> Page:
    """A scenario of the suite in play.html, after its last scan."""
    page = open_page("play", f"#seed={seed_of(name)}")
    if name != "lesson":
        page.set_input_files("#file", ROOT / "scenarios" / f"{name}.log")
        said = page.locator("#file-words", has_text=f"{name}.log: ")
        said.wait_for(state="attached")  # in a part that is closed
    page.evaluate("occgridPage.lab.goTo(occgridPage.lab.scans.length)")
    return page


def words_of(name: str, scenario: str) -> tuple[str, bool]:
    """What the page has to say, by the catalogue; and whether anything differs."""
    drawn_world, seed = world(scenario), seed_of(scenario)
    right = Mapper(drawn_world, seed).draw()
    wrong = MISTAKES[name](drawn_world, seed).draw()
    height, width = right.pixels.shape
    if wrong.pixels.shape != right.pixels.shape:
        return f"The picture has {height} x {width} pixels", True
    pixels = int(np.count_nonzero(wrong.pixels != right.pixels))
    log_odds = int(np.count_nonzero(wrong.log_odds != right.log_odds))
    cells = width * height
    return (
        f"{pixels:,} of {cells:,} cells differ in the picture ... {log_odds:,} in their log-odds.",
        pixels > 0,
    )


def counts(page: Page, name: str) -> str:
    said = page.evaluate(COUNTS, name)
    assert isinstance(said, str)
    return re.sub(r"after \d+ scans?,", "...", said)


def test_the_mistakes_are_those_of_the_catalogue(open_page: Open) -> None:
    """All that do not lie in how a file is read, in its order."""
    page = open_page("play")
    known = page.evaluate("occgridPage.mistakes")
    assert known == [name for name in MISTAKES if name not in READING]
    boxes = page.locator("[data-mistake]")
    assert boxes.count() == 20
    for i in range(boxes.count()):
        name = boxes.nth(i).get_attribute("data-mistake") or ""
        label = boxes.nth(i).locator("xpath=..").text_content() or ""
        assert MISTAKES[name].title in label
        assert MISTAKES[name].lesson in label


def test_each_mistake_differs_in_as_many_cells(open_page: Open) -> None:
    seen = set()
    for scenario in SCENARIOS:
        page = open_scenario(open_page, scenario)
        for name in page.evaluate("occgridPage.mistakes"):
            expected, differs = words_of(name, scenario)
            assert counts(page, name).startswith(expected), (scenario, name)
            if differs:
                seen.add(name)
    assert seen == set(MISTAKES) - READING


@pytest.mark.parametrize(
    "mistake", ["robot-outside-skipped", "hit-also-free", "pixel-half-even"]
)
def test_a_mistake_in_the_whole_lesson(open_page: Open, mistake: str) -> None:
    page = open_scenario(open_page, "lesson")
    expected, differs = words_of(mistake, "lesson")
    assert differs
    assert counts(page, mistake).startswith(expected)


def test_a_switch_is_moved_and_a_cell_read(open_page: Open) -> None:
    """By the page's own controls: two mistakes at once, and both values under the mouse."""
    page = open_scenario(open_page, "asymmetric")
    drawn_world = world("asymmetric")
    names = ("hit-also-free", "bearings-clockwise")
    right = Mapper(drawn_world, SEED).draw()
    wrong = with_mistakes(*names)(drawn_world, SEED).draw()
    for name in names:
        page.locator(f"[data-mistake={name}]").check()
    page.locator(
        "#difference-words",
        has_text=f"{np.count_nonzero(wrong.pixels != right.pixels):,} of ",
    ).wait_for()
    view = page.locator("#wrong-view")
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    height, width = right.pixels.shape
    gy, gx = np.argwhere(wrong.log_odds != right.log_odds)[100].tolist()
    scale = (box["width"] - 2) / width  # the border is one pixel
    page.mouse.move(
        box["x"] + 1 + (gx + 0.5) * scale,
        box["y"] + 1 + (height - gy - 0.5) * scale,
    )
    said = page.locator("#wrong-words", has_text=f"cell gx={gx} gy={gy}:")
    said.wait_for()
    found = re.search(
        r"log-odds (\S+), pixel (\d+); right are (\S+) \(P .*\) and (\d+)\.",
        said.inner_text(),
    )
    assert found
    assert float(found[1]) == wrong.log_odds[gy, gx]
    assert float(found[3]) == right.log_odds[gy, gx]
    assert int(found[2]) == wrong.pixels[height - 1 - gy, gx]
    assert int(found[4]) == right.pixels[height - 1 - gy, gx]
    page.locator("[data-mistake=hit-also-free]").uncheck()
    expected, _ = words_of("bearings-clockwise", "asymmetric")
    count = expected.split(" ")[0]
    page.locator("#difference-words", has_text=f"{count} of ").wait_for()
