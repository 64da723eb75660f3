"""The scans of a CARMEN log."""

from __future__ import annotations

from collections.abc import Iterator

# the reader of a whole scenario wants its PARAM lines, which a bare log does not have;
# its scan lines are read by the same code here
from occgrid.scenario import ScenarioError, ScenarioReader
from occgrid.sensor import Scan
from occgrid_parity.logs.conversion import MAX_RANGE, Entry, Request
from occgrid_parity.logs.keywords import FLASER, TAKEN, KeywordCounts
from occgrid_parity.logs.text_logs import text_lines

OURS = (b"WALL", b"POSE")
SCANS = tuple(keyword.encode("ascii") for keyword in TAKEN)
POSE_FIELDS = 3
FLASER_FIELDS = 9
"""After the ranges: the pose, and six that the contract wants and nobody looks at."""


class CarmenLog:
    """A CARMEN log as a Source."""

    def __init__(self, request: Request) -> None:
        self.request = request
        self.max_range = request.max_range or MAX_RANGE
        self.keywords = KeywordCounts()
        self.scans = 0
        self.filled = 0
        self.cut_off = ""

    def entries(self) -> Iterator[Entry]:
        """The chosen scans, and the other lines on request."""
        reader = ScenarioReader(str(self.request.log))
        try:
            for raw in text_lines(self.request.log):
                reader.line += 1
                entry = self._entry(reader, raw)
                if entry is not None:
                    yield entry
            if self.scans == 0:
                reader.fail(self.keywords.no_scan())
        finally:
            reader.close()

    def total(self) -> int:
        """How many scans it has."""
        return self.scans

    def notes(self) -> list[str]:
        """Which keywords were taken."""
        return [self.keywords.note()]

    def warnings(self) -> list[str]:
        """Lines that were mended or skipped."""
        said = []
        if self.filled:
            said.append(
                f"{self.filled:,} FLASER with fewer than {FLASER_FIELDS} values after the ranges: "
                "the first three are taken as the pose"
            )
        if self.cut_off:
            said.append(
                f"the last line is cut off and skipped: {self.cut_off}"
            )
        return said

    def _entry(self, reader: ScenarioReader, raw: bytes) -> Entry | None:
        """What a line gives."""
        words = raw[:80].split(maxsplit=1)
        keyword = words[0] if words else b""
        if keyword in OURS or _is_parameter(raw):
            reader.fail("this is a scenario already, not a log")
        if keyword not in SCANS:
            self.keywords.add(keyword)
            if not self.request.all_lines:
                return None
            return Entry(raw.rstrip(b"\r\n"), None)
        number = self.scans
        chosen = self.request.selection.holds(number)
        try:
            entry = self._scan(reader, keyword, raw) if chosen else None
        except ScenarioError as error:
            if raw.endswith(b"\n"):
                raise
            self.cut_off = error.reason
            return None
        self.keywords.add(keyword)
        self.scans += 1
        return entry

    def _scan(
        self, reader: ScenarioReader, keyword: bytes, raw: bytes
    ) -> Entry:
        """A scan, its line filled up where the log leaves out what nobody looks at."""
        line = raw.strip(b"\r\n\t ")
        if (
            not line.isascii()
            or not line.replace(b"\t", b" ").decode("ascii").isprintable()
        ):
            reader.fail("not plain ASCII text")
        values = line.decode("ascii").split()[1:]
        scan: Scan
        if keyword == FLASER.encode("ascii"):
            missing = _missing_fields(values)
            if missing and raw.endswith(b"\n"):
                values += missing * ["0"]
                line += missing * b" 0"
                self.filled += 1
            scan = reader.flaser(values)
        else:
            scan = reader.robotlaser1(values)
        return Entry(line, scan)


def _missing_fields(values: list[str]) -> int:
    """How many of the six last fields a FLASER lacks, if it has its ranges and its pose."""
    if not values or not values[0].isdigit() or len(values[0]) > 6:
        return 0
    after = len(values) - 1 - int(values[0])
    return FLASER_FIELDS - after if POSE_FIELDS <= after < FLASER_FIELDS else 0


def _is_parameter(raw: bytes) -> bool:
    words = raw[:200].split(maxsplit=2)
    return (
        len(words) > 1
        and words[0] == b"PARAM"
        and words[1].startswith(b"occgrid_")
    )
