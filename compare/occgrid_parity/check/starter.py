"""The functions of an exercise: which are missing, and which are wrong in which case.

A starter of the handouts has a ``starter.toml`` beside its port.toml: the number and title of the exercise, a scenario,
and its functions with the shared vectors that try them. The check says this before its levels.
"""

from __future__ import annotations

import re
import struct
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import msgspec

from occgrid_parity.formats.toml_records import (
    Count,
    Table,
    Text,
    read_record,
)
from occgrid_parity.ports.building import build_port
from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.ports.port_file import PortError
from occgrid_parity.ports.probing import ProbeError, run_probe
from occgrid_parity.processes.process_group import run_process
from occgrid_parity.suite.cases import scenario_folder
from occgrid_parity.suite.vectors import FUNCTIONS, read_vectors

STARTER = "starter.toml"
NOT_WRITTEN = re.compile(r"exercise \d+: (\w+) is not written yet")
DOUBLE = re.compile(r"[0-9a-f]{16}")
WIDEST_ANSWER = 160


class StarterFunction(Table, frozen=True):
    """A function of the exercise; without ``vectors`` only whole maps try it."""

    name: Text
    vectors: str = ""

    def __post_init__(self) -> None:
        if self.vectors and self.vectors not in FUNCTIONS:
            raise ValueError(f"there are no vectors {self.vectors}")


class Starter(Table, frozen=True):
    """What a starter.toml says."""

    exercise: Count
    title: Text
    scenario: Text
    functions: Annotated[
        tuple[StarterFunction, ...], msgspec.Meta(min_length=1)
    ]

    def __post_init__(self) -> None:
        if not (scenario_folder() / f"{self.scenario}.log").is_file():
            raise ValueError(f"no scenario is named {self.scenario}")


def read_starter(folder: Path) -> Starter | None:
    """The starter in a folder; None where it is none. Raises PortError where its file cannot be used."""
    path = folder / STARTER
    return read_record(path, Starter, PortError) if path.is_file() else None


def starter_lines(declaration: Path) -> list[str]:
    """What to say about the starter whose port.toml this is; nothing where it is none.

    Builds it first. Raises PortError where one of its files cannot be used.
    """
    starter = read_starter(declaration.parent)
    if starter is None:
        return []
    port = read_port(declaration)
    lines = [f"exercise {starter.exercise}: {starter.title}"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        built = build_port(port, folder)
        if built.problem:
            return [*lines, f"  it does not build: {built.problem}"]
        for function in starter.functions:
            found = _look_at(port, starter, function, folder)
            lines.append(f"  {function.name}: {found}")
    return lines


def _look_at(
    port: Port, starter: Starter, function: StarterFunction, folder: Path
) -> str:
    if not function.vectors:
        return _in_the_program(port, starter, function, folder)
    vectors = read_vectors(function.vectors)
    questions, answers = vectors.questions, vectors.answers
    try:
        found = run_probe(port, function.vectors, questions, folder)
    except ProbeError as error:
        said = folder / f"{port.name}.{function.vectors}.stderr"
        missing = _missing(said)
        if missing == function.name:
            return "not written yet"
        if missing:
            return f"cannot be tried before {missing} is written"
        return f"no answer: {error}"
    wrong = [
        (question, right, answer)
        for question, right, answer in zip(
            questions, answers, found, strict=False
        )
        if right != answer
    ]
    if not wrong:
        return f"right in all {len(found)} cases"
    question, right, answer = wrong[0]
    return (
        f"wrong in {len(wrong)} of {len(found)} cases; the first: "
        f"{function.name}({_short(question, vectors.arguments)}) "
        f"should be {_short(right)}; yours is {_short(answer)}"
    )


def _in_the_program(
    port: Port, starter: Starter, function: StarterFunction, folder: Path
) -> str:
    """Whether a run of the whole program comes to the function and finds it written."""
    scenario = str(scenario_folder() / f"{starter.scenario}.log")
    out = folder / f"out-{function.name}"
    out.mkdir()
    said = folder / f"{function.name}.run.stderr"
    run_process(
        port.command(
            port.run,
            mode=["--noise-free"],
            out=out,
            scenario=scenario,
            scenarios=[scenario],
        ),
        cwd=port.folder,
        stdout=folder / f"{function.name}.run.stdout",
        stderr=said,
        time_limit=port.timeout,
    )
    missing = _missing(said)
    if missing == function.name:
        return "not written yet"
    if missing:
        return f"cannot be tried before {missing} is written"
    return "written; whole maps show whether it is right"


def _missing(said: Path) -> str:
    """The function that a program says is not written, on its standard error; empty where it says so of none."""
    match = NOT_WRITTEN.search(said.read_text("utf-8", "replace"))
    return match[1] if match else ""


def _short(text: str, names: Sequence[str] = ()) -> str:
    """A question, with its arguments' names, or an answer to be read: doubles as decimals, and not too long."""
    words = [
        repr(struct.unpack(">d", bytes.fromhex(word))[0])
        if DOUBLE.fullmatch(word)
        else word
        for word in "".join(
            c if c.isprintable() else "?" for c in text
        ).split()
    ]
    plain = (
        ", ".join(
            f"{name} {word}" for name, word in zip(names, words, strict=True)
        )
        if names
        else " ".join(words)
    )
    return (
        plain
        if len(plain) <= WIDEST_ANSWER
        else plain[: WIDEST_ANSWER - 3] + "..."
    )
