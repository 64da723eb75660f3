"""Pictures of two pages for README.md, after `make handouts`: `.venv/bin/python docs/screenshots.py docs`.

check.html with the lesson's map of a program that marks the ends of beams without return, and a part of the Python
handout.
"""

from __future__ import annotations

import io
import shutil
import sys
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, sync_playwright

from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model.worlds import world_of
from occgrid_parity.suite.cases import case

HANDOUTS = Path(__file__).resolve().parents[1] / "build" / "handouts"
MISTAKE = "max-range-occupied"
WIDTH, HEIGHT = 860, 1000


def keep(picture: bytes, file: Path) -> None:
    """Writes a picture with a palette, which takes a fifth of the space."""
    image = Image.open(io.BytesIO(picture)).convert("RGB")
    covering = Image.Quantize.MAXCOVERAGE
    image.quantize(128, method=covering).save(file, optimize=True)


def check_page(browser: Browser, file: Path) -> None:
    """The verdict about a map with a mistake."""
    pixels = MISTAKES[MISTAKE](world_of(case("lesson")), None).draw().pixels
    height, width = pixels.shape
    rows = "\n".join(" ".join(map(str, row)) for row in pixels.tolist())
    page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    page.goto((HANDOUTS / "check.html").as_uri())
    with tempfile.TemporaryDirectory() as folder:
        map_file = Path(folder) / "my_map.pgm"
        map_file.write_text(f"P2\n{width} {height}\n255\n{rows}\n")
        page.set_input_files("#file", map_file)
        page.locator("#verdict[data-status=differs]").wait_for(timeout=180_000)
        page.locator("#result").scroll_into_view_if_needed()
        page.evaluate("document.querySelector('#result').scrollIntoView()")
        keep(page.screenshot(), file)


def handout_page(browser: Browser, file: Path) -> None:
    """The section on one update of a cell."""
    page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    page.goto((HANDOUTS / "student" / "python.html").as_uri())
    page.evaluate(
        "document.querySelector('#equation-endpoint').scrollIntoView()"
    )
    page.wait_for_timeout(500)
    keep(page.screenshot(), file)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python docs/screenshots.py FOLDER")
    folder = Path(sys.argv[1])
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(
            executable_path=chromium, args=["--no-sandbox"]
        )
        check_page(opened, folder / "check-page.png")
        handout_page(opened, folder / "handout-page.png")
        opened.close()
