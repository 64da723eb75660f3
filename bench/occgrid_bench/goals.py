"""What was aimed at, and whether it was reached."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import median

from occgrid_bench.contestants import REFERENCE
from occgrid_bench.record import Part, Series
from occgrid_bench.statistics import ratio


@dataclass(frozen=True)
class Goal:
    """One aim: a figure, and the bound that it has to keep."""

    text: str
    value: float
    bound: float
    at_least: bool
    command: str  # measures it anew

    @property
    def met(self) -> bool:
        if self.at_least:
            return self.value >= self.bound
        return self.value <= self.bound


def goals(parts: Mapping[str, Part]) -> list[Goal]:
    """The goals that the parts say something about."""
    found = []
    if "lesson" in parts:
        found += _lesson_goals(parts["lesson"])
    if "open" in parts:
        part = parts["open"]
        text = "C++ on a grid that holds every beam: times as fast as MRPT"
        found += _speeds(part, [(text, "cpp", "mrpt", 1.0)])
    if "commands" in parts:
        part = parts["commands"]
        woxi = part.find("mathematica")
        if woxi is not None:
            text = "Wolfram on woxi: seconds for the lesson, all included"
            found.append(Goal(text, woxi.median, 20.0, False, part.command))
    if "threads" in parts:
        part = parts["threads"]
        for name, title in (("cpp", "C++"), ("java", "Java")):
            text = f"{title}, two threads: times as fast as one"
            found += _speeds(part, [(text, f"{name}-2", f"{name}-1", 1.6)])
    if "long" in parts:
        found += _memory_goals(parts["long"])
    return found


def _lesson_goals(part: Part) -> list[Goal]:
    quicker = min(
        ("octomap", "octomap-rays"),
        key=lambda name: s.median if (s := part.find(name)) else math.inf,
    )
    found = _speeds(
        part,
        [
            ("C++: times as fast as the lesson's C++", "cpp", REFERENCE, 6.0),
            ("C++: times as fast as MRPT", "cpp", "mrpt", 1.0),
            (
                "Java, warm: times as fast as the lesson's Java",
                "java",
                "lesson-java",
                4.0,
            ),
            (
                "NumPy, whole log: times as fast as the lesson's Python",
                "python",
                "lesson-python",
                15.0,
            ),
            (
                "NumPy, per scan: times as fast as the lesson's Python",
                "python-scan",
                "lesson-python",
                4.5,
            ),
            (
                "NumPy, whole log: times as fast as OctoMap in C++",
                "python",
                quicker,
                1.0,
            ),
            (
                "Octave, whole log: times as fast as the lesson's Octave",
                "octave",
                "lesson-octave",
                75.0,
            ),
        ],
    )
    for text, name, other, bound in (
        (
            "C++, plain: time over the lesson's algorithm",
            "cpp-plain",
            REFERENCE,
            1.0,
        ),
        (
            "Java, warm, plain: time over the lesson's algorithm",
            "java-plain",
            "lesson-java",
            1.0,
        ),
        (
            "NumPy, plain: time over the lesson's algorithm",
            "python-plain",
            "lesson-python",
            1.3,
        ),
        (
            "Octave, plain: time over the lesson's algorithm",
            "octave-plain",
            "lesson-octave",
            1.0,
        ),
        ("Java, warm: time over the C++ port's", "java", "cpp", 1.5),
    ):
        value = _times(part.find(other), part.find(name))
        if value is not None:
            found.append(Goal(text, value, bound, False, part.command))
    cpp = part.find("cpp")
    updates, ends = part.find("floor-list"), part.find("floor-ends")
    if cpp and updates and ends:
        both = [
            a + b for a, b in zip(updates.seconds, ends.seconds, strict=True)
        ]
        text = "C++: time over the floor's"
        over_floor = ratio(cpp.seconds, both)
        found.append(Goal(text, over_floor, 1.5, False, part.command))
    return found


def _speeds(
    part: Part, pairs: Sequence[tuple[str, str, str, float]]
) -> list[Goal]:
    """Goals from text, a contestant, the one that it is held against, and how many times as fast it has to be."""
    found = []
    for text, name, other, bound in pairs:
        value = _times(part.find(name), part.find(other))
        if value is not None:
            found.append(Goal(text, value, bound, True, part.command))
    return found


def _times(one: Series | None, other: Series | None) -> float | None:
    """How many times one's time the other takes."""
    if one is None or other is None:
        return None
    return ratio(other.seconds, one.seconds)


def _memory_goals(part: Part) -> list[Goal]:
    peaks: dict[float, list[float]] = {}
    for series in part.series:
        scans = series.extra["scans"]
        peaks.setdefault(scans, []).append(series.extra["peak_mib"])
    most, fewest = max(peaks), min(peaks)
    growth = median(
        b / a for a, b in zip(peaks[fewest], peaks[most], strict=True)
    )
    text = f"C++: peak memory at {most:,.0f} scans over that at {fewest:,.0f}"
    return [Goal(text, growth, 1.1, False, part.command)]
