"""The page of a check in a real browser: what it opens on, on a phone and on a desk, light and dark."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, Page
from typer.testing import CliRunner

from occgrid_parity.commands.app import app

from .accessible import is_noticed, tables_too_wide, violations
from .test_report_page import browser, open_table  # noqa: F401

PROGRAM = Path(__file__).parent / "check" / "programs" / "lesson.pl"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a program that cuts to integers instead of taking the floor."""
    folder = tmp_path_factory.mktemp("check")
    command = (
        f"perl {PROGRAM} --bug truncation {{mode}} --out {{out}} {{scenario}}"
    )
    arguments = ["check", "--run", command, "--out", str(folder / "out")]
    for name in ("one-beam", "no-return-free", "outside", "asymmetric"):
        arguments += ["--scenario", name]
    ended = CliRunner().invoke(
        app, [*arguments, "--report", str(folder / "page")]
    )
    assert ended.exit_code == 1, ended.output
    return folder / "page" / "index.html"


def open_page(
    browser: Browser,  # noqa: F811
    file: Path,
    width: int = 1280,
    scheme: Literal["light", "dark"] = "light",
) -> Page:
    page = browser.new_page(
        viewport={"width": width, "height": 900}, color_scheme=scheme
    )
    page.goto(file.as_uri())
    page.locator("#case-title").get_by_text(",").wait_for()
    return page


@pytest.fixture
def page(browser: Browser, file: Path) -> Iterator[Page]:  # noqa: F811
    page = open_page(browser, file)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    yield page
    assert errors == []
    page.close()


def move(page: Page, position: int) -> None:
    page.locator("#scrubber").evaluate(
        "(e, v) => { e.value = v; e.dispatchEvent(new Event('input')); }",
        position,
    )


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_axe_finds_nothing_and_all_can_be_read(
    browser: Browser,  # noqa: F811
    file: Path,
    width: int,
    scheme: Literal["light", "dark"],
) -> None:
    page = open_page(browser, file, width, scheme)
    assert page.evaluate("document.documentElement.scrollWidth") == width
    assert tables_too_wide(page) == []
    open_table(page)
    assert violations(page) == []
    assert is_noticed(page)
    page.close()


def test_the_page_opens_where_the_map_first_goes_wrong(page: Page) -> None:
    """After the scan of the first difference, with the program's map; the scrubber goes back to the first scan."""
    title = page.locator("#case-title").inner_text()
    assert title == "no-return-free, noise-free: lesson.pl"
    found = page.locator("#first-difference strong").inner_text()
    assert found.startswith("scan 2, beam 4, cell gx=15 gy=12")
    assert page.locator("#scrubber-value").inner_text() == "3 of 3"
    assert (
        page.locator("#readout-cell")
        .inner_text()
        .startswith("cell gx=15 gy=12")
    )
    assert page.locator("#readout tr.other").count() == 1
    said = page.locator("#difference-count")
    assert said.inner_text() == "46 of 1200 cells differ"
    move(page, 0)
    assert page.locator("#scrubber-value").inner_text() == "1 of 3"
    assert said.inner_text() == "0 of 1200 cells differ"


def test_without_a_map_of_the_program_the_page_says_where_there_is_one(
    page: Page,
) -> None:
    page.locator("#thumbs .thumb:visible", has_text="asymmetric").click()
    page.locator("#case-title").get_by_text("asymmetric").wait_for()
    said = page.locator("#difference-count")
    assert said.inner_text().endswith("of 2257 cells differ")
    move(page, 0)
    assert said.inner_text() == "no map of lesson.pl after 1 scan"
