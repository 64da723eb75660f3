"""Lines of a port's output, each within the length that its row can need."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

from occgrid_parity.formats.errors import MAX_CELLS, OutputError, shown


class LineReader:
    """Reads LF lines from a file and knows the number of the last one."""

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self.path = path
        self.file = file
        self.number = 0

    def error(self, reason: str) -> OutputError:
        """An error in the line that was read last."""
        return OutputError(self.path, reason, self.number)

    def line(self, limit: int, what: str) -> bytes:
        """The next line without its LF.

        Raises OutputError where the file ends before it or within it, and where the
        line is longer than ``limit`` bytes. ``what`` names it in the message.
        """
        self.number += 1
        data = self.file.readline(limit + 1)
        if not data:
            raise self.error(f"the file ends, expected {what}")
        if data.endswith(b"\n"):
            return data[:-1]
        if len(data) > limit:
            raise self.error(f"more than {limit} bytes, expected {what}")
        raise self.error(
            f"the file ends within the line {shown(data)}, expected LF"
        )

    def end(self) -> None:
        """Raises OutputError where the file does not end here."""
        data = self.file.readline(80)
        if data:
            self.number += 1
            raise self.error(
                f"expected the end of the file, found {shown(data)}"
            )

    def size(self, words: list[bytes], found: bytes) -> tuple[int, int]:
        """Width and height from two decimal words of the line."""
        if len(words) != 2 or not all(
            w.isdigit() and len(w) <= 8 for w in words
        ):
            raise self.error(
                f"expected a width and a height, found {shown(found)}"
            )
        width, height = int(words[0]), int(words[1])
        if [b"%d" % width, b"%d" % height] != words or 0 in (width, height):
            raise self.error(
                f"expected a width and a height, found {shown(found)}"
            )
        if width * height > MAX_CELLS:
            raise self.error(
                f"{width} x {height} is more than {MAX_CELLS} cells"
            )
        return width, height
