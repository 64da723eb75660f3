"""What the tests of the ports' functions share: every port's probe, asked once for all of a module's tests."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.probing import ProbeError, run_probe
from occgrid_parity.processes.pool import side_by_side

from .conftest import JOBS

Answers = dict[tuple[str, str], list[str] | ProbeError]
"""By the name of the port and that of the function."""


def ask_ports(
    ports: Sequence[Port], questions: Mapping[str, list[str]], folder: Path
) -> Answers:
    """What each port answers to the questions of each function; the slowest port is asked first."""
    slowest_first = sorted(ports, key=lambda port: -port.timeout)
    work = [(port, name) for port in slowest_first for name in questions]

    def ask(item: tuple[Port, str], stop: object) -> list[str] | ProbeError:
        port, function = item
        try:
            return run_probe(port, function, questions[function], folder)
        except ProbeError as error:
            return error

    found = side_by_side(ask, work, JOBS)
    return {(p.name, f): a for (p, f), a in zip(work, found, strict=True)}


def answered(answers: Answers, port: str, function: str) -> list[str]:
    """A port's answers; fails the test where there are none."""
    found = answers[port, function]
    if isinstance(found, ProbeError):
        pytest.fail(str(found), pytrace=False)
    return found
