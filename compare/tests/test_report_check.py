"""What `parity check` writes beside its text: the page, JUnit XML and an autograder's results."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner

from parity.checking.verdict import from_json
from parity.cli import app

PROGRAM = Path(__file__).parent / "check" / "programs" / "lesson.pl"


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
    passed = [
        name for name, test in tests.items() if test["status"] == "passed"
    ]
    assert passed == [
        "it runs",
        "its file is a picture of the right size",
        "one beam",
        "lines in all octants",
    ]
    assert (
        results["score"] == sum(test["score"] for test in tests.values()) == 4
    )
    failed = tests["beams without return"]
    assert failed["score"] == 0 and "cells differ" in failed["output"]
    assert "truncation instead of floor" in results["output"]


def test_junit_xml(written: Path) -> None:
    root = ElementTree.parse(written / "junit.xml").getroot()
    cases = {case.get("name"): case for case in root.iter("testcase")}
    failed = [
        name
        for name, case in cases.items()
        if case.find("failure") is not None
    ]
    assert failed == ["beams without return"]
    assert root.get("failures") == "1"
    assert int(root.get("skipped", "0")) + 5 == len(cases)


def test_the_page_has_the_verdict_and_every_map(written: Path) -> None:
    text = (written / "page" / "index.html").read_text()
    assert "truncation instead of floor [truncation]" in text
    rows = re.findall(
        r'<th scope="row"[^>]*>([^<]+)</th><td>([^<]+)</td>', text
    )
    assert ("no-return-free", "noise-free") in rows
    assert ("one-beam", "noise-free") in rows
    cells = re.findall(r'class="status (\w+)"', text)
    assert cells.count("differs") == 6
    assert cells.count("identical") == 2 * len(rows) - 6


def test_one_program_only(tmp_path: Path) -> None:
    arguments = ["check", "--class", str(tmp_path), "--report", str(tmp_path)]
    assert CliRunner().invoke(app, arguments).exit_code == 2
