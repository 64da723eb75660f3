"""The address of play.html: what it says, it shows, and what it cannot mean harms nothing."""

from __future__ import annotations

import pytest
from pages_in_browser import ROOT, Open, drop_file
from playwright.sync_api import Page
from test_play import HASH, set_value, words

STATE = """(({scan, beam, seed, cell, line, step, mistakes, world: {settings}}) =>
  [scan, beam, seed, cell.gx, cell.gy, line, step, [...mistakes],
   settings.pOcc, settings.resolution])(occgridPage.lab)"""
AS_OPENED: list[object] = [24, 181, 0, 109, 90, None, 0, [], 0.75, 0.1]


def rested(page: Page) -> str:
    """The address when the page has come to rest."""
    words(page, "scan-text")
    page.wait_for_timeout(300)
    page.wait_for_function("!occgridPage.busy()")
    return str(page.evaluate("location.hash"))


NOTHING = [
    "#=",
    "#scan=",
    "#scan=x&beam=-x&seed=-1",
    "#scan=0x10",
    "#cell=,",
    "#cell=220,1",
    "#line=,,,",
    "#line=1,2,3",
    "#line=9007199254740991,0,9007199254740990,3",
    "#line=0,0,5001,0",
    "#mistake=unknown",
    "#%E0%A4%A=",
]


def test_what_means_nothing_is_as_if_it_were_not_there(
    open_page: Open,
) -> None:
    page = open_page("play", NOTHING[-1])
    for address in NOTHING:
        page.evaluate("h => { location.hash = h; }", address)
        rested(page)
        assert page.evaluate(STATE) == AS_OPENED, address
        assert words(page, "settings-words") == ""


IMPOSSIBLE = {
    "#p_occ=": "p_occ",
    "#p_occ=abc": "p_occ",
    "#p_occ=1&resolution=0.2": "p_occ",
    "#resolution=0": "resolution",
    "#resolution=1e-300": "cells are too many",
    "#l_max=Infinity": "l_max",
    "#max_range=10001": "max_range",
    "#no_return=maybe": "no_return",
    "#p0=0.1&l_min=-1": "l_min",
}


def test_settings_that_are_not_possible_are_said(open_page: Open) -> None:
    page = open_page("play", next(iter(IMPOSSIBLE)))
    for address, why in IMPOSSIBLE.items():
        page.evaluate("h => { location.hash = h; }", address)
        rested(page)
        assert page.evaluate(STATE) == AS_OPENED
        said = words(page, "settings-words")
        assert said.startswith(
            "The address asks for other settings. Not possible"
        )
        assert why in said


@pytest.mark.parametrize(
    ("control", "value"),
    [("resolution", 0.25), ("l_min", -3.5), ("max_range", 4.5)],
)
def test_a_page_loaded_again_has_the_same_map(
    open_page: Open, control: str, value: float
) -> None:
    page = open_page("play", "#scan=60")
    set_value(page, control, value)
    page.locator("#no-return").select_option("ignore")
    rested(page)
    before = page.evaluate(HASH), page.evaluate(STATE)
    page.reload()
    rested(page)
    assert (page.evaluate(HASH), page.evaluate(STATE)) == before


def test_the_way_back_undoes_what_the_address_did(open_page: Open) -> None:
    page = open_page("play", "#scan=30")
    rested(page)
    page.evaluate("location.hash = '#scan=45&p_occ=0.9&mistake=no-clamp'")
    assert rested(page) == "#scan=45&p_occ=0.9&mistake=no-clamp"
    page.go_back()
    assert rested(page) == "#scan=30"
    assert page.evaluate(STATE) == [30, *AS_OPENED[1:]]
    page.go_forward()
    assert rested(page) == "#scan=45&p_occ=0.9&mistake=no-clamp"


def test_a_file_leaves_no_settings_in_the_address(open_page: Open) -> None:
    """Loaded again, the page has the lesson, which must not get the file's grid."""
    page = open_page("play")
    drop_file(page, "#drop", ROOT / "scenarios" / "asymmetric.log")
    page.locator("#file-words", has_text="asymmetric.log: ").wait_for()
    assert rested(page) == "#scan=1"
    set_value(page, "p_occ", 0.9)
    assert rested(page) == "#scan=1&p_occ=0.9"


def test_a_page_loaded_again_stays_where_it_was(open_page: Open) -> None:
    page = open_page("play", "#cell=10,90")
    page.wait_for_function("scrollY > 1000")
    rested(page)
    page.wait_for_timeout(1000)  # it scrolls smoothly
    page.evaluate("scrollTo({ top: 100, behavior: 'instant' })")
    rested(page)
    page.reload()
    rested(page)
    assert page.evaluate("scrollY") < 200


def test_a_beam_of_too_many_cells_is_not_followed(open_page: Open) -> None:
    page = open_page("play", "#max_range=10000")
    for wall in range(6, 0, -1):
        page.evaluate(
            f"document.querySelector('[aria-label=\"Remove wall {wall}\"]').click()"
        )
    assert "too many cells to follow" in words(page, "line-words")
    assert page.locator("#line-on").is_disabled()
    page.evaluate("location.hash = '#line=0,0,3,1'")
    page.wait_for_function("occgridPage.lab.line !== null")
    assert "4 cells" in words(page, "line-words")
    assert page.locator("#line-on").is_enabled()


def test_a_resolution_and_back_is_the_same_grid(open_page: Open) -> None:
    page = open_page("play", "#scan=120")
    before = page.evaluate(HASH)
    for resolution in (0.35, 0.15, 0.1):
        set_value(page, "resolution", resolution)
    words(page, "map-words")
    assert page.evaluate(HASH) == before
