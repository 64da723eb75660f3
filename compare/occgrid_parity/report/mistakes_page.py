"""The page docs/mistakes.md: every mistake, what the lesson says about it, and which scenarios catch it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from occgrid_parity.check.levels import LEVELS
from occgrid_parity.explain.closeness import differing
from occgrid_parity.mistakes.catalogue import MISTAKES, only_noise
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import LESSON, TWIN, case
from occgrid_parity.suite.modes import NOISE_FREE, Mode

PAGE = "docs/mistakes.md"
SMALL = tuple(
    dict.fromkeys(
        name
        for plan in LEVELS
        if not plan.noisy
        for name in plan.scenarios
        if name not in (TWIN, LESSON)
    )
)
COLUMNS: tuple[tuple[str, Mode], ...] = (
    *((name, NOISE_FREE) for name in (*SMALL, LESSON)),
    ("asymmetric", Mode(0)),
    ("asymmetric", Mode(1)),
    ("mixed", Mode(0)),
    ("noise-half", Mode(0)),
    ("noise-clamp", Mode(0)),
)

HEAD = """# Mistakes that the suite knows

<!-- written by `occgrid-parity mistakes --write`; a test holds this page to the code -->

`occgrid-parity check` compares a program that draws another map with the reference that has one mistake planted. If
one of them draws every map exactly as the program does, the check names it. The same mistakes test the suite: each must
be caught by some scenario, or it gets one.

Each mistake is a few lines in `compare/occgrid_parity/mistakes/`; `occgrid-parity check` prints what the lesson says
about it.
"""

TABLE = """## Which scenario catches which mistake

**P** the picture differs; L only the log-odds differ; · neither does. All without noise but the last five columns.
"""


def catches(mistake: type[Mapper], name: str, mode: Mode) -> str:
    """``P`` where the picture shows the mistake, ``L`` where only the log-odds do, empty where nothing does."""
    if mode.seed is None and only_noise(mistake):
        return ""
    one = case(name)
    expected = reference_map(one, mode)
    drawn = mistake.of(one, mode.seed).draw()
    if drawn.pixels.shape != expected.pixels.shape:
        return "P"
    if (drawn.pixels != expected.pixels).any():
        return "P"
    observed = Observed(drawn.pixels.astype(np.uint16), drawn.log_odds, "")
    return "L" if differing(observed, expected).any() else ""


def table() -> dict[str, list[str]]:
    """For each mistake, what each of COLUMNS shows of it."""
    return {
        name: [catches(mistake, *column) for column in COLUMNS]
        for name, mistake in MISTAKES.items()
    }


def page(found: dict[str, list[str]]) -> str:
    """The page as Markdown."""
    lines = [HEAD]
    for name, mistake in MISTAKES.items():
        lines += [f"**{mistake.title}** (`{name}`)  "]
        lines += [f"{mistake.lesson} *Lesson: {mistake.where}.*", ""]
    lines += [TABLE, _row("mistake", [_title(*column) for column in COLUMNS])]
    lines.append(_row("---", [":-:"] * len(COLUMNS)))
    for name, marks in found.items():
        shown = {"P": "**P**", "L": "L", "": "·"}
        lines.append(_row(f"`{name}`", [shown[mark] for mark in marks]))
    return "\n".join(lines) + "\n"


def _title(name: str, mode: Mode) -> str:
    return name if mode.seed is None else f"{name} {mode.name}"


def _row(first: str, cells: Sequence[str]) -> str:
    return f"| {first} | {' | '.join(cells)} |"
