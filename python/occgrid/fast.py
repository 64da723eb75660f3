"""The same maps, sooner: everything that only speed needs.

The printed program maps beam by beam. One call of NumPy costs as much as hundreds of its additions, and a beam of some
sixty cells takes thirty calls. Here the beams of many scans are traced together, and the updates of all their cells are
applied side by side, those of one cell in their order: the lesson is mapped in a twentieth of the time. The comments
show why the bits are those of the printed program.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from occgrid.grid import Cells, OccupancyGrid
from occgrid.mapper import simulated_scans
from occgrid.portable_math import Mask
from occgrid.ray import MAX_STEPS
from occgrid.scenario import Scenario
from occgrid.sensor import NoReturn, Scan, beam_endpoints, read_ranges
from occgrid.world import Pose

# Beams that are read together; bounds the memory, whatever the log.
BATCH_BEAMS = 8192
# Updates that are applied together; bounds the memory, whatever the beams.
BATCH_CELLS = 1 << 20
# Cells that are traced together, a line more or less: what stays in the processor's cache.
CELLS_AT_ONCE = 1 << 15
# Up to so many cells of the grid for each update, a table of the cells costs less than sorting the updates.
SPREAD = 4


# [snippet: clip-ray]
def clip_ray(
    gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells, width: int, height: int
) -> tuple[Cells, Cells]:
    """First and last step of each line (n,) that lie in the grid; (n,) each.

    A line that misses the grid gets last < first. No cell is visited:
    step k has gone m cells or more along the shorter axis exactly when
    2 k b >= 2 a m - a + 1. Example: from (-2, 0) to (4, 3), a = 6, b = 3,
    on a grid of 3 x 3. x is in the grid at the steps 2 to 4. y leaves it
    with m = 3, so at the first k with 6 k >= 31, which is 6. Steps 2 to 4
    are in the grid. ValueError above 2**20 steps, as for bresenham.
    """
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    if (a > MAX_STEPS).any():
        raise ValueError(f"a line of {a.max()} steps, more than {MAX_STEPS}")
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


# [snippet: update-grid-from-scans]
def update_grid_from_scans(
    grid: OccupancyGrid,
    scans: Sequence[Scan],
    z_max: float,
    no_return: NoReturn = "free",
) -> None:
    """update_grid_from_scan for each of the scans in turn, all at once.

    The steps are those of update_grid_from_scan, on the beams of all
    scans. Only the order of the updates of one cell matters for its
    value, and _update_cells keeps that order.
    """
    if not scans:
        return
    beams = [scan.angles.size for scan in scans]
    x, y, theta = np.repeat([scan.pose for scan in scans], beams, axis=0).T
    if beams != [scan.ranges.size for scan in scans]:
        raise ValueError("a scan needs as many ranges as bearings")
    angles = np.concatenate([scan.angles for scan in scans])
    ranges = np.concatenate([scan.ranges for scan in scans])
    z, hit, used = read_ranges(ranges, z_max, no_return)
    ex, ey = beam_endpoints(Pose(x, y, theta), angles, z)
    gx0, gy0 = grid.world_to_grid(x[used], y[used])
    gx1, gy1 = grid.world_to_grid(ex[used], ey[used])
    width, height = grid.spec.width, grid.spec.height
    lines = _lines_in_grid(gx0, gy0, gx1, gy1, hit[used], width, height)
    for part in _parts(lines.counts, BATCH_CELLS):
        cells, occupied = _trace_rays(lines.part(part))
        _update_cells(grid, cells, occupied)


# [/snippet]


def map_scenario_fast(scenario: Scenario, seed: int | None) -> OccupancyGrid:
    """mapper.map_scenario in less time; the same arguments, result and errors."""
    settings = scenario.settings
    grid = settings.new_grid()
    for scans in _batches(simulated_scans(scenario, seed)):
        update_grid_from_scans(
            grid, scans, settings.max_range, settings.no_return
        )
    return grid


def _batches(scans: Iterator[Scan]) -> Iterator[list[Scan]]:
    """Scans in lists of BATCH_BEAMS beams, up to a scan more."""
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


def _parts(counts: Cells, most: int) -> Iterator[slice]:
    """Consecutive lines whose cells, ``counts`` (n,), are ``most`` in all or fewer, or a single line with more."""
    after = np.cumsum(counts)
    start = 0
    while start < counts.size:
        done = after[start - 1] if start else 0
        stop = int(np.searchsorted(after, done + most, side="right"))
        stop = max(stop, start + 1)
        yield slice(start, stop)
        start = stop


# --- The cells of many lines ---


class _Lines(NamedTuple):
    """Lines cut to the grid, (n,) each; cells are flat indices gy * width + gx."""

    first: Cells  # the first step in the grid
    counts: Cells  # how many steps are in the grid
    hit: Mask  # whether the last of these is the cell of a hit
    a: Cells  # extent along the longer axis
    b: Cells  # extent along the shorter axis
    start: Cells  # index of step 0, which may lie outside
    major: Cells  # what a step along the longer axis adds to the index
    minor: Cells  # what a step along the shorter axis adds to it

    def part(self, part: slice) -> _Lines:
        """Some of the lines."""
        return _Lines(*map(itemgetter(part), self))


def _lines_in_grid(
    gx0: Cells,
    gy0: Cells,
    gx1: Cells,
    gy1: Cells,
    hit: Mask,
    width: int,
    height: int,
) -> _Lines:
    """The lines from (gx0, gy0) to (gx1, gy1), which ends at a hit where ``hit``; all (n,)."""
    first, last = clip_ray(gx0, gy0, gx1, gy1, width, height)
    counts = np.maximum(last - first + 1, 0)
    dx, dy = np.abs(gx1 - gx0), np.abs(gy1 - gy0)
    a, b = np.maximum(dx, dy), np.minimum(dx, dy)
    step_x = np.where(gx0 < gx1, 1, -1)
    step_y = np.where(gy0 < gy1, width, -width)
    along_x = dx >= dy
    return _Lines(
        first,
        counts,
        hit & (last == a) & (counts > 0),
        a,
        b,
        gy0 * width + gx0,
        np.where(along_x, step_x, step_y),
        np.where(along_x, step_y, step_x),
    )


def _trace_rays(lines: _Lines) -> tuple[Cells, Mask]:
    """bresenham for many lines: their cells in the grid, one line after another, and which are cells of hits.

    Cells outside are never computed; the printed program computes and skips them.
    """
    parts = [
        _trace_part(lines.part(part))
        for part in _parts(lines.counts, CELLS_AT_ONCE)
    ]
    cells = np.concatenate(parts) if parts else np.empty(0, dtype=np.int64)
    occupied = np.zeros(cells.size, dtype=np.bool_)
    ends = np.cumsum(lines.counts) - 1
    occupied[ends[lines.hit]] = True
    return cells, occupied


def _trace_part(lines: _Lines) -> Cells:
    """The cells in the grid of some lines, by bresenham's closed form on one long array.

    Example: two lines with counts = [3, 2] and first = [0, 4] have the steps k = [0, 1, 2, 4, 5]. Their start, a, b,
    major and minor are repeated 3 and 2 times, and the index of each cell is start + k * major + minor(k) * minor.

    minor(k) = floor((2 k b + a - 1) / (2 a)) is computed in floating point, where division is several times as fast.
    That is exact: the numerator is below 2**42, and a quotient that is no integer lies at least 1 / (2 a) >= 2**-21
    below the next one, while rounding moves a quotient below 2**21 by at most 2**-33.
    """
    n = lines.counts
    after = np.cumsum(n)
    k = np.arange(after[-1])
    k -= np.repeat(after - n - lines.first, n)
    a = np.maximum(lines.a, 1)  # a line of one cell has step 0 only
    quotient = k * np.repeat(2.0 * lines.b, n)
    quotient += np.repeat(a - 1.0, n)
    quotient /= np.repeat(2.0 * a, n)
    cells = quotient.astype(np.int64)  # not negative: its floor
    cells *= np.repeat(lines.minor, n)
    k *= np.repeat(lines.major, n)
    cells += k
    cells += np.repeat(lines.start, n)
    return cells


# --- The updates of many cells ---


def _update_cells(grid: OccupancyGrid, cells: Cells, occupied: Mask) -> None:
    """update_cell for many cells in order, with l_occ where ``occupied`` and l_free elsewhere.

    cells: (n,) flat indices gy * width + gx, all in the grid, any of them repeated; occupied: (n,).

    grid[cells] += step would add once to a cell that stands there twice, and clamp it once. Updates of different cells
    do not influence each other, so those of one cell are put together. Most cells are only passed by beams: all their
    updates are alike, and their number is enough. The others need theirs in order.
    Example: cells [7, 3, 7, 7, 3], of which the fourth is occupied. Cell 3 is passed twice. Cell 7 gets free, free,
    occupied, in this order.
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
    """_update_cells where nothing is occupied, of the cells low + ``cells``.

    Example: cells [4, 9, 4, 4, 9] are counted: 4 three times, 9 twice. The step is added, and clamped, to both, to both
    and to cell 4: the same additions as one by one, in three calls. At the bound they stay, however many follow.
    """
    times = np.bincount(cells)
    touched = np.flatnonzero(times)
    times = times[touched]
    most_first = np.argsort(-times)
    gy, gx = np.divmod(touched[most_first] + low, grid.spec.width)
    values = grid.log_odds[gy, gx]
    step = grid.l_free - grid.l0
    bound = grid.l_min if step < 0.0 else grid.l_max
    for n in _how_many_reach(times[most_first]):
        head = values[:n]
        head += step
        np.clip(head, grid.l_min, grid.l_max, out=head)
        if (head == bound).all():
            break
    grid.log_odds[gy, gx] = values


