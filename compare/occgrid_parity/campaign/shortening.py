"""The least of a scenario that still shows what the whole one shows.

Delta debugging (Zeller and Hildebrandt 2002): parts are left out for as long as the rest still shows it, first scans,
then the ranges of each scan, walls, and parameters that have defaults. Whatever is left is a scenario of its
own; that it maps the same beams as before is not asked. Many shorter scenarios are tried at a time, for programs that
take many.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeVar

from occgrid.scenario import REQUIRED
from occgrid_parity.campaign.judging import valid
from occgrid_parity.suite.cases import Case

T = TypeVar("T")
Fields = list[str]
Lines = list[Fields]

Shows = Callable[[Sequence[Case]], list[bool]]
"""shows(cases): which of the scenarios, all of them valid, still show it."""

POSE, FLASER, ROBOTLASER1 = "POSE", "FLASER", "ROBOTLASER1"
BEFORE_RANGES = {FLASER: 1, ROBOTLASER1: 8}
"""Where the count of ranges stands in a line."""
FEW_BEAMS = (1, 2, 3, 5, 10)


def shortened(case: Case, shows: Shows) -> Case:
    """The scenario without what is not needed; the scenario itself where nothing can be left out."""
    search = _Search(case, shows)
    search.leave_out_lines()
    search.leave_out_ranges()
    search.leave_out_beams()
    search.leave_out_lines()
    search.write_plainly()
    return search.case


class _Search:
    """A scenario that gets shorter."""

    def __init__(self, case: Case, shows: Shows) -> None:
        self.case = case
        self.shows = shows
        lines = [
            line.split() for line in case.data.decode("ascii").splitlines()
        ]
        self.lines = lines
        counted = [_without_comment(line) for line in lines if _counts(line)]
        self.accept([counted])

    def accept(self, drafts: Sequence[Lines]) -> int | None:
        """Takes the first of the drafts that still shows it; its index, None where none does."""
        cases = [Case(self.case.name, _text(draft)) for draft in drafts]
        good = [number for number, one in enumerate(cases) if valid(one)]
        shown = self.shows([cases[number] for number in good])
        for number, is_shown in zip(good, shown, strict=True):
            if is_shown:
                self.lines, self.case = drafts[number], cases[number]
                return number
        return None

    def leave_out_lines(self) -> None:
        """Scans, then walls, then parameters."""
        for kind in (_is_scan, _is_wall, _is_optional):
            some = [line for line in self.lines if kind(line)]
            self.fewest(some, self._with_lines)

    def _with_lines(self, every: Sequence[Fields], kept: Lines) -> Lines:
        left_out = {id(line) for line in every}
        left_out -= {id(line) for line in kept}
        return [line for line in self.lines if id(line) not in left_out]

    def leave_out_ranges(self) -> None:
        """The ranges of recorded scans, one scan after the other."""
        for at in range(len(self.lines)):
            if self.lines[at][0] not in BEFORE_RANGES:
                continue
            head, ranges, tail = _parts(self.lines[at])

            def draft(
                _: Sequence[str],
                kept: Sequence[str],
                at: int = at,
                head: Fields = head,
                tail: Fields = tail,
            ) -> Lines:
                line = [*head, str(len(kept)), *kept, *tail]
                return [*self.lines[:at], line, *self.lines[at + 1 :]]

            self.fewest(ranges, draft)

    def leave_out_beams(self) -> None:
        """Fewer beams in simulated scans."""
        if not any(line[0] == POSE for line in self.lines):
            return
        name = "occgrid_beams"
        others = [line for line in self.lines if line[1] != name]
        given = [int(x[2]) for x in self.lines if x[1] == name]
        most = given[0] if given else math.inf
        self.accept(
            [
                [["PARAM", name, str(count)], *others]
                for count in FEW_BEAMS
                if count < most
            ]
        )

    def write_plainly(self) -> None:
        """Numbers written in the shortest way, if how they are written does not matter."""
        self.accept([[list(map(_plain, line)) for line in self.lines]])

    def fewest(
        self,
        items: Sequence[T],
        draft: Callable[[Sequence[T], list[T]], Lines],
    ) -> None:
        """Leaves out items. ``draft(items, kept)`` is the scenario with those that are kept."""
        left = list(items)
        parts = 1
        while left:
            size = math.ceil(len(left) / parts)
            kept = [
                left[:start] + left[start + size :]
                for start in range(0, len(left), size)
            ]
            found = self.accept([draft(left, one) for one in kept])
            if found is not None:
                left = kept[found]
                parts = max(parts - 1, 1)
            elif size == 1:
                return
            else:
                parts = min(2 * parts, len(left))


def _counts(line: Fields) -> bool:
    """Whether a line means anything to a mapper."""
    return _is_scan(line) or _is_wall(line) or _is_parameter(line)


def _is_scan(line: Fields) -> bool:
    return line[:1] in ([POSE], [FLASER], [ROBOTLASER1])


def _is_wall(line: Fields) -> bool:
    return line[:1] == ["WALL"]


def _is_parameter(line: Fields) -> bool:
    return line[:1] == ["PARAM"] and line[1].startswith("occgrid_")


def _is_optional(line: Fields) -> bool:
    name = line[1].removeprefix("occgrid_") if len(line) > 1 else ""
    return _is_parameter(line) and name not in REQUIRED


def _without_comment(line: Fields) -> Fields:
    if line[0] in BEFORE_RANGES:
        return line
    comments = [i for i, field in enumerate(line) if field.startswith("#")]
    return line[: comments[0]] if comments else line


def _parts(line: Fields) -> tuple[Fields, Fields, Fields]:
    """A recorded scan before the count of its ranges, the ranges, and what is after them, without remissions."""
    at = BEFORE_RANGES[line[0]]
    count = int(line[at])
    head, ranges = line[:at], line[at + 1 : at + 1 + count]
    tail = line[at + 1 + count :]
    if line[0] == ROBOTLASER1:
        tail = ["0", *tail[1 + int(tail[0]) :]]
    return head, ranges, tail


def _plain(word: str) -> str:
    """A number written in the shortest way; any other word as it is."""
    if word.isdigit():
        return str(int(word))
    try:
        value = float(word)
    except ValueError:
        return word
    return repr(value).removesuffix(".0") if math.isfinite(value) else word


def _text(lines: Lines) -> bytes:
    return "".join(" ".join(line) + "\n" for line in lines).encode("ascii")
