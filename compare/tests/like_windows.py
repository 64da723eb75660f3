"""Runs a module with no more of the operating system than Windows has, as far as Linux can pretend.

``python like_windows.py MODULE [ARGUMENT...]``. What others have written is imported before the pretence begins; the
suite's own modules are imported after it.
"""

from __future__ import annotations

import importlib
import os
import pkgutil
import runpy
import signal
import sys
from pathlib import Path

import occgrid
import occgrid_parity

SUPERVISOR = "occgrid_parity.processes.supervisor"
MODULES = ("fcntl", "grp", "pwd", "resource", "termios")
FUNCTIONS = {
    os: ("fork", "getloadavg", "getpgid", "getuid", "killpg", "set_blocking", "setsid"),
    signal: ("SIGPIPE", "SIGXFSZ", "SIG_BLOCK", "SIG_UNBLOCK", "pthread_sigmask", "setitimer"),
}  # fmt: skip


def import_all() -> None:
    """Imports every module of the wheel."""
    for package in (occgrid, occgrid_parity):
        for found in pkgutil.walk_packages(
            package.__path__, f"{package.__name__}."
        ):
            if not found.name.endswith(".__main__"):
                importlib.import_module(found.name)


def pretend() -> None:
    """From now on, this process is on Windows for whoever asks."""
    for name in list(sys.modules):
        if name.startswith(("occgrid.", "occgrid_parity.")):
            del sys.modules[name]
    for name in MODULES:
        sys.modules[name] = None  # type: ignore[assignment]
    for module, names in FUNCTIONS.items():
        for name in names:
            delattr(module, name)
    sys.platform = "win32"


def main() -> None:
    """Pretends, and runs the module; ``all`` imports them all."""
    module = sys.argv[1]
    if module == SUPERVISOR:
        importlib.import_module(SUPERVISOR)
        pretend()
    else:
        import_all()
        pretend()
        import_all()
        limits = importlib.import_module("occgrid_parity.processes.limits")
        script = str(Path(__file__).resolve())
        vars(limits)["SUPERVISOR"] = (script, SUPERVISOR)
    if module != "all":
        del sys.argv[0]
        runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
