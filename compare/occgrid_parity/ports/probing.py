"""Runs a port's probe, the small test program that CONTRIBUTING.md describes."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from pathlib import Path

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import run_process

FUNCTIONS = (
    "sin",
    "cos",
    "exp",
    "log",
    "philox",
    "normal_deviate",
    "logit",
    "sigmoid",
    "world_to_grid",
    "update_cell",
    "bresenham",
    "clip_ray",
    "flaser_angles",
    "read_ranges",
    "beam_endpoints",
    "pixel",
)


class ProbeError(ValueError):
    """A probe that did not answer as many lines as it was asked."""


def run_probe(
    port: Port,
    function: str,
    questions: Sequence[str],
    folder: Path,
    stop: threading.Event | None = None,
) -> list[str]:
    """The probe's answer to each question; its files are left in ``folder``.

    A port with ``probe_lines`` is asked, and answers, so many at the most. Raises
    ProbeError where the port has no probe, where it fails and where answers are missing.
    """
    if not port.probe:
        raise ProbeError(f"{port.name}: port.toml has no probe")
    asked = questions[: port.probe_lines]
    stem = f"{port.name}.{function}"
    question_file = folder / f"{stem}.input"
    answer_file = folder / f"{stem}.output"
    text = "".join(f"{line}\n" for line in asked)
    question_file.write_text(text, encoding="ascii", newline="\n")
    command = port.command(
        port.probe, function=function, input=question_file, output=answer_file
    )
    finished = run_process(
        command,
        cwd=port.folder,
        stdout=folder / f"{stem}.stdout",
        stderr=folder / f"{stem}.stderr",
        time_limit=port.timeout,
        stop=stop,
    )
    if not finished.succeeded:
        raise ProbeError(
            f"{port.name}: probe {function}: {finished.failure()}"
        )
    if not answer_file.is_file():
        raise ProbeError(f"{port.name}: probe {function}: no output")
    answers = answer_file.read_text(encoding="ascii").splitlines()
    if len(answers) != len(asked):
        raise ProbeError(
            f"{port.name}: probe {function}: {len(answers)} answers to {len(asked)} "
            "questions"
        )
    return answers
