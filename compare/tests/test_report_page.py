"""The HTML page in a real browser: what it says under the mouse is what the files say."""

from __future__ import annotations

import math
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import (
    Browser,
    ConsoleMessage,
    Page,
    sync_playwright,
)

from occgrid.map_writer import pixel
from occgrid.scenario import read_scenario
from occgrid_parity.formats.map_files import read_map
from occgrid_parity.model.map_history import maps_after_scans
from occgrid_parity.report.run_page import write_page

from .accessible import is_noticed, violations
from .conftest import ROOT, unavailable
from .reported import Ran

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
# as root, and without a look at the network
ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    if CHROMIUM is None:
        unavailable("chromium is missing: apt-get install chromium")
    with sync_playwright() as playwright:
        launched = playwright.chromium.launch(
            executable_path=CHROMIUM, args=ARGUMENTS
        )
        yield launched
        launched.close()


@pytest.fixture(scope="module")
def file(ran: Ran, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_page(ran.record, ran.folder, tmp_path_factory.mktemp("page"))


@pytest.fixture
def page(browser: Browser, file: Path) -> Iterator[Page]:
    opened = browser.new_page(viewport={"width": 1280, "height": 1400})
    complaints: list[str] = []
    requests: list[str] = []
    opened.on("console", lambda message: complain(complaints, message))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("request", lambda request: requests.append(request.url))
    opened.goto(file.as_uri())
    opened.locator("#case-title").get_by_text(",").wait_for()
    yield opened
    assert complaints == []
    assert requests == [file.as_uri()], "nothing is loaded from elsewhere"
    opened.close()


def complain(complaints: list[str], message: ConsoleMessage) -> None:
    """Keep what the browser calls an error; its advice on speed is none."""
    if message.type == "error":
        complaints.append(message.text)


def open_table(page: Page) -> None:
    page.locator("#table").evaluate("table => { table.open = true; }")


def choose(page: Page, scenario: str, mode: str, port: str) -> None:
    """Click the cell of the table."""
    open_table(page)
    names = page.locator("#matrix thead th").all_inner_texts()
    column = (
        next(i for i, name in enumerate(names) if name.startswith(port)) - 2
    )
    row = page.locator(
        f"#matrix tbody tr:has(th:text-is('{scenario}'))"
    ).filter(has_text=mode)
    row.locator("button").nth(column).click()
    page.locator(
        f"#case-title:text-is('{scenario}, {mode}: {port}')"
    ).wait_for()


def readout(page: Page) -> dict[str, list[str]]:
    rows = page.locator("#readout tbody tr")
    texts = [row.locator("th, td").all_inner_texts() for row in rows.all()]
    return {name: values for name, *values in texts}


def hover(page: Page, gx: int, gy: int, width: int, height: int) -> None:
    """Put the mouse over the middle of a cell of the whole map, which has axes on the left and below."""
    axis_left, axis_below = 44, 22
    page.locator("#zoom-all").click()
    canvas = page.locator("#compare")
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    assert box is not None
    across, up = box["width"] - axis_left, box["height"] - axis_below
    scale = min(across / width, up / height)
    left = axis_left + (across - scale * width) / 2
    top = (up - scale * height) / 2
    page.mouse.move(
        box["x"] + left + (gx + 0.5) * scale,
        box["y"] + top + (height - 1 - gy + 0.5) * scale,
    )


def test_failures_come_first_and_every_status_is_a_word(page: Page) -> None:
    rows = page.locator("#matrix tbody tr").all()
    kinds = [row.get_attribute("class") for row in rows]
    assert kinds == sorted(kinds, key=lambda kind: kind != "failed")
    words = set(page.locator("#matrix .status").all_text_contents())
    assert words == {"identical", "differs", "error", "skipped"}
    assert not page.locator("#matrix").is_visible(), "maps come first"
    # the case that is open is a failure
    assert not page.locator(".status.chosen").get_by_text("identical").count()


def test_text_of_a_program_stays_text(page: Page) -> None:
    choose(page, "one-beam", "noise-free", "crashes")
    assert (
        "<b>no</b> & never</script>"
        in page.locator("#case-words").inner_text()
    )
    assert page.locator("#case-words b").count() == 0


@pytest.mark.parametrize(
    "cell", [(30, 20), (5, 3), (0, 0), (60, 36), (41, 17)]
)
def test_the_numbers_under_the_mouse_are_those_in_the_files(
    page: Page, ran: Ran, cell: tuple[int, int]
) -> None:
    gx, gy = cell
    choose(page, "asymmetric", "seed-0", "nearly")
    hover(page, gx, gy, 61, 37)
    assert (
        f"cell gx={gx} gy={gy}," in page.locator("#readout-cell").inner_text()
    )
    read = readout(page)
    for port in ("python", "nearly"):
        result = ran.record.result(port, "asymmetric", "seed-0")
        assert result.picture is not None
        found = read_map((ran.folder / result.picture).parent, "asymmetric")
        log_odds, p, pixel = read[port]
        value = float(found.log_odds[gy, gx])
        assert float(log_odds) == value
        assert float(p) == pytest.approx(1 / (1 + math.exp(-value)), abs=5e-7)
        assert int(pixel) == found.pixels[36 - gy, gx]
    assert read["crashes"] == ["", "", "no map"]


def test_differences_are_counted_and_found(page: Page) -> None:
    choose(page, "asymmetric", "noise-free", "nearly")
    said = page.locator("#difference-count").inner_text()
    assert said == f"2 of {61 * 37} cells differ"
    page.locator("#next-difference").click()
    first = page.locator("#readout-cell").inner_text()
    page.locator("#next-difference").click()
    second = page.locator("#readout-cell").inner_text()
    assert first.startswith("cell gx=30 gy=20,")
    assert second.startswith("cell gx=5 gy=3,")
    assert readout(page)["nearly"] == ["4", "0.982014", "5"]
    assert page.locator("#readout tr.other").count() == 1
    choose(page, "saturate", "noise-free", "nearly")
    assert page.locator("#difference-count").inner_text().startswith("0 of ")
    assert page.locator("#next-difference").is_disabled()


def test_the_scrubber_goes_through_the_scans(page: Page) -> None:
    choose(page, "saturate", "noise-free", "nearly")
    scrubber = page.locator("#scrubber")
    cell = (9, 3)
    with read_scenario(ROOT / "scenarios" / "saturate.log") as scenario:
        expected = [
            int(pixel(grid.log_odds[cell[1], cell[0]]))
            for grid in maps_after_scans(scenario, None)
        ]
    assert len(expected) == 17 and len(set(expected)) == 11
    hover(page, *cell, 20, 16)
    for scans in (1, 5, 9, 14):
        scrubber.evaluate(
            "(e, v) => { e.value = v; e.dispatchEvent(new Event('input')); }",
            scans - 1,
        )
        assert page.locator("#scrubber-value").inner_text() == f"{scans} of 17"
        read = readout(page)[
            f"expected after {scans} scan" + "s" * (scans > 1)
        ]
        assert int(read[-1]) == expected[scans - 1]


def colours(page: Page, canvas: str) -> set[tuple[int, ...]]:
    found = page.locator(canvas).evaluate(
        """c => { const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
             const s = new Set();
             for (let i = 0; i < d.length; i += 4) s.add(d.slice(i, i + 3).join());
             return [...s]; }"""
    )
    return {tuple(map(int, text.split(","))) for text in found}


def test_the_slider_uncovers_the_found_map(page: Page) -> None:
    choose(page, "asymmetric", "noise-free", "nearly")
    seen = []
    for position in (0, 100):
        page.locator("#slider").evaluate(
            "(e, v) => { e.value = v; e.dispatchEvent(new Event('input')); }",
            position,
        )
        seen.append(colours(page, "#compare"))
    assert (5, 5, 5) in seen[0], "left: all found"
    assert (5, 5, 5) not in seen[1], "right: all expected"
    assert (200, 30, 20) in colours(page, "#difference")


def test_zoom_goes_down_to_the_cell_and_keys_move(page: Page) -> None:
    choose(page, "asymmetric", "noise-free", "nearly")
    hover(page, 30, 20, 61, 37)
    for _ in range(8):
        page.mouse.wheel(0, -100)
    hovered = page.locator("#readout-cell").inner_text()
    page.locator("#compare").focus()
    for key in ("ArrowRight", "ArrowRight", "ArrowUp"):
        page.keyboard.press(key)
    moved = page.locator("#readout-cell").inner_text()
    assert hovered.startswith("cell gx=30 gy=20,")
    assert moved.startswith("cell gx=32 gy=21,")


def test_a_thumbnail_for_each_scenario_and_mode(page: Page) -> None:
    shown = page.locator("#thumbs .thumb:visible")
    assert shown.count() == 3
    assert "3 with a difference" in page.locator("#modes").inner_text()
    names = {text.split()[0] for text in shown.all_inner_texts()}
    assert names == {"one-beam", "asymmetric", "saturate"}
    page.locator("#modes input[value=seed-0]").check()
    assert page.locator("#thumbs .thumb:visible").count() == 3
    page.locator("#thumbs .thumb:visible", has_text="saturate").click()
    title = page.locator("#case-title")
    title.get_by_text("saturate, seed-0: ").wait_for()
    thumb = "#thumbs li:not([hidden]) .thumb.chosen canvas"
    assert len(colours(page, thumb)) > 2, "the map, small"


def test_the_maps_of_all_ports_stand_side_by_side(page: Page) -> None:
    choose(page, "asymmetric", "noise-free", "python")
    ports = page.locator("#ports .thumb")
    said = [" ".join(text.split()) for text in ports.all_inner_texts()]
    assert said == [
        "python identical",
        "nearly differs",
        "crashes error",
        "absent skipped",
    ]
    assert page.locator("#ports canvas").count() == 2
    ports.nth(1).focus()
    page.keyboard.press("Enter")
    page.locator("#case-title").get_by_text(": nearly").wait_for()
    pressed = ports.nth(1).get_attribute("aria-pressed")
    assert pressed == "true"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_axe_finds_nothing_and_nothing_is_wider_than_the_page(
    browser: Browser, file: Path, width: int, scheme: Literal["light", "dark"]
) -> None:
    page = browser.new_page(
        viewport={"width": width, "height": 800}, color_scheme=scheme
    )
    page.goto(file.as_uri())
    page.locator("#case-title").get_by_text(",").wait_for()
    open_table(page)
    assert violations(page) == []
    assert page.evaluate("document.documentElement.scrollWidth") == width
    assert is_noticed(page)
    page.close()


def test_only_what_failed(page: Page) -> None:
    open_table(page)
    page.locator("#only-failed").check()
    visible = [
        r for r in page.locator("#matrix tbody tr").all() if r.is_visible()
    ]
    assert visible
    assert all(row.get_attribute("class") == "failed" for row in visible)
    page.locator("#only-failed").uncheck()
    assert len(page.locator("#matrix tbody tr").all()) == 6


def test_the_page_is_one_file(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert not re.search(r"(src|href)\s*=", text)
    assert "http://" not in text and "https://" not in text
