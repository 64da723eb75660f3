"""The cells in which beams start and end, with one right formula or another for each step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from occgrid.lesson import lesson_poses
from occgrid.sensor import Scan, read_ranges
from occgrid.world import Pose
from occgrid_parity.model.arithmetic import normal_deviate
from occgrid_parity.model.array_types import Array, Cells
from occgrid_parity.model.mapper_steps import Ends, meeting
from occgrid_parity.model.right_formulas import (
    BEARINGS,
    CELLS,
    DIRECTIONS,
    FUNCTIONS,
    HEADINGS,
    PI,
    TURNED_POINTS,
    Fan,
    Formulas,
)
from occgrid_parity.model.rounding import Beams
from occgrid_parity.model.worlds import World

LESSON_POSES = {pose: t for t, pose in enumerate(lesson_poses())}


class RightEnds:
    """Where beams start and end, with one formula or another.

    ``own_poses``: the program computes the lesson's poses itself.
    """

    def __init__(
        self, world: World, seed: int | None, beams: Beams, own_poses: bool
    ) -> None:
        self.world = world
        self.seed = seed
        self.beams = beams
        self.own_poses = own_poses
        scans = world.scans
        self.poses = np.array(
            [scan.pose if isinstance(scan, Scan) else scan for scan in scans]
        )
        recorded = [isinstance(scan, Scan) for scan in scans]
        self.simulated = ~np.array(recorded)[beams.scan]
        given = [scan for scan in scans if isinstance(scan, Scan)]
        none: list[Array] = [np.zeros(0)]
        self.angles = np.concatenate(none + [scan.angles for scan in given])
        self.ranges = np.concatenate(none + [scan.ranges for scan in given])
        self.known: dict[tuple[object, ...], tuple[Array, ...]] = {}

    def of(self, f: Formulas) -> Ends:
        """Of all beams (n,), in their order."""
        s = self.world.settings
        x, y, _ = self._poses_of_beams(f)
        distance, hit, _ = read_ranges(
            self._distances(f), s.max_range, s.no_return
        )
        ex, ey = self._points(f, distance)
        # a pose from a file has no rounding errors
        start = f.cell if self.own_poses else Formulas().cell

        def index(formula: str, value: Array, origin: float) -> Cells:
            cells = CELLS[formula](value, origin, s.resolution)
            return cells.astype(np.int64)

        return Ends(
            index(start, x, s.origin_x),
            index(start, y, s.origin_y),
            index(f.cell, x + ex, s.origin_x),
            index(f.cell, y + ey, s.origin_y),
            hit,
        )

    def _kept(
        self, key: tuple[object, ...], make: Callable[[], tuple[Array, ...]]
    ) -> tuple[Array, ...]:
        if key not in self.known:
            self.known[key] = make()
        return self.known[key]

    def _poses_of_scans(self, f: Formulas) -> tuple[Array, ...]:
        """x, y, theta of each scan."""
        poses = [Pose(*pose) for pose in self.poses.tolist()]
        known = LESSON_POSES.keys() >= {*poses}

        def make() -> tuple[Array, ...]:
            if not (self.own_poses and known):  # other poses have no formula
                return tuple(self.poses.T)
            numbers = FUNCTIONS[f.functions]
            angle = HEADINGS[f.heading](np.arange(float(len(LESSON_POSES))))
            t = [LESSON_POSES[pose] for pose in poses]
            x = -6.0 + 6.0 * numbers.cos(angle)
            y = 4.0 * numbers.sin(angle)
            return x[t], y[t], angle[t] + PI / 2.0

        return self._kept(("poses", f.heading, f.functions), make)

    def _poses_of_beams(self, f: Formulas) -> tuple[Array, ...]:
        return tuple(
            column[self.beams.scan] for column in self._poses_of_scans(f)
        )

    def _fan(self, f: Formulas, simulated: bool) -> Fan:
        """The simulated scans, (scans, beams), or the recorded beams, each of them a scan of its own."""
        numbers = FUNCTIONS[f.functions]
        theta = self._poses_of_beams(f)[2][self.simulated == simulated]
        if not simulated:
            return Fan(theta[:, None], self.angles[:, None], numbers)
        s = self.world.settings
        i = np.arange(float(s.beams))
        angles = BEARINGS[f.bearing](s.fov, i) if i.size > 1 else np.zeros(1)
        return Fan(theta[:: s.beams, None], angles[None, :], numbers)

    def _directions(
        self, f: Formulas, name: str, simulated: bool
    ) -> tuple[Array, ...]:
        """Cosines and sines; shaped as in ``_fan``."""
        return self._kept(
            ("directions", name, simulated, f.heading, f.bearing, f.functions),
            lambda: DIRECTIONS[name](self._fan(f, simulated)),
        )

    def _distances(self, f: Formulas) -> Array:
        """The ranges of all beams."""
        ranges = np.empty(self.beams.scan.size)
        ranges[~self.simulated] = self.ranges
        if self.simulated.any():
            ranges[self.simulated] = self._simulated(f).reshape(-1)
        return ranges

    def _simulated(self, f: Formulas) -> Array:
        def make() -> tuple[Array, ...]:
            x, y, _ = self._poses_of_beams(f)
            shape = -1, self.world.settings.beams
            x, y = (v[self.simulated].reshape(shape)[:, :1] for v in (x, y))
            rdx, rdy = self._directions(f, f.seen, True)
            ranges = self._cast((x, y), (rdx, rdy), f.distance)
            return (self._noisy(ranges, f),)

        return self._kept(
            ("ranges", f.heading, f.bearing, f.seen, f.distance, f.functions),
            make,
        )[0]

    def _noisy(self, ranges: Array, f: Formulas) -> Array:
        if self.seed is None:
            return ranges
        s = self.world.settings
        scan = self.beams.scan[self.simulated]
        number = self.beams.number[self.simulated]
        deviates = normal_deviate(
            self.seed, scan, number, FUNCTIONS[f.functions]
        )
        noise = s.noise_std * deviates.reshape(ranges.shape)
        return np.clip(ranges + noise, 0.0, s.max_range)

    def _cast(
        self,
        point: tuple[Array, Array],
        ray: tuple[Array, Array],
        distance: str,
    ) -> Array:
        """Ranges (scans, beams) from points (scans, 1)."""
        longest = self.world.settings.max_range
        (x, y), (rdx, rdy) = point, ray
        if distance == "a share of the maximum range":
            rdx, rdy = (x + longest * rdx) - x, (y + longest * rdy) - y
        nearest = np.full(rdx.shape, np.inf)
        for wall in self.world.walls:
            t, meets = meeting(x, y, rdx, rdy, wall)
            if distance == "a share of the maximum range":
                t = t * longest
            elif distance == "along x or y":
                if wall.x0 == wall.x1:
                    t = (wall.x0 - x) / np.where(meets, rdx, 1.0)
                elif wall.y0 == wall.y1:
                    t = (wall.y0 - y) / np.where(meets, rdy, 1.0)
            nearest = np.where(meets & (t < nearest), t, nearest)
        return np.where(nearest <= longest, nearest, longest)

    def _points(self, f: Formulas, distance: Array) -> tuple[Array, Array]:
        """The ends of all beams, from the robot."""
        ex, ey = np.empty(distance.size), np.empty(distance.size)
        for simulated in (True, False):
            mine = self.simulated == simulated
            if not mine.any():
                continue
            beams = self.world.settings.beams if simulated else 1
            z = distance[mine].reshape(-1, beams)
            if f.drawn == TURNED_POINTS:
                x, y = _turned(self._fan(f, simulated), z)
            else:
                cos, sin = self._directions(f, f.drawn, simulated)
                x, y = z * cos, z * sin
            ex[mine], ey[mine] = x.reshape(-1), y.reshape(-1)
        return ex, ey


def _turned(fan: Fan, z: Array) -> tuple[Array, Array]:
    """Ends in the robot's frame, turned by its heading."""
    cos, sin = fan.of(fan.angles)
    x, y = z * cos, z * sin
    c, s = fan.of(fan.theta)
    return c * x - s * y, s * x + c * y
