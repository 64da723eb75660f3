"""The shared vectors: every port's probe gives the results that stand in scenarios/vectors."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.suite.vectors import RESULTS, read_vectors

from .conftest import PORTS, ROOT
from .probe_answers import Answers, answered, ask_ports

FOLDER = ROOT / "scenarios" / "vectors"


@pytest.fixture(scope="session")
def answers(
    ready: list[Port], tmp_path_factory: pytest.TempPathFactory
) -> Answers:
    """What each port's probe answers to the questions of each file."""
    questions = {name: read_vectors(name).questions for name in RESULTS}
    return ask_ports(ready, questions, tmp_path_factory.mktemp("vectors"))


@pytest.mark.parametrize("function", RESULTS)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_gives_the_results_of_the_vectors(
    answers: Answers,
    need: Callable[[str], Port],
    port: str,
    function: str,
) -> None:
    need(port)
    found = answered(answers, port, function)
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
