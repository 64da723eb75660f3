"""Runs one command within limits and ends every process that it started.

This file is a program of its own, with nothing but the standard library: the harness starts it as
``python -I -S supervisor.py CONFIG``. It makes itself the parent of the command's orphans (on Linux), so a process
that left its group or session is still found and ended.
"""

from __future__ import annotations

import ctypes
import errno
import json
import os
import resource
import signal
import sys
import time
from pathlib import Path
from typing import Any, NoReturn

PR_SET_PDEATHSIG = 1
PR_SET_CHILD_SUBREAPER = 36
POLL = 0.01
LOOK = 0.05  # seconds between two looks at memory and processes
MEASURE = 0.25  # seconds between two looks at the files
PROC = Path("/proc")
SPARE_PROCESSES = 64
LEFT = 9  # behind a wall, a shell writes there how many processes the command left
WALL_PROCESSES = 3  # bubblewrap, the first process in it, and that shell


def prctl(option: int, value: int) -> None:
    """Linux's prctl; nothing where there is none."""
    if sys.platform == "linux":
        ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


def descendants() -> dict[int, int]:
    """Resident bytes of each living process that this one, or one of its children, started."""
    parents: dict[int, int] = {}
    pages: dict[int, int] = {}
    for entry in PROC.iterdir() if PROC.is_dir() else ():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if fields[0] not in "ZX":
            parents[int(entry.name)] = int(fields[1])
            pages[int(entry.name)] = int(fields[21])
    found: dict[int, int] = {}
    new = {os.getpid()}
    while new:
        new = {p for p, parent in parents.items() if parent in new} - set(
            found
        )
        found |= {p: pages[p] * resource.getpagesize() for p in new}
    return found


def tasks_of_user() -> int:
    """How many tasks this user has: the limit on processes counts them all."""
    count = 0
    for entry in PROC.glob("[0-9]*/task") if PROC.is_dir() else ():
        try:
            if entry.stat().st_uid == os.getuid():
                count += len(list(entry.iterdir()))
        except OSError:
            continue
    return count


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


def limit(kind: int, value: int) -> None:
    """Sets a limit, as far as it is not lower already."""
    _, hard = resource.getrlimit(kind)
    if hard != resource.RLIM_INFINITY:
        value = min(value, hard)
    resource.setrlimit(kind, (value, value))


def become(config: dict[str, Any], failed: int) -> NoReturn:
    """Turns this process into the command; what fails is written to ``failed``."""
    try:
        os.setsid()
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        for name, flags in (
            ("stdout", os.O_WRONLY | os.O_CREAT | os.O_TRUNC),
            ("stderr", os.O_WRONLY | os.O_CREAT | os.O_TRUNC),
        ):
            file = os.open(config[name], flags, 0o644)
            os.dup2(file, 1 if name == "stdout" else 2)
            os.close(file)
        if config["walled"]:
            file = os.open(config["left"], flags, 0o600)
            os.dup2(file, LEFT)
            if file != LEFT:
                os.close(file)
        null = os.open(os.devnull, os.O_RDONLY)
        os.dup2(null, 0)
        os.chdir(config["cwd"])
        limit(resource.RLIMIT_CORE, 0)
        limit(resource.RLIMIT_FSIZE, config["bytes"])
        limit(resource.RLIMIT_DATA, 2 * config["memory"])
        if os.getuid() != 0:
            spare = config["processes"] + SPARE_PROCESSES
            limit(resource.RLIMIT_NPROC, tasks_of_user() + spare)
        for number in (
            signal.SIGTERM,
            signal.SIGINT,
            signal.SIGXFSZ,
            signal.SIGPIPE,
        ):
            signal.signal(number, signal.SIG_DFL)
        os.execvpe(config["command"][0], config["command"], os.environ)
    except OSError as error:
        os.write(failed, f"{error.errno} {error.strerror}".encode())
    except ValueError as error:
        os.write(failed, f"{errno.EINVAL} {error}".encode())
    os._exit(127)


class Watch:
    """Looks at the running command; ``word`` says which limit it broke."""

    def __init__(self, config: dict[str, Any]) -> None:
        self.config = config
        self.word = ""
        self.peak = 0
        self.started = self.looked = self.measured = time.monotonic()
        self.stopped = False
        signal.signal(signal.SIGTERM, self.stop)
        signal.signal(signal.SIGINT, self.stop)

    def stop(self, number: int, frame: object) -> None:
        self.stopped = True

    def look(self) -> None:
        now = time.monotonic()
        if self.stopped:
            self.word = "stopped"
        elif now - self.started > self.config["seconds"]:
            self.word = "hang"
        if now - self.looked > LOOK:
            self.looked = now
            found = descendants()
            self.peak = max(self.peak, sum(found.values()))
            own = WALL_PROCESSES if self.config["walled"] else 0
            if len(found) > self.config["processes"] + own:
                self.word = "forks"
            elif self.peak > self.config["memory"]:
                self.word = "too much memory"
        if now - self.measured > MEASURE:
            self.measured = now
            self.measure()

    def measure(self) -> None:
        if size_of(Path(self.config["watch"])) >= self.config["bytes"]:
            self.word = "too much output"


def reap() -> None:
    """Takes note of children that have ended."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0] != 0:
            pass
    except ChildProcessError:
        pass


def end_all(child: int) -> int:
    """Kills whatever the command started; returns how many there were."""
    ended: set[int] = set()
    try:
        os.killpg(child, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        pass
    for _ in range(500):
        found = descendants()
        if not found:
            break
        ended |= set(found)
        for number in (signal.SIGSTOP, signal.SIGKILL):
            for process in found:
                try:
                    os.kill(process, number)
                except (ProcessLookupError, PermissionError):
                    continue
        reap()
        time.sleep(POLL / 5)
    return len(ended)


def supervise(config: dict[str, Any]) -> dict[str, Any]:
    """Runs the command to its end; returns what there is to tell."""
    prctl(PR_SET_CHILD_SUBREAPER, 1)
    watch = Watch(config)
    prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != config["parent"]:
        watch.stop(signal.SIGTERM, None)  # the parent died meanwhile
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        become(config, writing)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        problem = pipe.read().decode()
    status: int | None = None
    while not watch.word:
        ended, raw = os.waitpid(child, os.WNOHANG)
        if ended:
            status = os.waitstatus_to_exitcode(raw)
            break
        time.sleep(POLL)
        watch.look()
    seconds = time.monotonic() - watch.started
    left = [p for p in descendants() if p != child]
    end_all(child)
    reap()
    if not watch.word:
        watch.measure()
    number, _, reason = problem.partition(" ")
    return {
        "word": watch.word,
        "status": status,
        "seconds": seconds,
        "peak": watch.peak,
        "left": len(left),
        "start_error": int(number) if number else 0,
        "start_reason": reason,
    }


def main() -> None:
    config = json.loads(Path(sys.argv[1]).read_text())
    report = supervise(config)
    Path(config["report"]).write_text(json.dumps(report))


if __name__ == "__main__":
    main()
