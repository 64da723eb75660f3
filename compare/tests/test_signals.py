"""SIGINT and SIGTERM end a run with the status that the system gives to that, and leave no temporary file."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import search_path

from .port_runs import command_line, each_port, files

SIGNALS = [signal.SIGINT, signal.SIGTERM]
GRID = """WALL 1 1 1 4
PARAM occgrid_width 300
PARAM occgrid_height 300
PARAM occgrid_resolution 0.1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 3
POSE 0 2 0
"""
MOMENTS = [0.02, 0.06, 0.1, 0.14, 0.18, 0.25]
"""Seconds after the start; Octave is up after about 0.2 s."""
SCENARIOS = 200
"""More than any port maps before the signal comes: a port that ends before it fails the test."""


def start(
    port: Port, folder: Path, number: signal.Signals, *arguments: str
) -> subprocess.Popen[bytes]:
    """A run that does not ignore the signal, even where these tests do, as in a shell's background."""
    before = signal.signal(number, signal.SIG_DFL)
    try:
        return subprocess.Popen(
            command_line(port, *arguments),
            cwd=folder,
            env={**os.environ, "PATH": search_path()},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
    finally:
        signal.signal(number, before)


def temporary(folder: Path) -> list[str]:
    return [f for f in files(folder) if f.startswith(".occgrid-")]


def check_end(
    port: Port,
    process: subprocess.Popen[bytes],
    number: signal.Signals,
    *others: int,
) -> None:
    """By the signal, as a shell says that (Java's virtual machine ends by itself), or with another status."""
    try:
        status = process.wait(timeout=120)
    finally:
        # the interpreter, too, if the port's shell script has left it behind
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    assert status in (-number, 128 + number, *others), (
        f"{port.name}: status {status}"
    )


@each_port
@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_while_files_are_written(
    need: Callable[[str], Port],
    tmp_path: Path,
    number: signal.Signals,
    name: str,
) -> None:
    port = need(name)
    scenarios = [f"s{i}.log" for i in range(SCENARIOS)]
    for file in scenarios:
        (tmp_path / file).write_text(GRID)
    before = files(tmp_path)
    out = tmp_path / "o"
    out.mkdir()
    process = start(port, tmp_path, number, "--out", "o", *scenarios)
    until = time.monotonic() + port.timeout
    while not temporary(out) and time.monotonic() < until:
        assert process.poll() is None, "the run has ended"
        time.sleep(0.001)
    assert temporary(out), "no temporary file has been seen"
    process.send_signal(number)
    check_end(port, process, number)
    assert temporary(out) == []
    assert len(files(out)) < 3 * SCENARIOS
    assert files(tmp_path) == sorted([*before, "o"])


@each_port
@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_at_the_start(
    need: Callable[[str], Port],
    tmp_path: Path,
    number: signal.Signals,
    name: str,
) -> None:
    """Within some tenths of a second: some languages are not up by then."""
    port = need(name)
    head, pose = GRID.rsplit("\n", 2)[:2]
    lines = [head, "PARAM occgrid_beams 2000", *[pose] * 3000, ""]
    (tmp_path / "long.log").write_text("\n".join(lines))
    for seconds in MOMENTS:
        process = start(
            port, tmp_path, number, "--plain", "--out", "o", "long.log"
        )
        time.sleep(seconds)
        process.send_signal(number)
        # while Python itself starts, it ends with 1
        starting = [1] if (name, number) == ("python", signal.SIGINT) else []
        check_end(port, process, number, *starting)
        assert files(tmp_path) == ["long.log"], f"after {seconds} s"
