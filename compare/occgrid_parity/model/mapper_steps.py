"""The contract once more, one short method for each step, so that a mistake can be planted in one of them.

Without a mistake it draws the same bits as the reference; a test holds it to that.
"""

from __future__ import annotations

import functools
from collections.abc import Iterable, Iterator
from typing import ClassVar, NamedTuple

import numpy as np

from occgrid.sensor import Scan
from occgrid.world import Pose, Segment
from occgrid_parity.model import arithmetic
from occgrid_parity.model.arithmetic import Arithmetic
from occgrid_parity.model.array_types import (
    Array,
    Cells,
    Mask,
    index_type,
)
from occgrid_parity.model.line_cells import Lines, contract_lines
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.suite.cases import Case

SIDEWAYS = 2  # cells, at the most, from a line to a cell that it visits
BATCH_BEAMS = 1 << 12
BATCH_CELLS = 1 << 17


class Drawn(NamedTuple):
    """A map: log-odds (height, width), smallest y first; pixels in the file's order, largest y first."""

    log_odds: Array
    pixels: Cells


class Traced(NamedTuple):
    """Updates in order: the scan and the cell of each, and whether it is occupied; all (n,)."""

    scan: Cells
    gx: Cells
    gy: Cells
    occupied: Mask

    def where(self, chosen: Cells) -> Traced:
        """Some of the updates, or all of them in another order."""
        return Traced(
            self.scan[chosen],
            self.gx[chosen],
            self.gy[chosen],
            self.occupied[chosen],
        )

    def within(self, window: Window) -> Traced:
        """The updates of the cells of a window."""
        inside = (self.gx >= window.left) & (self.gx < window.right)
        inside &= (self.gy >= window.bottom) & (self.gy < window.top)
        return self.where(np.flatnonzero(inside))


class Window(NamedTuple):
    """A rectangle of cells; the right and the upper border belong to it no more."""

    left: int
    bottom: int
    right: int
    top: int


class Ends(NamedTuple):
    """The cells in which beams start and end, and which of them are hits; all (n,)."""

    gx0: Cells
    gy0: Cells
    gx1: Cells
    gy1: Cells
    hit: Mask

    def where(self, chosen: Mask | slice) -> Ends:
        """Some of the beams."""
        return Ends(
            self.gx0[chosen],
            self.gy0[chosen],
            self.gx1[chosen],
            self.gy1[chosen],
            self.hit[chosen],
        )

    def near(self, window: Window) -> Mask:
        """Which beams can come into a window.

        The rectangle between their ends meets it, and its corners do not all lie SIDEWAYS on one side of the line.
        """
        left, bottom, right, top = window
        near = (
            (np.minimum(self.gx0, self.gx1) < right)
            & (np.maximum(self.gx0, self.gx1) >= left)
            & (np.minimum(self.gy0, self.gy1) < top)
            & (np.maximum(self.gy0, self.gy1) >= bottom)
        )
        dx, dy = self.gx1 - self.gx0, self.gy1 - self.gy0
        aside = [
            dx * (y - self.gy0) - dy * (x - self.gx0)
            for x in (left, right - 1)
            for y in (bottom, top - 1)
        ]
        margin = SIDEWAYS * np.maximum(np.abs(dx), np.abs(dy))
        near &= np.minimum.reduce(aside) <= margin
        near &= np.maximum.reduce(aside) >= -margin
        return near

    @property
    def cells(self) -> Cells:
        """How many cells the line of each has, about."""
        dx, dy = np.abs(self.gx1 - self.gx0), np.abs(self.gy1 - self.gy0)
        cells: Cells = np.maximum(dx, dy) + 1
        return cells


class ScanEnds(NamedTuple):
    """Beams, and the numbers of their scans (n,)."""

    scan: Cells
    ends: Ends


def many_in_one(scans: Iterable[Scan]) -> Iterator[tuple[Cells, Scan]]:
    """The beams of many scans as one scan, and the number of the scan of each beam; BATCH_BEAMS or a scan more.

    The numbers of its pose are arrays, one for each beam.
    """
    for part in _batched(enumerate(scans)):
        sizes = [scan.angles.size for _, scan in part]
        numbers = np.repeat([number for number, _ in part], sizes)
        poses = np.repeat([scan.pose for _, scan in part], sizes, axis=0)
        angles = np.concatenate([scan.angles for _, scan in part])
        ranges = np.concatenate([scan.ranges for _, scan in part])
        yield numbers, Scan(Pose(*poses.T), angles, ranges)


