"""Why the same program draws a different map in another language: the measured tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid_handouts.own_math import Drawn, draw, lesson_arguments
from occgrid_handouts.platform_math import FUNCTIONS, Measured, measure
from occgrid_handouts.writings import (
    Writing,
    contract_writing,
    numpy_writing,
    octave_writing,
)

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Story:
    """The tables, as data, the maps (the contract's first), and the cells that they disagree on."""

    facts: dict[str, object]
    drawn: list[Drawn]
    bits_differ: Mask  # (height, width) in some bit of the log-odds
    seen_to_differ: Mask  # (height, width) in the picture


@dataclass(frozen=True)
class Program:
    """The lesson as one writes it in a language: a library, a way to write the angles."""

    name: str
    library: str
    writing: str
    fused: bool = False


PROGRAMS = (
    Program("Python", "python", "numpy"),
    Program("C++", "cpp", "contract"),
    Program("C++, fused", "cpp", "contract", fused=True),
    Program("Java", "java", "contract"),
    Program("Octave", "octave", "octave"),
)


def tell_story(programs: Path, work: Path) -> Story:
    """Measures the libraries and draws the lesson with each."""
    found = [contract_writing(), numpy_writing(), octave_writing(programs)]
    writings = {w.name: w for w in found if w is not None}
    plain = writings["contract"]
    contract = draw("the suite", plain)
    arguments = lesson_arguments(list(writings.values()), contract.log_odds)
    measured = measure(programs, work, arguments)
    by_id = {one.platform.id: one for one in measured}
    own = [
        _draw_program(program, writings, by_id, arguments)
        for program in PROGRAMS
    ]
    drawn = [one for one in own if one is not None]
    bits = np.zeros(contract.log_odds.shape, dtype=bool)
    seen = bits.copy()
    for one in drawn:
        bits |= differing(one.log_odds, contract.log_odds)
        seen |= one.pixels != contract.pixels
    facts: dict[str, object] = {
        "angles": int(plain.angles().size),
        "exp_arguments": int(arguments["exp"].size),
        "log_arguments": int(arguments["log"].size),
        "libraries": [
            _library_row(one, plain, contract, arguments) for one in measured
        ],
        "writings": {
            w.name: int(differing(w.bearings, plain.bearings).sum())
            for w in writings.values()
        },
        "turns": {
            w.name: int(differing(w.turns, plain.turns).sum())
            for w in writings.values()
        },
        "programs": _matrix([contract, *drawn]),
        "not_drawn": [
            {"name": p.name, "problem": _why_not(p, by_id)}
            for p, one in zip(PROGRAMS, own, strict=True)
            if one is None
        ],
        "same_library": _same_library(measured),
        "last_places": _last_places(measured, arguments),
        "bits_differ": int(bits.sum()),
        "seen_to_differ": int(seen.sum()),
    }
    return Story(facts, [contract, *drawn], bits, seen)


def differing(a: Array, b: Array) -> Mask:
    """Where two arrays of doubles differ in any bit."""
    return np.asarray(a.view(np.int64) != b.view(np.int64))


def _draw_program(
    program: Program,
    writings: Mapping[str, Writing],
    measured: Mapping[str, Measured],
    arguments: Mapping[str, Array],
) -> Drawn | None:
    library = measured[program.library]
    if library.problem or program.writing not in writings:
        return None
    writing = writings[program.writing]
    return draw(program.name, writing, library, arguments, fused=program.fused)


def _why_not(program: Program, measured: Mapping[str, Measured]) -> str:
    return measured[program.library].problem or "not measured: install octave"


def _library_row(
    one: Measured,
    plain: Writing,
    contract: Drawn,
    arguments: Mapping[str, Array],
) -> dict[str, object]:
    """How a library differs from portable_math, and what that does to the map."""
    row: dict[str, object] = {
        "name": one.platform.name,
        "problem": one.problem,
    }
    if one.problem:
        return row
    angles = plain.angles()
    at = np.searchsorted(arguments["sin"], angles)
    for function in FUNCTIONS:
        inside = at if function in ("sin", "cos") else slice(None)
        own = one.results[function][inside]
        portable = getattr(portable_math, function)
        expected = portable(arguments[function][inside])
        row[function] = int(differing(own, expected).sum())
    turned = draw("", plain, one, arguments, only=("sin", "cos"))
    whole = draw("", plain, one, arguments)
    moved = turned.beams.gx1 != contract.beams.gx1
    moved |= turned.beams.gy1 != contract.beams.gy1
    row["beams"] = int(moved.sum())
    row["cells_sin_cos"] = int(
        differing(turned.log_odds, contract.log_odds).sum()
    )
    row["cells"] = int(differing(whole.log_odds, contract.log_odds).sum())
    row["pixels"] = int((whole.pixels != contract.pixels).sum())
    return row


def _same_library(measured: Sequence[Measured]) -> list[str]:
    """The names of most libraries that gave the same bits for everything they were asked."""
    groups: dict[bytes, list[str]] = {}
    for one in measured:
        if not one.problem:
            results = [one.results[name].tobytes() for name in FUNCTIONS]
            groups.setdefault(b"".join(results), []).append(one.platform.name)
    return max(groups.values(), key=len, default=[])


def _last_places(
    measured: Sequence[Measured], arguments: Mapping[str, Array]
) -> int:
    """By how many units in the last place a library differs from portable_math at most."""
    largest = 0
    for one in measured:
        for name, results in one.results.items():
            portable = getattr(portable_math, name)(arguments[name])
            steps = np.abs(results.view(np.int64) - portable.view(np.int64))
            same_sign = np.signbit(results) == np.signbit(portable)
            largest = max(largest, int(steps[same_sign].max(initial=0)))
    return largest


def _matrix(drawn: Sequence[Drawn]) -> dict[str, object]:
    """Cells that differ, by pairs: in some bit of the log-odds, and in the picture."""
    bits = [
        [int(differing(a.log_odds, b.log_odds).sum()) for b in drawn]
        for a in drawn
    ]
    pixels = [
        [int((a.pixels != b.pixels).sum()) for b in drawn] for a in drawn
    ]
    return {"names": [d.name for d in drawn], "bits": bits, "pixels": pixels}
