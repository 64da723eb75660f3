"""What was aimed at, and whether it was reached."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from statistics import median

from occgrid_bench.record import Part, Series
from occgrid_bench.statistics import ratio


@dataclass(frozen=True)
class Goal:
    """One aim: a figure, and the bound that it has to keep."""

    text: str
    value: float
    bound: float
    at_least: bool

    @property
    def met(self) -> bool:
        if self.at_least:
            return self.value >= self.bound
        return self.value <= self.bound


def goals(parts: Mapping[str, Part]) -> list[Goal]:
    """The goals that the parts say something about."""
    found = []
    for name, title in (
        ("lesson", "lesson grid"),
        ("open", "grid that holds every beam"),
        ("log", "real log"),
    ):
        if name in parts:
            found += _mapping_goals(parts[name], title)
    if "commands" in parts:
        woxi = parts["commands"].find("mathematica")
        if woxi is not None:
            text = "Wolfram on woxi, the whole lesson, seconds"
            found.append(Goal(text, woxi.median, 20.0, at_least=False))
    if "threads" in parts:
        found += _thread_goals(parts["threads"])
    if "long" in parts:
        found += _memory_goals(parts["long"])
    return found


def _times(one: Series | None, other: Series | None) -> float | None:
    """How many times the other's time is of one's."""
    if one is None or other is None:
        return None
    return ratio(other.seconds, one.seconds)


def _mapping_goals(part: Part, where: str) -> list[Goal]:
    cpp = part.find("cpp")
    java = part.find("java")
    octomap = [
        s for s in map(part.find, ("octomap", "octomap-rays")) if s is not None
    ]
    quickest = min(octomap, key=lambda s: s.median, default=None)
    python, lesson_python = part.find("python"), part.find("lesson-python")
    pairs = [
        ("C++: times the lesson's C++", cpp, part.find("lesson-cpp"), 6.0),
        ("C++: times MRPT", cpp, part.find("mrpt"), 1.0),
        (
            "Java, warm: times the lesson's",
            java,
            part.find("lesson-java"),
            4.0,
        ),
        ("NumPy, whole log: times the lesson's", python, lesson_python, 15.0),
        ("NumPy, whole log: times the quicker OctoMap", python, quickest, 1.0),
        (
            "NumPy, per scan: times the lesson's",
            part.find("python-scan"),
            lesson_python,
            4.5,
        ),
        (
            "Octave, whole log: times the lesson's",
            part.find("octave"),
            part.find("lesson-octave"),
            75.0,
        ),
    ]
    found = []
    for text, one, other, bound in pairs:
        value = _times(one, other)
        if value is not None:
            found.append(Goal(f"{text}; {where}", value, bound, at_least=True))
    over_java = _times(cpp, java)
    if over_java is not None:
        text = f"Java, warm: time over the C++ port's; {where}"
        found.append(Goal(text, over_java, 1.5, at_least=False))
    updates, ends = part.find("floor-list"), part.find("floor-ends")
    if cpp and updates and ends:
        both = [
            a + b for a, b in zip(updates.seconds, ends.seconds, strict=True)
        ]
        text = f"C++: time over the floor's; {where}"
        over_floor = ratio(cpp.seconds, both)
        found.append(Goal(text, over_floor, 1.5, at_least=False))
    return found


def _thread_goals(part: Part) -> list[Goal]:
    found = []
    for name in ("cpp", "cpp-command", "java", "java-command"):
        one, two = part.find(f"{name}-1"), part.find(f"{name}-2")
        if one and two:
            text = f"{two.title}: times one thread"
            value = ratio(one.seconds, two.seconds)
            found.append(Goal(text, value, 1.6, at_least=True))
    return found


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
    return [Goal(text, growth, 1.1, at_least=False)]
