"""The processes that a process has started, and those that they have started."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

import psutil

LISTS_CHILDREN = any(Path("/proc/self/task").glob("*/children"))
DEAD = (psutil.STATUS_ZOMBIE, psutil.STATUS_DEAD)


def descendants(process: psutil.Process) -> set[psutil.Process]:
    """Every living process that this one, or one of its descendants, has started."""
    try:
        return set(filter(is_alive, process.children(recursive=True)))
    except psutil.NoSuchProcess:
        return set()


def descendants_quickly(process: psutil.Process) -> set[psutil.Process]:
    """The same, where Linux lists the children of each process, without a look at all processes of the machine.

    It can miss one whose brother ends just now.
    """
    if not LISTS_CHILDREN:
        return descendants(process)
    found: set[psutil.Process] = set()
    todo = [process.pid]
    while todo:
        for pid in _children(todo.pop()):
            todo.append(pid)
            with suppress(psutil.NoSuchProcess):
                found.add(psutil.Process(pid))
    return set(filter(is_alive, found))


def _children(pid: int) -> list[int]:
    """The processes that a thread of this one has started and that are there still, by their numbers."""
    found: list[int] = []
    # it can end while it is looked at, and so can each of its threads
    with suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            with suppress(OSError):
                found += map(int, (task / "children").read_bytes().split())
    return found


def children_of_ended(pid: int) -> set[psutil.Process]:
    """What a process that has ended has left behind, where the system still knows who started it: on Windows."""
    return {
        one
        for one in psutil.process_iter(["ppid"])
        if one.info["ppid"] == pid and is_alive(one)
    }


def is_alive(process: psutil.Process) -> bool:
    """Whether it still runs; a zombie does not."""
    try:
        return process.is_running() and process.status() not in DEAD
    except psutil.NoSuchProcess:
        return False


def resident_bytes(process: psutil.Process) -> int:
    """The memory that it has; 0 where it has ended, or where the system does not say it."""
    try:
        return process.memory_info().rss
    except (psutil.NoSuchProcess, psutil.AccessDenied):
        return 0


def kill_all(processes: Iterable[psutil.Process]) -> None:
    """Ends processes at once, all of them stopped first, so that none starts another meanwhile."""
    processes = list(processes)
    for action in (psutil.Process.suspend, psutil.Process.kill):
        for process in processes:
            try:
                action(process)
            except (psutil.NoSuchProcess, psutil.AccessDenied):
                continue


def kill_tree(process: psutil.Process) -> None:
    """Ends a process and whatever it has started."""
    kill_all([process, *descendants(process)])
