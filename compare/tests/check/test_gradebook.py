"""What a course hands on: points for Moodle and Canvas, feedback, results.json and JUnit for each."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner

from occgrid_parity.commands.app import app
from occgrid_parity.course.gradebook import RosterError, read_roster

from ..check_helpers import PROGRAMS

ROSTER = (
    "submission,Student,SIS Login ID,Email address\n"
    'right,"One, Some",one,one@example.org\n'
    "prior,Two,two,two@example.org\n"
    "absent,Three,three,three@example.org\n"
)


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A checked class of three, of which one is not in the roster."""
    folder = tmp_path_factory.mktemp("course")
    for name, bug in (("right", ""), ("prior", "prior"), ("guest", "")):
        place = folder / "in" / name
        place.mkdir(parents=True)
        program = PROGRAMS / "lesson.awk"
        (place / "lesson.awk").write_bytes(program.read_bytes())
        (place / "port.toml").write_text(
            f'run = ["awk", "-f", "lesson.awk", "-v", "bug={bug}", "{{scenario}}"]\n'
        )
    (folder / "in" / "class.toml").write_text(
        'assignment = "Grid"\n[points]\nruns = 1\nfile = 0.5\n'
    )
    (folder / "roster.csv").write_text(ROSTER)
    ended = CliRunner().invoke(
        app,
        f"check --class {folder}/in --out {folder}/out --roster {folder}/roster.csv --scenario prior "
        "--scenario one-beam --timeout 60 --gradescope results.json --junit junit.xml".split(),
    )  # fmt: skip
    assert ended.exit_code == 1, ended.output
    flat = ended.output.replace("\n", "")
    assert f"rules: {folder}/in/class.toml" in flat
    assert "not in the roster: guest" in ended.output
    return folder / "out"


def test_moodle(course: Path) -> None:
    with (course / "moodle.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["Student"] for row in rows] == ["One, Some", "Two"]
    assert [row["Grid"] for row in rows] == ["1.5", "1.5"]
    assert rows[0]["Feedback"] == "identical"
    assert rows[1]["Feedback"].startswith("prior, noise-free: ")
    assert rows[1]["Feedback"].endswith("(mistake: prior-not-subtracted)")
    assert "submission" not in rows[0]


def test_canvas(course: Path) -> None:
    with (course / "canvas.csv").open(newline="") as file:
        rows = list(csv.reader(file))
    assert rows == [
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Grid"],
        ["    Points Possible", "", "", "", "", "1.5"],
        ["One, Some", "", "", "one", "", "1.5"],
        ["Two", "", "", "two", "", "1.5"],
    ]


def test_each_has_its_own_files(course: Path) -> None:
    place = course / "submissions" / "prior"
    results = json.loads((place / "results.json").read_text())
    assert results["score"] == 1.5
    suite = ElementTree.parse(place / "junit.xml").getroot()
    assert int(suite.attrib["failures"]) == 1
    assert (place / "feedback.txt").read_text().startswith("1.5 of 1.5 points")


def test_mistakes_are_counted(course: Path) -> None:
    with (course / "mistakes.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["count"], row["of"]) for row in rows] == [("1", "3")]
    assert rows[0]["submissions"] == "prior"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("name\nx\n", ":1: there is no column submission"),
        ("submission,a,a\n", ":1: two columns have one name"),
        ("submission,a\nx\n", ":2: not as many columns"),
        ("submission,a\nx,1\ny,1,2\n", ":3: not as many columns"),
    ],
)
def test_a_roster_that_cannot_be_used(
    tmp_path: Path, text: str, said: str
) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(text)
    with pytest.raises(RosterError) as error:
        read_roster(file)
    assert str(error.value).startswith(f"{file}{said}")
