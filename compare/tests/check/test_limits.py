"""Every way to fail has its own word, and nothing of a program is left."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.processes.limits import MEBI, Ended, Limits, run_limited

Run = Callable[..., Ended]


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """``run(code, seconds=.., output=.., memory=.., processes=..)`` runs Python code."""

    def start(
        code: str, command: list[str] | None = None, **limits: float
    ) -> Ended:
        out = tmp_path / "out"
        out.mkdir(exist_ok=True)
        given = Limits(
            limits.get("seconds", 100.0),
            int(limits.get("output", 4 * MEBI)),
            int(limits.get("memory", 512 * MEBI)),
            int(limits.get("processes", 16)),
        )
        return run_limited(
            command or [sys.executable, "-c", code],
            cwd=out, folder=tmp_path / "run", watch=out, limits=given,
        )  # fmt: skip

    return start


def alive(file: Path) -> bool:
    try:
        state = Path(f"/proc/{int(file.read_text())}/stat").read_text()
    except OSError:
        return False
    return state.rpartition(")")[2].split()[0] not in "ZX"


def test_a_command_that_ends_well(run: Run, tmp_path: Path) -> None:
    ended = run("import os; print(os.getcwd()); open('file', 'w').write('x')")
    assert (ended.word, ended.message, ended.left) == ("", "", 0)
    assert ended.stdout.read_text() == f"{tmp_path}/out\n"
    assert (tmp_path / "out" / "file").read_text() == "x"


def test_hang(run: Run) -> None:
    started = time.monotonic()
    ended = run(
        "import signal, time; signal.signal(15, signal.SIG_IGN); time.sleep(1000)",
        seconds=0.5,
    )
    assert (ended.word, ended.message) == ("hang", "no end after 0.5 s; ended")
    assert time.monotonic() - started < 500


def test_crash_by_status(run: Run) -> None:
    ended = run("raise SystemExit('no way')")
    assert (ended.word, ended.message) == ("crash", "exit status 1: no way")


def test_crash_with_a_traceback(run: Run) -> None:
    ended = run("[][3]")
    assert (ended.word, ended.message) == (
        "crash",
        "exit status 1: IndexError: list index out of range",
    )


def test_crash_by_signal(run: Run) -> None:
    ended = run("import os; os.kill(os.getpid(), 11)")
    assert (ended.word, ended.message) == (
        "crash",
        "ended by SIGSEGV, and nothing on standard error",
    )


def test_a_file_that_is_missing(run: Run) -> None:
    ended = run("open('/nowhere/settings.txt')")
    assert ended.word == "missing file"
    assert "/nowhere/settings.txt" in ended.message


def test_a_program_that_is_missing(run: Run, tmp_path: Path) -> None:
    ended = run("", [str(tmp_path / "nothing")])
    assert (ended.word, ended.message) == (
        "not found", f"the program cannot be started: {tmp_path}/nothing: No such file or directory"
    )  # fmt: skip
    assert (
        run("", ["no-such-command"]).message
        == "no-such-command is not a command here"
    )


def test_a_program_that_is_not_executable(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "program"
    file.write_text("#!/bin/sh\n")
    ended = run("", [str(file)])
    assert ended.word == "not executable"
    assert ended.message.endswith("Permission denied")
    file.chmod(0o755)
    assert run("", [str(file)]).word == ""


def test_a_gigabyte_on_standard_output(run: Run) -> None:
    ended = run("import sys\nwhile True: sys.stdout.write('x' * 1000000)")
    assert ended.word == "too much output"
    assert ended.message == "more than 4 MiB were printed or written; ended"
    assert ended.stdout.stat().st_size <= 4 * MEBI


def test_a_gigabyte_by_yes(run: Run) -> None:
    assert run("", ["yes"]).word == "too much output"


def test_many_files_that_are_too_much_together(
    run: Run, tmp_path: Path
) -> None:
    code = "import time\nfor i in range(1000): open(str(i), 'w').write('x' * 1000000); time.sleep(0.1)"
    assert run(code).word == "too much output"
    written = sum(f.stat().st_size for f in (tmp_path / "out").iterdir())
    assert written < 80 * MEBI


def test_too_much_memory(run: Run) -> None:
    # more than the limit, and less than the twofold, which the system refuses at once; written to, or it is not there
    code = (
        "import time\n"
        "x = bytearray(80_000_000)\n"
        "for page in range(0, len(x), 1024): x[page] = 1\n"
        "time.sleep(1000)"
    )
    ended = run(code, memory=64 * MEBI)
    assert (ended.word, ended.message) == (
        "too much memory",
        "more than 64 MiB of memory; ended",
    )


def test_memory_all_at_once_is_refused(run: Run) -> None:
    ended = run("x = bytearray(1 << 40)", memory=64 * MEBI)
    assert ended.word == "crash"
    assert "MemoryError" in ended.message


def test_forks(run: Run, tmp_path: Path) -> None:
    """Processes without end, each in a session of its own."""
    code = (
        "import os, time\n"
        "for _ in range(300):\n"
        "    if os.fork() == 0:\n"
        "        os.setsid(); time.sleep(100); os._exit(0)\n"
        "    time.sleep(0.002)\n"
        "time.sleep(100)\n"
    )
    ended = run(code)
    assert (ended.word, ended.message) == (
        "forks",
        "more than 16 processes at a time; all ended",
    )


@pytest.mark.parametrize(
    "detach", ["", "start_new_session=True", "process_group=0"]
)
def test_what_a_program_leaves_behind_is_ended(
    run: Run, tmp_path: Path, detach: str
) -> None:
    code = (
        "import subprocess, sys\n"
        f"child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(1000)'], {detach})\n"
        "open('pid', 'w').write(str(child.pid))\n"
    )
    ended = run(code)
    assert ended.word == ""
    assert ended.left == 1
    assert not alive(tmp_path / "out" / "pid")


def test_a_grandchild_whose_parent_is_gone_is_ended(
    run: Run, tmp_path: Path
) -> None:
    code = (
        "import os, time\n"
        "if os.fork() == 0:\n"
        "    os.setsid()\n"
        "    if os.fork() == 0:\n"
        "        open('pid', 'w').write(str(os.getpid()))\n"
        "        os.closerange(0, 3)\n"
        "        time.sleep(1000)\n"
        "    os._exit(0)\n"
        "os.wait()\n"
        "while not os.path.exists('pid') or not open('pid').read(): time.sleep(0.02)\n"
    )
    ended = run(code)
    assert (ended.word, ended.left) == ("", 1)
    assert not alive(tmp_path / "out" / "pid")


def test_limits_of_the_harness_itself_stay(run: Run) -> None:
    import resource

    before = [
        resource.getrlimit(kind)
        for kind in (resource.RLIMIT_DATA, resource.RLIMIT_FSIZE)
    ]
    code = (
        "from resource import RLIMIT_CORE, RLIMIT_FSIZE, getrlimit\n"
        "print(getrlimit(RLIMIT_FSIZE)[0], getrlimit(RLIMIT_CORE)[0])"
    )
    assert run(code).stdout.read_text() == f"{4 * MEBI} 0\n"
    assert [
        resource.getrlimit(kind)
        for kind in (resource.RLIMIT_DATA, resource.RLIMIT_FSIZE)
    ] == before
