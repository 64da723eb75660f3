"""The same maps, sooner: what only speed needs.

The printed program maps beam by beam. A call of NumPy costs as much as hundreds of its additions, and a beam takes
some thirty calls; so here the beams of many scans are traced in one go, and the updates of all their cells are applied
side by side, those of one cell in their order. The bits are those of the printed program: each step says why.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from occgrid.grid import Cells, Mask, OccupancyGrid
from occgrid.mapper import simulated_scans
from occgrid.ray import MAX_STEPS
from occgrid.scenario import Scenario
from occgrid.sensor import NoReturn, Scan, beam_endpoints, read_ranges
from occgrid.world import Pose

# beams that are traced together; bounds the memory, whatever the log
BATCH_BEAMS = 8192
# cells that are held at once: bounds the memory of an update, whatever the scans
MAX_CELLS = 1 << 21
# cells of a trace that are worked on at once, a line more or less: what stays in the processor's cache
CELLS_AT_ONCE = 1 << 15
# up to so many cells of the grid for each update, a table of the cells costs less than sorting the updates
SPREAD = 16


def map_scenario_fast(scenario: Scenario, seed: int | None) -> OccupancyGrid:
    """mapper.map_scenario, in less time."""
    settings = scenario.settings
    grid = settings.new_grid()
    for scans in _batches(simulated_scans(scenario, seed)):
        update_grid_from_scans(
            grid, scans, settings.max_range, settings.no_return
        )
    return grid


def _batches(scans: Iterator[Scan]) -> Iterator[list[Scan]]:
    """Scans in lists of BATCH_BEAMS beams, or a scan more."""
    batch: list[Scan] = []
    beams = 0
    for scan in scans:
        batch.append(scan)
        beams += scan.angles.size
        if beams >= BATCH_BEAMS:
            yield batch
            batch, beams = [], 0
    if batch:
        yield batch


# [snippet: update-grid-from-scans]
def update_grid_from_scans(
    grid: OccupancyGrid,
    scans: Sequence[Scan],
    z_max: float,
    no_return: NoReturn = "free",
) -> None:
    """update_grid_from_scan for several scans, in order."""
    beams = [scan.angles.size for scan in scans]
    x, y, theta = np.repeat([scan.pose for scan in scans], beams, axis=0).T
    angles = np.concatenate([scan.angles for scan in scans])
    ranges = np.concatenate([scan.ranges for scan in scans])

    z, hit, used = read_ranges(ranges, z_max, no_return)
    ex, ey = beam_endpoints(Pose(x, y, theta), angles, z)
    gx0, gy0 = grid.world_to_grid(x[used], y[used])
    gx1, gy1 = grid.world_to_grid(ex[used], ey[used])
    hit = hit[used]

    spec = grid.spec
    beams_at_once = max(1, MAX_CELLS // max(spec.width, spec.height))
    for i in range(0, hit.size, beams_at_once):
        part = slice(i, i + beams_at_once)
        ends = gx0[part], gy0[part], gx1[part], gy1[part]
        trace = _trace_rays(*ends, spec.width, spec.height)
        occupied = trace.ends & np.repeat(hit[part], trace.counts)
        _update_cells(grid, trace.cells, occupied)


# [/snippet]


# [snippet: clip-ray]
def clip_ray(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, width: int, height: int
) -> tuple[Cells, Cells]:
    """First and last step of each line that lie in the grid.

    A line that misses the grid gets last < first. All arguments but the
    grid's size may be arrays of one shape. No cell outside is visited:
    step k has gone m cells along the shorter axis, or more, exactly
    when 2 k b >= 2 a m - a + 1.
    """
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    if (a > MAX_STEPS).any():
        raise ValueError(f"a line of more than {MAX_STEPS} steps")
    along_x = dx >= dy
    # steps that each axis may go: low <= step <= high
    x_low, x_high = _steps_inside(gx0, gx1, width)
    y_low, y_high = _steps_inside(gy0, gy1, height)
    low, high = np.where(along_x, [x_low, x_high], [y_low, y_high])
    minor = np.where(along_x, [y_low, y_high], [x_low, x_high])
    minor_low, minor_high = minor
    enters = _first_step(minor_low, a, b)
    leaves = _first_step(minor_high + 1, a, b)
    first = np.maximum(np.maximum(low, 0), enters)
    last = np.minimum(np.minimum(high, a), leaves - 1)
    return first, last


def _steps_inside(g0: Cells, g1: Cells, size: int) -> tuple[Cells, Cells]:
    """Fewest and most cells to go from g0 towards g1 to be in 0 .. size-1."""
    forward = g0 < g1
    low = np.where(forward, -g0, g0 - (size - 1))
    high = np.where(forward, size - 1 - g0, g0)
    return low, high


def _first_step(m: Cells, a: Cells, b: Cells) -> Cells:
    """The first step that has gone m cells along the shorter axis."""
    never = a + 1
    ceiling = -((a - 1 - 2 * a * m) // np.maximum(2 * b, 1))
    return np.where(m <= 0, 0, np.where(b == 0, never, ceiling))


# [/snippet]


class _Trace(NamedTuple):
    """The cells in the grid of many lines, one line after another."""

    cells: Cells  # (cells,) flat indices gy * width + gx
    counts: Cells  # (lines,) cells of each line
    ends: Mask  # (cells,) whether a cell is the last of its whole line


def _trace_rays(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, width: int, height: int
) -> _Trace:
    """bresenham for many lines at once, only the cells in the grid.

    The same closed form, on long arrays: NumPy's cost is in the number of its calls. On too long ones it is in the
    memory, so the lines are taken some at a time.
    """
    first, last = clip_ray(gx0, gy0, gx1, gy1, width, height)
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    along_x = dx >= dy
    step_x = np.where(gx0 < gx1, 1, -1)
    step_y = np.where(gy0 < gy1, width, -width)
    major = np.where(along_x, step_x, step_y)
    minor = np.where(along_x, step_y, step_x)
    longest = np.maximum(a, 1)  # a line of one cell has step 0 only
    start = gy0 * width + gx0

    counts = np.maximum(last - first + 1, 0)
    after = np.cumsum(counts)  # cells of the lines up to each line
    cells = np.empty(after[-1] if after.size else 0, dtype=np.int64)
    lines = 0
    while lines < counts.size:
        done = after[lines - 1] if lines else 0
        upto = int(np.searchsorted(after, done + CELLS_AT_ONCE)) + 1
        part = slice(lines, upto)
        n = counts[part]
        k = np.arange(after[part][-1] - done)
        k -= np.repeat(after[part] - done - n - first[part], n)
        # In floating point: with extents of at most a million the quotient is at least 1 / (2 a) below the next
        # integer, or is that integer, and so never rounds up to it.
        quotient = k * np.repeat(2.0 * b[part], n)
        quotient += np.repeat(longest[part] - 1.0, n)
        quotient /= np.repeat(2.0 * longest[part], n)
        found = quotient.astype(np.int64)  # not negative: its floor
        found *= np.repeat(minor[part], n)
        k *= np.repeat(major[part], n)
        found += k
        found += np.repeat(start[part], n)
        cells[done : done + k.size] = found
        lines = upto

    ends = np.zeros(cells.size, dtype=np.bool_)
    ends[after[(counts > 0) & (last == a)] - 1] = True
    return _Trace(cells, counts, ends)


def _update_cells(grid: OccupancyGrid, cells: Cells, occupied: Mask) -> None:
    """Apply update_cell to many cells in order, as l_occ where ``occupied`` and l_free elsewhere.

    cells: (n,) flat indices gy * width + gx, all in the grid, any of them repeated; occupied: (n,).

    Cells are independent of each other: only the order of the updates of one cell counts. Most cells are only
    passed, and need but the count of it.
    """
    if cells.size == 0:
        return
    low, high = int(cells.min()), int(cells.max())
    if high - low < SPREAD * cells.size:
        hit = np.zeros(high - low + 1, dtype=np.bool_)
        hit[cells[occupied] - low] = True
        ordered = hit[cells - low]
        _update_passed_cells(grid, cells[~ordered] - low, low)
        cells, occupied = cells[ordered], occupied[ordered]
    _update_cells_in_order(grid, cells, occupied)


def _update_passed_cells(grid: OccupancyGrid, cells: Cells, low: int) -> None:
    """update_cells where nothing is occupied, of the cells low + ``cells``."""
    times = np.bincount(cells)
    touched = np.flatnonzero(times)
    times = times[touched]
    most_first = np.argsort(-times)
    touched = touched[most_first] + low
    values = grid.log_odds.reshape(-1)[touched]
    step = grid.l_free - grid.l0
    bound = grid.l_min if step < 0.0 else grid.l_max
    for n in _how_many_reach(times[most_first]):
        head = values[:n]
        head += step
        np.maximum(head, grid.l_min, out=head)
        np.minimum(head, grid.l_max, out=head)
        if (head == bound).all():
            break  # where they stay
    grid.log_odds.reshape(-1)[touched] = values


def _update_cells_in_order(
    grid: OccupancyGrid, cells: Cells, occupied: Mask
) -> None:
    """update_cells by sorting the updates by cell, in order within it, and applying the j-th of all at once."""
    # cell, place in the order and kind in one number each: sorting these is much faster than a stable argsort
    bits = int(cells.size).bit_length() + 1
    keys = cells << bits | np.arange(cells.size) << 1 | occupied
    keys.sort()
    cells = keys >> bits
    steps = np.where(keys & 1, grid.l_occ - grid.l0, grid.l_free - grid.l0)

    starts = np.flatnonzero(np.diff(cells, prepend=-1))
    counts = np.diff(starts, append=cells.size)
    most_first = np.argsort(-counts)
    starts, counts = starts[most_first], counts[most_first]
    touched = cells[starts]
    values = grid.log_odds.reshape(-1)[touched]
    for j, n in enumerate(_how_many_reach(counts)):
        head = values[:n]
        head += steps[starts[:n] + j]
        np.maximum(head, grid.l_min, out=head)
        np.minimum(head, grid.l_max, out=head)
    grid.log_odds.reshape(-1)[touched] = values


def _how_many_reach(counts: Cells) -> list[int]:
    """How many of the counts, the greatest first, are more than j: for j = 0, 1, ..., below the greatest."""
    most = counts[0] if counts.size else 0
    reached = np.searchsorted(-counts, -np.arange(most), side="left")
    return list(map(int, reached))