def _batched(
    scans: Iterable[tuple[int, Scan]],
) -> Iterator[list[tuple[int, Scan]]]:
    part: list[tuple[int, Scan]] = []
    beams = 0
    for number, scan in scans:
        part.append((number, scan))
        beams += scan.angles.size
        if beams >= BATCH_BEAMS:
            yield part
            part, beams = [], 0
    if part:
        yield part


def _whole_scans(numbers: Cells, cells: Cells) -> Iterator[slice]:
    """Consecutive beams of whole scans, which have BATCH_CELLS cells, up to a scan more."""
    starts = np.flatnonzero(np.diff(numbers, prepend=-1))
    sums = np.add.reduceat(cells, starts) if starts.size else starts
    first, many = 0, 0
    for start, own in zip(starts.tolist(), sums.tolist(), strict=True):
        if many > BATCH_CELLS:
            yield slice(first, start)
            first, many = start, 0
        many += own
    if numbers.size:
        yield slice(first, numbers.size)


def meeting(
    x: float | Array,
    y: float | Array,
    rdx: Array,
    rdy: Array,
    wall: Segment,
    least: float = 1e-12,
) -> tuple[Array, Mask]:
    """How far rays from points (metres) go to a wall's line, and which of them meet the wall (3.2)."""
    sx, sy = wall.x1 - wall.x0, wall.y1 - wall.y0
    qpx, qpy = wall.x0 - x, wall.y0 - y
    rxs = rdx * sy - rdy * sx
    parallel = np.abs(rxs) < least
    rxs = np.where(parallel, 1.0, rxs)
    t = (qpx * sy - qpy * sx) / rxs
    u = (qpx * rdy - qpy * rdx) / rxs
    meets = ~parallel & (t >= 0.0) & (u >= 0.0) & (u <= 1.0)
    return t, meets


@functools.lru_cache(512)
def _cast(
    walls: tuple[Segment, ...],
    points: bytes,
    beams: bytes,
    z_max: float,
    numbers: Arithmetic,
    least: float,
) -> Array:
    """Ranges (k, n) from points x, y along n directions each (3.2); kept, since most mistakes see the same ranges."""
    x, y = np.frombuffer(points).reshape(2, -1, 1)
    flat = arithmetic.directions(np.frombuffer(beams), numbers)
    rdx, rdy = (values.reshape(len(x), -1) for values in flat)
    nearest = np.full(rdx.shape, np.inf)
    for wall in walls:
        t, meets = meeting(x, y, rdx, rdy, wall, least)
        nearest = np.where(meets & (t < nearest), t, nearest)
    ranges = np.where(nearest <= z_max, nearest, z_max)
    ranges.setflags(write=False)
    return ranges


