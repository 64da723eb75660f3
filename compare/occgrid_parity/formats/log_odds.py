"""The log-odds file of SPEC section 7, read to the last bit."""

from __future__ import annotations

import hashlib
import re
import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from occgrid_parity.formats.errors import shown
from occgrid_parity.formats.text_lines import LineReader

LogOdds = NDArray[np.float64]
"""Shape (height, width), the row with the smallest y first."""

HEADER_LIMIT = 80
VALUE_BYTES = 40
MAX_DIGITS = 17
MARK = b"# logodds "
NUMBER = re.compile(
    rb"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
)
TOO_LONG = re.compile(rb"[1-9](?:[0-9.]{18}|[0-9]{17})")
"""Eighteen digits from the first that is not zero, with or without a point."""


def read_log_odds(path: Path) -> LogOdds:
    """The log-odds of every cell.

    Raises OutputError at the first line that is not as SPEC section 7 says, and
    OSError where the file cannot be read.
    """
    with path.open("rb") as file:
        lines = LineReader(path, file)
        head = lines.line(HEADER_LIMIT, "# logodds WIDTH HEIGHT")
        if not head.startswith(MARK):
            raise lines.error(
                f"expected # logodds WIDTH HEIGHT, found {shown(head)}"
            )
        width, height = lines.size(head.removeprefix(MARK).split(b" "), head)
        log_odds = np.empty((height, width), dtype=np.float64)
        for row in range(height):
            line = lines.line(
                VALUE_BYTES * width, f"row {row + 1} of {height}"
            )
            log_odds[row] = _row(line, width, lines)
        lines.end()
    return log_odds


def _row(line: bytes, width: int, lines: LineReader) -> LogOdds:
    """The values of one line: quickly, and where that fails, word by word."""
    words_fit = (
        line.count(b" ") == width - 1 and b"  " not in b" " + line + b" "
    )
    if words_fit and not line.translate(None, b"0123456789.eE+- "):
        with warnings.catch_warnings():
            warnings.simplefilter("error", DeprecationWarning)
            try:
                values = np.fromstring(
                    line.decode("ascii"), dtype=np.float64, sep=" "
                )
            except (DeprecationWarning, ValueError):
                values = np.empty(0)
        good = values.size == width and bool(np.isfinite(values).all())
        if good and not TOO_LONG.search(line):
            return values
    _explain(line, width, lines)
    return np.array(
        [float(word) for word in line.split(b" ")], dtype=np.float64
    )


def _explain(line: bytes, width: int, lines: LineReader) -> None:
    """Raises OutputError for what is wrong with a line, if anything is."""
    words = line.split(b" ")
    if b"" in words:
        raise lines.error("values are not separated by one space each")
    if len(words) != width:
        raise lines.error(f"{len(words)} values, expected {width}")
    for column, word in enumerate(words, 1):
        if not NUMBER.fullmatch(word):
            raise lines.error(
                f"value {column} is {shown(word)}, expected a decimal"
            )
        digits = re.split(rb"[eE]", word.lstrip(b"+-"))[0].replace(b".", b"")
        if len(digits.lstrip(b"0")) > MAX_DIGITS:
            raise lines.error(
                f"value {column} is {shown(word)}, more than {MAX_DIGITS} digits"
            )
        if not np.isfinite(float(word)):
            raise lines.error(f"value {column} is {shown(word)}, not finite")


def bits(log_odds: LogOdds) -> NDArray[np.uint64]:
    """The same array as its bit patterns."""
    return np.ascontiguousarray(log_odds).view(np.uint64)


def hash_log_odds(log_odds: LogOdds) -> str:
    """SHA-256 of the values as little-endian doubles, row by row, smallest y first."""
    data = np.ascontiguousarray(log_odds, dtype="<f8")
    return hashlib.sha256(data.tobytes()).hexdigest()
