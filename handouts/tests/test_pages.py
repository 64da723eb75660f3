"""The pages: every snippet, every link, every alternative text, nothing from outside."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from built_handouts import REQUIRE_ALL, Handouts
from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.math_font import find_font
from occgrid_handouts.page_tree import Element
from occgrid_handouts.project import ROOT
from occgrid_parity.ports.snippets import MAX_COLUMNS


def handout_pages(handouts: Handouts) -> list[str]:
    return [p for p in handouts.pages() if not p.endswith("index.html")]


def lines_of(listing: Element) -> dict[int, str]:
    """A listing's lines by their numbers."""
    return {
        int(e.attributes["data-n"]): e.text()
        for e in listing.walk()
        if e.has_class("line")
    }


def test_all_languages_are_there(handouts: Handouts) -> None:
    for language in LANGUAGES:
        for edition in ("student", "instructor"):
            folder = handouts.folder / edition
            assert (folder / f"{language.id}.html").is_file()
            assert (folder / f"{language.id}.pdf").is_file()


def test_every_snippet_stands_in_its_handout_line_by_line(
    handouts: Handouts,
) -> None:
    for language in LANGUAGES:
        page = handouts.page(f"student/{language.id}.html")
        listings = {
            e.attributes["id"].removeprefix("listing-"): e
            for e in page.walk()
            if e.has_class("listing") and "id" in e.attributes
        }
        for name, snippet in handouts.snippets[language.id].items():
            shown = lines_of(listings[name])
            numbers = range(snippet.first, snippet.last + 1)
            assert list(shown) == list(numbers), (language.id, name)
            code = snippet.code.split("\n")
            assert list(shown.values()) == code, (language.id, name)
            assert snippet.file in listings[name].text()
            assert max(map(len, code)) <= MAX_COLUMNS


def test_appendix_has_the_same_snippets_in_all_languages(
    handouts: Handouts,
) -> None:
    for name in handout_pages(handouts):
        groups = [e for e in handouts.page(name).walk() if e.has_class("tabs")]
        assert len(groups) >= 6
        for group in groups:
            shown = [
                e.attributes["data-language"]
                for e in group.walk()
                if e.has_class("panel")
            ]
            assert shown == [one.id for one in LANGUAGES]


def test_equations_and_listings_point_to_each_other(
    handouts: Handouts,
) -> None:
    for name in handout_pages(handouts):
        page = handouts.page(name)
        to_code: set[tuple[str, str]] = set()
        to_equation: set[tuple[str, str]] = set()
        for element in page.walk():
            own = element.attributes.get("id", "")
            links = [
                e.attributes.get("href", "").removeprefix("#")
                for e in element.walk()
                if e.tag == "a"
            ]
            if element.has_class("equation") and own:
                to_code |= {(own, link) for link in links}
            if element.has_class("listing") and own.startswith("listing-"):
                to_equation |= {(link, own) for link in links}
        assert to_code == to_equation
        assert len(to_code) >= 16


def test_links_lead_somewhere(handouts: Handouts) -> None:
    for name in handouts.pages():
        page = handouts.page(name)
        ids = [e.attributes["id"] for e in page.walk() if "id" in e.attributes]
        assert len(ids) == len(set(ids)), name
        here = (handouts.folder / name).parent
        for element in page.walk():
            if element.tag == "a":
                target = element.attributes["href"]
                if target.startswith("https://doi.org/10."):
                    continue
                if target.startswith("#"):
                    assert target[1:] in ids, (name, target)
                else:
                    file = target.partition("#")[0]
                    assert (here / file).resolve().is_file(), (name, target)


def test_every_reference_is_cited(handouts: Handouts) -> None:
    for name in handout_pages(handouts):
        page = handouts.page(name)
        entries = {
            e.attributes["id"] for e in page.walk() if e.has_class("reference")
        }
        cited = {
            e.attributes["href"][1:]
            for e in page.walk()
            if e.tag == "a" and e.attributes["href"].startswith("#reference-")
        }
        assert entries == cited
        assert len(entries) == 12


def test_every_picture_has_an_alternative_text(handouts: Handouts) -> None:
    for name in handout_pages(handouts):
        page = handouts.page(name)
        pictures = [e for e in page.walk() if e.tag == "img"]
        drawings = [e for e in page.walk() if e.tag == "svg"]
        framed = [
            e
            for e in page.walk()
            if e.attributes.get("role") == "img" and e.find("svg")
        ]
        assert len(pictures) >= 11
        assert len(drawings) == len(framed) == 2
        for picture in pictures:
            assert len(picture.attributes["alt"]) > 30
        for drawing in framed:
            assert len(drawing.attributes["aria-label"]) > 30


