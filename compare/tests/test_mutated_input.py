"""Random faults: every port answers as the Python port does, with the same error or the same map.

What an error must be is tested with scenarios/bad; here the ports are held together where nobody chose the fault.
Every file is a process for each port, so each is given a part of the files, and all of them where the environment has
PARITY_ALL_CASES=1.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.pool import side_by_side

from .bad_files import Answer, give
from .conftest import JOBS, PORTS
from .mutations import mutant

COUNT = 300
PART = 80
PARTS = {"matlab": 50, "mathematica": 30}
ERROR = re.compile(rb"[^\n]+\.log:\d+: [\x20-\x7e]+\n")


def count_for(port: str) -> int:
    """How many of the files the port is given."""
    if os.environ.get("PARITY_ALL_CASES", "") not in ("", "0"):
        return COUNT
    return PARTS.get(port, PART)


def give_all(port: Port, files: list[Path], folder: Path) -> list[Answer]:
    """The port's answers to the files, some of them at a time."""

    def answer(file: Path, stop: object) -> Answer:
        return give(port, file, folder / port.name / file.stem)

    return side_by_side(answer, files, JOBS)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the files and the answers are."""
    return tmp_path_factory.mktemp("mutated")


@pytest.fixture(scope="module")
def files(folder: Path) -> list[Path]:
    """The scenarios with faults."""
    found = [folder / f"mutant-{seed}.log" for seed in range(COUNT)]
    for seed, file in enumerate(found):
        file.write_bytes(mutant(seed))
    return found


@pytest.fixture(scope="module")
def reference(
    need: Callable[[str], Port], files: list[Path], folder: Path
) -> list[Answer]:
    """What the Python port answers."""
    return give_all(need("python"), files, folder)


def outcome(answer: Answer) -> tuple[int | None, bytes, dict[str, bytes]]:
    """What ports must agree in: the decimals of NAME.logodds are a port's own."""
    maps = {
        name: data
        for name, data in answer.maps.items()
        if not name.endswith(".logodds")
    }
    return answer.finished.exit_status, answer.stderr, maps


@pytest.mark.parametrize(
    "port", [port.name for port in PORTS if port.name != "python"]
)
def test_answers_as_the_python_port(
    reference: list[Answer],
    files: list[Path],
    folder: Path,
    need: Callable[[str], Port],
    port: str,
) -> None:
    part = files[: count_for(port)]
    found = give_all(need(port), part, folder)
    differ = []
    for file, right, answer in zip(part, reference, found, strict=False):
        assert answer.stdout == b""
        if outcome(answer) != outcome(right):
            differ.append(
                f"{file}: {answer.finished.exit_status} {answer.stderr!r}, "
                f"Python {right.finished.exit_status} {right.stderr!r}"
            )
    if differ:
        count = f"{port}: {len(differ)} of {len(part)} differ"
        pytest.fail("\n".join([count, *differ[:10]]), pytrace=False)


def test_most_files_are_refused_in_many_ways(reference: list[Answer]) -> None:
    """The Python port ends every run as it should, and the faults are of all kinds."""
    reasons = set()
    for answer in reference:
        if answer.finished.exit_status == 0:
            assert answer.stderr == b"" and len(answer.maps) == 3
        else:
            assert answer.finished.exit_status == 1
            assert ERROR.fullmatch(answer.stderr) and not answer.maps
            reason = answer.stderr.split(b": ", 1)[1]
            reasons.add(re.sub(rb"'[^ ]*'|\d+", b"", reason))
    refused = sum(a.finished.exit_status == 1 for a in reference)
    assert COUNT * 0.6 < refused < COUNT
    assert len(reasons) > 40


def test_every_part_has_faults_of_many_kinds(reference: list[Answer]) -> None:
    for count in PARTS.values():
        said = {a.stderr.split(b": ", 1)[-1] for a in reference[:count]}
        assert len(said) > count / 3


def test_the_files_are_the_same_in_every_run() -> None:
    assert [mutant(seed) for seed in range(COUNT)] == [
        mutant(seed) for seed in range(COUNT)
    ]
    assert len({mutant(seed) for seed in range(COUNT)}) > COUNT * 0.9
