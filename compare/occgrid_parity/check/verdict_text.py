"""A verdict as text for the terminal."""

from __future__ import annotations

import textwrap

from occgrid_parity.check.levels import ROUNDING
from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.check.wording import plural
from occgrid_parity.compare.cell_values import CellValue
from occgrid_parity.explain.findings import Cause, FirstDifference

WIDTH = 100
HALVES = "identical except for pixels exactly halfway between two grey levels"
LAST_BIT = ", where the last bit of exp or log decides"
MARKS = {
    "identical": "identical",
    "halves": "identical*",
    "edges": "at edges",
    "passed": "passed",
    "failed": "FAILED",
    "not checked": "not checked",
    "grey": "cannot be judged",
}


def halves_words(verdict: Verdict) -> str:
    """What the star of ``identical*`` means; no last bit decides where one half is rounded down."""
    wrong = any(
        level.name == ROUNDING[0] and level.status == "failed"
        for level in verdict.levels
    )
    return HALVES if wrong else HALVES + LAST_BIT


def verdict_status(verdict: Verdict) -> str:
    """The verdict as the status of a level: where all is grey values halfway between two levels, halves."""
    statuses = {level.status for level in verdict.levels}
    if verdict.overall == "edges" and "edges" not in statuses:
        return "halves"
    return verdict.overall


def verdict_word(verdict: Verdict) -> str:
    """The verdict in a word or two."""
    if verdict.failed_level is not None:
        return verdict.failed_level.word
    status = verdict_status(verdict)
    return MARKS.get(status, status)


def verdict_text(verdict: Verdict, points: bool = True) -> str:
    """The whole verdict; without ``points`` where rules of a class say what the levels are worth."""
    lines = [f"{verdict.program}: {verdict.summary}", ""]
    title_width = max(len(level.title) for level in verdict.levels)
    for level in verdict.levels:
        lines += _level(level, title_width)
    if any(level.status == "halves" for level in verdict.levels):
        lines.append(f"* {halves_words(verdict)}")
    if points:
        lines.append(f"  {verdict.score} of {verdict.maximum} points")
    if verdict.observations:
        lines += ["", "What we see"]
        for said in verdict.observations:
            lines += _wrap(f"{said[0].upper()}{said[1:]}.", "  ")
    if verdict.cause is not None:
        lines += ["", cause_title(verdict.cause), *_cause(verdict.cause)]
    if verdict.first_difference is not None:
        lines += [
            "",
            "First difference",
            *_difference(verdict.first_difference),
        ]
    lines += ["", f"compared: {verdict.compared}"]
    lines += [f"not checked: {said}" for said in verdict.not_checked]
    lines += [f"note: {note}" for note in verdict.notes]
    lines.append(f"{plural(verdict.runs, 'run')}, {verdict.seconds:.1f} s")
    return "\n".join(lines) + "\n"


def _wrap(text: str, indent: str) -> list[str]:
    return textwrap.wrap(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent
    )


def _level(level: Level, width: int) -> list[str]:
    word = f" ({level.word})" if level.word else ""
    line = f"  {level.title:<{width}}  {MARKS[level.status]}{word}"
    return [line, *_wrap(level.message, " " * 6)]


def cause_title(cause: Cause) -> str:
    """What stands above a cause: whether it is known, and of how many mistakes it is one."""
    count = len(cause.candidates)
    if count > 1:
        return f"Likely cause: one of these {count}"
    return "Likely cause" if count else "Cause"


def _cause(cause: Cause) -> list[str]:
    lines = []
    for one in cause.candidates:
        lines += _wrap(f"{one.title} [{one.name}]", "  ")
        lines += _wrap(f"{one.lesson} (lesson: {one.where})", "    ")
    return lines + _wrap(cause.message, "  ")


def _difference(d: FirstDifference) -> list[str]:
    head = f"{d.scenario}, {d.mode}: {place_text(d)} ({how_text(d)})"
    lines = [
        f"  {head}",
        f"    expected  {value_text(d.expected)}",
        f"    found     {value_text(d.found)}",
        *(f"    {line}" for line in beam_lines(d)),
    ]
    if d.command:
        lines += ["  to see it again:", f"    {d.command}"]
    return lines


def place_text(d: FirstDifference) -> str:
    """``scan 2, beam 4, cell gx=15 gy=12``, without what is not known."""
    scan = [] if d.scan is None else [f"scan {d.scan}"]
    beam = [] if d.beam is None else [f"beam {d.beam}"]
    return ", ".join([*scan, *beam, f"cell gx={d.gx} gy={d.gy}"])


def how_text(d: FirstDifference) -> str:
    """How the place was found."""
    if d.how == "runs":
        return f"found in {plural(d.runs, 'run')}"
    return "worked out from the finished map"


def beam_lines(d: FirstDifference) -> list[str]:
    """The beam: where it ends, the cells around the difference, and what is not certain."""
    lines = []
    if d.candidates:
        named = ", ".join(map(str, d.candidates[:20]))
        more = (
            f" and {len(d.candidates) - 20} more"
            if len(d.candidates) > 20
            else ""
        )
        lines.append(
            f"beams of that scan that touch wrong cells: {named}{more}"
        )
    if d.endpoint is not None:
        e = d.endpoint
        kind = "hit" if e.hit else "no return"
        lines += [
            f"the beam's endpoint ({kind}, range {e.range} m)",
            f"  x = {e.x} m  {e.x_hex}",
            f"  y = {e.y} m  {e.y_hex}",
            f"  {e.edge_distance:.3g} m from the nearest cell edge; rounding can move it by {e.rounding:.1g} m",
        ]
    lines += d.patch
    if d.patch:
        lines.append(
            "o free, # occupied, R the robot's cell, [ ] wrong; gy on the left, gx below"
        )
    for said in d.undetermined:
        lines += _wrap(f"not certain: {said}", "")
    return lines


def value_text(value: CellValue) -> str:
    """``p 0.3, log-odds -0.847 (0x...), pixel 179``."""
    parts = []
    if value.probability is not None:
        parts.append(f"p {value.probability}")
    if value.log_odds is not None:
        parts.append(f"log-odds {value.log_odds} (0x{value.bits})")
    if value.pixel is not None:
        parts.append(f"pixel {value.pixel}")
    return ", ".join(parts)
