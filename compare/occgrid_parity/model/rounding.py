"""Which beams rounding decides: how far each endpoint is from a cell edge, and the ways that a beam can go.

A correct program may have other last bits in its sines, cosines and angles. How far its endpoint can lie from the
contract's is bounded here by a few units in the last place (u = 2^-52) of what enters it:

- the direction: 8 u (|theta| + |angle| + fov), for another order of its additions and another formula of the bearings;
- a recorded range is exact; a simulated one is N / R (numerator over the cross product of direction and wall), so its
  error is that of N over R plus the range times that of R over R, which grows for beams that graze a wall;
- the endpoint: the range's error, the range times the direction's error and 2 u, and 4 u of the coordinates;
- in cells: all that over the resolution, and 4 u of the number of cells;
- a pose that is read from a file, and the end of a range of 0 m, are exact, and so are their cells.

Where the cell, the hit or the wall is the same on the whole interval, no rounding can change the beam. Every other beam
is undecided, and all its ways are listed: both cells at an edge, hit and no return at the limit, either wall at a tip.
The bound says which beams may go either way, and nothing else: maps are compared bit by bit.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.noise import normal_deviate
from occgrid.scenario import Settings
from occgrid.sensor import Scan, beam_angles, read_ranges
from occgrid.world import Pose, Segment
from occgrid_parity.model.worlds import World

Array = npt.NDArray[np.float64]
Cells = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]

U = 2.0**-52
ANGLE_ULPS = 8.0
MARGIN = 1e-12  # of a hit below the maximum range (SPEC.md section 2.3)


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


@dataclass(frozen=True)
class Beams:
    """All beams of a world in one mode.

    ``scan`` and ``number`` say which one each is; ``ex`` and ``ey`` are the contract's endpoint (metres), ``edge`` its
    distance from the nearest cell edge (metres), ``error`` the bound on what rounding can do to it (metres).
    """

    scan: Cells
    number: Cells
    ex: Array
    ey: Array
    z: Array
    hit: Mask
    used: Mask
    edge: Array
    error: Array
    ways: Ways

    @property
    def undecided(self) -> Cells:
        """The beams with more than one way."""
        count = np.bincount(self.ways.beam, minlength=self.scan.size)
        return np.flatnonzero(count > 1)


@dataclass
class _Range:
    """One range that a beam can have: metres, and the bound on its error."""

    beam: Cells
    z: Array
    error: Array


def beams_of(world: World, seed: int | None, own_poses: bool = False) -> Beams:
    """All beams, and their ways.

    ``own_poses``: the program computes the poses itself, so they have errors, too.
    """
    known = seed is None and world.settings.beams == 1
    walls = tuple(world.walls)
    parts = [
        _known_beam(world.settings, walls, scan, number, own_poses)
        if known and not isinstance(scan, Scan)
        else _scan_beams(world, scan, number, seed, own_poses)
        for number, scan in enumerate(world.scans)
    ]
    counts = np.array([part.scan.size for part in parts])
    before = np.cumsum(counts) - counts
    ways = [
        replace(part.ways, beam=part.ways.beam + first)
        for part, first in zip(parts, before, strict=True)
    ]
    return Beams(
        scan=np.concatenate([p.scan for p in parts]),
        number=np.concatenate([p.number for p in parts]),
        ex=np.concatenate([p.ex for p in parts]),
        ey=np.concatenate([p.ey for p in parts]),
        z=np.concatenate([p.z for p in parts]),
        hit=np.concatenate([p.hit for p in parts]),
        used=np.concatenate([p.used for p in parts]),
        edge=np.concatenate([p.edge for p in parts]),
        error=np.concatenate([p.error for p in parts]),
        ways=Ways(
            beam=np.concatenate([w.beam for w in ways]),
            gx0=np.concatenate([w.gx0 for w in ways]),
            gy0=np.concatenate([w.gy0 for w in ways]),
            gx1=np.concatenate([w.gx1 for w in ways]),
            gy1=np.concatenate([w.gy1 for w in ways]),
            hit=np.concatenate([w.hit for w in ways]),
            used=np.concatenate([w.used for w in ways]),
            contract=np.concatenate([w.contract for w in ways]),
        ),
    )


def _known_beam(
    settings: Settings,
    walls: tuple[Segment, ...],
    pose: Pose,
    number: int,
    own_poses: bool,
) -> Beams:
    """A simulated scan of one beam without noise; kept, since the search cuts the same scans again and again."""
    beam = _one_beam(settings, walls, pose, own_poses)
    return replace(beam, scan=np.full(1, number))


@functools.lru_cache(50_000)  # some 2.5 kB each
def _one_beam(
    settings: Settings,
    walls: tuple[Segment, ...],
    pose: Pose,
    own_poses: bool,
) -> Beams:
    world = World(settings, walls, [pose])
    return _scan_beams(world, pose, 0, None, own_poses)


def _scan_beams(
    world: World,
    scan: Pose | Scan,
    number: int,
    seed: int | None,
    own_poses: bool,
) -> Beams:
    s = world.settings
    simulated = not isinstance(scan, Scan)
    pose = scan.pose if isinstance(scan, Scan) else scan
    angles = (
        scan.angles if isinstance(scan, Scan) else beam_angles(s.fov, s.beams)
    )
    n = angles.size
    swing = np.abs(angles) + abs(pose.theta) + (s.fov if simulated else 0.0)
    turn = ANGLE_ULPS * U * swing
    offset = 8.0 * U * (abs(pose.x) + abs(pose.y)) if own_poses else 0.0
    offset += 4.0 * U * s.max_range if own_poses else 0.0
    if isinstance(scan, Scan):
        ranges = scan.ranges
        candidates = [_Range(np.arange(n), ranges, np.zeros(n))]
    else:
        candidates = _cast(world, pose, angles, turn, offset)
        if seed is not None:
            _add_noise(candidates, world, seed, number)
        ranges = candidates[0].z
    z, hit, used = read_ranges(ranges, s.max_range, s.no_return)
    a = pose.theta + angles
    cos, sin = portable_math.cos(a), portable_math.sin(a)

    columns: list[tuple[npt.NDArray[np.generic], ...]] = []
    edge = np.full(n, np.inf)
    error = np.zeros(n)
    for i, one in enumerate(candidates):
        b = one.beam
        for hits in (True, False):
            can = (
                _can_hit(one, s.max_range)
                if hits
                else _can_miss(one, s.max_range)
            )
            chosen = np.flatnonzero(can)
            beam = b[chosen]
            length = one.z[chosen] if hits else np.full(beam.size, s.max_range)
            blur = one.error[chosen] if hits else np.zeros(beam.size)
            ex = pose.x + length * cos[beam]
            ey = pose.y + length * sin[beam]
            blur = blur + offset + length * (turn[beam] + 2.0 * U)
            blur = blur + 4.0 * U * (abs(pose.x) + abs(pose.y) + length)
            if not own_poses:  # x + 0 is x
                blur = np.where(length == 0.0, 0.0, blur)
            is_contract = (hit[beam] == hits) & (i == 0)
            _expand(
                columns,
                world,
                pose,
                offset,
                beam,
                (ex, ey),
                blur,
                hits,
                is_contract,
            )
            dx = _distance(ex, s.origin_x, s.resolution)
            dy = _distance(ey, s.origin_y, s.resolution)
            mine = beam[is_contract]
            edge[mine] = np.minimum(dx, dy)[is_contract] * s.resolution
            error[mine] = blur[is_contract]
    ways = _unique(columns, hit, used, n, s.no_return)
    ex, ey = pose.x + z * cos, pose.y + z * sin
    return Beams(
        np.full(n, number), np.arange(n), ex, ey, z, hit, used, edge, error, ways
    )  # fmt: skip


def _can_hit(one: _Range, z_max: float) -> Mask:
    with np.errstate(invalid="ignore"):
        return one.z - one.error < z_max - MARGIN


def _can_miss(one: _Range, z_max: float) -> Mask:
    with np.errstate(invalid="ignore"):
        return ~(one.z + one.error < z_max - MARGIN)


def _distance(value: Array, origin: float, resolution: float) -> Array:
    """From the nearest edge, in cells."""
    cells = (value - origin) / resolution
    return np.abs(cells - np.rint(cells))


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


def _expand(
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


def _unique(
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


def _cast(
    world: World, pose: Pose, angles: Array, turn: Array, offset: float
) -> list[_Range]:
    """Simulated ranges: the contract's first, then others that a beam can have at a wall's tip."""
    s = world.settings
    a = pose.theta + angles
    rdx, rdy = portable_math.cos(a), portable_math.sin(a)
    n = angles.size
    best, best_error = np.full(n, np.inf), np.zeros(n)
    sure, sure_error = np.full(n, np.inf), np.zeros(n)
    doubtful: list[tuple[Array, Array, Mask]] = []
    for wall in world.walls:
        t, error, meets, surely, possibly = _meet(
            pose, rdx, rdy, wall, turn, offset
        )
        nearer = meets & (t < best)
        best = np.where(nearer, t, best)
        best_error = np.where(nearer, error, best_error)
        nearer = surely & (t < sure)
        sure = np.where(nearer, t, sure)
        sure_error = np.where(nearer, error, sure_error)
        doubtful.append((t, error, possibly & ~surely))
    beams = np.arange(n)

    def range_of(chosen: Mask, t: Array, error: Array) -> _Range:
        beam = beams[chosen]
        far = ~(t[beam] <= s.max_range)
        z = np.where(far, s.max_range, t[beam])
        return _Range(beam, z, np.where(far, 0.0, error[beam]))

    found = [range_of(np.ones(n, dtype=bool), best, best_error)]
    other = sure != best
    if other.any():
        found.append(range_of(other, sure, sure_error))
    for t, error, maybe in doubtful:
        other = maybe & (t != best) & (t - error < sure)
        if other.any():
            found.append(range_of(other, t, error))
    # a range at the horizon itself, on either side of it
    first = found[0]
    close = np.abs(best - s.max_range) <= best_error
    if close.any():
        beam = beams[close]
        found.append(_Range(beam, best[beam], best_error[beam]))
        found.append(
            _Range(beam, np.full(beam.size, s.max_range), np.zeros(beam.size))
        )
    assert first is found[0]
    return found


def _meet(
    pose: Pose,
    rdx: Array,
    rdy: Array,
    wall: Segment,
    turn: Array,
    offset: float,
) -> tuple[Array, Array, Mask, Mask, Mask]:
    """Distance to a wall, its error; whether the contract meets it, surely does, possibly does."""
    sx, sy = wall.x1 - wall.x0, wall.y1 - wall.y0
    qpx, qpy = wall.x0 - pose.x, wall.y0 - pose.y
    length = math.hypot(sx, sy)
    reach = math.hypot(qpx, qpy)
    rxs = rdx * sy - rdy * sx
    rxs_error = length * (turn + 4.0 * U)
    parallel = np.abs(rxs) < 1e-12
    surely_parallel = np.abs(rxs) < 1e-12 - rxs_error
    surely_crossing = np.abs(rxs) > 1e-12 + rxs_error
    divisor = np.where(rxs == 0.0, 1.0, rxs)
    steep = np.maximum(np.abs(divisor), 1e-300)
    across = qpx * sy - qpy * sx
    t = across / divisor
    # rounding of the two products and differences, of a wall or pose that is itself computed
    across_error = 4.0 * U * (abs(qpx * sy) + abs(qpy * sx)) + offset * length
    t_error = (
        across_error + np.abs(t) * rxs_error
    ) / steep + 2.0 * U * np.abs(t)
    along = qpx * rdy - qpy * rdx
    u = along / divisor
    along_error = reach * (turn + 4.0 * U) + offset
    u_error = (along_error + np.abs(u) * rxs_error) / steep + 2.0 * U
    meets = ~parallel & (t >= 0.0) & (u >= 0.0) & (u <= 1.0)
    surely = (
        surely_crossing
        & (t - t_error >= 0.0)
        & (u - u_error >= 0.0)
        & (u + u_error <= 1.0)
    )
    # a robot on the wall itself: its distance is exactly 0 in every program
    surely |= (
        meets
        & (across == 0.0)
        & (offset == 0.0)
        & surely_crossing
        & ((u - u_error >= 0.0) & (u + u_error <= 1.0))
    )
    possibly = (
        ~surely_parallel
        & (t + t_error >= 0.0)
        & (u + u_error >= 0.0)
        & (u - u_error <= 1.0)
    )
    return t, t_error, meets, surely, possibly


def _add_noise(
    candidates: list[_Range], world: World, seed: int, scan: int
) -> None:
    """Noise on every range; a deviate may have other last bits, too."""
    s = world.settings
    for one in candidates:
        noise = normal_deviate(seed, scan, one.beam)
        one.z = np.clip(one.z + s.noise_std * noise, 0.0, s.max_range)
        one.error = one.error + 16.0 * U * (
            s.noise_std * np.abs(noise) + one.z
        )
