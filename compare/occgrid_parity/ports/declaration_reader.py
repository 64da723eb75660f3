"""Takes the keys of a port.toml out of its table, and says what is wrong with them."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.processes.process_group import search_path

LIST_PLACEHOLDERS = ("mode", "scenario", "scenarios")


class PortError(ValueError):
    """A declaration that cannot be used; the text names the file and the key."""


@dataclass(frozen=True)
class Need:
    """Commands of which one must be on the PATH, and the package that brings one."""

    commands: tuple[str, ...]
    install: str

    def is_missing(self) -> bool:
        """Whether none of the commands is there."""
        path = search_path()
        return all(
            shutil.which(command, path=path) is None
            for command in self.commands
        )


class DeclarationReader:
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

    def alternatives(self, key: str) -> tuple[str, ...]:
        """A text, or a list of texts of which one is enough."""
        value = self.table.get(key)
        if not isinstance(value, list):
            return (self.text(key),)
        del self.table[key]
        if not value or not all(isinstance(x, str) and x for x in value):
            raise self.error(f"{key} must be a text or a list of texts")
        return tuple(value)

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
            inner = DeclarationReader(
                self.path, entry if isinstance(entry, dict) else {}
            )
            needs.append(
                Need(inner.alternatives("command"), inner.text("install"))
            )
            inner.no_more_keys()
        return tuple(needs)
