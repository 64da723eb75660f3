"""What the tests look at: a build of everything."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from occgrid_handouts.building import build
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.page_tree import Element, read_page
from occgrid_handouts.platform_math import search_path
from occgrid_handouts.project import ROOT, Edition, current_edition
from occgrid_handouts.snippets import read_snippets
from occgrid_handouts.web_pages import NAMES as WEB_PAGES
from occgrid_parity.ports.snippets import Snippet

# a telephone's, and a desk's
WIDTHS = (390, 1280)
REQUIRE_ALL = os.environ.get("PARITY_REQUIRE_ALL") == "1"


@dataclass(frozen=True)
class Handouts:
    """What a build wrote."""

    folder: Path
    edition: Edition
    snippets: dict[str, dict[str, Snippet]]
    missing: bool
    _read: dict[str, Element] = field(default_factory=dict)

    def page(self, name: str) -> Element:
        """A page's tree, read once for all tests."""
        if name not in self._read:
            text = (self.folder / name).read_text(encoding="utf-8")
            self._read[name] = read_page(text)
        return self._read[name]

    def pages(self) -> list[str]:
        """The names of all pages."""
        return sorted(
            path.relative_to(self.folder).as_posix()
            for path in self.folder.glob("**/*.html")
            if path.name not in WEB_PAGES
        )

    def pdfs(self) -> list[Path]:
        """All PDFs."""
        return sorted(self.folder.glob("**/*.pdf"))


def needs(package: str, *commands: str) -> str:
    """The path of the first command that is there; without any the test is skipped, or fails where none may be."""
    for command in commands:
        path = shutil.which(command, path=search_path())
        if path is not None:
            return path
    reason = f"{' or '.join(commands)} is missing: install {package}"
    if REQUIRE_ALL:
        pytest.fail(reason)
    pytest.skip(reason)


def build_into(folder: Path) -> Handouts:
    """Builds everything into a folder that is not there yet; OCCGRID_HANDOUTS names one that was built just before."""
    edition = current_edition()
    built = os.environ.get("OCCGRID_HANDOUTS")
    if built:
        folder = Path(built).resolve()
    elif not folder.exists():
        build(
            ROOT,
            folder,
            LANGUAGES,
            edition,
            2,
            lambda text: None,
            partial=not REQUIRE_ALL,
        )
    snippets = {one.id: read_snippets(ROOT, one) for one in LANGUAGES}
    index = (folder / "student" / "index.html").read_text(encoding="utf-8")
    return Handouts(folder, edition, snippets, "What is missing" in index)
