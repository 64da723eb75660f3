"""A program to check: its command, and what it can be asked."""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from occgrid_parity.ports.declaration import expand
from occgrid_parity.ports.port_file import (
    BUILD_TIMEOUT,
    DECLARATION,
    DEFAULT_TIMEOUT,
    PortError,
    ProgramFile,
    read_port_file,
)
from occgrid_parity.programs.command_words import (
    is_path,
    join_words,
    split_words,
)
from occgrid_parity.suite.modes import NOISE_FREE, Mode

PLACEHOLDERS = (
    *("scenario", "scenarios", "out", "pgm"),
    *("mode", "seed", "port", "python"),
)
SHELL = frozenset({">", ">>", "<", "|", "&", "&&", "||", ";", "2>", "2>&1"})


@dataclass(frozen=True)
class Program:
    """A command template and where it runs.

    ``cwd`` None: in the run's own empty folder. ``build`` are commands to run first, in ``folder``. ``probe`` answers
    the shared vectors. ``words`` is the command as it was given, ``option`` how to give it to ``occgrid-parity check``
    again, ``python`` what {python} becomes.
    """

    name: str
    command: tuple[str, ...]
    folder: Path
    cwd: Path | None = None
    timeout: float = DEFAULT_TIMEOUT
    build: tuple[tuple[str, ...], ...] = ()
    build_timeout: float = BUILD_TIMEOUT
    words: str = ""
    option: str = ""
    probe: tuple[str, ...] = ()
    python: str = sys.executable

    def has(self, *names: str) -> bool:
        """Whether the command has one of the placeholders."""
        return any(
            "{" + name + "}" in argument
            for argument in self.command
            for name in names
        )

    @property
    def reads_scenarios(self) -> bool:
        """Whether it maps a file that it is given; otherwise it has only the lesson."""
        return self.has("scenario", "scenarios")

    @property
    def takes_seeds(self) -> bool:
        """Whether it can be asked for noise of a seed."""
        return self.has("mode", "seed")

    @property
    def plain_mode(self) -> Mode:
        """The mode of most checks: without noise, unless it can only be given a seed."""
        only_seed = self.has("seed") and not self.has("mode")
        return Mode(0) if only_seed else NOISE_FREE

    def arguments(
        self, scenario: Path | None, out: Path, pgm: Path, mode: Mode
    ) -> list[str]:
        """The command of one run."""
        files = [] if scenario is None else [str(scenario)]
        lists = {
            "mode": mode.arguments,
            "scenario": files,
            "scenarios": files,
        }
        texts = {
            **{name: " ".join(words) for name, words in lists.items()},
            "port": str(self.folder),
            "python": self.python,
            "out": str(out),
            "pgm": str(pgm),
            "seed": str(mode.seed or 0),
        }
        command: list[str] = []
        for argument in self.command:
            alone = (
                argument[1:-1] if argument == f"{{{argument[1:-1]}}}" else ""
            )
            if alone in lists:
                command += lists[alone]
            else:
                command += expand([argument], texts)
        return command


def program_from_command(text: str, start: Path, timeout: float) -> Program:
    """The program of ``--run``; words that name files are looked for from the folder ``start``.

    Raises ValueError where the text is no command.
    """
    try:
        words = split_words(text)
    except ValueError as error:
        raise ValueError(f"--run {text!r}: {error}") from error
    if not words:
        raise ValueError("--run needs a command")
    _check_words(words, start)
    command = tuple(_absolute(word, start) for word in words)
    return Program(
        name=_name(words),
        command=command,
        folder=start,
        timeout=timeout,
        words=text,
        option=f"--run {join_words([text])}",
    )


def _check_words(words: Sequence[str], start: Path) -> None:
    """Raises ValueError where the command expects what it does not get: another placeholder, a shell, a quoted path."""
    for word in words:
        if re.fullmatch(r"\{\w+\}", word) and word[1:-1] not in PLACEHOLDERS:
            known = ", ".join(f"{{{name}}}" for name in PLACEHOLDERS)
            raise ValueError(f"--run: {word} is none of {known}")
        if word in SHELL:
            raise ValueError(
                f"--run starts the program without a shell, so {word!r} would be an argument of it; "
                "with one: --run \"sh -c 'COMMAND'\""
            )
    if (start / words[0]).exists():
        return
    for count in range(2, len(words) + 1):
        path = " ".join(words[:count])
        if is_path(path) and (start / path).is_file():
            raise ValueError(
                f"--run: a path with spaces needs quotes: '{path}'"
            )


def _absolute(word: str, start: Path) -> str:
    """A word that names a file or folder as its full path; others as they are.

    Links are kept: the python of a virtual environment is one.
    """
    if "{" in word or word.startswith("-") or not word:
        return word
    path = start / word
    is_there = path.is_file() or (path.is_dir() and is_path(word))
    is_here = word.startswith(("./", ".\\"))
    return str(path.absolute()) if is_there or is_here else word


def _name(words: Sequence[str]) -> str:
    """The program's own name, not its interpreter's."""
    plain = [w for w in words if re.fullmatch(r"[\w./\\:+][\w./\\:+-]*", w)]
    files = [w for w in plain if is_path(w) or "." in Path(w).name]
    word = (files or plain or words)[-1 if files else 0]
    return Path(word).name or word


def program_from_port(path: Path, timeout: float | None = None) -> Program:
    """The program that a port.toml declares; only ``run`` must be there.

    Where the command says where its files go, it runs in its own folder, as ``occgrid-parity run`` does it, else in the
    run's empty folder. Raises PortError where the file cannot be used.
    """
    if path.is_dir():
        path = path / DECLARATION
    folder = path.resolve().parent
    file = read_port_file(path, ProgramFile)
    if file.missing:
        raise PortError(f"{path}: install {file.missing}")
    program = Program(
        name=file.name or folder.name,
        command=file.run,
        folder=folder,
        timeout=timeout or file.timeout,
        build=file.build,
        build_timeout=file.build_timeout,
        words=join_words(file.run),
        option=f"--port {join_words([str(path)])}",
        probe=file.probe,
    )
    if program.has("out", "pgm"):
        return replace(program, cwd=folder)
    command = tuple(_absolute(word, folder) for word in file.run)
    return replace(program, command=command)
