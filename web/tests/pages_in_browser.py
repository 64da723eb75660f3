"""The pages, built once, in a headless Chromium; and the Python port beside them."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from playwright.sync_api import Browser, Page, sync_playwright

WEB = Path(__file__).resolve().parents[1]
ROOT = WEB.parent
GOLDEN = ROOT / "scenarios" / "golden"
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
# as root, and without a look at the network
ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
Open = Callable[..., Page]


def unavailable(reason: str) -> None:
    if os.environ.get("PARITY_REQUIRE_ALL", "") not in ("", "0"):
        pytest.fail(reason, pytrace=False)
    pytest.skip(reason)


def build_pages(folder: Path) -> None:
    subprocess.run(
        ["node", WEB / "build.mjs", folder], check=True, capture_output=True
    )


@pytest.fixture(scope="session")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with play.html and check.html."""
    if not (WEB / "node_modules" / "esbuild").is_dir():
        unavailable("web/node_modules is missing: npm ci in web/")
    folder = tmp_path_factory.mktemp("pages")
    build_pages(folder)
    return folder


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    if CHROMIUM is None:
        unavailable("chromium is missing: apt-get install chromium")
    with sync_playwright() as playwright:
        launched = playwright.chromium.launch(
            executable_path=CHROMIUM, args=ARGUMENTS
        )
        yield launched
        launched.close()


@pytest.fixture
def open_page(browser: Browser, pages: Path) -> Iterator[Open]:
    """Opens a page; at the end, nothing was complained of and nothing came from elsewhere."""
    opened: list[Page] = []
    complaints: list[str] = []
    requests: list[str] = []

    def open_(
        name: str, address: str = "", first: str = "", **options: object
    ) -> Page:
        """`first` is a script that runs before the page's own."""
        chosen = {"viewport": {"width": 1280, "height": 1000}, **options}
        page = browser.new_page(**chosen)  # type: ignore[arg-type]
        if first:
            page.add_init_script(first)
        page.set_default_timeout(60_000)
        page.on(
            "console",
            lambda message: (
                complaints.append(message.text)
                if message.type == "error"
                else None
            ),
        )
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("request", lambda request: requests.append(request.url))
        page.goto((pages / f"{name}.html").as_uri() + address)
        opened.append(page)
        return page

    yield open_
    for page in opened:
        page.close()
    assert complaints == []
    assert all(
        url.startswith(("file:", "blob:")) and "/pages" in url
        for url in requests
        if not url.startswith("blob:")
    ), requests


DROP = """([selector, name, text]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([text], name));
  document.querySelector(selector).dispatchEvent(
    new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}"""


def drop_file(page: Page, place: str, file: Path) -> None:
    """Lets go of a file over a place of the page."""
    text = file.read_text(encoding="ascii")
    page.evaluate(DROP, [place, file.name, text])


def log_odds_of(path: Path) -> npt.NDArray[np.float64]:
    """The values of a .logodds file, (height, width), smallest y first."""
    return np.loadtxt(path, ndmin=2)


def hash_of(log_odds: npt.NDArray[np.float64]) -> str:
    return hashlib.sha256(log_odds.astype("<f8").tobytes()).hexdigest()


def python_map(
    scenario: str, folder: Path, *options: str
) -> npt.NDArray[np.float64]:
    """What the Python port makes of a scenario, given as text."""
    file = folder / "scenario.log"
    file.write_text(scenario, encoding="ascii")
    subprocess.run(
        [sys.executable, "-m", "occgrid", "--out", folder, *options, file],
        check=True,
    )
    return log_odds_of(folder / "scenario.logodds")
