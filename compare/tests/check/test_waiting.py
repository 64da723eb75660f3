"""Programs that wait keep no processor from others, and time in which others have the processor does not count."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import psutil
import pytest

from occgrid_parity.processes import own_time, turns
from occgrid_parity.processes.limits import Limits, run_limited
from occgrid_parity.processes.own_time import OwnTime
from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.process_tree import descendants_quickly
from occgrid_parity.processes.turns import Turns, at_most

linux_only = pytest.mark.skipif(
    sys.platform != "linux",
    reason="only Linux says how long a thread has waited for a processor",
)

NEEDS = 0.7  # seconds of a processor
PINNED = f"import os, time; os.sched_setaffinity(0, [{{cpu}}])\nwhile time.process_time() < {NEEDS}: pass"
RIVAL = "import os; os.sched_setaffinity(0, [{cpu}]); open('{file}', 'w').close()\nwhile True: pass"


@contextlib.contextmanager
def running(*codes: str) -> Iterator[list[int]]:
    """Python programs that run meanwhile, by their numbers."""
    with contextlib.ExitStack() as stack:
        pids = []
        for code in codes:
            # Linux may share the processor out among sessions first
            process = stack.enter_context(
                subprocess.Popen(
                    [sys.executable, "-c", code], start_new_session=True
                )
            )
            stack.callback(process.kill)
            pids.append(process.pid)
        yield pids


@linux_only
def test_a_program_is_not_ended_for_the_time_that_others_take(
    tmp_path: Path,
) -> None:
    """With eight others on its only processor it takes nine times as long as it needs, far longer than its limit."""
    cpu = min(os.sched_getaffinity(0))
    out = tmp_path / "out"
    out.mkdir()
    files = [tmp_path / f"rival-{number}" for number in range(8)]
    with running(*[RIVAL.format(cpu=cpu, file=file) for file in files]):
        while not all(file.exists() for file in files):
            time.sleep(0.02)
        ended = run_limited(
            [sys.executable, "-c", PINNED.format(cpu=cpu)],
            cwd=out,
            folder=tmp_path / "run",
            watch=out,
            limits=Limits(seconds=3 * NEEDS),
        )
    assert (ended.word, ended.message) == ("", "")
    assert ended.seconds > 3 * NEEDS


def test_a_program_that_never_ends_has_its_limit(tmp_path: Path) -> None:
    for code in ("while True: pass", "import time; time.sleep(1000)"):
        ended = run_limited(
            [sys.executable, "-c", code],
            cwd=tmp_path,
            folder=tmp_path / "run",
            watch=tmp_path / "out",
            limits=Limits(seconds=0.5),
        )
        assert ended.word == "hang"


def test_own_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the longest wait of a thread takes, but never more than nine tenths."""
    now = 100.0
    waited: dict[str, float] = {}
    clock = SimpleNamespace(monotonic=lambda: now)
    monkeypatch.setattr(own_time, "time", clock)
    monkeypatch.setattr(
        own_time,
        "thread_times",
        lambda pids: [(task, 0, int(s * 1e9)) for task, s in waited.items()],
    )
    mine = OwnTime()
    now, waited = 101.0, {"1": 0.5, "2": 0.25}
    assert mine.seconds == pytest.approx(1.0)
    mine.look([])
    assert mine.seconds == pytest.approx(0.5)
    now, waited = 102.0, {"1": 0.5, "2": 0.5}
    mine.look([])
    assert mine.seconds == pytest.approx(0.5 + 0.75)
    now, waited = 103.0, {"1": 0.5, "2": 0.5, "3": 7.0}
    mine.look([])
    assert mine.seconds == pytest.approx(0.5 + 0.75 + 0.1)


def test_threads_that_wait_for_each_other(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Four threads that have both processors all the time: each waits half of it, and all of it counts."""
    now = 100.0
    second = 10**9
    clock = SimpleNamespace(monotonic=lambda: now)
    monkeypatch.setattr(own_time, "time", clock)
    monkeypatch.setattr(own_time, "PROCESSORS", 2)
    times = [(task, second // 2, second // 2) for task in "1234"]
    monkeypatch.setattr(own_time, "thread_times", lambda pids: times)
    mine = OwnTime()
    now = 101.0
    mine.look([])
    assert mine.seconds == pytest.approx(1.0)


FORKS = (
    "import os\nwhile True:\n    if os.fork() == 0: os._exit(0)\n    os.wait()"
)


@linux_only
def test_processes_that_end_while_they_are_looked_at() -> None:
    with running(FORKS, FORKS) as pids:
        own = psutil.Process()
        deadline = time.monotonic() + 3
        while time.monotonic() < deadline:
            found = {one.pid for one in descendants_quickly(own)}
            assert set(pids) <= found
            list(own_time.thread_times(found))


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """A process is idle after a second.

    Linux counts a wait for a processor when it is over, so a sample must be longer than any such wait.
    """
    monkeypatch.setattr(turns, "IDLE", 1.0)
    monkeypatch.setattr(turns, "SAMPLE", 0.5)
    monkeypatch.setattr(turns, "LOOK", 0.05)


def has_turn_within(seconds: float, some: Turns) -> bool:
    """Whether another piece of work gets its turn, for a moment."""
    begun, stop = threading.Event(), threading.Event()

    def one() -> None:
        with contextlib.suppress(Stopped), some.turn(stop):
            begun.set()

    thread = threading.Thread(target=one)
    thread.start()
    found = begun.wait(seconds)
    stop.set()
    thread.join()
    return found


NEVER = threading.Event()


@contextlib.contextmanager
def turns_for(*codes: str) -> Iterator[tuple[Turns, list[int]]]:
    """Turns for one piece of work at a time, where these programs are those at work; and their numbers."""
    with running(*codes) as pids:
        yield Turns(1, lambda: pids), pids


@linux_only
@pytest.mark.usefixtures("quick")
def test_others_begin_while_one_waits() -> None:
    with turns_for("import time; time.sleep(1000)") as (some, _):
        with some.turn(NEVER):
            assert has_turn_within(120, some)
            with some.turn(NEVER):  # the one that waits has lent its place
                assert not has_turn_within(3, some)
        assert some.taken == 0


@pytest.mark.usefixtures("quick")
def test_nobody_else_begins_while_all_work() -> None:
    with turns_for("while True: pass") as (some, _):
        with some.turn(NEVER):
            assert not has_turn_within(4, some)
        assert has_turn_within(120, some)


@linux_only
@pytest.mark.usefixtures("quick")
def test_what_a_process_has_started_works_for_it() -> None:
    """A shell that waits for a program is not idle while that works."""
    code = "import subprocess, sys; subprocess.run([sys.executable, '-c', 'while True: pass'])"
    with turns_for(code) as (some, pids):
        with some.turn(NEVER):
            assert not has_turn_within(4, some)
        for child in turns._tree(pids[0])[1:]:
            os.kill(child, 9)


@linux_only
@pytest.mark.usefixtures("quick")
def test_there_is_an_end_to_lending() -> None:
    most = at_most(1)
    sleepers = ["import time; time.sleep(1000)"] * (most + 2)
    with turns_for(*sleepers) as (some, _):
        with contextlib.ExitStack() as stack:
            for _ in range(most):
                assert has_turn_within(120, some)
                stack.enter_context(some.turn(NEVER))
            assert not has_turn_within(3, some)
