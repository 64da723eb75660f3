"""The worked example: the single beam of scenarios/one-beam.log."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from occgrid.grid import OccupancyGrid
from occgrid.mapper import map_scenario
from occgrid.ray import bresenham
from occgrid.scenario import read_scenario
from occgrid.sensor import Scan, beam_endpoints, read_ranges

SCENARIO = "scenarios/one-beam.log"


@dataclass(frozen=True)
class OneBeam:
    """The beam and the map that it leaves."""

    x: float
    y: float
    theta: float
    angle: float
    range: float
    ex: float
    ey: float
    hit: bool
    cells: list[tuple[int, int]]
    grid: OccupancyGrid


def run_one_beam(root: Path) -> OneBeam:
    """Maps the scenario with the Python port."""
    with read_scenario(root / SCENARIO) as scenario:
        settings = scenario.settings
        (scan,) = scenario.scans
    if not isinstance(scan, Scan) or scan.ranges.size != 1:
        raise ValueError(f"{SCENARIO} is to have one recorded beam")
    with read_scenario(root / SCENARIO) as scenario:
        grid = map_scenario(scenario, None)
    z, hit, _ = read_ranges(
        scan.ranges, settings.max_range, settings.no_return
    )
    x, y = np.array([scan.pose.x]), np.array([scan.pose.y])
    ex, ey = beam_endpoints(scan.pose, scan.angles, z)
    gx0, gy0 = grid.world_to_grid(x, y)
    gx1, gy1 = grid.world_to_grid(ex, ey)
    cells = bresenham(int(gx0[0]), int(gy0[0]), int(gx1[0]), int(gy1[0]))
    return OneBeam(
        *scan.pose,
        angle=float(scan.angles[0]),
        range=float(z[0]),
        ex=float(ex[0]),
        ey=float(ey[0]),
        hit=bool(hit[0]),
        cells=list(zip(cells[0].tolist(), cells[1].tolist(), strict=True)),
        grid=grid,
    )


def one_beam_facts(beam: OneBeam) -> dict[str, object]:
    """The example's numbers, rounded for print, and its cells."""
    grid = beam.grid
    probability = grid.probability_grid()
    log_odds: npt.NDArray[np.float64] = grid.log_odds
    (gx0, gy0), (gx1, gy1) = beam.cells[0], beam.cells[-1]
    return {
        "file": SCENARIO,
        "width": grid.spec.width,
        "height": grid.spec.height,
        "resolution": f"{grid.spec.resolution:g}",
        "x": f"{beam.x:g}",
        "y": f"{beam.y:g}",
        "theta": f"{beam.theta:g}",
        "angle": f"{beam.angle:.4f}",
        "angle_degrees": f"{math.degrees(beam.angle):.2f}",
        "range": f"{beam.range:.4f}",
        "ex": f"{beam.ex:.4f}",
        "ey": f"{beam.ey:.4f}",
        "ex_exact": repr(beam.ex),
        "ey_exact": repr(beam.ey),
        "hit": beam.hit,
        "dx": abs(gx1 - gx0),
        "dy": abs(gy1 - gy0),
        "count": len(beam.cells),
        "delta_occ": f"{grid.l_occ - grid.l0:+.4f}",
        "delta_free": f"{grid.l_free - grid.l0:+.4f}",
        "cells": [
            {
                "k": k,
                "gx": gx,
                "gy": gy,
                "free": not (beam.hit and k == len(beam.cells) - 1),
                "log_odds": f"{log_odds[gy, gx]:+.4f}",
                "p": f"{probability[gy, gx]:.4f}",
            }
            for k, (gx, gy) in enumerate(beam.cells)
        ],
        "untouched": int((log_odds == grid.l0).sum()),
    }
