"""Runs of the lesson with other sensor models: the clamp of section 6 and the two designs of Problem 5."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from occgrid.grid import sigmoid
from occgrid.lesson import lesson_scenario, lesson_settings
from occgrid_parity.model.map_history import maps_after_scans

Array = npt.NDArray[np.float64]

UNCLAMPED = 1000.0
DESIGNS = ((0.6, 0.4), (0.9, 0.1))
DESIGN_SCANS = (10, 120)


@dataclass(frozen=True)
class ClampStory:
    """One cell after every scan, with the clamp and without."""

    gx: int
    gy: int
    clamped: Array  # (scans,)
    unclamped: Array  # (scans,)


@dataclass(frozen=True)
class Design:
    """The lesson with one choice of p_occ and p_free."""

    p_occ: float
    p_free: float
    probability: dict[int, Array]  # after so many scans
    delta_occ: float
    delta_free: float
    at_clamp: dict[int, int]


def history(**changes: float) -> Array:
    """Log-odds of every cell after every scan of the lesson, (scans, height, width)."""
    scenario = lesson_scenario()
    scenario.settings = replace(scenario.settings, **changes)  # type: ignore[arg-type]
    return np.stack(
        [grid.log_odds.copy() for grid in maps_after_scans(scenario, None)]
    )


def clamp_story(clamped: Array) -> ClampStory:
    """The cell on which the clamp changes the verdict, or the log-odds, most."""
    free = history(l_min=-UNCLAMPED, l_max=UNCLAMPED)
    last, last_free = clamped[-1], free[-1]
    turned = (last > 0.0) != (last_free > 0.0)
    gap = np.abs(last - last_free) + np.where(turned, UNCLAMPED, 0.0)
    gap = np.where(last_free != 0.0, gap, 0.0)
    gy, gx = np.unravel_index(int(np.argmax(gap)), gap.shape)
    return ClampStory(int(gx), int(gy), clamped[:, gy, gx], free[:, gy, gx])


def clamp_facts(story: ClampStory) -> dict[str, object]:
    """What the figure shows, in numbers."""
    settings = lesson_settings()
    at = np.flatnonzero(
        (story.clamped == settings.l_min) | (story.clamped == settings.l_max)
    )
    bound = float(sigmoid(np.array([settings.l_max]))[0])
    return {
        "gx": story.gx,
        "gy": story.gy,
        "l_min": f"{settings.l_min:g}",
        "l_max": f"{settings.l_max:g}",
        "p_max": f"{bound:.5f}",
        "p_min": f"{1.0 - bound:.5f}",
        "first": int(at[0]) + 1 if at.size else 0,
        "scans_at_clamp": int(at.size),
        "last": f"{story.clamped[-1]:+.2f}",
        "last_unclamped": f"{story.unclamped[-1]:+.2f}",
        "lowest_unclamped": f"{story.unclamped.min():+.2f}",
        "highest_unclamped": f"{story.unclamped.max():+.2f}",
        "p_last": f"{float(sigmoid(story.clamped[-1:])[0]):.3f}",
        "p_last_unclamped": f"{float(sigmoid(story.unclamped[-1:])[0]):.3g}",
    }


def designs() -> list[Design]:
    """The lesson with the two designs of Problem 5."""
    made = []
    for p_occ, p_free in DESIGNS:
        steps = history(p_occ=p_occ, p_free=p_free)
        settings = replace(lesson_settings(), p_occ=p_occ, p_free=p_free)
        grid = settings.new_grid()
        bounds = (settings.l_min, settings.l_max)
        made.append(
            Design(
                p_occ,
                p_free,
                {n: sigmoid(steps[n - 1]) for n in DESIGN_SCANS},
                grid.l_occ - grid.l0,
                grid.l_free - grid.l0,
                {
                    n: int(np.isin(steps[n - 1], bounds).sum())
                    for n in DESIGN_SCANS
                },
            )
        )
    return made


def design_facts(made: list[Design]) -> list[dict[str, object]]:
    """The increments and how sure the maps are."""
    rows: list[dict[str, object]] = []
    for design in made:
        row: dict[str, object] = {
            "p_occ": f"{design.p_occ:g}",
            "p_free": f"{design.p_free:g}",
            "delta_occ": f"{design.delta_occ:+.4f}",
            "delta_free": f"{design.delta_free:+.4f}",
        }
        for n in DESIGN_SCANS:
            p = design.probability[n]
            seen = p[p != 0.5]
            unsure = (seen > 0.05) & (seen < 0.95)
            row[f"unsure_{n}"] = f"{100.0 * unsure.mean():.0f}"
            row[f"clamped_{n}"] = design.at_clamp[n]
        rows.append(row)
    return rows
