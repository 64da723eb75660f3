"""What `occgrid-parity check` writes beside its text: the page, JUnit XML and an autograder's results."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner

from occgrid_parity.check.verdict import from_json
from occgrid_parity.check.whole_check import check
from occgrid_parity.commands.app import app
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.report.gradescope import gradescope_json

from .check_helpers import MapperRunner

PROGRAM = Path(__file__).parent / "check" / "programs" / "lesson.pl"
# The levels at which a coordinate below zero decides.
FAILED = [
    "beams without return",
    "clamping",
    "outside the grid",
    "simulated scans",
    "recorded scans",
    "all that the file format allows",
    "the well-conditioned lesson",
    "the lesson",
    "seeded noise",
]


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The check of a program that cuts to integers instead of taking the floor."""
    folder = tmp_path_factory.mktemp("check")
    command = (
        f"perl {PROGRAM} --bug truncation {{mode}} --out {{out}} {{scenario}}"
    )
    arguments = ["check", "--run", command, "--out", str(folder)]
    arguments += ["--report", str(folder / "page")]
    arguments += ["--junit", str(folder / "junit.xml")]
    arguments += ["--gradescope", str(folder / "results.json")]
    ended = CliRunner().invoke(app, arguments)
    assert ended.exit_code == 1, ended.output
    return folder


def test_results_of_an_autograder(written: Path) -> None:
    verdict = from_json((written / "verdict.json").read_text())
    results = json.loads((written / "results.json").read_text())
    tests = {test["name"]: test for test in results["tests"]}
    assert len(tests) == len(verdict.levels)
    failed = [
        name for name, test in tests.items() if test.get("status") == "failed"
    ]
    assert failed == FAILED
    unasked = {name for name, test in tests.items() if test["max_score"] == 0}
    assert unasked == {
        "how the log-odds file writes its numbers",
        "the YAML beside the map",
    }
    assert (
        results["score"]
        == sum(test["score"] for test in tests.values())
        == len(tests) - len(FAILED) - 2
    )
    wrong = tests["beams without return"]
    assert wrong["score"] == 0 and "cells differ" in wrong["output"]
    assert "truncation instead of floor" in results["output"]


def test_what_cannot_be_asked_is_worth_nothing() -> None:
    """A right program with only the lesson built in has full marks, of fewer."""
    runner = MapperRunner(Mapper, reads_scenarios=False, takes_seeds=False)
    results = json.loads(gradescope_json(check(runner)))
    scores = {
        test["name"]: (test["score"], test["max_score"])
        for test in results["tests"]
    }
    assert {name for name, (_, most) in scores.items() if most} == {
        "it runs",
        "its file is a picture of the right size",
        "orientation (the eight symmetries)",
        "how much a hit and a crossing add (p_occ, p_free)",
        "how grey values are rounded",
        "how the log-odds file writes its numbers",
        "the lesson",
    }
    assert all(score == most for score, most in scores.values())


def test_junit_xml(written: Path) -> None:
    root = ElementTree.parse(written / "junit.xml").getroot()
    cases = {case.get("name"): case for case in root.iter("testcase")}
    failed = [
        name
        for name, case in cases.items()
        if case.find("failure") is not None
    ]
    assert failed == FAILED
    assert root.get("failures") == str(len(FAILED))
    assert root.get("skipped") == "2"


def test_the_page_has_the_verdict_and_every_map(written: Path) -> None:
    text = (written / "page" / "index.html").read_text()
    assert "<strong>truncation instead of floor</strong>" in text
    assert "<strong>scan 2, beam 4, cell gx=15 gy=12</strong>" in text
    rows = re.findall(
        r'<th scope="row"[^>]*>([^<]+)</th><td>([^<]+)</td>',
        text[text.index('id="matrix"') :],
    )
    assert ("no-return-free", "noise-free") in rows
    assert ("one-beam", "noise-free") in rows
    cells = re.findall(r'class="status \w+"[^>]*>([^<]+)<', text)
    assert cells.count("expected") == len(rows)
    differ = cells.count("differs")
    verdict = from_json((written / "verdict.json").read_text())
    assert differ == sum(
        case.status == "differs"
        for level in verdict.levels
        for case in level.cases
    )
    assert (
        cells.count("identical") + cells.count("identical*")
        == len(rows) - differ
    )


