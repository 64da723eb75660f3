"""scenarios/vectors and scenarios/bad: they are what their generators write, and they leave nothing out."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

import pytest

from occgrid_parity.processes.process_group import run_process
from occgrid_parity.suite.vectors import read_vectors

from .bad_files import BAD, bad_files
from .conftest import ROOT, unavailable
from .test_vectors import FOLDER as VECTORS

# what the tables of SPEC section 8 write in capitals, and what may stand there
PLACEHOLDERS = {
    "KEYWORD": r"[A-Z0-9]+",
    "NAME": r"\S+",
    "FIELD": r"[a-z0-9_ ]+",
    "TOKEN": r"\S+",
    "LOW": r"\S+",
    "HIGH": r"\S+",
    "N": r"\d+",
    "K": r"\d+",
    "M": r"\d+",
    "V": r"\d+",
}


@pytest.mark.parametrize("folder", [VECTORS, BAD], ids=lambda f: f.name)
def test_is_what_its_generator_writes(folder: Path, tmp_path: Path) -> None:
    if folder == VECTORS and shutil.which("javac") is None:
        unavailable("the vectors are made with a JDK")
    made = tmp_path / "made"
    made.mkdir()
    finished = run_process(
        [sys.executable, str(folder / "generate.py"), str(made)],
        cwd=ROOT,
        stdout=tmp_path / "stdout",
        stderr=tmp_path / "stderr",
        time_limit=300,
    )
    assert finished.succeeded, finished.failure()
    kept = {
        path.name: path.read_bytes()
        for pattern in ("*.csv", "*.log", "*.txt")
        for path in folder.glob(pattern)
    }
    assert {path.name for path in made.iterdir()} == set(kept)
    for path in made.iterdir():
        assert path.read_bytes() == kept[path.name], path.name


def reasons_of_the_contract() -> list[str]:
    """The first column of the table of SPEC section 8."""
    text = (ROOT / "SPEC.md").read_text(encoding="utf-8")
    section = text.split("\n## 8. Errors\n")[1].split("\n## 9.")[0]
    return re.findall(r"^\| `([^`]+)` \|", section, flags=re.MULTILINE)


@pytest.mark.parametrize("reason", reasons_of_the_contract())
def test_every_row_of_the_contract_has_a_file(reason: str) -> None:
    if reason == "cannot be read":
        return  # about files that are not there: test_bad_input.py
    words = re.split(r"([A-Z0-9]*[A-Z][A-Z0-9]*)", reason)
    pattern = "".join(
        PLACEHOLDERS.get(word, re.escape(word)) for word in words
    )
    assert any(
        re.fullmatch(pattern, expected) for _, _, expected in bad_files()
    )


def test_the_table_of_reasons_is_found() -> None:
    assert len(reasons_of_the_contract()) == 24


def test_there_are_enough_bad_files_and_they_are_small() -> None:
    files = [file for file, _, _ in bad_files()]
    assert len(files) >= 300
    assert {file.name for file in files} == {f.name for f in BAD.glob("*.log")}
    assert max(file.stat().st_size for file in files) < 2000


@pytest.mark.parametrize(
    ("function", "question", "answer"),
    [
        ("bresenham", "2 5 4 4", "2:5 3:5 4:4"),
        ("clip_ray", "-10 2 20 3 8 5", "10 17"),
        ("clip_ray", "-5 0 5 -10 8 5", "0 -1"),
        ("flaser_angles", "1 0", "bff921fb54442d18"),
        ("sin", "0000000000000000", "0000000000000000"),
        ("sin", "8000000000000000", "8000000000000000"),
        ("exp", "0000000000000000", "3ff0000000000000"),
        ("log", "0000000000000000", "fff0000000000000"),
        ("logit", "3fe0000000000000", "0000000000000000"),
        ("sigmoid", "0000000000000000", "3fe0000000000000"),
        ("pixel", "0000000000000000", "128"),
        ("philox", " ".join(6 * ["00000000"]), "6627e8d5 e169c58d bc57ac4c 9b00dbd8"),
        ("read_ranges", "7ff8000000000000 4024000000000000 free", "4024000000000000 0 0"),
        ("read_ranges", "7ff0000000000000 4024000000000000 free", "4024000000000000 0 1"),
        ("read_ranges", "7ff0000000000000 4024000000000000 ignore", "4024000000000000 0 0"),
        ("read_ranges", "4014000000000000 4024000000000000 ignore", "4014000000000000 1 1"),
    ],
)  # fmt: skip
def test_a_result_known_by_hand(
    function: str, question: str, answer: str
) -> None:
    vectors = read_vectors(function)
    assert vectors.answers[vectors.questions.index(question)] == answer


def test_the_lines_go_everywhere() -> None:
    """All octants, axes and diagonals, with ties, and cells beyond 32 bits."""
    directions, ties, far = set(), 0, 0
    for question in read_vectors("bresenham").questions:
        gx0, gy0, gx1, gy1 = map(int, question.split())
        dx, dy = gx1 - gx0, gy1 - gy0
        signs = ((dx > 0) - (dx < 0), (dy > 0) - (dy < 0))
        steeper = (abs(dx) > abs(dy)) - (abs(dx) < abs(dy))
        directions.add((*signs, steeper))
        ties += max(abs(dx), abs(dy)) == 2 * min(abs(dx), abs(dy)) > 0
        far += abs(gx0) > 2**31
    assert len(directions) == 8 + 4 + 4 + 1
    assert ties >= 16
    assert far >= 4


def test_the_clipped_lines_meet_the_grid_in_every_way() -> None:
    vectors = read_vectors("clip_ray")
    kinds, longest = set(), 0
    for question, answer in zip(
        vectors.questions, vectors.answers, strict=True
    ):
        gx0, gy0, gx1, gy1, _, _ = map(int, question.split())
        first, last = map(int, answer.split())
        steps = max(abs(gx1 - gx0), abs(gy1 - gy0))
        longest = max(longest, steps)
        kinds.add((first == 0, last == steps, first > last))
    within, out, into, across = [(a, b, False) for a in (True, False) for b in (True, False)]  # fmt: skip
    assert kinds >= {within, out, into, across, (True, False, True)}
    assert longest == 2**20
