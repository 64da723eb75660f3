"""Runs a command in a process group of its own, within a time and a size limit."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import psutil

from occgrid_parity.processes.process_tree import (
    children_of_ended,
    kill_all,
    kill_tree,
)

CAPTURE_LIMIT = 4 * 2**20
KILL_GRACE = 2.0
DRAIN_GRACE = 0.5
POLL_INTERVAL = 0.02
CHUNK = 2**16


def search_path() -> str:
    """PATH with the folder of the harness's own Python before it.

    So what is installed beside it is found without the environment being active.
    """
    own = str(Path(sys.executable).parent)
    return os.pathsep.join([own, os.environ.get("PATH", os.defpath)])


class Stopped(Exception):
    """The harness was asked to stop while the command ran; its group is killed."""


@dataclass(frozen=True)
class Finished:
    """How a command ended.

    ``exit_status`` is negative for a signal, and None where the command was killed
    for its time limit or could not be started (``start_error`` then says why).
    ``stdout`` and ``stderr`` are the files with the first CAPTURE_LIMIT bytes each.
    """

    command: tuple[str, ...]
    exit_status: int | None
    timed_out: bool
    time_limit: float
    seconds: float
    stdout: Path
    stderr: Path
    start_error: str | None = None

    @property
    def succeeded(self) -> bool:
        """Whether it ended by itself with status 0."""
        return self.exit_status == 0

    def failure(self) -> str:
        """Why it did not succeed, in one line."""
        if self.start_error is not None:
            return f"cannot be started: {self.start_error}"
        if self.timed_out:
            return f"no end after {self.time_limit:g} s, killed"
        status = self.exit_status or 0
        text = (
            f"exit status {status}" if status >= 0 else _signal_text(-status)
        )
        said = first_line(self.stderr)
        return (
            f"{text}: {said}" if said else f"{text}, nothing on standard error"
        )


def first_line(path: Path, limit: int = 300) -> str:
    """The first line of a file that is not blank, shortened; empty without one."""
    with path.open("rb") as file:
        for line in file.read(CHUNK).decode("utf-8", "replace").splitlines():
            if line.strip():
                return line.strip()[:limit]
    return ""


def _signal_text(number: int) -> str:
    try:
        return f"killed by {signal.Signals(number).name}"
    except ValueError:
        return f"killed by signal {number}"


def run_process(
    command: Sequence[str],
    *,
    cwd: Path,
    stdout: Path,
    stderr: Path,
    time_limit: float,
    capture_limit: int = CAPTURE_LIMIT,
    environment: Mapping[str, str] | None = None,
    stop: threading.Event | None = None,
) -> Finished:
    """Runs ``command`` to its end, or kills its whole group after ``time_limit`` s.

    Standard output and error go to the two files, each cut off after
    ``capture_limit`` bytes (what is above is read and dropped, so that the command
    is not held up). ``environment`` is added to the harness's own. Whatever the
    command leaves behind in its group is killed when it ends. Raises Stopped when ``stop`` is set meanwhile.
    """
    started = time.monotonic()
    with stdout.open("wb") as out, stderr.open("wb") as err:
        try:
            process = subprocess.Popen(
                list(command),
                cwd=cwd,
                env={
                    **os.environ,
                    "PATH": search_path(),
                    **(environment or {}),
                },
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                bufsize=0,
                start_new_session=True,
            )
        except (OSError, ValueError) as error:
            reason = (
                error.strerror if isinstance(error, OSError) else str(error)
            )
            return Finished(
                tuple(command), None, False, time_limit, 0.0, stdout, stderr,
                f"{command[0]}: {reason}",
            )  # fmt: skip
        assert process.stdout is not None and process.stderr is not None
        copies = [
            _Copy(process.stdout, out, capture_limit),
            _Copy(process.stderr, err, capture_limit),
        ]
        try:
            timed_out = _wait(process, started + time_limit, stop)
        finally:
            _end_group(process)
            deadline = time.monotonic() + DRAIN_GRACE
            for copy in copies:
                copy.finish(deadline)
    return Finished(
        tuple(command),
        None if timed_out else process.returncode,
        timed_out,
        time_limit,
        time.monotonic() - started,
        stdout,
        stderr,
    )


def _wait(
    process: subprocess.Popen[bytes],
    deadline: float,
    stop: threading.Event | None,
) -> bool:
    """Waits for the end; True where the deadline came first."""
    while True:
        left = deadline - time.monotonic()
        try:
            process.wait(min(max(left, 0.0), POLL_INTERVAL))
            return False
        except subprocess.TimeoutExpired:
            if stop is not None and stop.is_set():
                raise Stopped from None
            if left <= 0:
                return True


def _end_group(process: subprocess.Popen[bytes]) -> None:
    """Ends what is left of the group: SIGTERM, a moment's grace, SIGKILL. On Windows, the tree of processes."""
    if sys.platform == "win32":
        with suppress(psutil.NoSuchProcess):
            kill_tree(psutil.Process(process.pid))
        kill_all(children_of_ended(process.pid))
    else:
        if process.poll() is None:
            _signal_group(process.pid, signal.SIGTERM)
            with suppress(subprocess.TimeoutExpired):
                process.wait(KILL_GRACE)
        _signal_group(process.pid, signal.SIGKILL)
    process.wait()


def _signal_group(group: int, number: signal.Signals) -> None:
    if sys.platform != "win32":
        try:
            os.killpg(group, number)
        except (ProcessLookupError, PermissionError):
            pass  # nobody is left in it (macOS says the second for zombies)


class _Copy(threading.Thread):
    """Copies a pipe to a file as its data comes, up to a limit. What is above is read and dropped."""

    def __init__(self, pipe: IO[bytes], file: IO[bytes], limit: int) -> None:
        super().__init__(daemon=True)
        self.pipe = pipe
        self.file = file
        self.room = limit
        self.over = False
        self.lock = threading.Lock()
        self.start()

    def run(self) -> None:
        with self.pipe:
            while data := self.pipe.read(CHUNK):
                with self.lock:
                    if self.over:
                        return
                    self.room -= self.file.write(data[: self.room])

    def finish(self, deadline: float) -> None:
        """Waits for the end of the pipe, until the deadline: who is not of the group may still hold it."""
        self.join(max(0.0, deadline - time.monotonic()))
        with self.lock:
            self.over = True
