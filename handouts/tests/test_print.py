"""The PDFs: accessible, with a footer, within the margins, the same at every build."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import dataclass
from html import unescape
from itertools import pairwise
from pathlib import Path

import pytest

from built_handouts import REQUIRE_ALL, Handouts, needs
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.project import ROOT

POINTS_PER_MM = 72 / 25.4


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


def test_nothing_leaves_the_margins(handouts: Handouts) -> None:
    """Punctuation alone hangs into the right margin, by less than 3 pt."""
    for path in handouts.pdfs():
        boxes = pdf_text(path, "-bbox")
        for page in boxes.split("<page ")[1:]:
            width, height = map(
                float, re.findall(r'(?:width|height)="([\d.]+)"', page)[:2]
            )
            margin = (21 if width < height else 8) * POINTS_PER_MM
            right = [float(x) for x in re.findall(r'xMax="([\d.]+)"', page)]
            below = [float(y) for y in re.findall(r'yMax="([\d.]+)"', page)]
            assert max(right) <= width - margin + 3, path
            assert max(below) <= height - 20, path


@dataclass(frozen=True)
class Line:
    """A line of a page, in points from the upper left corner."""

    left: float
    right: float
    top: float
    words: str


def lines_of(path: Path) -> list[list[Line]]:
    """The lines of each column of a PDF's pages from top to bottom, without the footer."""
    columns = []
    for page in pdf_text(path, "-bbox-layout").split("<page ")[1:]:
        width, height = map(
            float, re.findall(r'(?:width|height)="([\d.]+)"', page)[:2]
        )
        lines = []
        for line in page.split("<line ")[1:]:
            left, top, right, _ = map(
                float, re.findall(r'[xy]M(?:in|ax)="([\d.]+)"', line)[:4]
            )
            words = " ".join(re.findall(r">([^<>]+)</word>", line))
            if top < height - 50:
                lines.append(Line(left, right, top, unescape(words)))
        lines.sort(key=lambda line: (line.top, line.left))
        middle = width / 2 if width > height else width
        columns.append([line for line in lines if line.left < middle])
        columns.append([line for line in lines if line.left >= middle])
    return [column for column in columns if column]


def test_what_leads_over_stays_with_what_follows(handouts: Handouts) -> None:
    """No page or column ends with words and a colon, and none begins with an equation."""
    for path in handouts.pdfs():
        code = {
            " ".join(line.split())
            for snippets in handouts.snippets.values()
            for snippet in snippets.values()
            for line in snippet.code.splitlines()
        }
        for column in lines_of(path):
            # a colon in the middle of a paragraph stands at the right margin
            last = column[-1]
            within = last.right > max(line.right for line in column) - 5
            words = re.sub(r"^\d+ ", "", last.words)  # a line number
            leads_over = words.endswith(":") and words not in code
            assert within or not leads_over, (path, words)
            # an equation is centred, a sentence above it is not
            margin = min(line.left for line in column)
            top = column[0].top
            begins = [line for line in column if line.top < top + 25]
            numbered = [
                line.words
                for line in begins
                if re.fullmatch(r"\(\d+\)", line.words)
                and all(one.left > margin + 10 for one in begins)
            ]
            assert not numbered, (path, numbered)


def test_no_few_lines_of_a_listing_stand_alone(handouts: Handouts) -> None:
    """Where a page ends within a listing, at least four of its lines stand on each side."""
    parts = 0
    for path in handouts.pdfs():
        whole = {
            (snippet.first, snippet.last)
            for snippet in handouts.snippets[path.stem].values()
        }
        for column in lines_of(path):
            numbers = [
                int(found[0])
                for line in column
                if 62 < line.left < 85
                and (found := re.match(r"\d+(?= |$)", line.words))
            ]
            for run in consecutive(numbers):
                if (
                    len(run) > 1
                    and run[0] > 1
                    and (run[0], run[-1]) not in whole
                ):
                    assert len(run) >= 4, (path, run)
                    parts += 1
    assert parts > 20


def consecutive(numbers: list[int]) -> list[list[int]]:
    """The runs of numbers of which each is one more than the last."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs


def test_code_within_a_sentence_stays_on_one_line(handouts: Handouts) -> None:
    """`--plain` is not broken after its hyphens, nor an expression at a space."""
    for path in handouts.pdfs():
        name = path.relative_to(handouts.folder).with_suffix(".html")
        body = handouts.page(name.as_posix()).find("main")
        assert body is not None
        printed = "\n".join(
            line.words for column in lines_of(path) for line in column
        )
        inline = {
            " ".join(code.text().split())
            for paragraph in body.walk()
            if paragraph.tag in ("p", "li", "dd")
            for code in paragraph.walk()
            if code.tag == "code"
        }
        assert len(inline) > 20
        assert [code for code in inline if code not in printed] == []


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
