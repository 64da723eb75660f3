"""What the tests look at: a build of the languages whose ports define every snippet."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from occgrid_handouts.building import build
from occgrid_handouts.languages import LANGUAGES, Language
from occgrid_handouts.page_tree import Element, read_page
from occgrid_handouts.platform_math import search_path
from occgrid_handouts.project import ROOT, Edition, current_edition
from occgrid_handouts.snippets import (
    NAMES,
    Snippet,
    read_snippets,
    source_files,
)

REQUIRE_ALL = os.environ.get("PARITY_REQUIRE_ALL") == "1"


@dataclass(frozen=True)
class Handouts:
    """What a build wrote."""

    folder: Path
    languages: tuple[Language, ...]
    edition: Edition
    snippets: dict[str, dict[str, Snippet]]

    def page(self, name: str) -> Element:
        """A page's tree."""
        return read_page((self.folder / name).read_text(encoding="utf-8"))

    def pages(self) -> list[str]:
        """The names of all pages."""
        return sorted(
            path.relative_to(self.folder).as_posix()
            for path in self.folder.glob("**/*.html")
        )

    def pdfs(self) -> list[Path]:
        """All PDFs."""
        return sorted(self.folder.glob("**/*.pdf"))


def needs(command: str, package: str) -> str:
    """The command's path; skips the test where it is missing, or fails where nothing may be skipped."""
    path = shutil.which(command, path=search_path())
    if path is None:
        if REQUIRE_ALL:
            pytest.fail(f"{command} is missing: install {package}")
        pytest.skip(f"{command} is missing: install {package}")
    return path


def ready_languages() -> tuple[Language, ...]:
    """The languages whose ports are there; all five where nothing may be skipped."""
    if REQUIRE_ALL:
        return LANGUAGES
    return tuple(
        language
        for language in LANGUAGES
        if source_files(ROOT, language)
        and set(NAMES) <= set(read_snippets(ROOT, language))
    )


def build_into(folder: Path) -> Handouts:
    """Builds everything into a folder."""
    languages, edition = ready_languages(), current_edition()
    build(ROOT, folder, languages, edition, 2, lambda text: None)
    snippets = {one.id: read_snippets(ROOT, one) for one in languages}
    return Handouts(folder, languages, edition, snippets)
