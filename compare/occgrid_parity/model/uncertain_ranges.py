"""The ranges that a beam can have, and how far rounding can move each."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from occgrid import portable_math
from occgrid.noise import normal_deviate
from occgrid.world import Pose, Segment
from occgrid_parity.model.arithmetic import U
from occgrid_parity.model.array_types import Array, Cells, Mask
from occgrid_parity.model.worlds import World

MARGIN = 1e-12  # of a hit below the maximum range (SPEC.md section 2.3)


@dataclass
class UncertainRange:
    """One range that a beam can have: metres, and the bound on its error."""

    beam: Cells
    z: Array
    error: Array


def can_hit(one: UncertainRange, z_max: float) -> Mask:
    """Which ranges can be those of a hit."""
    with np.errstate(invalid="ignore"):
        return one.z - one.error < z_max - MARGIN


def can_miss(one: UncertainRange, z_max: float) -> Mask:
    """Which ranges can be those of a beam without return."""
    with np.errstate(invalid="ignore"):
        return ~(one.z + one.error < z_max - MARGIN)


def cast(
    world: World, pose: Pose, angles: Array, turn: Array, offset: float
) -> list[UncertainRange]:
    """Simulated ranges: the contract's first, then others that a beam can have at a wall's tip."""
    s = world.settings
    a = pose.theta + angles
    rdx, rdy = portable_math.cos(a), portable_math.sin(a)
    n = angles.size
    best, best_error = np.full(n, np.inf), np.zeros(n)
    sure, sure_error = np.full(n, np.inf), np.zeros(n)
    doubtful: list[tuple[Array, Array, Mask]] = []
    ahead = _exactly_ahead(pose, angles, offset)
    for wall in world.walls:
        t, error, meets, surely, possibly = _meet(
            pose, rdx, rdy, wall, turn, offset, ahead
        )
        nearer = meets & (t < best)
        best = np.where(nearer, t, best)
        best_error = np.where(nearer, error, best_error)
        nearer = surely & (t < sure)
        sure = np.where(nearer, t, sure)
        sure_error = np.where(nearer, error, sure_error)
        doubtful.append((t, error, possibly & ~surely))
    beams = np.arange(n)

    def range_of(chosen: Mask, t: Array, error: Array) -> UncertainRange:
        beam = beams[chosen]
        far = ~(t[beam] <= s.max_range)
        z = np.where(far, s.max_range, t[beam])
        return UncertainRange(beam, z, np.where(far, 0.0, error[beam]))

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
        found.append(UncertainRange(beam, best[beam], best_error[beam]))
        found.append(
            UncertainRange(
                beam, np.full(beam.size, s.max_range), np.zeros(beam.size)
            )
        )
    assert first is found[0]
    return found


def _exactly_ahead(pose: Pose, angles: Array, offset: float) -> Mask:
    """The beams that have the direction (1, 0) in every program: sin(0) is 0 and cos(0) is 1 in every library.

    With 3, 5, 9, 17, ... beams, every formula of the bearings makes the middle one exactly 0.
    """
    intervals = angles.size - 1
    halved = intervals > 0 and intervals & (intervals - 1) == 0
    if not (halved and pose.theta == 0.0 and offset == 0.0):
        return np.zeros(angles.shape, dtype=np.bool_)
    ahead: Mask = angles == 0.0
    return ahead


def _meet(
    pose: Pose,
    rdx: Array,
    rdy: Array,
    wall: Segment,
    turn: Array,
    offset: float,
    ahead: Mask,
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
    # a wall straight across, one end of which lies on the beam: u is exactly 0 or 1
    if sx == 0.0 and pose.y in (wall.y0, wall.y1):
        surely |= ahead & meets & surely_crossing & (t - t_error >= 0.0)
    possibly = (
        ~surely_parallel
        & (t + t_error >= 0.0)
        & (u + u_error >= 0.0)
        & (u - u_error <= 1.0)
    )
    return t, t_error, meets, surely, possibly


def add_noise(
    candidates: list[UncertainRange], world: World, seed: int, scan: int
) -> None:
    """Noise on every range; a deviate may have other last bits, too."""
    s = world.settings
    for one in candidates:
        noise = normal_deviate(seed, scan, one.beam)
        one.z = np.clip(one.z + s.noise_std * noise, 0.0, s.max_range)
        one.error = one.error + 16.0 * U * (
            s.noise_std * np.abs(noise) + one.z
        )