def _update_cells_in_order(
    grid: OccupancyGrid, cells: Cells, occupied: Mask
) -> None:
    """_update_cells by sorting the updates by cell, in order within it, and applying the j-th of all cells at once.

    Example: cells [7, 3, 7, 7] with steps [f, f, f, o] become 3: f and 7: f, f, o. Cell 7 has most updates and comes
    first: f to 7 and 3, f to 7, o to 7.
    """
    # Cell, place in the order and kind in one number each: sorting these is much faster than a stable argsort.
    # 25 million cells and a million updates take 25 + 21 + 1 of its 63 bits.
    bits = int(cells.size).bit_length() + 1
    keys = cells << bits | np.arange(cells.size) << 1 | occupied
    keys.sort()
    cells = keys >> bits
    steps = np.where(keys & 1, grid.l_occ - grid.l0, grid.l_free - grid.l0)

    starts = np.flatnonzero(np.diff(cells, prepend=-1))
    counts = np.diff(starts, append=cells.size)
    most_first = np.argsort(-counts)
    starts, counts = starts[most_first], counts[most_first]
    gy, gx = np.divmod(cells[starts], grid.spec.width)
    values = grid.log_odds[gy, gx]
    for j, n in enumerate(_how_many_reach(counts)):
        head = values[:n]
        head += steps[starts[:n] + j]
        np.clip(head, grid.l_min, grid.l_max, out=head)
    grid.log_odds[gy, gx] = values


def _how_many_reach(counts: Cells) -> list[int]:
    """How many of the counts, the greatest first, are more than j: for j = 0, 1, ..., below the greatest.

    Example: counts [3, 2, 2] give [3, 3, 1].
    """
    most = counts[0] if counts.size else 0
    reached = np.searchsorted(-counts, -np.arange(most), side="left")
    return list(map(int, reached))
