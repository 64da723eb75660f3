"""The pages in a browser: nothing leaves the page at the width of a phone or a desk, and tabs are remembered."""

from __future__ import annotations

import html
import json
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl

import pytest

from built_handouts import Handouts, needs

OPTIONS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--allow-file-access-from-files",
    "--virtual-time-budget=20000",
)

# What reaches over the right edge, unless it lies in a box that scrolls.
MEASURE = """
<script>
addEventListener("load", function () {
  var width = document.documentElement.clientWidth, over = [];
  document.querySelectorAll("body *").forEach(function (e) {
    if (e.closest("math, svg") || e.getBoundingClientRect().right <= width + 1) { return; }
    for (var p = e.parentElement; p; p = p.parentElement) {
      if (getComputedStyle(p).overflowX === "auto") { return; }
    }
    over.push(e.tagName + " " + e.className + ": " + e.textContent.slice(0, 40));
  });
  parent.postMessage({width: width, over: over, page: location.pathname}, "*");
});
</script>
"""
FRAME = """<!DOCTYPE html><title>waiting</title>
<script>
var said = [];
onmessage = function (e) { said.push(e.data); document.title = JSON.stringify(said); };
</script>
"""
STATE = """
<script>
addEventListener("load", function () {
  setTimeout(function () { document.title = occgridPage.address(); }, 1000);
});
</script>
"""
REMEMBER = """
<script>
var chosen = document.querySelector("[role=tab][aria-selected=true]").dataset.language;
if (!location.search) {
  document.querySelector("[role=tab][data-language=cpp]").click();
  location.search = "?again";
} else { document.title = "remembered: " + chosen; }
</script>
"""


def title_in_browser(folder: Path, name: str, address: str = "") -> str:
    """The title of a page after its scripts have run; the address is what follows the page's name, "#" included."""
    browser = needs("chromium", "chromium", "google-chrome")
    done = subprocess.run(
        [
            browser,
            *OPTIONS,
            f"--user-data-dir={folder / 'profile'}",
            "--dump-dom",
            "--window-size=1400,1000",
            (folder / name).as_uri() + address,
        ],
        capture_output=True,
        text=True,
        timeout=300,
    )
    found = re.search(r"<title>([^<]*)</title>", done.stdout)
    assert found, done.stderr
    return found[1]


def with_script(handouts: Handouts, name: str, script: str) -> str:
    page = (handouts.folder / name).read_text(encoding="utf-8")
    return page.replace("</body>", script + "</body>")


def measured(
    folder: Path, pages: Mapping[str, str], width: int
) -> list[dict[str, Any]]:
    """What each page says of itself in a frame of that width."""
    frames = []
    for name, page in pages.items():
        file = name.replace("/", "-")
        (folder / file).write_text(page, encoding="utf-8")
        style = f"width: {width}px; height: 900px; border: 0"
        frames.append(f'<iframe src="{file}" style="{style}"></iframe>')
    (folder / "frame.html").write_text(FRAME + "\n".join(frames))
    title = title_in_browser(folder, "frame.html")
    said: list[dict[str, Any]] = json.loads(html.unescape(title))
    assert len(said) == len(pages)
    return said


@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_leaves_a_page(
    handouts: Handouts, tmp_path: Path, width: int
) -> None:
    pages = {
        name: with_script(handouts, name, MEASURE) for name in handouts.pages()
    }
    for said in measured(tmp_path, pages, width):
        assert said["over"] == [], said["page"]
        assert width - 20 <= said["width"] <= width


def test_element_over_the_edge_is_noticed(
    handouts: Handouts, tmp_path: Path
) -> None:
    wide = '<p style="width: 50rem">wide</p>' + MEASURE
    page = with_script(handouts, "student/index.html", wide)
    (said,) = measured(tmp_path, {"index.html": page}, 390)
    assert said["over"] == ["P : wide"]


def test_language_of_the_tabs_is_remembered(
    handouts: Handouts, tmp_path: Path
) -> None:
    page = with_script(handouts, "student/python.html", REMEMBER)
    (tmp_path / "page.html").write_text(page)
    assert title_in_browser(tmp_path, "page.html") == "remembered: cpp"


def test_links_to_play_open_the_state_that_they_ask_for(
    handouts: Handouts, tmp_path: Path
) -> None:
    if not (handouts.folder / "student" / "play.html").is_file():
        pytest.skip("this build could not make play.html")
    page = with_script(handouts, "student/play.html", STATE)
    (tmp_path / "play.html").write_text(page, encoding="utf-8")
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
        title = title_in_browser(tmp_path, "play.html", "#" + state)
        shown = html.unescape(title).removeprefix("#")
        assert set(parse_qsl(state)) <= set(parse_qsl(shown)), (state, shown)
