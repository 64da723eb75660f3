"""What can be seen in a program's files without any guess: which grey levels, how many digits, which scale."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence

import numpy as np

from occgrid.grid import sigmoid
from occgrid_parity.explain.empty_maps import empty_maps, is_empty
from occgrid_parity.explain.mistaken_maps import Evidence
from occgrid_parity.explain.single_updates import single_update, untouched
from occgrid_parity.formats.log_odds import bits
from occgrid_parity.model.array_types import Array
from occgrid_parity.model.reference import reference_map
from occgrid_parity.suite.cases import scenario_folder

TRINARY = {0, 205, 254}
SINGLE_BITS = np.uint64(2**28 - 1)
MOST_DIGITS = 15


def observations(maps: Sequence[Evidence], reads_scenarios: bool) -> list[str]:
    """Sentences about what is seen. ``maps`` are the maps of the program; those of a wrong size say nothing here."""
    maps = [
        one
        for one in maps
        if one.observed.pixels.shape
        == reference_map(one.case, one.mode).pixels.shape
    ]
    said = [text] if (text := empty_maps(maps)) else []
    maps = [one for one in maps if not is_empty(one)]
    # the first that fits explains the grey levels
    grey_levels = (_maximum, _trinary, _one_row, _prior, _probability)
    for looks in (grey_levels, (log_odds_fault,)):
        sentences = (look(maps) for look in looks)
        said += [text for text in sentences if text][:1]
    if not reads_scenarios:
        said += [text for one in maps if (text := _copied(one))]
    return said


def _maximum(maps: Sequence[Evidence]) -> str:
    tops = {one.observed.top for one in maps} - {255}
    if not tops:
        return ""
    return f"your picture's maximum is {min(tops)}; a PGM picture of a map has 255, and grey levels from 0 to 255"


def _trinary(maps: Sequence[Evidence]) -> str:
    levels = set()
    expected = set()
    for one in maps:
        levels |= set(np.unique(one.observed.pixels).tolist())
        expected |= set(
            np.unique(reference_map(one.case, one.mode).pixels).tolist()
        )
    if not levels <= TRINARY or expected <= TRINARY or len(levels) < 2:
        return ""
    return (
        "your pictures have no grey levels but 0, 205 and 254, which are those of ROS's map_saver (occupied, unknown, "
        "free); SPEC.md section 2.6 wants the probability of each cell as one of 256 levels"
    )


def _one_row(maps: Sequence[Evidence]) -> str:
    """Rows that share their cells."""
    for one in maps:
        found, right = one.observed.pixels, reference_map(one.case, one.mode)
        many = len(found) > 1 and (found == found[0]).all()
        if not many or (right.pixels == right.pixels[0]).all():
            return ""
    return (
        "all rows of your picture are the same, so they may be one row in memory: in Python, [[l0] * W] * H is the "
        "same list H times; [[l0] * W for _ in range(H)] makes H lists"
        if maps
        else ""
    )


def _prior(maps: Sequence[Evidence]) -> str:
    """Another prior, from cells that nothing has updated."""
    said = {untouched(one) for one in maps} - {""}
    return said.pop() if len(said) == 1 else ""


def _probability(maps: Sequence[Evidence]) -> str:
    """Another probability, from cells that have been updated once."""
    for free in (False, True):
        said = [single_update(one, free) for one in maps]
        known = {one for one in said if one is not None}
        wrong = {one for one in known if not one.is_right}
        if len(known) == 1 and wrong:
            update = known.pop()
            if update.p is not None:
                return update.words
    return ""


def log_odds_fault(maps: Sequence[Evidence]) -> str:
    """What the log-odds of all maps together show, in a sentence; empty where nothing is seen."""
    pairs = [
        (one.observed.log_odds, reference_map(one.case, one.mode).log_odds)
        for one in maps
        if one.observed.log_odds is not None
    ]
    if not pairs:
        return ""
    found = np.concatenate([own.reshape(-1) for own, _ in pairs])
    right = np.concatenate([ours.reshape(-1) for _, ours in pairs])
    if (bits(found) == bits(right)).all():
        return ""
    for words, test in LOOKS:
        if test(found, right):
            return words
    digits = _digits(found)
    if digits is not None and _digits(right) != digits:
        return (
            f"your log-odds have at most {digits} significant digits; 17 are needed for a text that reads back to the "
            "same double"
        )
    return ""


def _single(found: Array, right: Array) -> bool:
    return bool((bits(found) & SINGLE_BITS == 0).all()) and not bool(
        (bits(right) & SINGLE_BITS == 0).all()
    )


def _base_10(found: Array, right: Array) -> bool:
    """Cells that are or were at a limit tell nothing: the limits are the same in either base."""
    tell = (np.abs(right) < np.abs(right).max()) & (right != 0.0)
    same = np.isclose(found[tell] * np.log(10.0), right[tell], 1e-9, 1e-9)
    return bool(same.any()) and float(same.mean()) > 0.99


def _probabilities(found: Array, right: Array) -> bool:
    return bool(np.allclose(found, sigmoid(right), 1e-9, 1e-9))


LOOKS: tuple[tuple[str, Callable[[Array, Array], bool]], ...] = (
    (
        "your log-odds file holds probabilities: they are those of the reference; write the log-odds themselves",
        _probabilities,
    ),
    (
        "where they are not clamped, your log-odds are those of the reference divided by log(10): the logarithm is "
        "taken to base 10, and must be the natural one",
        _base_10,
    ),
    (
        "your log-odds are in single precision (the last 28 bits of every one are 0); the contract has doubles",
        _single,
    ),
)


def _digits(values: Array) -> int | None:
    """How many significant digits are enough for all values; None where it takes more than MOST_DIGITS."""
    some = np.unique(values)[:2000].tolist()
    for digits in range(1, MOST_DIGITS + 1):
        if all(float(f"{v:.{digits}g}") == v for v in some):
            return digits
    return None


def _copied(one: Evidence) -> str:
    """Whether the picture is the committed one."""
    name = f"{one.case.name}.{one.mode.name}.pgm"
    file = scenario_folder() / "golden" / name
    if not file.is_file():
        return ""
    if hashlib.sha256(file.read_bytes()).hexdigest() != one.observed.digest:
        return ""
    return (
        f"the picture is the suite's own {name} byte for byte, from a program that reads no scenario. A program that "
        "follows SPEC.md can draw it, and a copied file looks the same: only a program that reads scenarios can be "
        "told from a copy"
    )
