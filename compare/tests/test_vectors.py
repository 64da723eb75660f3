"""The shared vectors: every port's probe gives the results that stand in scenarios/vectors."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.probing import ProbeError, run_probe
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.suite.vectors import RESULTS, read_vectors

from .conftest import JOBS, PORTS, ROOT

FOLDER = ROOT / "scenarios" / "vectors"


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
