"""Records, which are dataclasses of plain data, to JSON and back."""

from __future__ import annotations

import dataclasses
import json
import types
import typing
from typing import Any


def json_text(record: Any) -> str:
    """A record as JSON text."""
    return json.dumps(dataclasses.asdict(record), indent=1) + "\n"


def from_plain(kind: Any, data: Any) -> Any:
    """Plain JSON data as a value of the annotated type."""
    if dataclasses.is_dataclass(kind) and isinstance(kind, type):
        hints = typing.get_type_hints(kind)
        return kind(
            **{
                key: from_plain(hints[key], value)
                for key, value in data.items()
            }
        )
    origin, arguments = typing.get_origin(kind), typing.get_args(kind)
    if origin is list:
        return [from_plain(arguments[0], item) for item in data]
    if origin is types.UnionType and data is not None:
        return from_plain(arguments[0], data)
    return data
