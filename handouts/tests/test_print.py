"""The PDFs: accessible, with a footer, within the margins, the same at every build."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest

from built_handouts import REQUIRE_ALL, Handouts, needs
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.project import ROOT


def test_pdfs_are_tagged_and_pdf_ua(handouts: Handouts) -> None:
    """The compiler checks the standard itself and fails where a text breaks it; the file says that it did."""
    assert len(handouts.pdfs()) == 2 * len(LANGUAGES)
    for path in handouts.pdfs():
        content = path.read_bytes()
        assert re.search(rb"<pdfuaid:part>1</pdfuaid:part>", content), path
        assert b"/StructTreeRoot" in content
        assert b"/Lang" in content


def pdf_text(path: Path, *options: str) -> str:
    command = [needs("poppler-utils", "pdftotext"), *options, str(path), "-"]
    return subprocess.run(
        command, capture_output=True, text=True, check=True
    ).stdout


def test_no_page_is_mostly_empty(handouts: Handouts) -> None:
    """The last word of each page stands below its upper third, but where the text ends or the paper is turned."""
    for path in handouts.pdfs():
        pages = pdf_text(path, "-bbox").split("<page ")[1:]
        for number, (page, following) in enumerate(pairwise(pages), 1):
            if page.split(">")[0] != following.split(">")[0]:
                continue
            height = float(re.findall(r'height="([\d.]+)"', page)[0])
            below = [float(y) for y in re.findall(r'yMax="([\d.]+)"', page)]
            # without the footer
            lowest = max(y for y in below if y < height - 45)
            assert lowest > height / 3, (path.name, number)


def test_footer_on_every_page(handouts: Handouts) -> None:
    edition = handouts.edition
    stamp = f"occgrid {edition.version} · commit {edition.commit}"
    for path in handouts.pdfs():
        pages = pdf_text(path, "-layout").split("\f")[:-1]
        assert len(pages) > 15
        for number, page in enumerate(pages, 1):
            assert stamp in page, (path, number)
            assert "make handouts" in page


def test_every_listing_is_printed_whole(handouts: Handouts) -> None:
    """Each line of code, unbroken: none is cut off at the margin or wrapped. Columns are read one after the other."""
    for language in LANGUAGES:
        text = pdf_text(handouts.folder / f"student/{language.id}.pdf", "-raw")
        printed = {" ".join(line.split()) for line in text.splitlines()}
        joined = "\n".join(printed)
        for name, snippet in handouts.snippets[language.id].items():
            for line in snippet.code.splitlines():
                plain = " ".join(line.split())
                if plain.isascii():
                    assert plain in joined, (language.id, name, line)


def test_nothing_leaves_the_paper(handouts: Handouts) -> None:
    for path in handouts.pdfs():
        boxes = pdf_text(path, "-bbox")
        for page in boxes.split("<page ")[1:]:
            width, height = re.findall(r'(?:width|height)="([\d.]+)"', page)
            right = [float(x) for x in re.findall(r'xMax="([\d.]+)"', page)]
            below = [float(y) for y in re.findall(r'yMax="([\d.]+)"', page)]
            assert max(right) <= float(width) - 20, path
            assert max(below) <= float(height) - 20, path


@pytest.mark.long
def test_two_builds_are_the_same(handouts: Handouts, tmp_path: Path) -> None:
    """The second one in a process of its own, where sets and hashes have another order."""
    again = tmp_path / "again"
    program = str(ROOT / "handouts" / "build.py")
    subprocess.run(
        [
            sys.executable,
            program,
            "--quiet",
            *([] if REQUIRE_ALL else ["--partial"]),
            "--out",
            str(again),
        ],
        check=True,
        env={**os.environ, "PYTHONHASHSEED": "1"},
    )
    first, second = contents(handouts.folder), contents(again)
    assert len(first) >= 60
    assert sorted(first) == sorted(second)
    assert [name for name in first if first[name] != second[name]] == []


def contents(folder: Path) -> dict[str, bytes]:
    """Every file by its name in the folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.glob("**/*"))
        if path.is_file()
    }
