"""The eight symmetries of a picture: turned, flipped, transposed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from occgrid_parity.explain.closeness import compare_with_reference
from occgrid_parity.formats.pgm import Pixels
from occgrid_parity.model.array_types import Cells
from occgrid_parity.model.reference import reference_map
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

Turn = Callable[[Pixels], Pixels]

# what a picture is of the right one, and how to turn it back
SYMMETRIES: dict[str, Turn] = {
    "the reference flipped vertically (upside down)": lambda p: p[::-1],
    "the reference mirrored left to right": lambda p: p[:, ::-1],
    "the reference turned by 180 degrees": lambda p: p[::-1, ::-1],
    "the reference transposed (rows and columns exchanged)": lambda p: (
        p[::-1, ::-1].T
    ),
    "the reference transposed as a picture (rows and columns exchanged, counted from the top)": lambda p: (
        p.T
    ),
    "the reference turned by 90 degrees to the left": lambda p: np.rot90(
        p, -1
    ),
    "the reference turned by 90 degrees to the right": lambda p: np.rot90(p),
}


def orientation(observed: Observed, case: Case, mode: Mode) -> list[str]:
    """Which symmetries, the identity apart, turn the map into the reference's picture."""
    found = []
    expected = reference_map(case, mode).pixels
    upright = _wrong(observed.pixels, expected)
    for name, back in SYMMETRIES.items():
        turned = back(observed.pixels)
        # rounding explains a few cells only, so a picture that comes no nearer when it is turned is not turned
        if _wrong(turned, expected) >= upright:
            continue
        picture = Observed(np.ascontiguousarray(turned), None, "")
        if compare_with_reference(picture, case, mode).status != "differs":
            found.append(name)
    return found


def _wrong(found: Pixels, expected: Cells) -> float:
    """How many cells are not the same; infinitely many where the sizes differ."""
    if found.shape != expected.shape:
        return np.inf
    return float(np.count_nonzero(found != expected))


LEAST_LIKENESS = 0.3  # a correlation of pictures below it says nothing


def is_upright(observed: Observed, case: Case, mode: Mode) -> bool:
    """Whether a map that is wrong in some other way is nearest to the reference as it stands.

    Nearness is the correlation of grey values, whatever its sign: it does not mind another probability or an inverted
    picture.
    """
    expected = reference_map(case, mode).pixels
    likeness = [
        _likeness(turn(observed.pixels), expected)
        for turn in (_as_it_is, *SYMMETRIES.values())
    ]
    return likeness[0] > max(LEAST_LIKENESS, *likeness[1:])


def _as_it_is(pixels: Pixels) -> Pixels:
    return pixels


def _likeness(found: Pixels, expected: Cells) -> float:
    """The correlation of two pictures, from 0 to 1; 0 where their sizes differ or one is of one grey."""
    if found.shape != expected.shape:
        return 0.0
    one = found - found.mean()
    other = expected - expected.mean()
    size = float(np.sqrt((one * one).sum() * (other * other).sum()))
    return abs(float((one * other).sum())) / size if size else 0.0
