"""The page of a class of a thousand in a real browser: words to look for, columns to sort by, a phone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, Page

from occgrid_parity.check.levels import LEVELS, RUNS
from occgrid_parity.check.verdict import (
    SCHEMA,
    Level,
    LevelStatus,
    Overall,
    Verdict,
)
from occgrid_parity.check.verdict_text import HALVES
from occgrid_parity.course.class_page import write_class_page
from occgrid_parity.explain.cause import likely
from occgrid_parity.explain.findings import Cause
from occgrid_parity.mistakes.catalogue import MISTAKES

from .accessible import is_noticed, tables_too_wide, violations
from .test_report_page import browser  # noqa: F401

COUNT = 1000


def verdict(number: int) -> Verdict:
    """Every third one is wrong, by one of five mistakes."""
    wrong = number % 3 == 0
    level = LEVELS[number % len(LEVELS)]
    status: LevelStatus = "failed" if wrong else "identical"
    overall: Overall = "differs" if wrong else "identical"
    mistakes = list(MISTAKES.values())[:5]
    cause = Cause([likely(mistakes[number % 5])], [], len(MISTAKES))
    return Verdict(
        SCHEMA, f"s{number}", "x", overall, overall, "pixels", 1.0, 20,
        [Level(*RUNS, "passed"), Level(level.name, level.title, status)],
        cause=cause if wrong else None,
    )  # fmt: skip


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    submissions = [(f"s{number}", verdict(number)) for number in range(COUNT)]
    return write_class_page(
        submissions, tmp_path_factory.mktemp("class"), COUNT
    )


@pytest.fixture
def page(browser: Browser, file: Path) -> Iterator[Page]:  # noqa: F811
    page = browser.new_page(viewport={"width": 390, "height": 800})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(file.as_uri())
    yield page
    assert errors == []
    page.close()


def names(page: Page) -> list[str]:
    """The submissions that are shown, in order."""
    found: list[str] = page.eval_on_selector_all(
        "#submissions tbody tr:not([hidden]) th",
        "cells => cells.map(cell => cell.innerText)",
    )
    return found


def test_words_and_what_failed(page: Page) -> None:
    assert len(names(page)) == COUNT
    page.locator("#only-failed").check()
    assert names(page) == [f"s{number}" for number in range(0, COUNT, 3)]
    title = next(iter(MISTAKES.values())).title
    page.locator("#words").fill(title)
    expected = [f"s{number}" for number in range(0, COUNT, 15)]
    assert names(page) == expected
    assert page.locator("#shown").inner_text() == f"{len(expected)} of {COUNT}"
    page.locator("#words").fill("S999 ")
    assert names(page) == ["s999"]


def test_columns_sort_numbers_as_numbers(page: Page) -> None:
    button = page.locator("#submissions thead button").first
    button.click()
    assert names(page) == [f"s{number}" for number in range(COUNT)]
    button.click()
    assert names(page) == [f"s{number}" for number in reversed(range(COUNT))]
    header = page.locator("#submissions thead th").first
    assert header.get_attribute("aria-sort") == "descending"


def test_no_sideways_scrolling_on_a_phone(page: Page) -> None:
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    assert tables_too_wide(page) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_axe_finds_nothing(
    browser: Browser,  # noqa: F811
    tmp_path: Path,
    width: int,
    scheme: Literal["light", "dark"],
) -> None:
    few = [(f"s{number}", verdict(number)) for number in range(4)]
    page = browser.new_page(
        viewport={"width": width, "height": 800}, color_scheme=scheme
    )
    page.goto(write_class_page(few, tmp_path, 4).as_uri())
    assert violations(page) == []
    assert is_noticed(page)
    page.close()


def test_what_the_star_means_is_said_where_there_is_one(
    tmp_path: Path,
) -> None:
    right = verdict(1)
    star = replace(
        right,
        overall="edges",
        levels=[replace(right.levels[0], status="halves")],
    )
    for one, there in ((right, False), (star, True)):
        text = write_class_page([("s", one)], tmp_path, 1).read_text()
        assert (HALVES in text) == ("identical*" in text) == there
