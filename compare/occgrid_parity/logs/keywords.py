"""The keywords of CARMEN logs: which are taken, and what is known of the others."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable

FLASER = "FLASER"
ROBOTLASER1 = "ROBOTLASER1"
TAKEN = (FLASER, ROBOTLASER1)

KNOWN = {
    r"RAWLASER[0-9]+": "which has no pose",
    r"ROBOTLASER[0-9]+": "which is another laser of the robot",
    r"RLASER|LASER[0-9]+": "which is another laser of the robot, of unstated direction",
    r"OLDLASER": "which has no pose of the laser",
    r"LASER_READING": "which has the pose of one guess among many",
}
"""Scans that are not taken, because the log does not say for certain where their beams start or point."""

NUMBER = "(number)"
OTHER = "(other)"
MOST_KEYWORDS = 100
SHOWN_KEYWORDS = 6
_KEYWORD = re.compile(rb"[A-Za-z_][A-Za-z0-9_]{0,39}")
_NUMBER = re.compile(rb"[-+.0-9]")


class KeywordCounts:
    """How many lines each keyword has; what is no keyword counts together."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()

    def add(self, keyword: bytes) -> None:
        """Counts a line by its first word; blank lines and comments do not count."""
        if not keyword or keyword.startswith(b"#"):
            return
        if _KEYWORD.fullmatch(keyword):
            name = keyword.decode("ascii")
        else:
            name = NUMBER if _NUMBER.match(keyword) else OTHER
        if name not in self.counts and len(self.counts) >= MOST_KEYWORDS:
            name = OTHER
        self.counts[name] += 1

    def note(self) -> str:
        """What was taken and what was passed over."""
        taken = [name for name in TAKEN if self.counts[name]]
        text = f"lines: {self._listed(taken)} taken"
        others = self._others()
        return (
            f"{text}; passed over: {self._listed(others)}" if others else text
        )

    def no_scan(self) -> str:
        """Why a log without scans that could be taken has none."""
        reason = f"no {' or '.join(TAKEN)}"
        if not self.counts:
            return f"{reason}: the file has no line"
        unusable = [name for name in self._others() if _what_is_known(name)]
        if unusable:
            found = " and ".join(
                f"{_count(self.counts[name], name)}, {_what_is_known(name)}"
                for name in unusable[:3]
            )
            return f"{reason}; found {found}"
        return f"{reason}; found {self._listed(self._others())}"

    def _others(self) -> list[str]:
        """The keywords that are not taken, the most frequent first."""
        return [
            name for name, _ in self.counts.most_common() if name not in TAKEN
        ]

    def _listed(self, names: Iterable[str]) -> str:
        every = list(names)
        shown = [
            _count(self.counts[name], name) for name in every[:SHOWN_KEYWORDS]
        ]
        left = len(every) - len(shown)
        return ", ".join(shown) + (f" and {left} more" if left else "")


def _what_is_known(name: str) -> str:
    """Why scans of that keyword are not taken; empty where it is not known as a scan."""
    for pattern, reason in KNOWN.items():
        if re.fullmatch(pattern, name):
            return reason
    return ""


def _count(count: int, name: str) -> str:
    if name == NUMBER:
        return f"{count:,} lines that begin with a number"
    if name == OTHER:
        return f"{count:,} lines of another kind"
    return f"{count:,} {name}"
