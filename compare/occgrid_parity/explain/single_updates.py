"""Which probabilities a map's grey levels are those of, read from the cells that one beam has updated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.suite.cases import Case

LEAST_CELLS = 3
SEVERAL = -1
BLUR = 1e-9  # a grey value halfway between two levels may be on either side
NEARLY_ALL = 0.9  # a few cells may be on the other side of an edge


class SingleUpdate(NamedTuple):
    """The grey level of the cells with one update: as it should be, and as it is.

    ``name`` is the parameter that decides it, ``right`` its value; ``found`` is SEVERAL where there is no one grey
    level; ``p`` the probability of two decimals that has the grey level that was found, None where none has.
    """

    name: str
    right: float
    expected: int
    found: int
    p: float | None

    @property
    def is_right(self) -> bool:
        """Whether it is the expected grey level, or the next one, which rounding can make of it."""
        return abs(self.found - self.expected) <= 1

    @property
    def words(self) -> str:
        """What is seen, in a sentence."""
        what = "crossed" if self.name == "p_free" else "hit"
        return (
            f"cells that one beam has {what} have grey level {self.found}, which is that of a probability of "
            f"{self.p:.2f}; with {self.name} {self.right:.2f} it is {self.expected}"
        )


def single_update(one: Evidence, free: bool) -> SingleUpdate | None:
    """What a map's cells with one update show; None where there are too few."""
    s = world_of(one.case).settings
    if one.observed.top != 255 or s.p0 != 0.5:
        return None
    mapper = Mapper(world_of(one.case), one.mode.seed)
    drawn = reference_map(one.case, one.mode)
    step = mapper.steps()[0 if free else 1]
    cells = (drawn.log_odds == mapper.start() + step)[::-1]
    levels, counts = np.unique(one.observed.pixels[cells], return_counts=True)
    if counts.sum() < LEAST_CELLS:
        return None
    name, right = ("p_free", s.p_free) if free else ("p_occ", s.p_occ)
    expected = int(drawn.pixels[cells][0])
    if counts.max() < NEARLY_ALL * counts.sum():
        return SingleUpdate(name, right, expected, SEVERAL, None)
    found = int(levels[counts.argmax()])
    p = round(1.0 - found / 255.0, 2)
    # with the prior's grey level, the cells are more likely not updated at all
    fits = 0.0 < p < 1.0 and p != s.p0
    fits = fits and abs((1.0 - p) * 255.0 - found) <= 0.5 + BLUR
    return SingleUpdate(name, right, expected, found, p if fits else None)


def untouched(one: Evidence) -> str:
    """What the cells show that nothing has updated, in a sentence; empty where they are right or have no one level."""
    s = world_of(one.case).settings
    if one.observed.top != 255 or s.p0 != 0.5:
        return ""
    drawn = reference_map(one.case, one.mode)
    cells = (drawn.log_odds == 0.0)[::-1]
    levels, counts = np.unique(one.observed.pixels[cells], return_counts=True)
    if counts.sum() < LEAST_CELLS or counts.max() < NEARLY_ALL * counts.sum():
        return ""
    found, expected = (
        int(levels[counts.argmax()]),
        int(drawn.pixels[cells][0]),
    )
    if abs(found - expected) <= 1:
        return ""
    return (
        f"cells that no beam has touched have grey level {found}, which is that of a probability of "
        f"{1.0 - found / 255.0:.2f}; with p0 {s.p0:.2f} it is {expected}"
    )


def rounded_down(one: Evidence) -> bool:
    """Whether cells that nothing has updated, with a probability of exactly one half, have 127.5 rounded down."""
    if one.observed.top != 255:
        return False
    drawn = reference_map(one.case, one.mode)
    found = one.observed.pixels[(drawn.log_odds == 0.0)[::-1]]
    return bool(found.size) and float((found == 127).mean()) > NEARLY_ALL


def single_updates(maps: Sequence[Evidence]) -> list[SingleUpdate]:
    """What all maps show of cells with one update, crossed ones and hit ones."""
    found = [
        single_update(one, free) for one in maps for free in (True, False)
    ]
    return [one for one in found if one is not None]


def has_single_updates(one: Evidence) -> bool:
    """Whether a map has the grey levels of one crossing and of one hit somewhere, be it in the wrong cells."""
    mapper = Mapper(world_of(one.case), one.mode.seed)
    log_odds = mapper.start() + np.array(mapper.steps())
    expected = mapper.pixel(mapper.probability(log_odds))
    found = np.unique(one.observed.pixels).astype(np.float64)
    return all(np.abs(found - level).min() <= 1.0 for level in expected)


def with_parameters(case: Case, values: Mapping[str, float]) -> Case:
    """The scenario with other values of some parameters."""
    names = {f"occgrid_{name}".encode() for name in values}
    lines = [
        line
        for line in case.data.splitlines(keepends=True)
        if line.split()[:1] != [b"PARAM"] or names.isdisjoint(line.split())
    ]
    head = [
        f"PARAM occgrid_{name} {value!r}\n".encode()
        for name, value in values.items()
    ]
    return Case(case.name, b"".join([*head, *lines]), case.is_file)
