"""A wall around a program: bubblewrap, which shows it no more of the machine than it needs."""

from __future__ import annotations

import functools
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

Sandbox = Literal["auto", "require", "none"]

BUBBLEWRAP = "bwrap"
INSTALL = "install the package bubblewrap"
PATH = "/usr/local/bin:/usr/bin:/bin:/usr/local/games:/usr/games"
HOME = "/tmp"
SPARE_BYTES = (
    256 * 2**20
)  # in each folder for temporary files, which lie in memory
LEFT = (
    9  # the file descriptor that says how many processes a command left behind
)

# the command, and then how many processes there are beside the first one and this shell
COUNTING = f'"$@" {LEFT}>&-; s=$?; set -- /proc/[0-9]*; echo $(($# - 2)) >&{LEFT}; exit $s'

SYSTEM = ("/usr", "/opt", "/bin", "/sbin", "/lib", "/lib32", "/lib64")

# what compilers and interpreters read of /etc; no passwords, keys or host names
SETTINGS = (
    "alternatives", "fonts", "ghc", "group", "java*", "ld.so.cache", "ld.so.conf", "ld.so.conf.d", "localtime",
    "magic", "maven", "mime.types", "node*", "nsswitch.conf", "octave*", "openmpi", "os-release", "passwd", "perl",
    "python*", "R", "timezone", "vulkan", "OpenCL",
)  # fmt: skip


class NoWall(Exception):
    """There is no wall on this machine; the text says why."""


@dataclass(frozen=True)
class Wall:
    """What a program sees.

    ``works`` False: everything, there is no wall, and ``reason`` says why. ``readable`` are folders that the
    instructor shows beside the system's own. ``hidden`` ones are empty to the program, even inside those.
    """

    works: bool = False
    reason: str = ""
    readable: tuple[Path, ...] = ()
    hidden: tuple[Path, ...] = ()
    environment: tuple[tuple[str, str], ...] = field(default=())

    @property
    def python(self) -> str:
        """What ``{python}`` becomes: never the harness's own behind a wall."""
        return "python3" if self.works else sys.executable

    def around(
        self,
        command: Sequence[str],
        *,
        cwd: Path,
        readable: Sequence[Path] = (),
        writable: Sequence[Path] = (),
    ) -> list[str]:
        """The command behind the wall, where it can read and write nothing else; without a wall the command."""
        if not self.works:
            return list(command)
        words = [
            BUBBLEWRAP, "--unshare-all", "--die-with-parent", "--new-session", "--clearenv",
            "--setenv", "PATH", PATH, "--setenv", "HOME", HOME, "--setenv", "LANG", "C.UTF-8",
        ]  # fmt: skip
        for name, value in self.environment:
            words += ["--setenv", name, value]
        words += [*_system(), "--proc", "/proc", "--dev", "/dev"]
        for place in ("/tmp", "/dev/shm"):
            words += ["--size", str(SPARE_BYTES), "--tmpfs", place]
        for path in self.readable:
            words += ["--ro-bind", str(path), str(path)]
        for path in self._to_hide():
            words += ["--tmpfs", str(path), "--remount-ro", str(path)]
        for path in readable:
            words += ["--ro-bind", str(path), str(path)]
        for path in writable:
            words += ["--bind", str(path), str(path)]
        words += ["--remount-ro", "/", "--chdir", str(cwd)]
        return [*words, "--", "/bin/sh", "-c", COUNTING, "sh", *command]

    def _to_hide(self) -> list[Path]:
        """The hidden folders that the rest of the wall would show."""
        shown = [Path(place) for place in SYSTEM] + list(self.readable)
        return [
            path
            for path in self.hidden
            if path.is_dir() and any(path.is_relative_to(one) for one in shown)
        ]


NONE = Wall()


def find_wall(wanted: Sandbox, hidden: Sequence[Path] = ()) -> Wall:
    """The wall that is wanted.

    ``auto`` takes it where it works and says in ``reason`` where it does not. Raises NoWall where it is required and
    does not work.
    """
    if wanted == "none":
        return replace(NONE, reason="it was not asked for")
    on_linux = sys.platform == "linux"
    reason = _problem() if on_linux else "bubblewrap needs Linux"
    if not reason:
        return Wall(True, hidden=tuple(path.resolve() for path in hidden))
    if wanted == "require":
        raise NoWall(f"no program can be run behind a wall here: {reason}")
    return replace(NONE, reason=reason)


@functools.cache
def _problem() -> str:
    """Why bubblewrap does not work here; empty where it does."""
    if shutil.which(BUBBLEWRAP) is None:
        return INSTALL
    command = Wall(True).around(["true"], cwd=Path("/"))
    try:
        ended = subprocess.run(
            ["/bin/sh", "-c", f'exec "$@" {LEFT}>/dev/null', "sh", *command],
            capture_output=True,
            text=True,
            timeout=30,
            errors="replace",
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"bubblewrap does not run: {error}"
    if ended.returncode == 0:
        return ""
    said = (ended.stderr.strip().splitlines() or ["it says nothing"])[0]
    return f"bubblewrap does not work: {said}"


@functools.cache
def _system() -> tuple[str, ...]:
    """The system's files: programs, libraries, and the settings that they read."""
    words: list[str] = []
    for place in SYSTEM:
        path = Path(place)
        if path.is_symlink():
            words += ["--symlink", str(path.readlink()), place]
        elif path.is_dir():
            words += ["--ro-bind", place, place]
    for pattern in SETTINGS:
        for path in sorted(Path("/etc").glob(pattern)):
            words += ["--ro-bind", str(path), str(path)]
    return tuple(words)
