"""Supervisors that start at once, on Linux: a process that has imported all they need forks one for each command.

To start a Python and import psutil takes longer than most programs take for a small scenario. This file is both the
process and, as class ``Server``, how the harness asks it.
"""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

from occgrid_parity.processes.process_group import KILL_GRACE, Stopped

if sys.platform != "win32":
    from occgrid_parity.processes.posix_limits import PR_SET_PDEATHSIG, prctl

if TYPE_CHECKING:
    from collections.abc import Iterator

WORKS = sys.platform == "linux"
COMMAND = ("-P", "-m", "occgrid_parity.processes.supervisor_server")
LOOK = 0.1  # seconds between two looks whether to stop
STARTED, ENDED = "started", "ended"

_of_thread = threading.local()


class ServerLost(Exception):
    """The process that starts supervisors has ended."""


class Server:
    """A process that forks supervisors, for one thread of the harness: one command at a time."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, *COMMAND, str(os.getpid())],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            bufsize=0,
        )

    def __del__(self) -> None:
        self.close()

    def close(self) -> None:
        """Ends the process."""
        for pipe in (self.process.stdin, self.process.stdout):
            if pipe is not None:
                pipe.close()
        self.process.kill()
        self.process.wait()

    def run(
        self, config: Path, seconds: float, stop: threading.Event | None
    ) -> None:
        """Supervises a command; ``config`` is its file of settings.

        Raises Stopped when ``stop`` is set meanwhile, and ServerLost where there is nobody to supervise it.
        """
        deadline = time.monotonic() + seconds
        supervisor = 0
        is_ended = False
        try:
            self._say(str(config))
            supervisor = self._number(STARTED)
            while not (is_ended := self._has_said_something(LOOK)):
                if stop is not None and stop.is_set():
                    raise Stopped
                if time.monotonic() > deadline:
                    return
            self._number(ENDED)
        finally:
            if supervisor and not is_ended:
                self._end(supervisor)

    def _end(self, supervisor: int) -> None:
        """Ends a supervisor, which ends its command."""
        if sys.platform != "win32":
            for number in (signal.SIGTERM, signal.SIGKILL):
                os.kill(supervisor, number)
                if self._has_said_something(KILL_GRACE):
                    self._number(ENDED)
                    return

    def _say(self, text: str) -> None:
        assert self.process.stdin is not None
        try:
            self.process.stdin.write(text.encode() + b"\0")
        except OSError as error:
            raise ServerLost from error

    def _has_said_something(self, seconds: float) -> bool:
        assert self.process.stdout is not None
        return bool(select.select([self.process.stdout], [], [], seconds)[0])

    def _number(self, word: str) -> int:
        """The number in a line that begins with the word."""
        assert self.process.stdout is not None
        line = self.process.stdout.readline().decode().split()
        if line[:1] != [word]:
            raise ServerLost
        return int(line[1])


def run_supervised(
    config: Path, seconds: float, stop: threading.Event | None
) -> None:
    """Supervises a command with the server of this thread. Raises as Server.run does."""
    server: Server | None = getattr(_of_thread, "server", None)
    if server is None or server.process.poll() is not None:
        server = _of_thread.server = Server()
    try:
        server.run(config, seconds, stop)
    except ServerLost:
        _of_thread.server = None
        raise


def _names() -> Iterator[str]:
    """What comes in on standard input, each up to a NUL."""
    text = b""
    while data := os.read(0, 65536):
        text += data
        while b"\0" in text:
            name, _, text = text.partition(b"\0")
            yield name.decode()


if sys.platform != "win32":

    def serve(parent: int) -> None:
        """In the server: forks a supervisor for every file of settings whose name comes in, and says how it goes."""
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:
            return  # it has ended meanwhile
        from occgrid_parity.processes.supervisor import supervise_file

        server = os.getpid()
        for name in _names():
            pid = os.fork()
            if pid == 0:
                os.setsid()
                null = os.open(os.devnull, os.O_RDWR)
                for number in (0, 1):
                    os.dup2(null, number)
                said = os.open(f"{name}.said", os.O_WRONLY | os.O_CREAT, 0o600)
                os.dup2(said, 2)
                try:
                    supervise_file(Path(name), server)
                finally:
                    sys.stderr.flush()
                os._exit(0)
            os.write(1, f"{STARTED} {pid}\n".encode())
            os.waitpid(pid, 0)
            os.write(1, f"{ENDED} {pid}\n".encode())

    if __name__ == "__main__":
        serve(int(sys.argv[1]))
