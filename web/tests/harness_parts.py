"""What the pages' tests take from the harness: maps with planted mistakes, and the full check's comparison."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from occgrid_parity.check.wording import compared_words
from occgrid_parity.explain.closeness import Compared, compare_with_reference
from occgrid_parity.mistakes import reading_mistakes
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model import arithmetic
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import LESSON, built_in, case
from occgrid_parity.suite.modes import Mode

__all__ = [
    "MISTAKES",
    "READING",
    "SCENARIOS",
    "SEED",
    "Mapper",
    "World",
    "arithmetic",
    "full_check",
    "full_words",
    "misread_world",
    "seed_of",
    "with_mistakes",
    "world",
]

# Mistakes in how a file is read, which the pages do not know.
READING = {mistake.name for mistake in reading_mistakes.MISTAKES}
# One scenario where most mistakes show, and those for the others; with noise, which some of them are about.
SCENARIOS = (
    "asymmetric",
    "no-return-free",
    "no-return-ignore",
    "saturate",
    "prior",
    "outside",
    "powers",
    "noise-half",
    "noise-clamp",
    "flaser",
    "clamp-order",
    "slanting",
    "mixed",
)
SEED = 3

Pixels = npt.NDArray[np.int64]


def seed_of(name: str) -> int:
    """The seed of a scenario of this list: that of noise-half is the one it was made for."""
    return 0 if name == "noise-half" else SEED


def world(name: str) -> World:
    """A scenario of the suite."""
    return world_of(case(name))


def misread_world(mistake: str, name: str) -> World:
    """A scenario of the suite as a program with a mistake in its reading takes it."""
    return world_of(MISTAKES[mistake].reads(case(name)))


def with_mistakes(*names: str) -> type[Mapper]:
    """A mapper with several mistakes at once."""
    return type("Several", tuple(MISTAKES[name] for name in names), {})


def full_check(name: str, pixels: Pixels, seed: int | None = None) -> str:
    """What the full check says of a picture: identical, halves, edges or differs.

    The lesson's is taken for that of a program that has the lesson built in, as the page takes it.
    """
    return str(compared(name, pixels, seed).status)


def full_words(name: str, pixels: Pixels) -> str:
    """The full check's sentence on a picture without noise."""
    return compared_words(compared(name, pixels, None))


def compared(name: str, pixels: Pixels, seed: int | None) -> Compared:
    """The full check's comparison."""
    observed = Observed(pixels.astype(np.uint16), None, "")
    one = built_in() if name == LESSON else case(name)
    own_poses = not one.is_file
    return compare_with_reference(observed, one, Mode(seed), own_poses)
