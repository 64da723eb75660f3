"""Which mistake of the catalogue draws a program's maps, every one of them, pixel for pixel."""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence

import numpy as np

from occgrid_parity.explain.findings import Cause, Likely
from occgrid_parity.explain.mistaken_maps import LARGE, Evidence, MistakenMaps
from occgrid_parity.mistakes.catalogue import MISTAKES, only_noise
from occgrid_parity.model.arithmetic import PLATFORM, PORTABLE, Arithmetic
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.worlds import world_of
from occgrid_parity.processes.pool import side_by_side

ARITHMETIC = {"portable": PORTABLE, "platform": PLATFORM}
LEFT_OUT = (
    "Maps in which rounding decides where a beam ends were left out, and grey values halfway between two levels may be "
    "on either side."
)
JOBS = min(2, os.cpu_count() or 1)


def find_cause(
    evidence: Sequence[Evidence], short: Evidence | None = None
) -> Cause:
    """The mistakes that reproduce all the maps.

    First every map must be the same in every pixel, and in every bit of the log-odds where the program writes them,
    in the contract's arithmetic or in this machine's. Where no mistake is that, and some map differs by more than
    rounding, grey values halfway between two levels may be on the other side, and maps with beams that rounding decides
    are left out. Nothing else is guessed.

    ``short`` is a map of a shorter scenario that differs, too. It is evidence of little weight, but a mistake that
    does not draw it is soon ruled out.
    """
    noisy = any(one.mode.seed is not None for one in evidence)
    mistakes = [
        mistake
        for mistake in MISTAKES.values()
        if noisy or not only_noise(mistake)
    ]
    maps = MistakenMaps()
    everything = [*evidence, *([] if short is None else [short])]
    for name, numbers in ARITHMETIC.items():
        found = _matching(maps, mistakes, everything, numbers)
        if found:
            return _cause(found, evidence, name)
    if short is not None and not short.is_conditioned:
        everything.remove(short)
    certain = [one for one in everything if one.is_conditioned]
    if any(one.status == "differs" for one in certain):
        for name, numbers in ARITHMETIC.items():
            found = _matching(maps, mistakes, certain, numbers, halves=True)
            if found:
                known = [one for one in evidence if one.is_conditioned]
                return _cause(found, known or certain, name, LEFT_OUT)
    none = f"None of the {len(MISTAKES)} mistakes in our catalogue draws these maps, so we name no cause."
    titles = [one.title for one in evidence]
    return Cause([], titles, len(MISTAKES), "", none)


def find_halves_cause(evidence: Sequence[Evidence]) -> Cause:
    """The mistakes in rounding a grey value that reproduce all maps: what looks like a last bit can be one."""
    mistakes = [
        mistake
        for mistake in MISTAKES.values()
        if mistake.pixel is not Mapper.pixel
        and all(_is_nearer(mistake, one) for one in evidence)
    ]
    if not mistakes:
        return Cause([], [], 0)
    maps = MistakenMaps()
    small = [one for one in evidence if one.observed.pixels.size < LARGE]
    small = small or list(evidence)
    for name, numbers in ARITHMETIC.items():
        # maps that the contract draws in this arithmetic need no mistake
        if _matching(maps, [Mapper], small, numbers):
            break
        found = _matching(maps, mistakes, evidence, numbers)
        if found:
            return _cause(found, evidence, name)
    titles = [one.title for one in evidence]
    return Cause([], titles, len(mistakes))


def _is_nearer(mistake: type[Mapper], one: Evidence) -> bool:
    """Whether the reference's log-odds, made to grey values with the mistake, come at least as near to a map."""
    right = reference_map(one.case, one.mode)
    mapper = mistake(world_of(one.case), one.mode.seed)
    found = one.observed.pixels
    with_it = np.count_nonzero(mapper.picture(right.log_odds) != found)
    return bool(with_it <= np.count_nonzero(right.pixels != found))


def _cause(
    found: Sequence[type[Mapper]],
    evidence: Sequence[Evidence],
    arithmetic: str,
    more: str = "",
) -> Cause:
    titles = [one.title for one in evidence]
    maps = (
        "your map"
        if len(evidence) == 1
        else f"all {len(evidence)} of your maps"
    )
    if len(found) == 1:
        said = f"When we plant only this mistake in the reference, it reproduces {maps} exactly."
    else:
        said = (
            f"When we plant any one of these {len(found)} mistakes in the reference, it reproduces {maps} exactly: "
            "these maps cannot tell them apart."
        )
    message = f"{said} {more}".strip()
    return Cause(
        [likely(one) for one in found],
        titles,
        len(MISTAKES),
        arithmetic,
        message,
    )


def _matching(
    maps: MistakenMaps,
    mistakes: Sequence[type[Mapper]],
    evidence: Sequence[Evidence],
    numbers: Arithmetic,
    halves: bool = False,
) -> list[type[Mapper]]:
    """The mistakes with which all maps are drawn."""

    def matches(mistake: type[Mapper], stop: threading.Event) -> bool:
        loose = halves and mistake.pixel is Mapper.pixel
        return maps.draws_all(mistake, evidence, numbers, loose)

    found = side_by_side(matches, mistakes, JOBS)
    return [one for one, draws in zip(mistakes, found, strict=True) if draws]


def likely(mistake: type[Mapper]) -> Likely:
    """What there is to say about a mistake."""
    return Likely(mistake.name, mistake.title, mistake.lesson, mistake.where)
