"""Settings in TOML files, read into records. What is wrong is told with the file, the key and what is expected."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Annotated, Any, TypeVar

import msgspec

R = TypeVar("R", bound=msgspec.Struct)

Text = Annotated[str, msgspec.Meta(min_length=1)]
Positive = Annotated[float, msgspec.Meta(gt=0)]
Count = Annotated[int, msgspec.Meta(ge=1)]

KINDS = {
    "float": "a number",
    "int": "a whole number",
    "str": "a text",
    "bool": "true or false",
    "array": "a list",
    "object": "a table",
}
"""What msgspec calls the kinds of values, and what a reader of the file calls them."""


class SettingsError(ValueError):
    """A TOML file that cannot be used; the text names the file and the key."""


class Table(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of a TOML file. A key that it does not have is an error."""


def read_toml(
    path: Path, problem: type[SettingsError] = SettingsError
) -> dict[str, Any]:
    """What is in a file. Raises ``problem`` where it cannot be read."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise problem(f"{path}: {error.strerror}") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise problem(f"{path}: {error}") from error


def read_record(
    path: Path, kind: type[R], problem: type[SettingsError] = SettingsError
) -> R:
    """The record that a file holds. Raises ``problem`` where it does not."""
    table = read_toml(path, problem)
    try:
        return msgspec.convert(table, kind)
    except msgspec.ValidationError as error:
        raise problem(f"{path}: {_plain(str(error))}") from error


def _plain(said: str) -> str:
    """An error of msgspec with the key first, in the words of the file."""
    what, _, place = said.partition(" - at `")
    place = place.removeprefix("key in ").removesuffix("`")
    key = place.removeprefix("$").removeprefix(".").replace("[...]", "")
    missing = re.fullmatch(r"Object missing required field `(.*)`", what)
    if missing:
        return f"{'.'.join(filter(None, [key, missing[1]]))} is missing"
    unknown = re.fullmatch(r"Object contains unknown field `(.*)`", what)
    if unknown:
        return f"unknown key {'.'.join(filter(None, [key, unknown[1]]))}"
    if not place:
        return what  # what a record has said about itself
    what = re.sub(r"`([a-z |]+)`", _kinds, what)
    what = what.replace(" of length >= 1", " that is not empty")
    what = what.removesuffix(".0")
    depth = place.count("[...]")
    where = f"{'an entry of ' * depth}{key}"
    return f"{where}: {what[0].lower()}{what[1:]}"


def _kinds(match: re.Match[str]) -> str:
    words = [word for word in match[1].split(" | ") if word != "null"]
    return " or ".join(KINDS.get(word, word) for word in words)
