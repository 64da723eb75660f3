"""Reading a scenario: a CARMEN log with PARAM, WALL and POSE lines (SPEC.md sections 5 and 8)."""

from __future__ import annotations

import itertools
import math
import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Literal, NamedTuple, NoReturn, Self

import numpy as np
import numpy.typing as npt

from occgrid import sensor
from occgrid.grid import GridSpec, OccupancyGrid, logit
from occgrid.portable_math import pi
from occgrid.sensor import Scan, flaser_angles
from occgrid.world import Pose, Segment

MAX_CELLS = 25_000_000
MAX_RANGE_CELLS = 1_000_000
MAX_BEAMS = 100_000


@dataclass(frozen=True)
class Settings:
    """What the PARAM lines set: metres, radians, probabilities, log-odds; the table of SPEC.md section 5.2."""

    width: int
    height: int
    resolution: float
    origin_x: float
    origin_y: float
    max_range: float
    min_range: float = 0.0  # the reader gives NaN for recorded ranges below it
    p0: float = 0.5
    p_occ: float = 0.75
    p_free: float = 0.30
    l_min: float = -8.0
    l_max: float = 8.0
    no_return: sensor.NoReturn = "free"
    fov: float = pi
    beams: int = 181
    noise_std: float = 0.02

    def new_grid(self) -> OccupancyGrid:
        """An empty map."""
        spec = GridSpec(
            self.width,
            self.height,
            self.resolution,
            self.origin_x,
            self.origin_y,
        )
        return OccupancyGrid(
            spec, self.p0, self.p_occ, self.p_free, self.l_min, self.l_max
        )


class Scenario:
    """Settings, walls and scans: all that a map is made of.

    ``scans`` gives a Pose for a simulated scan and a Scan for a recorded one. Going through it starts from the first
    scan each time, so a scenario can be mapped again. Those of a file are read one by one as they are asked for, within
    the ``with`` statement; that raises ScenarioError for a line that breaks a rule, and where a second pass is asked
    for of a file that cannot go back, such as a pipe.
    """

    def __init__(
        self,
        name: str,
        settings: Settings,
        walls: list[Segment],
        scans: Iterable[Pose | Scan],
        file: BinaryIO | None = None,
    ) -> None:
        self.name = name
        self.settings = settings
        self.walls = walls
        # a bare iterator could be gone through only once
        self.scans = list(scans) if isinstance(scans, Iterator) else scans
        self._file = file

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._file is not None:
            self._file.close()


class ScenarioError(Exception):
    """A scenario that breaks a rule; its text is ``FILE:LINE: REASON``."""

    def __init__(self, file: str, line: int, reason: str) -> None:
        super().__init__(f"{on_one_line(file)}:{line}: {reason}")
        self.line = line
        self.reason = reason


def read_scenario(path: str | Path) -> Scenario:
    """Open a scenario and read it up to its first scan.

    Use it in a ``with`` statement: the file stays open while scans are read. Raises ScenarioError here for what is
    wrong before the first scan, and while going through the scans for what is wrong later.
    """
    reader = ScenarioReader(str(path))
    try:
        return reader.read()
    except BaseException:
        reader.close()
        raise


def scenario_name(path: str | Path) -> str:
    """A scenario's name: its file name without the part from its last dot on."""
    separators = "/\\" if os.name == "nt" else "/"
    file_name = re.split(f"[{separators}]", str(path).rstrip(separators))[-1]
    dot = file_name.rfind(".")
    return file_name[:dot] if dot > 0 else file_name


def on_one_line(path: str) -> str:
    """A path as error messages show it: control characters as ?, so that a message is one line."""
    return re.sub("[\x00-\x1f\x7f]", "?", path)


class Parameter(NamedTuple):
    """A row of the table of parameters: name, kind, limits as they are printed."""

    name: str
    kind: Literal["whole", "real", "probability", "no_return"]
    low: str = ""
    high: str = ""


COORDINATE = ("-10000000", "10000000")
ANGLE = ("-1000000", "1000000")

