"""A command is held to its limits, and nothing of it is left."""

from __future__ import annotations

import os
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from occgrid_parity.processes import process_group
from occgrid_parity.processes.process_group import (
    Finished,
    Stopped,
    run_process,
)


def run_python(
    folder: Path,
    code: str,
    time_limit: float = 100,
    capture_limit: int = 1000,
    stop: threading.Event | None = None,
) -> Finished:
    return run_process(
        [sys.executable, "-c", code],
        cwd=folder,
        stdout=folder / "stdout",
        stderr=folder / "stderr",
        time_limit=time_limit,
        capture_limit=capture_limit,
        stop=stop,
    )


def says_pid(folder: Path) -> bool:
    """Whether the command has written its file ``pid``: it has come so far."""
    file = folder / "pid"
    return file.is_file() and file.read_text() != ""


@pytest.fixture
def time_is_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A clock that stands still until the command says its pid, and then is past every limit."""

    def now() -> float:
        return 1000.0 if says_pid(tmp_path) else 0.0

    monkeypatch.setattr(process_group, "time", SimpleNamespace(monotonic=now))


def is_gone(pid: int) -> bool:
    """Whether the process ends within a minute: signals need a moment."""
    for _ in range(3000):
        try:
            stat = Path(f"/proc/{pid}/stat").read_text()
        except OSError:
            return True
        if stat.rsplit(")", 1)[1].split()[0] == "Z":
            return True
        time.sleep(0.02)
    return False


def test_captures_both_streams_and_the_status(tmp_path: Path) -> None:
    code = (
        "import sys; print('out'); print('why', file=sys.stderr); sys.exit(3)"
    )
    finished = run_python(tmp_path, code)
    assert (finished.exit_status, finished.timed_out) == (3, False)
    assert not finished.succeeded
    assert finished.stdout.read_text() == "out\n"
    assert finished.stderr.read_text() == "why\n"
    assert finished.failure() == "exit status 3: why"


def test_cuts_off_what_is_too_much_and_lets_the_command_end(
    tmp_path: Path,
) -> None:
    code = "import sys; sys.stdout.write('x' * 3_000_000); sys.stderr.write('y' * 999)"
    finished = run_python(tmp_path, code, capture_limit=1000)
    assert finished.succeeded
    assert finished.stdout.read_bytes() == b"x" * 1000
    assert finished.stderr.read_bytes() == b"y" * 999


@pytest.mark.usefixtures("time_is_up")
def test_kills_a_command_that_hangs_and_the_processes_it_started(
    tmp_path: Path,
) -> None:
    code = (
        "import subprocess, sys, time\n"
        "child = subprocess.Popen(['sleep', '1000'])\n"
        "open('pid', 'w').write(str(child.pid))\n"
        "time.sleep(1000)"
    )
    finished = run_python(tmp_path, code)
    assert finished.timed_out
    assert finished.exit_status is None
    assert finished.failure() == "no end after 100 s, killed"
    assert is_gone(int((tmp_path / "pid").read_text()))


@pytest.mark.usefixtures("time_is_up")
def test_kills_a_command_that_does_not_listen_to_sigterm(
    tmp_path: Path,
) -> None:
    code = (
        "import os, signal, time\n"
        "signal.signal(signal.SIGTERM, signal.SIG_IGN)\n"
        "open('pid', 'w').write(str(os.getpid()))\n"
        "while True: time.sleep(1)"
    )
    finished = run_python(tmp_path, code)
    assert finished.timed_out
    assert is_gone(int((tmp_path / "pid").read_text()))


def test_a_clock_ends_a_command_that_hangs(tmp_path: Path) -> None:
    finished = run_python(tmp_path, "import time; time.sleep(1000)", 0.5)
    assert finished.timed_out
    assert 0.5 <= finished.seconds < 500


def test_kills_what_a_command_leaves_behind(tmp_path: Path) -> None:
    code = (
        "import subprocess\n"
        "child = subprocess.Popen(['sleep', '1000'])\n"
        "open('pid', 'w').write(str(child.pid))"
    )
    started = time.monotonic()
    finished = run_python(tmp_path, code)
    assert finished.succeeded
    assert time.monotonic() - started < 500
    assert is_gone(int((tmp_path / "pid").read_text()))


def test_says_which_signal_ended_a_command(tmp_path: Path) -> None:
    finished = run_python(tmp_path, "import os; os.kill(os.getpid(), 11)")
    assert finished.failure() == "killed by SIGSEGV, nothing on standard error"


def test_says_what_cannot_be_started(tmp_path: Path) -> None:
    finished = run_process(
        [str(tmp_path / "nowhere")],
        cwd=tmp_path,
        stdout=tmp_path / "stdout",
        stderr=tmp_path / "stderr",
        time_limit=100,
    )
    reason = (
        f"cannot be started: {tmp_path}/nowhere: No such file or directory"
    )
    assert finished.failure() == reason
    assert not finished.succeeded


def test_reads_nothing_from_the_terminal(tmp_path: Path) -> None:
    finished = run_python(tmp_path, "print(len(input()))")
    assert not finished.timed_out
    assert "EOFError" in finished.stderr.read_text()


def test_stops_when_it_is_told_to(tmp_path: Path) -> None:
    stop = threading.Event()

    def set_when_it_runs() -> None:
        while not says_pid(tmp_path):
            time.sleep(0.02)
        stop.set()

    threading.Thread(target=set_when_it_runs, daemon=True).start()
    code = "import os, time; open('pid', 'w').write(str(os.getpid())); time.sleep(1000)"
    with pytest.raises(Stopped):
        run_python(tmp_path, code, stop=stop)
    assert is_gone(int((tmp_path / "pid").read_text()))


def test_finds_what_is_installed_beside_its_own_python(tmp_path: Path) -> None:
    finished = run_python(tmp_path, "import os; print(os.environ['PATH'])")
    first = finished.stdout.read_text().split(os.pathsep)[0]
    assert first == str(Path(sys.executable).parent)
