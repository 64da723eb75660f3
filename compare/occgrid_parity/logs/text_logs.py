"""The lines of a text log: plain or gzip, with or without a byte-order mark."""

from __future__ import annotations

import gzip
import zlib
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

from occgrid_parity.logs.conversion import ConversionError

GZIP = b"\x1f\x8b"
BYTE_ORDER_MARK = b"\xef\xbb\xbf"
LONGEST_LINE = 1 << 24


def text_lines(path: Path) -> Iterator[bytes]:
    """Every line with its end. Whether the file is compressed is seen from its first bytes.

    Raises ConversionError where the file is no text or a compressed file is damaged, and OSError where
    it cannot be read.
    """
    with ExitStack() as stack:
        plain = stack.enter_context(path.open("rb"))
        compressed = plain.peek(2)[:2] == GZIP
        file = (
            stack.enter_context(gzip.open(plain, "rb"))
            if compressed
            else plain
        )
        number = 0
        try:
            while raw := file.readline(LONGEST_LINE):
                number += 1
                if len(raw) == LONGEST_LINE:
                    raise ConversionError(
                        f"{path}:{number}: a line of more than {LONGEST_LINE} bytes: not a text log"
                    )
                if number == 1:
                    raw = raw.removeprefix(BYTE_ORDER_MARK)
                yield raw
        except (EOFError, zlib.error, gzip.BadGzipFile) as error:
            raise ConversionError(
                f"{path}: the compressed file is damaged or cut off after line {number}"
            ) from error
