"""The ways that a beam can go, where rounding moves its start or its end into another cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from occgrid.world import Pose
from occgrid_parity.model.arithmetic import U
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.mapper_steps import Ends
from occgrid_parity.model.worlds import World


@dataclass(frozen=True)
class Ways:
    """Every way that every beam can go; arrays (n,), sorted by beam.

    ``beam`` counts the beams of all scans; ``contract`` marks the way of the contract, one for each beam. An ignored
    beam has the way with ``used`` False.
    """

    beam: Cells
    gx0: Cells
    gy0: Cells
    gx1: Cells
    gy1: Cells
    hit: Mask
    used: Mask
    contract: Mask


def _span(
    value: Array, error: Array, origin: float, resolution: float
) -> tuple[Cells, Cells, Cells]:
    """The cell of a coordinate, and the least and the largest that rounding can make of it."""
    cells = (value - origin) / resolution
    blur = error / resolution + 4.0 * U * (
        np.abs(cells) + (np.abs(value) + abs(origin)) / resolution
    )
    blur = np.where(
        error == 0.0, 0.0, blur
    )  # the same operations on the same numbers
    return (
        np.floor(cells).astype(np.int64),
        np.floor(cells - blur).astype(np.int64),
        np.floor(cells + blur).astype(np.int64),
    )


def add_ways(
    columns: list[tuple[npt.NDArray[np.generic], ...]],
    world: World,
    pose: Pose,
    offset: float,
    beam: Cells,
    end: tuple[Array, Array],
    blur: Array,
    hits: bool,
    is_contract: Mask,
) -> None:
    """Adds the ways of some beams: every cell that start and end can lie in."""
    s = world.settings
    n = beam.size
    still = np.full(n, offset)
    spans = [
        _span(np.full(n, pose.x), still, s.origin_x, s.resolution),
        _span(np.full(n, pose.y), still, s.origin_y, s.resolution),
        _span(end[0], blur, s.origin_x, s.resolution),
        _span(end[1], blur, s.origin_y, s.resolution),
    ]
    for choice in range(16):
        cells = []
        wanted = np.ones(n, dtype=bool)
        exact = is_contract.copy()
        for axis, (cell, low, high) in enumerate(spans):
            upper = bool(choice >> axis & 1)
            cells.append(high if upper else low)
            wanted &= (high > low) | (not upper)
            exact &= cells[-1] == cell
        if not wanted.any():
            continue
        kind = np.full(n, hits)
        row = (beam, *cells, kind, exact)
        columns.append(tuple(column[wanted] for column in row))


def unique_ways(
    columns: list[tuple[npt.NDArray[np.generic], ...]],
    hit: Mask,
    used: Mask,
    n: int,
    no_return: str,
) -> Ways:
    """The ways without those that come twice, sorted by beam; ignored beams have one way that is not used."""
    beam, gx0, gy0, gx1, gy1, hits, exact = (
        np.concatenate(column) for column in zip(*columns, strict=True)
    )
    hits, exact = hits.astype(bool), exact.astype(bool)
    counts = used[beam] if no_return == "free" else hits
    table = np.stack([beam, gx0, gy0, gx1, gy1, hits, counts, exact], axis=1)
    table = table.astype(np.int64)
    # an ignored beam's cells say nothing
    table[table[:, 6] == 0, 1:6] = 0
    order = np.lexsort(
        (-table[:, 7], *(table[:, c] for c in range(6, -1, -1)))
    )
    table = table[order]
    fresh = np.any(np.diff(table[:, :7], axis=0, prepend=-1) != 0, axis=1)
    table = table[fresh]
    columns_ = [table[:, c] for c in range(5)]
    flags = [table[:, c].astype(bool) for c in (5, 6, 7)]
    return Ways(*columns_, *flags)


def ways_of_ends(ways: Ways, ends: Ends) -> Cells:
    """For each beam (n,) the way between these ends, or the contract's where it is none of its ways."""
    chosen = np.flatnonzero(ways.contract)
    same = np.ones(ways.beam.shape, dtype=bool)
    for name, column in ends._asdict().items():
        same &= getattr(ways, name) == column[ways.beam]
    chosen[ways.beam[same]] = np.flatnonzero(same)
    return chosen
