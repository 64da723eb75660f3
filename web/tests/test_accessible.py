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
