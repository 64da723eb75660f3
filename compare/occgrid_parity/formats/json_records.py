"""Records, which are dataclasses of plain data, to JSON and back."""

from __future__ import annotations

from typing import TypeVar

import msgspec

T = TypeVar("T")


def json_text(record: object) -> str:
    """A record as JSON text."""
    encoded = msgspec.json.encode(record)
    return msgspec.json.format(encoded, indent=1).decode() + "\n"


def record_from_json(kind: type[T], schema: int, text: str) -> T:
    """The record in JSON text. Raises ValueError where it is of another schema or not of that kind."""
    try:
        data = msgspec.json.decode(text)
        found = data.get("schema") if isinstance(data, dict) else None
        if found != schema:
            raise ValueError(
                f"a record of schema {found!r}, expected {schema}"
            )
        return msgspec.convert(data, kind)
    except msgspec.MsgspecError as error:
        raise ValueError(
            f"not a record of schema {schema}: {error}"
        ) from error
