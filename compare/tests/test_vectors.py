"""The shared vectors: every port's probe gives the results that stand in scenarios/vectors."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from parity.pool import side_by_side
from parity.ports import Port
from parity.probing import ProbeError, run_probe

from .conftest import JOBS, PORTS, ROOT

FOLDER = ROOT / "scenarios" / "vectors"

# the last columns of each file, which are results; those before are arguments
RESULTS = {
    "beam_endpoints": ["ex", "ey"],
    "bresenham": ["cells"],
    "clip_ray": ["first", "last"],
    "cos": ["y"],
    "exp": ["y"],
    "flaser_angles": ["angle"],
    "log": ["y"],
    "logit": ["log_odds"],
    "normal_deviate": ["deviate"],
    "philox": ["w0", "w1", "w2", "w3"],
    "pixel": ["pixel"],
    "read_ranges": ["z", "hit", "used"],
    "sigmoid": ["p"],
    "sin": ["y"],
    "update_cell": ["log_odds"],
    "world_to_grid": ["gx", "gy"],
}


class Vectors(NamedTuple):
    """What a file holds, as the probe is asked and answers."""

    arguments: list[str]  # the columns' names
    questions: list[str]
    answers: list[str]


def read_vectors(function: str, folder: Path = FOLDER) -> Vectors:
    """The file of a function. Raises ValueError where a line does not fit its columns."""
    lines = (folder / f"{function}.csv").read_text("ascii").splitlines()
    columns, *rows = [line.split(",") for line in lines]
    results = len(RESULTS[function])
    if columns[-results:] != RESULTS[function]:
        raise ValueError(f"{function}.csv: {columns}")
    for number, row in enumerate(rows, start=2):
        if len(row) != len(columns) or not all(row):
            raise ValueError(f"{function}.csv:{number}: {row}")
    return Vectors(
        columns[:-results],
        [" ".join(row[:-results]) for row in rows],
        [" ".join(row[-results:]) for row in rows],
    )


@pytest.fixture(scope="session")
def answers(
    ready: list[Port], tmp_path_factory: pytest.TempPathFactory
) -> dict[tuple[str, str], list[str] | ProbeError]:
    """What each port's probe answers to the questions of each file."""
    folder = tmp_path_factory.mktemp("vectors")
    work = [(port, function) for port in ready for function in RESULTS]

    def ask(item: tuple[Port, str], stop: object) -> list[str] | ProbeError:
        port, function = item
        try:
            questions = read_vectors(function).questions
            return run_probe(port, function, questions, folder)
        except ProbeError as error:
            return error

    found = side_by_side(ask, work, JOBS)
    return {(p.name, f): a for (p, f), a in zip(work, found, strict=True)}


@pytest.mark.parametrize("function", RESULTS)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_gives_the_results_of_the_vectors(
    answers: dict[tuple[str, str], list[str] | ProbeError],
    need: Callable[[str], Port],
    port: str,
    function: str,
) -> None:
    need(port)
    found = answers[port, function]
    if isinstance(found, ProbeError):
        pytest.fail(str(found), pytrace=False)
    vectors = read_vectors(function)
    wrong = [
        f"{function}({question}) is {right}, not {answer}"
        for question, right, answer in zip(
            vectors.questions, vectors.answers, found, strict=True
        )
        if answer != right
    ]
    if wrong:
        count = f"{port}: {len(wrong)} of {len(found)} wrong"
        pytest.fail("\n".join([count, *wrong[:5]]), pytrace=False)


def test_every_file_is_put_to_the_ports() -> None:
    assert sorted(path.stem for path in FOLDER.glob("*.csv")) == list(RESULTS)


@pytest.mark.parametrize("function", RESULTS)
def test_no_question_is_asked_twice(function: str) -> None:
    questions = read_vectors(function).questions
    assert len(questions) > 150
    assert len(set(questions)) == len(questions)
