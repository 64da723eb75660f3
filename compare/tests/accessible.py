"""Pages for everyone: what axe-core finds in a page, and which tables leave it."""

from __future__ import annotations

from playwright.sync_api import Page

from .conftest import ROOT, unavailable

AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
TOO_WIDE = """() => [...document.querySelectorAll("table")].filter(table =>
  table.checkVisibility() && table.getBoundingClientRect().right > document.documentElement.clientWidth
).map(table => table.id)"""


def violations(page: Page) -> list[str]:
    """What axe-core finds in a page as it is shown."""
    if not AXE.is_file():
        unavailable("web/node_modules is missing: npm ci in web/")
    page.evaluate(AXE.read_text(encoding="utf-8"))
    results = page.evaluate("axe.run({ resultTypes: ['violations'] })")
    return [
        f"{one['id']}: {node['html'][:200]} {node['failureSummary']}"
        for one in results["violations"]
        for node in one["nodes"]
    ]


def is_noticed(page: Page) -> bool:
    """Whether axe-core notices a picture without a text, which this puts into the page."""
    page.evaluate(
        "document.querySelector('h1').innerHTML = '<img src=\"data:,\">'"
    )
    return any("image-alt" in one for one in violations(page))


def tables_too_wide(page: Page) -> list[str]:
    """The tables that reach over the right edge: what stands there is not seen at once."""
    found: list[str] = page.evaluate(TOO_WIDE)
    return found
