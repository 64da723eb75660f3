"""Runs a command that may not end by itself, within limits of time, output, memory and processes."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import re
import signal
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from occgrid_parity.processes import supervisor_server
from occgrid_parity.processes.own_time import COUNTED
from occgrid_parity.processes.process_group import first_line, run_process
from occgrid_parity.processes.wall import NONE, Wall

SUPERVISOR = ("-P", "-m", "occgrid_parity.processes.supervisor")
GRACE = 10.0  # seconds that the supervisor has to clean up
MEBI = 2**20
TAIL = 65536  # bytes of standard error in which a traceback is looked for
PLACE = re.compile(r'\s+File "(?P<file>[^"]+)", line (?P<line>[0-9]+)')
EXCEPTION = re.compile(r"[A-Za-z_][\w.]*(?:: .*)?$")
LIBRARY = re.compile(
    r"/lib(?:64)?/python[0-9.]*/|/Python[0-9.]*/Lib/|/site-packages/|^<"
)

LOST = "lost"
"""The word of a run of which nobody knows how it ended: it says nothing about the program."""

WATCHED = (
    "{system} sets no limits for a program: its memory, its processes and what it writes were looked at several times "
    "a second, and what it took in between was not refused"
)
UNSEEN = "a process that a program leaves running can stay unseen: {system} does not say who started it"
SYSTEMS = {"win32": "Windows", "darwin": "macOS"}

# a shell's exit statuses
NOT_EXECUTABLE = 126
NOT_FOUND = 127
SIGNALLED = 128

MISSING = (
    "No such file or directory",
    "FileNotFoundError",
    "No such file",
    "cannot find the file",
)


@dataclass(frozen=True)
class Limits:
    """What one run may use.

    ``seconds`` of time, without that in which it could have run and others had the processor; ``output`` bytes of
    files and of what is printed, together; ``memory`` bytes of all its processes; ``processes`` at a time.
    """

    seconds: float = 60.0
    output: int = 256 * MEBI
    memory: int = 2048 * MEBI
    processes: int = 64


@dataclass(frozen=True)
class Ended:
    """How a run ended.

    ``word`` is empty where it went well, else what went wrong in a word or two, with ``message`` for the rest.
    ``left`` processes were still there when the command had ended; they were ended, too. ``notes`` say to what this
    system could not hold it.
    """

    word: str
    message: str
    seconds: float
    stdout: Path
    stderr: Path
    left: int = 0
    peak: int = 0
    status: int | None = None
    notes: tuple[str, ...] = ()


def not_held(refused: str = "") -> tuple[str, ...]:
    """What this system cannot hold a program to, in sentences; ``refused`` names limits that it would not set."""
    name = SYSTEMS.get(sys.platform, sys.platform)
    notes = []
    if sys.platform == "win32":
        notes.append(WATCHED.format(system=name))
    if sys.platform != "linux":
        notes.append(UNSEEN.format(system=name))
    if refused:
        notes.append(f"this system refused to limit the program's {refused}")
    return tuple(notes)


def run_limited(
    command: Sequence[str],
    *,
    cwd: Path,
    folder: Path,
    watch: Path,
    limits: Limits,
    stop: threading.Event | None = None,
    wall: Wall = NONE,
    readable: Sequence[Path] = (),
    writable: Sequence[Path] = (),
) -> Ended:
    """Runs ``command`` in ``cwd``; ``folder`` gets its stdout and stderr, ``watch`` is where its files count.

    Behind a ``wall`` it sees the ``readable`` and ``writable`` folders, and those of the system.
    Raises occgrid_parity.processes.process_group.Stopped when ``stop`` is set meanwhile.
    """
    folder.mkdir(parents=True, exist_ok=True)
    config = folder / "limits.json"
    report = folder / "ended.json"
    stdout, stderr = folder / "stdout", folder / "stderr"
    report.unlink(missing_ok=True)
    for file in (stdout, stderr):
        file.write_bytes(b"")
    config.write_text(
        json.dumps(
            {
                "command": wall.around(
                    command, cwd=cwd, readable=readable, writable=writable
                ),
                "walled": wall.works,
                "parent": os.getpid(),
                "left": str(folder / "left"),
                "cwd": str(cwd),
                "stdout": str(stdout),
                "stderr": str(stderr),
                "report": str(report),
                "watch": str(watch),
                "seconds": limits.seconds,
                "bytes": limits.output,
                "memory": limits.memory,
                "processes": limits.processes,
            }
        ),
        encoding="utf-8",
    )
    seconds = _supervise(config, limits.seconds / COUNTED + GRACE, stop)
    if not report.is_file():
        said = first_line(_said(config)) or "nothing on standard error"
        message = f"the run could not be watched to its end ({said})"
        return Ended(LOST, message, seconds, stdout, stderr)
    told = json.loads(report.read_text(encoding="utf-8"))
    if wall.works:
        _behind_the_wall(told, folder / "left")
    word, message = what_went_wrong(
        told, command, limits, stdout, stderr, wall
    )
    return Ended(
        word,
        message,
        told["seconds"],
        stdout,
        stderr,
        told["left"],
        told["peak"],
        None if told["word"] else told["status"],
        not_held(told["refused"]),
    )


def _supervise(
    config: Path, seconds: float, stop: threading.Event | None
) -> float:
    """Runs the command of a file of settings; how long it took."""
    started = time.monotonic()
    _said(config).write_bytes(b"")
    if supervisor_server.WORKS:
        with contextlib.suppress(supervisor_server.ServerLost):
            supervisor_server.run_supervised(config, seconds, stop)
    else:
        run_process(
            [sys.executable, *SUPERVISOR, str(config)],
            cwd=config.parent,
            stdout=config.with_name("supervisor.stdout"),
            stderr=_said(config),
            time_limit=seconds,
            stop=stop,
        )
    return time.monotonic() - started


def _said(config: Path) -> Path:
    """What the supervisor says on standard error."""
    return config.with_name(f"{config.name}.said")


def _behind_the_wall(told: dict[str, Any], left: Path) -> None:
    """What bubblewrap and the shell in it tell in other ways: signals, and processes that were left behind."""
    if told["status"] is not None and told["status"] > SIGNALLED:
        told["status"] = SIGNALLED - told["status"]
    try:
        told["left"] = max(0, int(left.read_bytes()[:20]))
    except (OSError, ValueError):
        told["left"] = 0  # the shell was ended before it could count


def what_went_wrong(
    told: dict[str, Any],
    command: Sequence[str],
    limits: Limits,
    stdout: Path,
    stderr: Path,
    wall: Wall,
) -> tuple[str, str]:
    """Word and message of a run that the supervisor tells of."""
    status = told["status"]
    if wall.works and status in (NOT_EXECUTABLE, NOT_FOUND):
        said = _telling_line(stderr)
        if said.startswith(f"sh: 1: {command[0]}: "):
            word = "not found" if status == NOT_FOUND else "not executable"
            reason = said.rpartition(": ")[2]
            return (
                word,
                f"the program cannot be started: {command[0]}: {reason}",
            )
    if told["start_error"]:
        what = f"{command[0]}: {told['start_reason']}"
        is_name = Path(command[0]).name == command[0]
        if told["start_error"] == errno.ENOENT and is_name:
            return "not found", f"{command[0]} is not a command here"
        if told["start_error"] == errno.ENOENT:
            return "not found", f"the program cannot be started: {what}"
        return "not executable", f"the program cannot be started: {what}"
    printed = max(file.stat().st_size for file in (stdout, stderr))
    too_much = printed >= limits.output or (
        sys.platform != "win32" and status == -signal.SIGXFSZ
    )
    if told["word"] == "too much output" or too_much:
        return (
            "too much output",
            f"more than {limits.output // MEBI} MiB were printed or written; ended",
        )
    if told["word"] == "hang":
        return "hang", f"no end after {limits.seconds:g} s; ended"
    if told["word"] == "forks":
        return (
            "forks",
            f"more than {limits.processes} processes at a time; all ended",
        )
    if told["word"] == "too much memory":
        return (
            "too much memory",
            f"more than {limits.memory // MEBI} MiB of memory; ended",
        )
    if told["word"]:
        return str(told["word"]), "the run was stopped"
    if status == 0:
        return "", ""
    assert isinstance(status, int)
    said = _telling_line(stderr)
    said = f": {said}" if said else ", and nothing on standard error"
    if status < 0:
        return "crash", f"ended by {_signal(-status)}{said}"
    if any(mark in said for mark in MISSING):
        return "missing file", f"exit status {status}{said}"
    return "crash", f"exit status {status}{said}"


def _telling_line(stderr: Path) -> str:
    """What standard error says of the failure: an exception and the program's own line, else the first line."""
    with stderr.open("rb") as file:
        file.seek(max(0, stderr.stat().st_size - TAIL))
        text = file.read().decode("utf-8", "replace")
    return python_exception(text) or first_line(stderr)


def python_exception(text: str) -> str:
    """``IndexError: list index out of range (mapper.py, line 12)`` of a Python traceback; empty where there is none.

    The line is the last one of the program's own files, not of Python or of a library.
    """
    lines = text.splitlines()
    places = [(i, m) for i, x in enumerate(lines) if (m := PLACE.match(x))]
    if not places:
        return ""
    last = places[-1][0]
    said = [x for x in lines[last + 1 :] if EXCEPTION.match(x)]
    if not said:
        return ""
    files = [(m["file"].replace("\\", "/"), m["line"]) for _, m in places]
    own = [(f, line) for f, line in files if not LIBRARY.search(f)]
    if not own:
        return said[-1][:300]
    file, line = own[-1]
    return f"{said[-1][:300]} ({file.rsplit('/', 1)[-1]}, line {line})"


def _signal(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"