class Mapper:
    """Maps a world; each method is a step of the contract (SPEC.md has the section numbers)."""

    name: ClassVar[str] = "none"
    title: ClassVar[str] = "no mistake"
    lesson: ClassVar[str] = ""
    where: ClassVar[str] = ""

    def __init__(
        self,
        world: World,
        seed: int | None,
        numbers: Arithmetic = arithmetic.PORTABLE,
    ) -> None:
        self.world = world
        self.settings = world.settings
        self.seed = seed
        self.numbers = numbers
        self.l0 = self.logit(self.settings.p0)
        self.l_occ = self.logit(self.settings.p_occ)
        self.l_free = self.logit(self.settings.p_free)

    @classmethod
    def of(
        cls,
        case: Case,
        seed: int | None,
        numbers: Arithmetic = arithmetic.PORTABLE,
    ) -> Mapper:
        """The mapper of a scenario, as it reads the file."""
        return cls(world_of(cls.reads(case)), seed, numbers)

    @classmethod
    def reads(cls, case: Case) -> Case:
        """The scenario as it should be written for the contract to read what this mapper reads."""
        return case

    def draw(self) -> Drawn:
        """Maps all scans."""
        return self.drawn(self.log_odds(self.batches()))

    def log_odds(self, batches: Iterable[Traced]) -> Array:
        """The array of log-odds after these updates."""
        s = self.settings
        log_odds: Array = np.full(s.height * s.width, self.start())
        for traced in batches:
            self.apply(log_odds, traced)
        return self.finish(log_odds).reshape(s.height, s.width)

    def drawn(self, log_odds: Array) -> Drawn:
        """The map of an array of log-odds."""
        return Drawn(self.file_order(log_odds), self.picture(log_odds))

    # --- the model (2.2) ---

    def logit(self, p: float) -> float:
        q = min(max(p, 1e-9), 1.0 - 1e-9)
        return float(self.numbers.log(np.array([q / (1.0 - q)]))[0])

    def start(self) -> float:
        return self.l0

    def steps(self) -> tuple[float, float]:
        """What a free cell and an occupied cell add."""
        return self.l_free - self.l0, self.l_occ - self.l0

    def clamp(self, log_odds: Array) -> Array:
        s = self.settings
        return np.minimum(np.maximum(log_odds, s.l_min), s.l_max)

    def updated(self, log_odds: Array, steps: Array) -> Array:
        """After one update."""
        return self.clamp(log_odds + steps)

    def finish(self, log_odds: Array) -> Array:
        """After the last scan."""
        return log_odds

    # --- the simulated sensor (3) ---

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        i = np.arange(n, dtype=np.float64)
        return np.zeros(1) if n == 1 else -(fov / 2.0) + (fov * i) / (n - 1.0)

    def parallel(self) -> float:
        """The cross product of direction and wall below which they are parallel."""
        return 1e-12

    def simulate(self, pose: Pose, angles: Array) -> Array:
        """Ranges (n,) from a pose; (k, n) from many in one, whose numbers are arrays (k, 1)."""
        shape = np.broadcast_shapes(np.shape(pose.theta), angles.shape)
        beams = np.broadcast_to(self.beam(pose.theta, angles), shape)
        points = np.array([pose.x, pose.y]).tobytes()
        walls = tuple(self.world.walls)
        z_max = self.settings.max_range
        ranges = _cast(
            walls,
            points,
            beams.tobytes(),
            z_max,
            self.numbers,
            self.parallel(),
        )
        return ranges.reshape(shape)

    def simulated(self, angles: Array) -> Iterator[Array]:
        """The ranges of each simulated scan, without noise."""
        scans = self.world.scans
        poses = [scan for scan in scans if not isinstance(scan, Scan)]
        many = max(1, BATCH_BEAMS // max(1, angles.size))
        for first in range(0, len(poses), many):
            x, y, theta = np.array(poses[first : first + many]).T[:, :, None]
            yield from self.simulate(Pose(x, y, theta), angles)

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return arithmetic.normal_deviate(seed, scan, beams, self.numbers)

    def noisy(self, ranges: Array, seed: int, scan: int) -> Array:
        deviates = self.deviate(seed, scan, np.arange(ranges.size))
        noise = self.settings.noise_std * deviates
        return self.clip_range(ranges + noise)

    def clip_range(self, ranges: Array) -> Array:
        return np.clip(ranges, 0.0, self.settings.max_range)

    def scans(self) -> Iterator[Scan]:
        angles = self.bearings()
        simulated = self.simulated(angles)
        for number, scan in enumerate(self.world.scans):
            if isinstance(scan, Scan):
                yield scan
                continue
            ranges = next(simulated)
            if self.seed is not None:
                ranges = self.noisy(ranges, self.seed, number)
            yield Scan(scan, angles, ranges)

    # --- beams (2.3) ---

    def read(self, ranges: Array) -> tuple[Array, Mask, Mask]:
        """Distance, hit, used: what ranges mean."""
        s = self.settings
        hit = ranges < s.max_range - 1e-12
        z = np.where(hit, ranges, s.max_range)
        used = hit if s.no_return == "ignore" else ~np.isnan(ranges)
        return z, hit, used

    def beam(self, theta: float, angles: Array) -> Array:
        """Directions in the world."""
        return theta + angles

    def endpoint(
        self, pose: Pose, beam: Array, z: Array
    ) -> tuple[Array, Array]:
        cos, sin = arithmetic.directions(beam, self.numbers)
        return pose.x + z * cos, pose.y + z * sin

    # --- the grid (2.1) ---

    def index(self, cells: Array) -> Array:
        """The whole number of a coordinate in cells."""
        return np.floor(cells)

    def to_grid(self, x: Array, y: Array) -> tuple[Cells, Cells]:
        s = self.settings
        gx = self.index((x - s.origin_x) / s.resolution)
        gy = self.index((y - s.origin_y) / s.resolution)
        return gx.astype(np.int64), gy.astype(np.int64)

    def place(self, gx: Cells, gy: Cells) -> tuple[Cells, Mask]:
        """Where a cell lies in the array of log-odds, and whether it is in the grid."""
        w, h = self.settings.width, self.settings.height
        inside = (gx >= 0) & (gx < w) & (gy >= 0) & (gy < h)
        return gy * w + gx, inside

    # --- the update (2.4, 2.5) ---

    def lines(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Lines:
        """The cells of each beam, in order."""
        return contract_lines(gx0, gy0, gx1, gy1)

    def evidence(self, lines: Lines, hit: Mask) -> tuple[Lines, Mask]:
        """Which cells are updated, and which of them as occupied; hit: one for each beam."""
        return lines, lines.last & hit[lines.beam]

    def kept(self, gx0: Cells, gy0: Cells, gx1: Cells, gy1: Cells) -> Mask:
        """Which beams are traced."""
        return np.ones(gx0.shape, dtype=bool)

    def ends(self, scan: Scan) -> tuple[Ends, Cells]:
        """Where the beams of a scan start and end, in cells, and which beams they are: some are not traced.

        The scan may be many in one, whose pose then has arrays, a number for each beam.
        """
        z, hit, used = self.read(scan.ranges)
        pose = scan.pose
        ex, ey = self.endpoint(pose, self.beam(pose.theta, scan.angles), z)
        x, y = (
            np.broadcast_to(pose.x, z.shape),
            np.broadcast_to(pose.y, z.shape),
        )
        gx1, gy1 = self.to_grid(ex[used], ey[used])
        gx0, gy0 = self.to_grid(x[used], y[used])
        kept = self.kept(gx0, gy0, gx1, gy1)
        ends = Ends(gx0, gy0, gx1, gy1, hit[used])
        return ends.where(kept), np.flatnonzero(used)[kept]

    def within_scan(self, traced: Traced) -> Traced:
        """The updates of some whole scans, before they are applied."""
        return traced

    def beams(self) -> Iterator[ScanEnds]:
        """The beams of several scans at a time, which is quicker than one by one."""
        for numbers, scan in many_in_one(self.scans()):
            ends, beams = self.ends(scan)
            yield ScanEnds(numbers[beams], ends)

    def batches(
        self,
        window: Window | None = None,
        beams: Iterable[ScanEnds] | None = None,
    ) -> Iterator[Traced]:
        """The updates of several scans at a time; those of cells outside a ``window`` may be left out.

        ``beams`` are those of all scans, where they are known.
        """
        for numbers, ends in self.beams() if beams is None else beams:
            if window is not None:
                near = ends.near(window)
                numbers, ends = numbers[near], ends.where(near)
            for part in _whole_scans(numbers, ends.cells):
                traced = self._trace(numbers[part], ends.where(part))
                yield traced if window is None else traced.within(window)

    def _trace(self, scan: Cells, ends: Ends) -> Traced:
        lines = self.lines(ends.gx0, ends.gy0, ends.gx1, ends.gy1)
        lines, occupied = self.evidence(lines, ends.hit)
        return self.within_scan(
            Traced(scan[lines.beam], lines.gx, lines.gy, occupied)
        )

    def apply(self, log_odds: Array, traced: Traced) -> None:
        """Adds the steps in order, clamping after each.

        Cells do not depend on each other, so the j-th updates of all cells are made at once.
        """
        places, inside = self.place(traced.gx, traced.gy)
        places, occupied = places[inside], traced.occupied[inside]
        if not places.size:
            return
        # NumPy sorts small integers much faster
        small = index_type(log_odds.size)
        order = np.argsort(places.astype(small), kind="stable")
        places, occupied = places[order], occupied[order]
        free_step, occupied_step = self.steps()
        steps = np.where(occupied, occupied_step, free_step)
        starts = np.flatnonzero(np.diff(places, prepend=-1))
        counts = np.diff(starts, append=places.size)
        most_first = np.argsort(-counts, kind="stable")
        starts, counts = starts[most_first], counts[most_first]
        touched = places[starts]
        values = log_odds[touched]
        reached = np.searchsorted(-counts, -np.arange(counts[0]), side="left")
        for j, n in enumerate(reached.tolist()):
            values[:n] = self.updated(values[:n], steps[starts[:n] + j])
        log_odds[touched] = values

    # --- the files (2.6, 7) ---

    def file_order(self, log_odds: Array) -> Array:
        """The rows of the log-odds file."""
        return log_odds

    def probability(self, log_odds: Array) -> Array:
        z = self.numbers.exp(-np.abs(log_odds))
        return np.where(log_odds >= 0.0, 1.0, z) / (1.0 + z)

    def pixel(self, p: Array) -> Array:
        return np.floor((1.0 - p) * 255.0 + 0.5)

    def picture(self, log_odds: Array) -> Cells:
        """The rows of the picture, the one with the largest y first."""
        # many cells have the same log-odds
        values, cell = np.unique(log_odds.reshape(-1), return_inverse=True)
        levels = self.pixel(self.probability(values)).astype(np.int64)
        return self.arrange(levels[cell].reshape(log_odds.shape))

    def arrange(self, cells: Cells) -> Cells:
        """An array of cells in the order of the picture."""
        return cells[::-1]
