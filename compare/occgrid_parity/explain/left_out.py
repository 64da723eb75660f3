"""Whether a map is that of right formulas without one scan, or without one beam of every scan.

Rounding may explain such a map, too, if many beams may be turned one by one. What is left out explains it more simply.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from occgrid_parity.explain.nearest_formulas import NearestFormulas
from occgrid_parity.model.array_types import Mask
from occgrid_parity.model.rounding import Beams

NO_WAY = -1
FEW = 8


def left_out(nearest: NearestFormulas, beams: Beams) -> str:
    """``without scan 50``, ``without beam 180 of every scan``; empty where nothing of this kind gives all cells."""
    crossing = [nearest.crossing(cell) for cell in nearest.open[:FEW].tolist()]
    for words, gone in _gaps(beams):
        # a cell that nothing leaves out stays wrong
        if not all(gone[those].any() for those in crossing):
            continue
        chosen = np.where(gone, NO_WAY, nearest.chosen)
        # most choices leave one of the first open cells wrong, which is quickly seen
        for cells in (nearest.open[:FEW], nearest.open, nearest.touched):
            if nearest.misfits(cells, chosen).size:
                break
        else:
            return words
    return ""


def _gaps(beams: Beams) -> Iterator[tuple[str, Mask]]:
    """What may be missing, and which beams that is."""
    scans = np.unique(beams.scan).tolist()
    words = {
        0: "without the first scan",
        scans[-1]: f"after {len(scans) - 1} of {len(scans)} scans",
    }
    for scan in scans:
        yield words.get(scan, f"without scan {scan}"), beams.scan == scan
    for beam in np.unique(beams.number).tolist():
        yield f"without beam {beam} of every scan", beams.number == beam
