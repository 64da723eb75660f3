"""The lines and scans of a CARMEN log, read without holding it."""

from __future__ import annotations

from collections.abc import Iterator

# the reader of a whole scenario wants its PARAM lines, which a bare log does not have;
# its scan lines are read by the same code here
from occgrid.scenario import ScenarioReader
from occgrid.sensor import Scan
from occgrid_parity.logs.conversion import Request

SCAN_KEYWORDS = (b"FLASER", b"ROBOTLASER1")
OURS = (b"WALL", b"POSE")


def log_scans(request: Request) -> Iterator[tuple[int, Scan | None]]:
    """Number and content of every scan; without content where it is not chosen."""
    reader = ScenarioReader(str(request.log))
    number = 0
    try:
        for keyword, raw in log_lines(request):
            reader.line += 1
            if keyword in OURS or _is_parameter(raw):
                reader.fail("this is a scenario already, not a log")
            if keyword not in SCAN_KEYWORDS:
                continue
            if not request.selection.holds(number):
                yield number, None
            else:
                line = raw.strip(b"\r\n\t ")
                if not all(byte == 9 or 32 <= byte < 127 for byte in line):
                    reader.fail("not plain ASCII text")
                values = line.decode("ascii").split()[1:]
                if keyword == b"FLASER":
                    yield number, reader.flaser(values)
                else:
                    yield number, reader.robotlaser1(values)
            number += 1
        if number == 0:
            reader.fail("no scan")
    finally:
        reader.close()


def log_lines(request: Request) -> Iterator[tuple[bytes, bytes]]:
    """Keyword (empty where there is none) and raw text of every line."""
    with request.log.open("rb") as file:
        for raw in file:
            words = raw[:80].split(maxsplit=1)
            yield (words[0] if words else b""), raw


def _is_parameter(raw: bytes) -> bool:
    words = raw[:200].split(maxsplit=2)
    return (
        len(words) > 1
        and words[0] == b"PARAM"
        and words[1].startswith(b"occgrid_")
    )