def test_pages_need_nothing_from_outside(handouts: Handouts) -> None:
    outside = re.compile(
        r"""src="(?:https?:)?//|href="(?!https://doi\.org/)(?:https?:)?//|url\((?!data:)|@import|<link|fetch\("""
    )
    for name in handouts.pages():
        text = (handouts.folder / name).read_text(encoding="utf-8")
        assert not outside.search(text), name


def test_equations_are_mathml_with_a_font(handouts: Handouts) -> None:
    text = (handouts.folder / "student/python.html").read_text(
        encoding="utf-8"
    )
    assert text.count("<math") > 150
    if find_font() is None and not REQUIRE_ALL:
        pytest.skip("the font is missing: install fonts-dejavu-extra")
    assert "data:font/woff;base64," in text


def test_solutions_are_the_instructors(handouts: Handouts) -> None:
    for language in LANGUAGES:
        student = handouts.page(f"student/{language.id}.html")
        instructor = handouts.page(f"instructor/{language.id}.html")
        solved = [e for e in instructor.walk() if e.has_class("solution")]
        assert len(solved) == 5
        assert not [e for e in student.walk() if e.has_class("solution")]
        for page in (student, instructor):
            titles = [e.text() for e in page.walk() if e.tag == "h3"]
            assert sum("Problem" in title for title in titles) == 5


def test_numbers_come_from_the_run(handouts: Handouts) -> None:
    text = handouts.page("student/python.html").text()
    for number in ("17,356", "4,163", "21,720", "39,600"):
        assert number in text
    table = next(
        e
        for e in handouts.page("student/python.html").walk()
        if e.tag == "table" and "the beam says" in e.text()
    )
    rows = [
        [cell.text() for cell in e.elements()]
        for e in table.walk()
        if e.tag == "tr"
    ]
    assert rows[1][:4] == ["0", "1", "1", "free"]
    assert rows[-1][:4] == ["4", "5", "3", "occupied"]
    assert rows[-1][-1] == "0.7500"


def test_ports_agree_in_every_bit(handouts: Handouts) -> None:
    table = next(
        e
        for e in handouts.page("student/python.html").walk()
        if e.tag == "table" and "seed 0" in e.text()
    )
    rows = [
        [cell.text() for cell in e.elements()]
        for e in table.walk()
        if e.tag == "tr"
    ][1:]
    assert [row[0] for row in rows] == [o.name for o in LANGUAGES]
    for row in rows:
        if not REQUIRE_ALL and "not measured" in row[1]:
            continue
        assert row[1:] == ["0", "0"]


def test_commands_of_the_exercises_work(
    handouts: Handouts, tmp_path: Path
) -> None:
    """Each as it is printed, with the Python port as the student's program."""
    program = tmp_path / "my_program"
    port = f'exec "{sys.executable}" -m occgrid --noise-free --out "$2" "$1"'
    program.write_text(f"#!/bin/sh\n{port}\n")
    program.chmod(0o755)
    paths = [str(ROOT / "python"), str(ROOT / "compare")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
    commands = [
        e.text().strip()
        for e in handouts.page("student/cpp.html").walk()
        if e.has_class("command") and "--scenario" in e.text()
    ]
    assert len(commands) == 7
    for command in commands:
        name, *arguments = shlex.split(command)
        done = subprocess.run(
            [str(Path(sys.executable).with_name(name)), *arguments],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert "every bit of the log-odds" in done.stdout, command


def test_every_page_says_what_it_is_made_of(handouts: Handouts) -> None:
    edition = handouts.edition
    for name in handouts.pages():
        footer = handouts.page(name).find("footer")
        assert footer is not None
        for part in (edition.version, edition.commit, "make handouts"):
            assert part in footer.text()


def test_index_lists_everything(handouts: Handouts) -> None:
    for name in ("student/index.html", "instructor/index.html"):
        links = {
            e.attributes["href"]
            for e in handouts.page(name).walk()
            if e.tag == "a"
        }
        for language in LANGUAGES:
            assert {f"{language.id}.html", f"{language.id}.pdf"} <= links
            if name.startswith("student"):
                assert f"starter-{language.id}.zip" in links
                assert f"occupancy-grid-{language.id}.zip" in links
            else:
                solution = f"solutions/{language.id}/exercise-5"
                assert {f"{solution}.patch", f"{solution}.class.toml"} <= links
        assert "python.ipynb" in links