def test_the_page_calls_rounding_by_its_name(tmp_path: Path) -> None:
    """What rounding decides is neither identical nor wrong, in the text or in the table."""
    command = f"perl {PROGRAM} {{mode}} --out {{out}} {{scenario}}"
    arguments = ["check", "--run", command, "--out", str(tmp_path / "out")]
    for name in ("one-beam", "lesson"):
        arguments += ["--scenario", name]
    ended = CliRunner().invoke(
        app, [*arguments, "--report", str(tmp_path / "page")]
    )
    assert ended.exit_code == 0, ended.output
    text = (tmp_path / "page" / "index.html").read_text()
    cells = re.findall(r'class="status (\w+)"[^>]*>([^<]+)<', text)
    assert sorted(cells) == [
        ("good", "expected"),
        ("good", "expected"),
        ("good", "identical"),
        ("near", "at edges"),
    ]


@pytest.fixture(scope="module")
def class_report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class of four, two of them with the same mistake; the folder of its pages."""
    folder = tmp_path_factory.mktemp("class")
    for name, bug in (
        ("ana", "heading"),
        ("bo & co", "none"),
        ("cy", "heading"),
    ):
        place = folder / "in" / name
        place.mkdir(parents=True)
        (place / PROGRAM.name).write_bytes(PROGRAM.read_bytes())
        (place / "port.toml").write_text(
            f'run = ["perl", "{{port}}/{PROGRAM.name}", "--bug", "{bug}", '
            '"{mode}", "--out", "{out}", "{scenario}"]\n'
        )
    (folder / "in" / "dee").mkdir()
    arguments = ["check", "--class", str(folder / "in")]
    for name in ("one-beam", "asymmetric"):
        arguments += ["--scenario", name]
    arguments += ["--out", str(folder / "out")]
    ended = CliRunner().invoke(
        app, [*arguments, "--report", str(folder / "pages")]
    )
    assert ended.exit_code == 1, ended.output
    assert f"report: {folder / 'pages' / 'index.html'}" in ended.output
    return folder / "pages"


def test_the_page_of_a_class(class_report: Path) -> None:
    text = (class_report / "index.html").read_text()
    assert "1 of 4 are as they should be." in text
    rows = re.findall(
        r'<a href="([^"]+)">([^<]+)</a></th>\s*<td[^>]* class="(\w+)">([^<]+)</td>',
        text,
    )
    assert rows == [
        ("submissions/ana/index.html", "ana", "bad", "differs"),
        ("submissions/cy/index.html", "cy", "bad", "differs"),
        ("submissions/dee/index.html", "dee", "bad", "no port.toml"),
        (
            "submissions/bo%20%26%20co/index.html",
            "bo &amp; co",
            "good",
            "identical*",
        ),
    ]
    causes = text[text.index('id="causes"') : text.index('id="submissions"')]
    assert causes.count("not added to the bearing") == 1
    assert re.search(r"<td[^>]*>2</td><td[^>]*>ana, cy</td>", causes)
    for name in ("ana", "bo & co", "cy", "dee"):
        own = (class_report / "submissions" / name / "index.html").read_text()
        assert f"Check of {name.replace('&', '&amp;')}" in own


def test_a_record_of_one_program_is_not_for_a_class(tmp_path: Path) -> None:
    arguments = ["check", "--class", str(tmp_path), "--json"]
    ended = CliRunner().invoke(app, [*arguments, str(tmp_path / "x")])
    assert ended.exit_code == 2
