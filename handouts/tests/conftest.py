"""One build of everything and one browser, for all tests."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from filelock import FileLock
from playwright.sync_api import Browser, sync_playwright

from built_handouts import Handouts, build_into, needs

ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


@pytest.fixture(scope="session")
def handouts(tmp_path_factory: pytest.TempPathFactory) -> Handouts:
    """The one build, which several workers share: the first one makes it, and the others wait."""
    folder = tmp_path_factory.getbasetemp()
    if os.environ.get("PYTEST_XDIST_WORKER"):
        folder = folder.parent
    with FileLock(folder / "handouts.lock"):
        return build_into(folder / "handouts")


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """A headless browser."""
    path = needs("chromium", "chromium", "google-chrome")
    with sync_playwright() as playwright:
        launched = playwright.chromium.launch(
            executable_path=path, args=ARGUMENTS
        )
        yield launched
        launched.close()