PARAMETERS = {
    row.name: row
    for row in (
        Parameter("width", "whole", "1", "25000000"),
        Parameter("height", "whole", "1", "25000000"),
        Parameter("resolution", "real", "0.001", "1000"),
        Parameter("origin_x", "real", *COORDINATE),
        Parameter("origin_y", "real", *COORDINATE),
        Parameter("max_range", "real", "0.001", "10000"),
        Parameter("min_range", "real", "0", "10000"),
        Parameter("p0", "probability"),
        Parameter("p_occ", "probability"),
        Parameter("p_free", "probability"),
        Parameter("l_min", "real", "-1000", "1000"),
        Parameter("l_max", "real", "-1000", "1000"),
        Parameter("no_return", "no_return"),
        Parameter("fov", "real", "0", "6.283185307179586"),
        Parameter("beams", "whole", "1", "100000"),
        Parameter("noise_std", "real", "0", "1000"),
    )
}
REQUIRED = (
    "width",
    "height",
    "resolution",
    "origin_x",
    "origin_y",
    "max_range",
)
SCAN_KEYWORDS = ("POSE", "FLASER", "ROBOTLASER1")

_KEYWORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_WHOLE = re.compile(r"[0-9]+")
_NOT_PLAIN = re.compile(rb"[^\t\x20-\x7e]")
_DECIMAL_CHARACTERS = str.maketrans("", "", "0123456789+-.eE")
_WORDS = {"nan", "inf", "infinity"}


