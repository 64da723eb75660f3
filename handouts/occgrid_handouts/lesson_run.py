"""The lesson, mapped noise-free: what the text says about it in numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from occgrid.fast import clip_ray
from occgrid.lesson import lesson_scenario, lesson_settings
from occgrid.mapper import simulated_scans
from occgrid.sensor import Scan, beam_endpoints, read_ranges
from occgrid_parity.model.map_history import maps_after_scans

Array = npt.NDArray[np.float64]
Cells = npt.NDArray[np.int64]

SNAPSHOTS = (1, 10, 120)


@dataclass(frozen=True)
class Beams:
    """All beams of the lesson in their order, (n,) each."""

    scan: Cells
    hit: npt.NDArray[np.bool_]
    ex: Array  # ends, metres
    ey: Array
    gx0: Cells  # the robot's cell
    gy0: Cells
    gx1: Cells  # the end's cell
    gy1: Cells


@dataclass(frozen=True)
class LessonRun:
    """The beams, the log-odds after some scans, and one cell's after every scan."""

    beams: Beams
    snapshots: dict[int, Array]
    history: Array  # (scans, height, width)


def run_lesson() -> LessonRun:
    """Maps the lesson noise-free and keeps what happens."""
    maps = maps_after_scans(lesson_scenario(), None)
    history = [grid.log_odds.copy() for grid in maps]
    snapshots = {scans: history[scans - 1] for scans in SNAPSHOTS}
    return LessonRun(lesson_beams(), snapshots, np.stack(history))


def lesson_beams(scans: Sequence[Scan] | None = None) -> Beams:
    """The beams of the lesson's scans, noise-free."""
    settings = lesson_settings()
    grid = settings.new_grid()
    scans = scans or list(simulated_scans(lesson_scenario(), None))
    parts: list[tuple[npt.NDArray[np.generic], ...]] = []
    for number, scan in enumerate(scans):
        x = np.full(scan.angles.size, scan.pose.x)
        y = np.full(scan.angles.size, scan.pose.y)
        z, hit, _ = read_ranges(
            scan.ranges, settings.max_range, settings.no_return
        )
        ex, ey = beam_endpoints(scan.pose, scan.angles, z)
        cells = (*grid.world_to_grid(x, y), *grid.world_to_grid(ex, ey))
        parts.append((np.full(hit.size, number), hit, ex, ey, *cells))
    return Beams(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def lesson_facts(run: LessonRun) -> dict[str, object]:
    """Sizes and counts of the lesson."""
    settings, beams = lesson_settings(), run.beams
    spec = settings.new_grid().spec
    first, last = clip_ray(
        beams.gx0, beams.gy0, beams.gx1, beams.gy1, spec.width, spec.height
    )
    updates = np.maximum(last - first + 1, 0)
    whole = (
        np.maximum(abs(beams.gx1 - beams.gx0), abs(beams.gy1 - beams.gy0)) + 1
    )
    outside = (beams.gx0 < 0) | (beams.gx0 >= spec.width)
    outside |= (beams.gy0 < 0) | (beams.gy0 >= spec.height)
    final = run.snapshots[SNAPSHOTS[-1]]
    seen = [int((run.snapshots[n] != 0.0).sum()) for n in SNAPSHOTS]
    return {
        "width": spec.width,
        "height": spec.height,
        "cells": spec.width * spec.height,
        "resolution": spec.resolution,
        "bytes": 8 * spec.width * spec.height,
        "scans": len(run.history),
        "beams_per_scan": settings.beams,
        "noise_cm": f"{100.0 * settings.noise_std:g}",
        "beams": int(beams.hit.size),
        "hits": int(beams.hit.sum()),
        "no_returns": int((~beams.hit).sum()),
        "beams_from_outside": int(outside.sum()),
        "line_cells": int(whole.sum()),
        "updates": int(updates.sum()),
        "cells_per_beam": round(float(updates.mean()), 1),
        "updates_per_cell": round(float(updates.sum() / final.size), 1),
        "snapshots": list(SNAPSHOTS),
        "seen": seen,
        "at_l_min": int((final == settings.l_min).sum()),
        "at_l_max": int((final == settings.l_max).sum()),
        "near_edge": near_edge(beams),
        "near_edge_tolerance": "1e-12",
    }


def near_edge(beams: Beams, tolerance: float = 1e-12) -> int:
    """Hits that end within a tolerance (metres) of an edge between cells."""
    spec = lesson_settings().new_grid().spec
    near = np.zeros(beams.hit.shape, dtype=bool)
    for end, origin in ((beams.ex, spec.origin_x), (beams.ey, spec.origin_y)):
        steps = (end - origin) / spec.resolution
        edge = np.round(steps) * spec.resolution + origin
        near |= np.abs(end - edge) <= tolerance
    return int((near & beams.hit).sum())
