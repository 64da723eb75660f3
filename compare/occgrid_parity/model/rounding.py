"""Which beams rounding decides: how far each endpoint is from a cell edge, and the ways that a beam can go.

A correct program may have other last bits in its sines, cosines and angles. How far its endpoint can lie from the
contract's is bounded here by a few units in the last place (u = 2^-52) of what enters it:

- the direction: 8 u (|theta| + |angle| + fov), for another order of its additions and another formula of the bearings;
- a recorded range is exact; a simulated one is N / R (numerator over the cross product of direction and wall), so its
  error is that of N over R plus the range times that of R over R, which grows for beams that graze a wall;
- the endpoint: the range's error, the range times the direction's error and 2 u, and 4 u of the coordinates;
- in cells: all that over the resolution, and 4 u of the number of cells;
- a pose that is read from a file, and the end of a range of 0 m, are exact, and so are their cells;
- at heading 0, the middle one of 3, 5, 9, ... beams has the direction (1, 0) exactly, so that it meets a wall straight
  across even where this ends on the beam;
- a program that computes the lesson's poses has errors in them, but for the first: cos(0) is 1 and sin(0) is 0.

Where the cell, the hit or the wall is the same on the whole interval, no rounding can change the beam. Every other beam
is undecided, and all its ways are listed: both cells at an edge, hit and no return at the limit, either wall at a tip.
The bound says which beams may go either way, and nothing else: maps are compared bit by bit.
"""

from __future__ import annotations

import functools
import itertools
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from occgrid import portable_math
from occgrid.lesson import lesson_poses
from occgrid.scenario import Settings
from occgrid.sensor import Scan, beam_angles, read_ranges
from occgrid.world import Pose, Segment
from occgrid_parity.model.arithmetic import U
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.beam_ways import Ways, add_ways, unique_ways
from occgrid_parity.model.uncertain_ranges import (
    UncertainRange,
    add_noise,
    can_hit,
    can_miss,
    cast,
)
from occgrid_parity.model.worlds import World

ANGLE_ULPS = 8.0
FIRST_POSE = lesson_poses()[0]
KEPT = 64  # worlds in a mode: those of the suite, which a class asks for again and again, and some more
KEPT_BEAMS = 300_000  # of all of them together, at some 200 bytes each


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


class _LastBeams:
    """Keeps the beams of the worlds that were looked at last: a check asks for the same ones several times."""

    def __init__(self) -> None:
        self.known: list[tuple[World, int | None, bool, Beams]] = []

    def of(self, world: World, seed: int | None, own_poses: bool) -> Beams:
        known = [one for one in self.known if one[0] is world]
        found = next((x for x in known if x[1:3] == (seed, own_poses)), None)
        if found is None:
            beams = _all_beams(world, seed, own_poses)
            found = world, seed, own_poses, beams
        others = [one for one in self.known if one is not found]
        sizes = itertools.accumulate(one[3].scan.size for one in others)
        kept = sum(size < KEPT_BEAMS for size in sizes)
        self.known = [found, *others[: min(kept, KEPT - 1)]]
        return found[3]


_last = _LastBeams()


def beams_of(world: World, seed: int | None, own_poses: bool = False) -> Beams:
    """All beams, and their ways.

    ``own_poses``: the program computes the poses itself, so they have errors, too.
    """
    return _last.of(world, seed, own_poses)


def _all_beams(world: World, seed: int | None, own_poses: bool) -> Beams:
    walls = tuple(world.walls)
    parts = [
        _known_scan(world.settings, walls, scan, number, own_poses)
        if seed is None and not isinstance(scan, Scan)
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


def _known_scan(
    settings: Settings,
    walls: tuple[Segment, ...],
    pose: Pose,
    number: int,
    own_poses: bool,
) -> Beams:
    """A simulated scan without noise; kept, since the same scans are looked at again in other scenarios."""
    known = _scan_of_one if settings.beams == 1 else _scan_of_many
    beams = known(settings, walls, pose, own_poses)
    return replace(beams, scan=np.full(beams.scan.size, number))


def _one_scan(
    settings: Settings,
    walls: tuple[Segment, ...],
    pose: Pose,
    own_poses: bool,
) -> Beams:
    world = World(settings, walls, [pose])
    return _scan_beams(world, pose, 0, None, own_poses)


_scan_of_one = functools.lru_cache(50_000)(_one_scan)  # some 2.5 kB each
_scan_of_many = functools.lru_cache(256)(_one_scan)  # twice the lesson


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
    own_poses = own_poses and pose != FIRST_POSE
    offset = 8.0 * U * (abs(pose.x) + abs(pose.y)) if own_poses else 0.0
    offset += 4.0 * U * s.max_range if own_poses else 0.0
    if isinstance(scan, Scan):
        ranges = scan.ranges
        candidates = [UncertainRange(np.arange(n), ranges, np.zeros(n))]
    else:
        candidates = cast(world, pose, angles, turn, offset)
        if seed is not None:
            add_noise(candidates, world, seed, number)
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
                can_hit(one, s.max_range)
                if hits
                else can_miss(one, s.max_range)
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
            add_ways(
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
    ways = unique_ways(columns, hit, used, n, s.no_return)
    ex, ey = pose.x + z * cos, pose.y + z * sin
    return Beams(
        np.full(n, number), np.arange(n), ex, ey, z, hit, used, edge, error, ways
    )  # fmt: skip


def _distance(value: Array, origin: float, resolution: float) -> Array:
    """From the nearest edge, in cells."""
    cells = (value - origin) / resolution
    return np.abs(cells - np.rint(cells))
