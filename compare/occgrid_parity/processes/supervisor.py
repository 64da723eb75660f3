"""Runs one command within limits and ends every process that it started.

This is a program of its own; the harness starts it for each command, with a file of settings, or has it forked by the
process of supervisor_server.py. On Linux it makes itself
the parent of the command's orphans, so a process that left its group or session is still found and ended; elsewhere it
ends those that it has seen.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import select
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import psutil

from occgrid_parity.processes.own_time import OwnTime
from occgrid_parity.processes.process_tree import (
    children_of_ended,
    descendants,
    descendants_quickly,
    is_alive,
    kill_all,
    resident_bytes,
)

if sys.platform != "win32":
    from occgrid_parity.processes.posix_limits import (
        adopt_orphans,
        limits_setter,
    )

LOOK = 0.05  # seconds between two looks at memory and processes, in the first second
LATER = 0.2  # and after it: a look at a machine with many processes takes a hundredth of a second
GONE = 0.002  # seconds that killed processes get to be gone
MEASURE = 0.25  # seconds between two looks at the files
LEFT = 9  # behind a wall, a shell writes there how many processes the command left
WALL_PROCESSES = 3  # bubblewrap, the first process in it, and that shell


def size_of(folder: Path) -> int:
    """Bytes of all files in a folder."""
    total = 0
    for place, _, files in os.walk(folder):
        for file in files:
            try:
                total += (Path(place) / file).lstat().st_size
            except OSError:
                continue
    return total


def handle_of(pid: int) -> int | None:
    """A file descriptor that can be read when the process has ended; None where the system has none."""
    if sys.platform == "linux":
        with contextlib.suppress(AttributeError, OSError):
            return os.pidfd_open(pid)
    return None


class Command:
    """The running command and its processes. ``refused`` names limits that the system would not set."""

    def __init__(self, config: dict[str, Any]) -> None:
        self.refused = ""
        self.seen: set[psutil.Process] = set()
        options: dict[str, Any] = {}
        if config["walled"]:
            flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC
            os.dup2(os.open(config["left"], flags, 0o600), LEFT)
            options["pass_fds"] = (LEFT,)
        reading, writing = os.pipe()
        if sys.platform != "win32":
            options["start_new_session"] = True
            options["preexec_fn"] = limits_setter(
                config["bytes"],
                config["memory"],
                config["processes"],
                writing,
            )
        with (
            os.fdopen(reading, "rb") as pipe,
            Path(config["stdout"]).open("wb") as stdout,
            Path(config["stderr"]).open("wb") as stderr,
        ):
            try:
                self.process = subprocess.Popen(
                    config["command"],
                    cwd=config["cwd"],
                    stdin=subprocess.DEVNULL,
                    stdout=stdout,
                    stderr=stderr,
                    **options,
                )
            finally:
                os.close(writing)
            self.refused = pipe.read().decode()
        self.handle = handle_of(self.process.pid)

    def living(self, quickly: bool = False) -> set[psutil.Process]:
        """Every process of the command that is known to live: the descendants, and who has been one before."""
        listed = descendants_quickly if quickly else descendants
        found = listed(psutil.Process())
        for one in self.seen - found:
            if is_alive(one):
                found |= {one, *listed(one)}
        self.seen = found
        return found

    def has_ended(self) -> bool:
        """Whether the command ends within a moment."""
        if self.handle is not None:
            # to wait with a limit, subprocess sleeps, longer and longer; this returns as soon as the command ends
            select.select([self.handle], [], [], LOOK)
            return self.process.poll() is not None
        try:
            self.process.wait(LOOK)
        except subprocess.TimeoutExpired:
            return False
        return True

    def left_behind(self) -> int:
        """How many processes are still there beside the first one."""
        if sys.platform == "win32":
            self.seen |= children_of_ended(self.process.pid)
        return sum(one.pid != self.process.pid for one in self.living())

    def end(self) -> None:
        """Ends them all."""
        if sys.platform != "win32":
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except (ProcessLookupError, PermissionError):
                pass
        for _ in range(500):
            # where a whole look has found nobody, a quick one is enough
            found = self.living(quickly=not self.seen)
            if not found:
                break
            kill_all(found)
            self.process.poll()
            time.sleep(GONE)


class Watch:
    """Looks at the running command; ``word`` says which limit it broke."""

    def __init__(self, config: dict[str, Any]) -> None:
        self.config = config
        self.word = ""
        self.peak = 0
        self.started = self.looked = self.measured = time.monotonic()
        self.own_time = OwnTime()
        self.stopped = False
        signal.signal(signal.SIGTERM, self.stop)
        signal.signal(signal.SIGINT, self.stop)

    def stop(self, number: int, frame: object) -> None:
        """The harness ends the run."""
        self.stopped = True

    def look(self, command: Command) -> None:
        """Looks at what is due: at each call whether to stop, the rest now and then."""
        now = time.monotonic()
        limit = self.config["seconds"]
        pause = LOOK if now - self.started < 1.0 else LATER
        if now - self.looked > pause or self.own_time.seconds > limit:
            self.looked = now
            self.look_at_processes(command)
        if now - self.measured > MEASURE:
            self.measured = now
            self.measure()
        if not self.word and self.own_time.seconds > limit:
            self.word = "hang"
        if self.stopped or self.parent_is_gone():
            self.word = "stopped"

    def look_at_processes(self, command: Command) -> None:
        """Looks at their number, their memory, and how long they have waited for a processor."""
        found = command.living(quickly=True)
        self.own_time.look(one.pid for one in found)
        memory = sum(resident_bytes(one) for one in found)
        self.peak = max(self.peak, memory)
        own = WALL_PROCESSES if self.config["walled"] else 0
        if len(found) > self.config["processes"] + own:
            self.word = "forks"
        elif self.peak > self.config["memory"]:
            self.word = "too much memory"

    def measure(self) -> None:
        """Looks at how much was written and printed."""
        files = (Path(self.config["stdout"]), Path(self.config["stderr"]))
        written = size_of(Path(self.config["watch"]))
        printed = max(file.stat().st_size for file in files)
        if max(written, printed) >= self.config["bytes"]:
            self.word = "too much output"

    def parent_is_gone(self) -> bool:
        """Whether the harness has ended."""
        parent: int = self.config["parent"]
        if sys.platform != "win32":
            gone = os.getppid() != parent
        else:
            gone = not psutil.pid_exists(parent)
        return gone


def supervise(config: dict[str, Any]) -> dict[str, Any]:
    """Runs the command to its end; returns what there is to tell."""
    if sys.platform != "win32":
        adopt_orphans()
    watch = Watch(config)
    told: dict[str, Any] = {
        "word": "",
        "status": None,
        "seconds": 0.0,
        "peak": 0,
        "left": 0,
        "refused": "",
        "start_error": 0,
        "start_reason": "",
    }
    try:
        command = Command(config)
    except OSError as error:
        reason = {
            "start_error": error.errno or errno.EINVAL,
            "start_reason": error.strerror,
        }
        return told | reason
    except ValueError as error:
        return told | {
            "start_error": errno.EINVAL,
            "start_reason": str(error),
        }
    while not watch.word and not command.has_ended():
        watch.look(command)
    seconds = time.monotonic() - watch.started
    status = None if watch.word else command.process.returncode
    left = command.left_behind()
    command.end()
    if not watch.word:
        watch.measure()
    return told | {
        "word": watch.word,
        "status": status,
        "seconds": seconds,
        "peak": watch.peak,
        "left": left,
        "refused": command.refused,
    }


def supervise_file(settings: Path, parent: int | None = None) -> None:
    """Runs the command of a file of settings, and writes what came of it.

    ``parent`` is the process that has started this one, where that is not the harness.
    """
    config = json.loads(settings.read_text(encoding="utf-8"))
    if parent is not None:
        config["parent"] = parent
    told = supervise(config)
    Path(config["report"]).write_text(json.dumps(told), encoding="utf-8")


if __name__ == "__main__":
    supervise_file(Path(sys.argv[1]))
