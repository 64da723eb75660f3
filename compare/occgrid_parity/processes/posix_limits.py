"""What POSIX systems hold a program to by themselves: limits of the system, and on Linux the end of its parent.

Windows has none of this: this module can be imported everywhere, but has its functions only on POSIX systems.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

if sys.platform != "win32":
    import ctypes
    import os
    import resource
    import signal

    import psutil

    PR_SET_PDEATHSIG = 1
    PR_SET_CHILD_SUBREAPER = 36
    SPARE_PROCESSES = 64

    def prctl(option: int, value: int) -> None:
        """Linux's prctl; nothing where there is none."""
        if sys.platform == "linux":
            ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)

    def adopt_orphans() -> None:
        """On Linux, whatever a descendant of this process leaves behind becomes its child."""
        prctl(PR_SET_CHILD_SUBREAPER, 1)

    def limits_setter(
        output: int, memory: int, processes: int, refused: int
    ) -> Callable[[], None]:
        """What a new process does before it becomes the command; limits that the system refuses go to ``refused``.

        ``output`` bytes for one file, twice ``memory`` bytes of data (it is watched besides), ``processes`` more than
        the user has now; root has no such limit.
        """
        values = {
            "core files": (resource.RLIMIT_CORE, 0),
            "output": (resource.RLIMIT_FSIZE, output),
            "memory": (resource.RLIMIT_DATA, 2 * memory),
        }
        if os.getuid() != 0:
            allowed = tasks_of_user() + processes + SPARE_PROCESSES
            values["processes"] = (resource.RLIMIT_NPROC, allowed)

        def set_all() -> None:
            prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
            names = [name for name in values if not lower(*values[name])]
            os.write(refused, ", ".join(names).encode())

        return set_all

    def lower(kind: int, value: int) -> bool:
        """Sets a limit, as far as it is not lower already; False where the system refuses it."""
        try:
            _, hard = resource.getrlimit(kind)
            if hard != resource.RLIM_INFINITY:
                value = min(value, hard)
            resource.setrlimit(kind, (value, value))
        except (OSError, ValueError):
            return False
        return True

    def tasks_of_user() -> int:
        """How many tasks this user has: the limit on processes counts them all."""
        own = os.getuid()
        return sum(
            process.info["num_threads"] or 0
            for process in psutil.process_iter(["uids", "num_threads"])
            if process.info["uids"] and process.info["uids"].real == own
        )