class ScenarioReader:
    """Goes through a file line by line; ``line`` is the number of the last one read."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.line = 0
        self.offset = 0  # in the file, where the next line begins
        if file.endswith("/"):  # a folder; pathlib would drop the slash
            self.fail("cannot be read")
        try:
            self.stream = Path(file).open("rb")
        except (OSError, ValueError):  # ValueError: NUL in the name
            self.fail("cannot be read")
        self.values: dict[str, int | float | str] = {}
        self.lines: dict[str, int] = {}
        self.walls: list[Segment] = []
        self.min_range = 0.0

    def close(self) -> None:
        """Closes the file."""
        self.stream.close()

    def fail(self, reason: str, line: int | None = None) -> NoReturn:
        """Raises ScenarioError, for the line read last where none is named."""
        raise ScenarioError(
            self.file, self.line if line is None else line, reason
        )

    def fields(self) -> Iterator[list[str]]:
        """Fields of the lines that are neither blank nor comments."""
        while True:
            try:
                line = self.stream.readline()
            except OSError:
                self.fail("cannot be read")
            if not line:
                return
            self.line += 1
            self.offset += len(line)
            line = line.removesuffix(b"\n").removesuffix(b"\r").strip(b" \t")
            if not line or line.startswith(b"#"):
                continue
            if _NOT_PLAIN.search(line):
                self.fail("not plain ASCII text")
            fields = line.decode("ascii").split()
            if not _KEYWORD.fullmatch(fields[0]):
                self.fail(f"'{fields[0]}' is not a keyword")
            yield fields

    def go_back(self, line: int, offset: int) -> None:
        """Go on reading after a line that was read before."""
        try:
            self.stream.seek(offset)
        except OSError:  # a pipe, for instance
            self.fail("cannot be read a second time", line=0)
        self.line, self.offset = line, offset

    def read(self) -> Scenario:
        """The settings and walls, up to the first scan."""
        for keyword, *values in self.fields():
            if keyword in SCAN_KEYWORDS:
                return Scenario(
                    scenario_name(self.file),
                    self.settings(),
                    self.walls,
                    _Recording(self, [keyword, *values]),
                    self.stream,
                )
            if (
                keyword == "PARAM"
                and values
                and values[0].startswith("occgrid_")
            ):
                self.parameter(_without_comment(values))
            elif keyword == "WALL":
                values = self.expect("WALL", 4, _without_comment(values))
                self.walls.append(self.wall(values))
        self.fail("no scan")

    def scans(self, lines: Iterable[list[str]]) -> Iterator[Pose | Scan]:
        """The scans among these lines."""
        for keyword, *values in lines:
            if keyword == "POSE":
                values = self.expect("POSE", 3, _without_comment(values))
                yield self.pose(values)
            elif keyword == "FLASER":
                yield self.flaser(values)
            elif keyword == "ROBOTLASER1":
                yield self.robotlaser1(values)
            elif keyword == "WALL" or (
                keyword == "PARAM"
                and values
                and values[0].startswith("occgrid_")
            ):
                self.fail(f"{keyword} must stand before the first scan")

    # --- PARAM ---

    def parameter(self, values: list[str]) -> None:
        """One PARAM line of ours."""
        name, token = self.expect("PARAM", 2, values)
        row = PARAMETERS.get(name.removeprefix("occgrid_"))
        if row is None:
            self.fail(f"unknown parameter {name}")
        if row.name in self.values:
            self.fail(f"{name} is given twice")
        value: int | float | str
        match row.kind:
            case "whole":
                value = self.whole(name, token, row.low, row.high)
            case "real":
                value = self.real(name, token, row.low, row.high)
            case "probability":
                value = self.number(name, token)
                if not 0.0 < value < 1.0:
                    self.fail(f"{name} '{token}' is not between 0 and 1")
            case "no_return":
                value = token
                if token not in ("free", "ignore"):
                    self.fail(f"{name} '{token}' is not free or ignore")
        self.values[row.name] = value
        self.lines[row.name] = self.line

    def settings(self) -> Settings:
        """The parameters as a whole, checked together."""
        for name in REQUIRED:
            if name not in self.values:
                self.fail(f"occgrid_{name} is missing")
        settings = Settings(**self.values)  # type: ignore[arg-type]
        if settings.width * settings.height > MAX_CELLS:
            self.fail(
                f"the grid has more than {MAX_CELLS} cells",
                self.latest("width", "height"),
            )
        if settings.max_range / settings.resolution > MAX_RANGE_CELLS:
            self.fail(
                f"occgrid_max_range is more than {MAX_RANGE_CELLS} cells",
                self.latest("max_range", "resolution"),
            )
        if not settings.l_min < settings.l_max:
            self.fail(
                "occgrid_l_min is not below occgrid_l_max",
                self.latest("l_min", "l_max"),
            )
        if not settings.l_min <= logit(settings.p0) <= settings.l_max:
            reason = (
                "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max"
            )
            self.fail(reason, self.latest("p0", "l_min", "l_max"))
        if not settings.min_range < settings.max_range:
            self.fail(
                "occgrid_min_range is not below occgrid_max_range",
                self.latest("min_range", "max_range"),
            )
        self.min_range = settings.min_range
        return settings

    def latest(self, *names: str) -> int:
        """The latest of the lines of these parameters."""
        return max(self.lines.get(name, 0) for name in names)

    # --- WALL ---

    def wall(self, values: list[str]) -> Segment:
        """x0, y0, x1 and y1."""
        fields = zip(("x0", "y0", "x1", "y1"), values, strict=True)
        return Segment(
            *(self.real(name, token, *COORDINATE) for name, token in fields)
        )

    # --- scans ---

    def flaser(self, values: list[str]) -> Scan:
        """FLASER n r1 .. rn x y theta and six fields that are not looked at."""
        if not values:
            self.fail("FLASER has no beam count")
        n = self.whole("beam count", values[0], "1", str(MAX_BEAMS))
        if len(values) != n + 10:
            self.fail(
                f"FLASER with {n} beams takes {n + 10} values, found {len(values)}"
            )
        ranges = self.ranges(values[1 : n + 1])
        return Scan(self.pose(values[n + 1 : n + 4]), flaser_angles(n), ranges)

    def robotlaser1(self, values: list[str]) -> Scan:
        """ROBOTLASER1 type start fov step max accuracy mode n r1 .. rn m e1 .. em x y theta and eleven fields."""
        found = len(values)
        if found < 8:
            self.fail("ROBOTLASER1 has no beam count")
        n = self.whole("beam count", values[7], "1", str(MAX_BEAMS))
        if found < n + 23:
            self.fail(
                f"ROBOTLASER1 with {n} beams takes at least {n + 23} values, found {found}"
            )
        m = self.whole("remission count", values[n + 8], "0", str(MAX_BEAMS))
        if found != n + m + 23:
            self.fail(
                f"ROBOTLASER1 with {n} beams and {m} remissions takes {n + m + 23} values, found {found}"
            )
        start = self.real("start", values[1], *ANGLE)
        step = self.real("step", values[3], *ANGLE)
        ranges = self.ranges(values[8 : n + 8])
        pose = self.pose(values[n + m + 9 : n + m + 12])
        return Scan(
            pose, start + np.arange(n, dtype=np.float64) * step, ranges
        )

    def pose(self, values: list[str]) -> Pose:
        """x, y and theta."""
        x = self.real("x", values[0], *COORDINATE)
        y = self.real("y", values[1], *COORDINATE)
        return Pose(x, y, self.real("theta", values[2], *ANGLE))

    def ranges(self, tokens: list[str]) -> npt.NDArray[np.float64]:
        """Ranges in metres, (n,), NaN and infinity among them; those below min_range are NaN, which is ignored."""
        try:
            # NumPy reads text as float() does, which takes more than our numbers where other letters stand
            if "".join(tokens).translate(_DECIMAL_CHARACTERS):
                raise ValueError
            values = np.array(tokens, dtype=np.float64)
            if not (values > 1e-300).all() or not (values < 1e300).all():
                raise ValueError
        except ValueError:  # something unusual: look at them one by one
            values = np.array(
                [self.range(i, token) for i, token in enumerate(tokens)]
            )
        values[values < self.min_range] = np.nan
        return values

    def range(self, beam: int, token: str) -> float:
        """One range."""
        value = self.number(f"range {beam}", token)
        if value < 0.0:
            self.fail(f"range {beam} '{token}' is negative")
        return value

    # --- values ---

    def expect(self, keyword: str, count: int, values: list[str]) -> list[str]:
        """The values, if there are so many."""
        if len(values) != count:
            self.fail(f"{keyword} takes {count} values, found {len(values)}")
        return values

    def number(self, field: str, token: str) -> float:
        """A number, NaN and infinity included (SPEC.md section 5.1)."""
        if not token.translate(_DECIMAL_CHARACTERS):
            try:
                value = float(token)
            except ValueError:
                self.fail(f"{field} '{token}' is not a number")
        elif token.removeprefix("-").removeprefix(
            "+"
        ).lower() in _WORDS and token[:2] not in ("-+", "+-"):
            value = float(token)
        else:
            self.fail(f"{field} '{token}' is not a number")
        if abs(value) >= 1e300:
            return math.copysign(math.inf, value)
        return 0.0 if abs(value) < 1e-300 else value

    def real(self, field: str, token: str, low: str, high: str) -> float:
        """A number within limits."""
        value = self.number(field, token)
        if not float(low) <= value <= float(high):
            self.fail(f"{field} '{token}' is not from {low} to {high}")
        return value

    def whole(self, field: str, token: str, low: str, high: str) -> int:
        """A whole number within limits."""
        if not _WHOLE.fullmatch(token):
            self.fail(f"{field} '{token}' is not a whole number")
        # as a double: Python refuses to turn thousands of digits into an integer
        value = float(token)
        if not float(low) <= value <= float(high):
            self.fail(f"{field} '{token}' is not from {low} to {high}")
        return int(value)


class _Recording:
    """The scans of a file, each time from the first one."""

    def __init__(self, reader: ScenarioReader, first: list[str]) -> None:
        self._reader = reader
        self._first = first  # the fields of the first scan's line
        self._start = reader.line, reader.offset
        self._turn = 0

    def __iter__(self) -> Iterator[Pose | Scan]:
        self._turn += 1
        turn = self._turn
        if turn > 1:
            self._reader.go_back(*self._start)
        lines = itertools.chain([self._first], self._reader.fields())
        for scan in self._reader.scans(lines):
            yield scan
            if turn != self._turn:
                raise RuntimeError("the scans are gone through anew elsewhere")


def _without_comment(values: list[str]) -> list[str]:
    """The fields before one that begins with #."""
    return next(
        (
            values[:i]
            for i, value in enumerate(values)
            if value.startswith("#")
        ),
        values,
    )
