"""Which mistake of the catalogue draws a program's maps, every one of them, pixel for pixel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from occgrid_parity.explain.closeness import Closeness, differing, grey_levels
from occgrid_parity.explain.findings import Cause, Likely
from occgrid_parity.mistakes.catalogue import MISTAKES, only_noise
from occgrid_parity.model.arithmetic import PLATFORM, PORTABLE, Arithmetic
from occgrid_parity.model.mapper_steps import Drawn, Mapper
from occgrid_parity.model.rounding import beams_of
from occgrid_parity.model.worlds import world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

ARITHMETIC = {"portable": PORTABLE, "platform": PLATFORM}
NO_MISTAKE = {
    "portable": "There is no mistake: every map is the reference's.",
    "platform": "There is no mistake: with this machine's own sin, cos, exp and log the contract draws every map, "
    "pixel for pixel.",
}
LEFT_OUT = (
    "Maps in which rounding decides a beam are left out, and grey values halfway between two levels may be on either "
    "side."
)
ROUNDINGS = 1000  # additions that a cell's log-odds may have behind them


@dataclass(frozen=True)
class Evidence:
    """A map that the program has drawn."""

    case: Case
    mode: Mode
    observed: Observed
    status: Closeness

    @property
    def title(self) -> str:
        return f"{self.case.name}, {self.mode.name}"

    def is_conditioned(self) -> bool:
        """Whether rounding decides no beam of it."""
        beams = beams_of(world_of(self.case), self.mode.seed)
        return beams.undecided.size == 0


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
    ordered = sorted(evidence, key=lambda one: one.observed.pixels.size)
    titles = [one.title for one in ordered]
    tried = len(MISTAKES)
    for name, numbers in ARITHMETIC.items():
        if all(_draws(Mapper, one, numbers) for one in ordered):
            return Cause([], titles, tried, name, NO_MISTAKE[name])
    for name, numbers in ARITHMETIC.items():
        found = _matching(ordered, numbers, short)
        if found:
            return Cause(found, titles, tried, name, _message(found, ordered))
    certain = [one for one in ordered if one.is_conditioned()]
    if short is not None and not short.is_conditioned():
        short = None
    if any(one.status == "differs" for one in certain):
        for name, numbers in ARITHMETIC.items():
            found = _matching(certain, numbers, short, halves=True)
            if found:
                titles = [one.title for one in certain]
                message = f"{_message(found, certain)} {LEFT_OUT}"
                return Cause(found, titles, tried, name, message)
    none = f"None of the {tried} mistakes of the catalogue draws these maps."
    return Cause([], titles, tried, "", none)


def _message(found: Sequence[Likely], evidence: Sequence[Evidence]) -> str:
    maps = "1 map" if len(evidence) == 1 else f"all {len(evidence)} maps"
    if len(found) == 1:
        return f"With this mistake alone, the reference draws {maps} exactly as the program does."
    return (
        f"With any one of these {len(found)} mistakes, the reference draws {maps} exactly as the program does; these "
        "maps do not tell them apart."
    )


def _matching(
    evidence: Sequence[Evidence],
    numbers: Arithmetic,
    short: Evidence | None,
    halves: bool = False,
) -> list[Likely]:
    """The mistakes with which all maps are drawn."""
    found = []
    noisy = any(one.mode.seed is not None for one in evidence)
    for mistake in MISTAKES.values():
        if only_noise(mistake) and not noisy:
            continue  # it draws what the contract draws
        loose = halves and mistake.pixel is Mapper.pixel
        maps = evidence if short is None else (short, *evidence)
        if all(_draws(mistake, one, numbers, loose) for one in maps):
            found.append(likely(mistake))
    return found


def likely(mistake: type[Mapper]) -> Likely:
    """What there is to say about a mistake."""
    return Likely(mistake.name, mistake.title, mistake.lesson, mistake.where)


def _draws(
    mistake: type[Mapper],
    one: Evidence,
    numbers: Arithmetic,
    halves: bool = False,
) -> bool:
    drawn = mistake(world_of(one.case), one.mode.seed, numbers).draw()
    if drawn.pixels.shape != one.observed.pixels.shape:
        return False
    if one.observed.log_odds is not None and (
        drawn.log_odds.shape != one.observed.log_odds.shape
    ):
        return False
    if not differing(one.observed, drawn).any():
        return True
    return halves and _only_halves(one.observed, drawn)


def _only_halves(observed: Observed, drawn: Drawn) -> bool:
    """Whether all differences are grey values halfway between two levels, by the mistaken map's own log-odds."""
    low, high = grey_levels(drawn.log_odds, ROUNDINGS)
    wrong = observed.pixels != drawn.pixels
    # a picture that is turned or flipped is not matched here
    upright = (
        (drawn.pixels[::-1] >= low) & (drawn.pixels[::-1] <= high)
    ).all()
    either = (
        (observed.pixels[::-1] == low) | (observed.pixels[::-1] == high)
    ).all()
    return bool(
        wrong.any() and upright and either and observed.log_odds is None
    )
