"""Draws docs/differences.png: `.venv/bin/python docs/differences.py docs/differences.png`.

The lesson, noise-free, as the suite's programs draw it, and as one writes it in each language, with the language's own
mathematics library; marked are the cells whose grey is another one than the suite's.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "handouts")]

from occgrid_handouts.own_math import Drawn  # noqa: E402
from occgrid_handouts.story import tell_story  # noqa: E402

ORANGE = "#d9480f"
EXTENT = (-11.0, 11.0, -9.0, 9.0)
# a corner of the room, where many of the cells lie
CLOSE_UP = (-10.4, -6.9, -9.0, -6.14)
PROGRAMS = ("Python", "C++", "Java", "Octave")


def draw(axes: Axes, one: Drawn, reference: Drawn, size: float) -> int:
    """A map with its marks; returns how many."""
    axes.imshow(one.pixels, cmap="gray", origin="lower", extent=EXTENT)
    differ = one.pixels != reference.pixels
    gy, gx = np.nonzero(differ)
    axes.plot(
        EXTENT[0] + (gx + 0.5) * 0.1,
        EXTENT[2] + (gy + 0.5) * 0.1,
        "s",
        color="none",
        markeredgecolor=ORANGE,
        markersize=size,
        markeredgewidth=1.0,
    )
    axes.set_xticks([])
    axes.set_yticks([])
    return int(differ.sum())


def picture(contract: Drawn, own: list[Drawn]) -> Figure:
    """Five maps, and a part of the one that differs most."""
    figure = Figure(figsize=(8.6, 5.2), layout="constrained")
    first, *others, last = figure.subplots(2, 3).flat
    draw(first, contract, contract, 2.2)
    first.set_title("This suite, in six languages", fontsize=9)
    counts = {}
    for axes, one in zip(others, own, strict=True):
        counts[one.name] = draw(axes, one, contract, 2.2)
        cells = "cell differs" if counts[one.name] == 1 else "cells differ"
        axes.set_title(
            f"Just written in {one.name}: {counts[one.name]} {cells}",
            fontsize=9,
        )
    most = max(own, key=lambda one: counts[one.name])
    draw(last, most, contract, 7.0)
    last.set_xlim(*CLOSE_UP[:2])
    last.set_ylim(*CLOSE_UP[2:])
    last.set_title(f"{most.name}, the lower left corner", fontsize=9)
    return figure


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python docs/differences.py FILE")
    with tempfile.TemporaryDirectory() as work:
        programs = ROOT / "handouts" / "platform_math"
        contract, *drawn = tell_story(programs, Path(work)).drawn
    own = [one for one in drawn if one.name in PROGRAMS]
    with mpl.rc_context({"svg.hashsalt": "occgrid"}):
        picture(contract, own).savefig(
            sys.argv[1], dpi=110, metadata={"Software": None}
        )
