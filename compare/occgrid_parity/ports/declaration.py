"""Ports as ``port.toml`` declares them, and their command templates."""

from __future__ import annotations

import re
import shutil
import sys
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.processes.process_group import search_path

DECLARATION = "port.toml"
LIST_PLACEHOLDERS = ("mode", "scenario", "scenarios")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")


class PortError(ValueError):
    """A declaration that cannot be used; the text names the file and the key."""


@dataclass(frozen=True)
class Need:
    """A command that must be on the PATH, and the package that brings it."""

    command: str
    install: str


@dataclass(frozen=True)
class Port:
    """One port, or a student's program.

    ``timeout`` and ``build_timeout`` are seconds: for one run of one scenario and
    for each build command. ``log_scans`` and ``probe_lines`` say how much of a real
    log and of a probe's input the tests give to a slow port (None: all).
    """

    name: str
    language: str
    folder: Path
    run: tuple[str, ...]
    timeout: float
    build: tuple[tuple[str, ...], ...] = ()
    version: tuple[str, ...] = ()
    probe: tuple[str, ...] = ()
    needs: tuple[Need, ...] = ()
    build_timeout: float = 900.0
    log_scans: int | None = None
    probe_lines: int | None = None

    @property
    def takes_many(self) -> bool:
        """Whether one process maps several scenarios."""
        return "{scenarios}" in self.run

    @property
    def skip_reason(self) -> str | None:
        """``install octave`` where something it needs is missing, else None."""
        missing = [n.install for n in self.needs if _missing(n.command)]
        return (
            "install " + ", ".join(dict.fromkeys(missing)) if missing else None
        )

    def command(
        self,
        template: Sequence[str],
        **values: str | Path | Sequence[str | Path],
    ) -> list[str]:
        """``template`` with ``{port}``, ``{python}`` and the values filled in."""
        known = {"port": self.folder, "python": sys.executable, **values}
        return expand(template, known)


def _missing(command: str) -> bool:
    return shutil.which(command, path=search_path()) is None


def expand(
    template: Sequence[str],
    values: Mapping[str, str | Path | Sequence[str | Path]],
) -> list[str]:
    """Fills in a command template.

    A value that is a list takes the place of an argument that is its placeholder
    and nothing else, with as many arguments as the list has. Text in braces that is
    no placeholder stays as it is.
    """
    command: list[str] = []
    for argument in template:
        whole = values.get(argument[1:-1]) if argument[:1] == "{" else None
        if whole is not None and not isinstance(whole, str | Path):
            command += [str(value) for value in whole]
            continue
        for name, value in values.items():
            if isinstance(value, str | Path):
                argument = argument.replace("{" + name + "}", str(value))
        command.append(argument)
    return command


def find_ports(root: Path) -> list[Port]:
    """The ports declared by ``*/port.toml`` in ``root``, by name, python first.

    Raises PortError where there is none, where a declaration cannot be used and where
    two share a name.
    """
    ports = [read_port(path) for path in sorted(root.glob(f"*/{DECLARATION}"))]
    if not ports:
        raise PortError(f"{root}: no folder in it has a {DECLARATION}")
    for port in ports:
        twins = [
            other.folder.name for other in ports if other.name == port.name
        ]
        if len(twins) > 1:
            raise PortError(
                f"{' and '.join(twins)}: both ports are named {port.name}"
            )
    return sorted(ports, key=lambda port: (port.name != "python", port.name))


def read_port(path: Path) -> Port:
    """The port that the file declares. Raises PortError where it cannot be used."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise PortError(f"{path}: {error}") from error
    reader = _Reader(path, table)
    port = Port(
        name=reader.text("name"),
        language=reader.text("language"),
        folder=path.resolve().parent,
        run=reader.command("run", required=True),
        timeout=reader.seconds("timeout"),
        build=reader.commands("build"),
        version=reader.command("version"),
        probe=reader.command("probe"),
        needs=reader.needs(),
        build_timeout=reader.seconds("build_timeout", Port.build_timeout),
        log_scans=reader.count("log_scans"),
        probe_lines=reader.count("probe_lines"),
    )
    reader.no_more_keys()
    if not NAME.fullmatch(port.name):
        raise reader.error(f"name {port.name!r} does not make a folder's name")
    if not any(word in port.run for word in ("{scenario}", "{scenarios}")):
        raise reader.error("run has no argument {scenarios} or {scenario}")
    for word in ("{mode}", "{out}"):
        if not any(word in argument for argument in port.run):
            raise reader.error(f"run has no {word}")
    return port


class _Reader:
    """Takes the keys of one declaration out of its table, with its errors."""

    def __init__(self, path: Path, table: dict[str, object]) -> None:
        self.path = path
        self.table = dict(table)

    def error(self, reason: str) -> PortError:
        return PortError(f"{self.path}: {reason}")

    def no_more_keys(self) -> None:
        if self.table:
            raise self.error(f"unknown key {', '.join(sorted(self.table))}")

    def text(self, key: str) -> str:
        value = self.table.pop(key, None)
        if not isinstance(value, str) or not value:
            raise self.error(f"{key} must be a text")
        return value

    def seconds(self, key: str, default: float | None = None) -> float:
        value = self.table.pop(key, default)
        if (
            isinstance(value, bool)
            or not isinstance(value, int | float)
            or value <= 0
        ):
            raise self.error(f"{key} must be a number of seconds above 0")
        return float(value)

    def count(self, key: str) -> int | None:
        value = self.table.pop(key, None)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, int) or value <= 0:
            raise self.error(f"{key} must be a whole number above 0")
        return value

    def command(self, key: str, required: bool = False) -> tuple[str, ...]:
        value = self.table.pop(key, None)
        if value is None and not required:
            return ()
        return self._command(key, value)

    def commands(self, key: str) -> tuple[tuple[str, ...], ...]:
        value = self.table.pop(key, [])
        if not isinstance(value, list):
            raise self.error(f"{key} must be a list of commands")
        return tuple(self._command(key, command) for command in value)

    def _command(self, key: str, value: object) -> tuple[str, ...]:
        words = value if isinstance(value, list) else []
        if not words or not all(isinstance(word, str) for word in words):
            raise self.error(f"{key} must be a command, a list of texts")
        for word in words:
            for name in LIST_PLACEHOLDERS:
                if "{" + name + "}" in word and word != "{" + name + "}":
                    raise self.error(
                        f"{key}: {{{name}}} must be an argument of its own"
                    )
        return tuple(words)

    def needs(self) -> tuple[Need, ...]:
        value = self.table.pop("needs", [])
        if not isinstance(value, list):
            raise self.error("needs must be tables [[needs]]")
        needs = []
        for entry in value:
            inner = _Reader(
                self.path, entry if isinstance(entry, dict) else {}
            )
            needs.append(Need(inner.text("command"), inner.text("install")))
            inner.no_more_keys()
        return tuple(needs)
