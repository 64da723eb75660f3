"""Numbers of the problems' solutions, computed with the Python port."""

from __future__ import annotations

import math

import numpy as np

from occgrid.grid import GridSpec, OccupancyGrid, logit, sigmoid
from occgrid.lesson import lesson_settings

EVIDENCE = ((0.5, 0.3), (0.5, 0.75), (0.2, 0.3))
STEPS = (1, 2, 3, 5, 10)


def problem_facts() -> dict[str, object]:
    """Problem 1: sizes; Problem 4: repeated evidence, by the formula and by updates."""
    width, height = math.floor(30.0 / 0.05), math.floor(20.0 / 0.05)
    settings = lesson_settings()
    odds = [
        {
            "p": f"{p:g}",
            "odds": f"{p / (1.0 - p):.4f}",
            "log_odds": f"{logit(p):+.4f}",
        }
        for p in (0.1, 0.3, 0.5, 0.75, 0.9)
    ]
    return {
        "sizing": {
            "width": width,
            "height": height,
            "cells": width * height,
            "bytes": 8 * width * height,
            "mb": f"{8 * width * height / 1e6:.2f}",
            "mib": f"{8 * width * height / 2**20:.2f}",
            "tenfold_mib": f"{8 * width * height * 100 / 2**20:.0f}",
        },
        "repeated": [_repeated(p0, p) for p0, p in EVIDENCE],
        "steps": list(STEPS),
        "odds": odds,
        "delta_occ": f"{logit(settings.p_occ) - logit(settings.p0):+.4f}",
        "delta_free": f"{logit(settings.p_free) - logit(settings.p0):+.4f}",
        "hits_to_clamp": _updates_to(settings.l_max, settings.p_occ),
        "misses_to_clamp": _updates_to(settings.l_min, settings.p_free),
        "p_occ": f"{settings.p_occ:g}",
        "p_free": f"{settings.p_free:g}",
        "p0": f"{settings.p0:g}",
    }


def _grid(p0: float, p: float, bound: float) -> OccupancyGrid:
    """One cell with log-odds from -bound to bound; evidence of a hit has the probability p."""
    spec = GridSpec(1, 1, 1.0, 0.0, 0.0)
    return OccupancyGrid(spec, p0, p, p, -bound, bound)


def _updates_to(bound: float, p: float) -> int:
    """How many updates in a row bring a cell of the lesson to the clamp."""
    grid, count = _grid(0.5, p, abs(bound)), 0
    while grid.log_odds[0, 0] != bound:
        grid.update_cell(0, 0, grid.l_occ)
        count += 1
    return count


def _repeated(p0: float, p: float) -> dict[str, object]:
    """p_t after t updates; the formula and the updates agree to the last printed digit."""
    grid = _grid(p0, p, 1000.0)
    prior, inverse = p0 / (1.0 - p0), p / (1.0 - p)
    rows = {}
    for t in range(1, max(STEPS) + 1):
        grid.update_cell(0, 0, grid.l_occ)
        odds = prior * (inverse / prior) ** t
        updated = float(sigmoid(np.array([grid.log_odds[0, 0]]))[0])
        formula = odds / (1.0 + odds)
        if abs(updated - formula) > 1e-12:
            raise ArithmeticError(f"Problem 4 fails for p0 = {p0}, p = {p}")
        rows[t] = f"{updated:.4f}"
    return {"p0": f"{p0:g}", "p": f"{p:g}", "values": [rows[t] for t in STEPS]}
