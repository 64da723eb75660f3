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
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.line_cells import Lines, contract_lines
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.suite.cases import Case

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

    def where(self, chosen: Mask) -> Ends:
        """Some of the beams."""
        return Ends(
            self.gx0[chosen],
            self.gy0[chosen],
            self.gx1[chosen],
            self.gy1[chosen],
            self.hit[chosen],
        )

    def near(self, window: Window) -> Mask:
        """Which beams can come into a window: the rectangle between their ends meets it."""
        return (
            (np.minimum(self.gx0, self.gx1) < window.right)
            & (np.maximum(self.gx0, self.gx1) >= window.left)
            & (np.minimum(self.gy0, self.gy1) < window.top)
            & (np.maximum(self.gy0, self.gy1) >= window.bottom)
        )

    @property
    def cells(self) -> int:
        """How many cells their lines have, about."""
        dx, dy = np.abs(self.gx1 - self.gx0), np.abs(self.gy1 - self.gy0)
        return int(np.maximum(dx, dy).sum() + dx.size)


def meeting(
    x: float | Array, y: float | Array, rdx: Array, rdy: Array, wall: Segment
) -> tuple[Array, Mask]:
    """How far rays from points (metres) go to a wall's line, and which of them meet the wall (3.2)."""
    sx, sy = wall.x1 - wall.x0, wall.y1 - wall.y0
    qpx, qpy = wall.x0 - x, wall.y0 - y
    rxs = rdx * sy - rdy * sx
    parallel = np.abs(rxs) < 1e-12
    rxs = np.where(parallel, 1.0, rxs)
    t = (qpx * sy - qpy * sx) / rxs
    u = (qpx * rdy - qpy * rdx) / rxs
    meets = ~parallel & (t >= 0.0) & (u >= 0.0) & (u <= 1.0)
    return t, meets


@functools.lru_cache(2048)
def _cast(
    walls: tuple[Segment, ...],
    x: float,
    y: float,
    beam: bytes,
    z_max: float,
    numbers: Arithmetic,
) -> Array:
    """Ranges along directions (3.2); kept, since most mistakes see the same ranges."""
    rdx, rdy = arithmetic.directions(np.frombuffer(beam), numbers)
    nearest = np.full(rdx.shape, np.inf)
    for wall in walls:
        t, meets = meeting(x, y, rdx, rdy, wall)
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
    strays: ClassVar[bool] = False
    """Whether a line may leave the rectangle between its ends."""

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

    def draw(
        self,
        batches: Iterable[Traced] | None = None,
        sample: Mask | None = None,
    ) -> Drawn:
        """Maps all scans.

        ``batches`` are the updates where they are known already. With ``sample`` (one for each cell of the array) the
        other cells keep what they start with.
        """
        s = self.settings
        log_odds: Array = np.full(s.height * s.width, self.start())
        for traced in self.batches() if batches is None else batches:
            self.apply(log_odds, traced, sample)
        log_odds = self.finish(log_odds).reshape(s.height, s.width)
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

    def finish(self, log_odds: Array) -> Array:
        """After the last scan."""
        return log_odds

    # --- the simulated sensor (3) ---

    def bearings(self) -> Array:
        n, fov = self.settings.beams, self.settings.fov
        i = np.arange(n, dtype=np.float64)
        return np.zeros(1) if n == 1 else -(fov / 2.0) + (fov * i) / (n - 1.0)

    def simulate(self, pose: Pose, angles: Array) -> Array:
        beam = self.beam(pose.theta, angles)
        walls = tuple(self.world.walls)
        z_max = self.settings.max_range
        return _cast(
            walls, pose.x, pose.y, beam.tobytes(), z_max, self.numbers
        )

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
        for number, scan in enumerate(self.world.scans):
            if isinstance(scan, Scan):
                yield scan
                continue
            ranges = self.simulate(scan, angles)
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

    def ends(self, scan: Scan) -> Ends:
        """Where the beams of one scan start and end, in cells; those that are not traced are left out."""
        z, hit, used = self.read(scan.ranges)
        pose = scan.pose
        ex, ey = self.endpoint(pose, self.beam(pose.theta, scan.angles), z)
        gx1, gy1 = self.to_grid(ex[used], ey[used])
        gx0, gy0 = self.to_grid(
            np.full(gx1.shape, pose.x), np.full(gx1.shape, pose.y)
        )
        ends = Ends(gx0, gy0, gx1, gy1, hit[used])
        return ends.where(self.kept(gx0, gy0, gx1, gy1))

    def within_scan(self, traced: Traced) -> Traced:
        """The updates of some whole scans, before they are applied."""
        return traced

    def batches(self, window: Window | None = None) -> Iterator[Traced]:
        """The updates of several scans at a time, which is quicker than one by one.

        With a ``window``, beams may be left out that cannot come into it.
        """
        numbers: list[Cells] = []
        ends: list[Ends] = []
        cells = 0
        for number, scan in enumerate(self.scans()):
            these = self.ends(scan)
            if window is not None and not self.strays:
                these = these.where(these.near(window))
            numbers.append(np.full(these.gx0.shape, number))
            ends.append(these)
            cells += these.cells
            if cells > BATCH_CELLS:
                yield self._trace(numbers, ends)
                numbers, ends, cells = [], [], 0
        if ends:
            yield self._trace(numbers, ends)

    def _trace(self, numbers: list[Cells], ends: list[Ends]) -> Traced:
        scan = np.concatenate(numbers)
        beams = Ends(*map(np.concatenate, zip(*ends, strict=True)))
        lines = self.lines(beams.gx0, beams.gy0, beams.gx1, beams.gy1)
        lines, occupied = self.evidence(lines, beams.hit)
        return self.within_scan(
            Traced(scan[lines.beam], lines.gx, lines.gy, occupied)
        )

    def apply(
        self, log_odds: Array, traced: Traced, sample: Mask | None = None
    ) -> None:
        """Adds the steps in order, clamping after each.

        Cells do not depend on each other, so the j-th updates of all cells are made at once.
        """
        places, inside = self.place(traced.gx, traced.gy)
        if sample is not None:
            inside = inside & sample[np.where(inside, places, 0)]
        places, occupied = places[inside], traced.occupied[inside]
        if not places.size:
            return
        order = np.argsort(places, kind="stable")
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
            values[:n] = self.clamp(values[:n] + steps[starts[:n] + j])
        log_odds[touched] = values

    def values(self, window: Window, batches: Iterable[Traced]) -> Array:
        """The log-odds of the cells of a window (n,), row by row, after these updates."""
        s = self.settings
        square = np.zeros((s.height, s.width), dtype=bool)
        square[window.bottom : window.top, window.left : window.right] = True
        sample = square.reshape(-1)
        log_odds: Array = np.full(sample.shape, self.start())
        for traced in batches:
            self.apply(log_odds, traced, sample)
        return self.finish(log_odds)[sample]

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
        p = self.probability(log_odds.reshape(-1)).reshape(log_odds.shape)
        return self.arrange(self.pixel(p).astype(np.int64))

    def arrange(self, cells: Cells) -> Cells:
        """An array of cells in the order of the picture."""
        return cells[::-1]
