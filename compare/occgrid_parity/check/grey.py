"""Levels that cannot be judged: each could be asked, and its place in the maximum stays."""

from __future__ import annotations

from occgrid_parity.check.levels import (
    LOG_ODDS,
    RUNS,
    YAML,
    is_asked,
    titles,
)
from occgrid_parity.check.verdict import Level
from occgrid_parity.programs.runner import Runner


def grey_or_unasked(runner: Runner, name: str, title: str, why: str) -> Level:
    """A level with nothing to judge, or one that the command cannot be asked."""
    if is_asked(runner, name):
        return Level(name, title, "grey", message=why)
    return Level(name, title, "not checked")


def levels_of_broken(runner: Runner, word: str, message: str) -> list[Level]:
    """The levels of a program that could not even be run."""
    levels = [Level(*RUNS, "failed", word, message)]
    for name, title in titles(runner).items():
        if name in (LOG_ODDS[0], YAML[0]):
            levels.append(Level(name, title, "not checked"))
        elif name != RUNS[0]:
            levels.append(
                grey_or_unasked(runner, name, title, "nothing could be run")
            )
    return levels
