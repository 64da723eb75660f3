/**
 * Which beams rounding decides. A right program may have other last bits in its sines, cosines and angles, so a beam
 * that ends within a few units in the last place of a cell's edge may end on either side. The bounds are those of
 * `occgrid-parity check` (compare, module rounding); all ways that such a beam can go are listed.
 */

import { noisyRange, normalDeviate } from "../../src/noise.js";
import { cos, sin } from "../../src/portableMath.js";
import { beamAngles, Scan } from "../../src/sensor.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("../../src/world.js").Pose} Pose */
/** @typedef {import("../../src/world.js").Segment} Segment */
/** @typedef {{gx0: number, gy0: number, gx1: number, gy1: number, hit: boolean, used: boolean}} Way */
/** @typedef {{scan: number, beam: number, ways: Way[]}} Beam the contract's way comes first */
/** @typedef {{z: number, error: number}} Range metres, and the bound on its error */
/** @typedef {{turn: number, offset: number, ahead: boolean}} Errors the bounds on those of a beam's direction, radians, and of its start, metres; whether every program gives it the direction (1, 0) */

const U = 2 ** -52;
const MARGIN = 1e-12;

/**
 * The beams of a scan, in order.
 *
 * @param {World} world
 * @param {number} number of the scan, from 0
 * @param {number | null} seed
 * @param {boolean} ownPoses the program computes the lesson's poses itself, so that they have errors, too
 * @returns {Beam[]}
 */
export function beamsOfScan(
  { settings, walls, scans },
  number,
  seed,
  ownPoses,
) {
  const s = settings;
  const scan = scans[number];
  const recorded = scan instanceof Scan;
  const pose = recorded ? scan.pose : scan;
  const angles = recorded ? scan.angles : beamAngles(s.fov, s.beams);
  // the lesson's first pose is exact: cos(0) is 1, and sin(0) is 0
  const offset =
    ownPoses && number > 0
      ? 8 * U * (Math.abs(pose.x) + Math.abs(pose.y)) + 4 * U * s.maxRange
      : 0;
  const starts = pairs(
    span(pose.x, offset, s.originX, s.resolution),
    span(pose.y, offset, s.originY, s.resolution),
  );
  const [[gx0, gy0]] = starts;
  // with 3, 5, 9, 17, ... beams, every formula of the bearings makes the middle one exactly 0
  const intervals = angles.length - 1;
  const halved = intervals > 0 && Number.isInteger(Math.log2(intervals));
  const exact = pose.theta === 0 && offset === 0;
  return Array.from(angles, (angle, beam) => {
    const swing =
      Math.abs(angle) + Math.abs(pose.theta) + (recorded ? 0 : s.fov);
    const turn = 8 * U * swing;
    const ahead = halved && exact && angle === 0;
    const errors = { turn, offset, ahead };
    const a = pose.theta + angle;
    const [c, d] = [cos(a), sin(a)];
    /** @type {Range[]} */
    let ranges;
    if (recorded) {
      ranges = [{ z: scan.ranges[beam], error: 0 }];
    } else {
      ranges = castWays(pose, [c, d], walls, errors, s.maxRange);
      if (seed !== null) {
        const noise = s.noiseStd * normalDeviate(seed, number, beam);
        ranges = ranges.map(({ z, error }) => {
          const noisy = noisyRange(z, noise, s.maxRange);
          const blur = 16 * U * (Math.abs(noise) + noisy);
          return { z: noisy, error: error + blur };
        });
      }
    }
    /** @type {Way[]} */
    const ways = [];
    const seen = new Set();
    const add = (/** @type {Way} */ way) => {
      const key = way.used
        ? `${way.gx0} ${way.gy0} ${way.gx1} ${way.gy1} ${way.hit}`
        : "ignored";
      if (seen.has(key)) return;
      seen.add(key);
      ways.push(way);
    };
    ranges.forEach(({ z, error }, i) => {
      const contractHits = z < s.maxRange - MARGIN;
      // the contract's own kind first, so that its way is the first
      for (const hit of [contractHits, !contractHits]) {
        const can = hit
          ? z - error < s.maxRange - MARGIN
          : !(z + error < s.maxRange - MARGIN);
        if (!can) continue;
        const nothing = !hit && (s.noReturn === "ignore" || Number.isNaN(z));
        if (nothing) {
          add({ gx0, gy0, gx1: 0, gy1: 0, hit: false, used: false });
          continue;
        }
        const length = hit ? z : s.maxRange;
        const ex = pose.x + length * c;
        const ey = pose.y + length * d;
        const blur =
          length === 0 && offset === 0
            ? 0
            : (hit ? error : 0) +
              offset +
              length * (turn + 2 * U) +
              4 * U * (Math.abs(pose.x) + Math.abs(pose.y) + length);
        const columns = span(ex, blur, s.originX, s.resolution);
        const rows = span(ey, blur, s.originY, s.resolution);
        for (const [gx0, gy0] of starts) {
          for (const [gx1, gy1] of pairs(columns, rows)) {
            add({ gx0, gy0, gx1, gy1, hit, used: true });
          }
        }
      }
      if (i === 0 && ways.length === 0) {
        add({ gx0, gy0, gx1: 0, gy1: 0, hit: false, used: false });
      }
    });
    return { scan: number, beam, ways };
  });
}

