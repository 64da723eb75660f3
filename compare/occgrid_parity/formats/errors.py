"""What can be wrong with a file that a port wrote."""

from __future__ import annotations

from pathlib import Path

MAX_CELLS = 25_000_000


class OutputError(ValueError):
    """``FILE: line N: reason``, or ``FILE: reason`` where no line is at fault."""

    def __init__(
        self, path: Path, reason: str, line: int | None = None
    ) -> None:
        place = "" if line is None else f"line {line}: "
        super().__init__(f"{path.name}: {place}{reason}")
        self.path = path
        self.line = line
        self.reason = reason


def shown(data: bytes, limit: int = 40) -> str:
    """Bytes of a file as an error quotes them, shortened."""
    text = data[: limit + 1].decode("ascii", "backslashreplace")
    return repr(text if len(text) <= limit else text[:limit] + "...")
