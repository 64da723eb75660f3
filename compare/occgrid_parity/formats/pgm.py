"""PGM pictures: strictly as SPEC section 7 writes them, or any valid P2 or P5."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from occgrid_parity.formats.errors import MAX_CELLS, OutputError, shown
from occgrid_parity.formats.text_lines import LineReader

Pixels = NDArray[np.uint16]
"""Shape (height, width), the top row of the picture (the largest y) first."""

HEADER_LIMIT = 80
HEADER_BYTES = 2**16
PIXEL = re.compile(rb"0|[1-9][0-9]{0,2}")


def read_pgm(path: Path) -> Pixels:
    """A picture that is written exactly as SPEC section 7 says.

    Raises OutputError at the first line that is not, and OSError where the file
    cannot be read.
    """
    with path.open("rb") as file:
        lines = LineReader(path, file)
        magic = lines.line(HEADER_LIMIT, "P2")
        if magic != b"P2":
            raise lines.error(f"expected P2, found {shown(magic)}")
        size = lines.line(HEADER_LIMIT, "the width and the height")
        width, height = lines.size(size.split(b" "), size)
        top = lines.line(HEADER_LIMIT, "255")
        if top != b"255":
            raise lines.error(f"expected 255, found {shown(top)}")
        pixels = np.empty((height, width), dtype=np.uint16)
        for row in range(height):
            line = lines.line(
                4 * width + HEADER_LIMIT, f"row {row + 1} of {height}"
            )
            pixels[row] = _row(line, width, lines)
        lines.end()
    return pixels


def _row(line: bytes, width: int, lines: LineReader) -> Pixels:
    words = line.split(b" ")
    if b"" in words:
        raise lines.error("pixels are not separated by one space each")
    if len(words) != width:
        raise lines.error(f"{len(words)} pixels, expected {width}")
    levels = {}
    for word in set(words):
        if not PIXEL.fullmatch(word) or int(word) > 255:
            column = words.index(word) + 1
            raise lines.error(
                f"pixel {column} is {shown(word)}, expected 0 to 255"
            )
        levels[word] = int(word)
    return np.fromiter(map(levels.__getitem__, words), np.uint16, width)


PLAIN = re.compile(rb"\s*(?:[0-9]{1,5}\s+)*(?:[0-9]{1,5})?")


def scaled(levels: NDArray[np.int64], top: int) -> Pixels:
    """Levels of 0 .. ``top`` as levels of 0 .. 255, rounded half up."""
    if top != 255:
        levels = (levels * 510 + top) // (2 * top)
    return levels.astype(np.uint16)


def read_any_pgm(path: Path) -> tuple[Pixels, int]:
    """Any valid P2 or P5 picture of 8 or 16 bits, comments included, and its maximum.

    Levels are scaled to 0 .. 255 where that is another. Raises OutputError where the file is no such picture, and
    OSError where it cannot be read.
    """
    limit = HEADER_BYTES + 8 * MAX_CELLS
    with path.open("rb") as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise OutputError(path, f"more than {limit} bytes")
    magic = data[:2]
    if magic not in (b"P2", b"P5"):
        raise OutputError(
            path, f"expected P2 or P5, found {shown(data[:2])}", 1
        )
    numbers, start = _header(path, data)
    width, height, top = numbers
    if not 0 < width * height <= MAX_CELLS:
        raise OutputError(
            path, f"{width} x {height} is not from 1 to {MAX_CELLS} cells"
        )
    if not 0 < top < 2**16:
        raise OutputError(path, f"the maximum {top} is not from 1 to 65535")
    if magic == b"P2":
        levels = _plain_levels(path, data, start, width * height)
    else:
        levels = _raw_levels(path, data, start, width * height, top)
    if int(levels.max()) > top:
        raise OutputError(path, f"a pixel is {int(levels.max())}, above {top}")
    return scaled(levels, top).reshape(height, width), top


def _header(path: Path, data: bytes) -> tuple[tuple[int, int, int], int]:
    """Width, height and maximum, and where the byte after them lies."""
    numbers: list[int] = []
    position = 2
    for what in ("width", "height", "maximum"):
        gap = re.compile(rb"(?:\s|#[^\n\r]*[\n\r])+").match(data, position)
        if gap is None:
            raise OutputError(path, f"expected white space before the {what}")
        number = re.compile(rb"[0-9]{1,9}").match(data, gap.end())
        if number is None:
            found = shown(data[gap.end() : gap.end() + 8])
            raise OutputError(path, f"expected the {what}, found {found}")
        numbers.append(int(number[0]))
        position = number.end()
    return (numbers[0], numbers[1], numbers[2]), position


def _plain_levels(
    path: Path, data: bytes, start: int, count: int
) -> NDArray[np.int64]:
    body = re.sub(rb"#[^\n\r]*", b"", data[start:])
    if PLAIN.fullmatch(body):
        levels = np.fromstring(body, dtype=np.int64, sep=" ")
        if levels.size >= count:
            return levels[:count]
    words = body.split()
    if len(words) < count:
        raise OutputError(path, f"{len(words)} pixels, expected {count}")
    for index, word in enumerate(words[:count]):
        if not word.isdigit() or len(word) > 5:
            raise OutputError(
                path, f"pixel {index + 1} is {shown(word)}, no number"
            )
    return np.array([int(word) for word in words[:count]], dtype=np.int64)


def _raw_levels(
    path: Path, data: bytes, start: int, count: int, top: int
) -> NDArray[np.int64]:
    kind = np.dtype(np.uint8) if top < 256 else np.dtype(">u2")
    body = data[start + 1 :]
    if data[start : start + 1] not in (b" ", b"\t", b"\n", b"\r"):
        raise OutputError(path, "expected one white space after the maximum")
    if len(body) < count * kind.itemsize:
        found = len(body) // kind.itemsize
        raise OutputError(path, f"{found} pixels, expected {count}")
    return np.frombuffer(body, dtype=kind, count=count).astype(np.int64)