/** Each with each, the first with the first at first. @param {number[]} columns @param {number[]} rows @returns {[number, number][]} */
function pairs(columns, rows) {
  return columns.flatMap((gx) =>
    rows.map((gy) => /** @type {[number, number]} */ ([gx, gy])),
  );
}

/**
 * The cells that a coordinate can lie in, the contract's first.
 *
 * @param {number} value
 * @param {number} error
 * @param {number} origin
 * @param {number} resolution
 */
function span(value, error, origin, resolution) {
  const cells = (value - origin) / resolution;
  const own = Math.floor(cells);
  if (error === 0) return [own];
  const blur =
    error / resolution +
    4 *
      U *
      (Math.abs(cells) + (Math.abs(value) + Math.abs(origin)) / resolution);
  const found = new Set([own]);
  found.add(Math.floor(cells - blur));
  found.add(Math.floor(cells + blur));
  return Array.from(found);
}

/**
 * Simulated ranges of one beam: the contract's first, then others that it can have at a wall's tip or at the horizon.
 *
 * @param {Pose} pose
 * @param {[number, number]} ray
 * @param {Segment[]} walls
 * @param {Errors} errors
 * @param {number} zMax
 * @returns {Range[]}
 */
function castWays(pose, ray, walls, errors, zMax) {
  let best = { z: Infinity, error: 0 };
  let sure = { z: Infinity, error: 0 };
  /** @type {Range[]} */
  const doubtful = [];
  for (const wall of walls) {
    const met = meet(pose, ray, wall, errors);
    if (met.meets && met.z < best.z) best = met;
    if (met.surely && met.z < sure.z) sure = met;
    if (met.possibly && !met.surely) doubtful.push(met);
  }
  const rangeOf = (/** @type {Range} */ { z, error }) =>
    z <= zMax ? { z, error } : { z: zMax, error: 0 };
  const found = [rangeOf(best)];
  if (sure.z !== best.z) found.push(rangeOf(sure));
  for (const other of doubtful) {
    if (other.z !== best.z && other.z - other.error < sure.z) {
      found.push(rangeOf(other));
    }
  }
  if (Math.abs(best.z - zMax) <= best.error) {
    found.push({ z: best.z, error: best.error }, { z: zMax, error: 0 });
  }
  return found;
}

/**
 * @param {Pose} pose
 * @param {[number, number]} ray
 * @param {Segment} wall
 * @param {Errors} errors
 */
function meet(pose, [rdx, rdy], wall, { turn, offset, ahead }) {
  const [sx, sy] = [wall.x1 - wall.x0, wall.y1 - wall.y0];
  const [qpx, qpy] = [wall.x0 - pose.x, wall.y0 - pose.y];
  const rxs = rdx * sy - rdy * sx;
  const rxsError = Math.hypot(sx, sy) * (turn + 4 * U);
  const divisor = rxs === 0 ? 1 : rxs;
  const steep = Math.max(Math.abs(divisor), 1e-300);
  const across = qpx * sy - qpy * sx;
  const z = across / divisor;
  const acrossError =
    4 * U * (Math.abs(qpx * sy) + Math.abs(qpy * sx)) +
    offset * Math.hypot(sx, sy);
  const error =
    (acrossError + Math.abs(z) * rxsError) / steep + 2 * U * Math.abs(z);
  const u = (qpx * rdy - qpy * rdx) / divisor;
  const alongError = Math.hypot(qpx, qpy) * (turn + 4 * U) + offset;
  const uError = (alongError + Math.abs(u) * rxsError) / steep + 2 * U;
  const meets = Math.abs(rxs) >= 1e-12 && z >= 0 && u >= 0 && u <= 1;
  const crossing = Math.abs(rxs) > 1e-12 + rxsError;
  const within = u - uError >= 0 && u + uError <= 1;
  // a wall straight across, one end of which lies on the beam: u is exactly 0 or 1
  const atTip = sx === 0 && (pose.y === wall.y0 || pose.y === wall.y1);
  const surely =
    (ahead && atTip && meets && crossing && z - error >= 0) ||
    (crossing && z - error >= 0 && within) ||
    (meets && across === 0 && offset === 0 && crossing && within);
  const possibly =
    !(Math.abs(rxs) < 1e-12 - rxsError) &&
    z + error >= 0 &&
    u + uError >= 0 &&
    u - uError <= 1;
  return { z, error, meets, surely, possibly };
}
