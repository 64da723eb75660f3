"""The PDFs: accessible, with a footer, within the margins, the same at every build."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from built_handouts import Handouts, build_into, needs


def test_pdfs_are_tagged_and_pdf_ua(handouts: Handouts) -> None:
    """The compiler checks the standard itself and fails where a text breaks it; the file says that it did."""
    assert len(handouts.pdfs()) == 2 * len(handouts.languages)
    for path in handouts.pdfs():
        content = path.read_bytes()
        assert re.search(rb"<pdfuaid:part>1</pdfuaid:part>", content), path
        assert b"/StructTreeRoot" in content
        assert b"/Lang" in content


def pdf_text(path: Path, *options: str) -> str:
    command = [needs("pdftotext", "poppler-utils"), *options, str(path), "-"]
    return subprocess.run(
        command, capture_output=True, text=True, check=True
    ).stdout


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
    """Each line of code, unbroken: none is cut off at the margin or wrapped."""
    for language in handouts.languages:
        text = pdf_text(handouts.folder / f"{language.id}.pdf", "-layout")
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
            width = float(re.search(r'width="([\d.]+)"', page)[1])  # type: ignore[index]
            right = [float(x) for x in re.findall(r'xMax="([\d.]+)"', page)]
            assert not right or max(right) <= width - 20, path


def test_two_builds_are_the_same(
    handouts: Handouts, tmp_path_factory: object
) -> None:
    again = build_into(handouts.folder.parent / "again")
    first = {
        p.relative_to(handouts.folder): p.read_bytes()
        for p in handouts.folder.glob("**/*")
        if p.is_file()
    }
    second = {
        p.relative_to(again.folder): p.read_bytes()
        for p in again.folder.glob("**/*")
        if p.is_file()
    }
    assert sorted(first) == sorted(second)
    assert [p for p in sorted(first) if first[p] != second[p]] == []
