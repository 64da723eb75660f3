/** The range sensor: bearings, what a range means, and the update of the grid (lesson section 4). */

import { cos, PI, sin } from "./portableMath.js";
import { bresenham } from "./ray.js";

/** @typedef {import("./grid.js").OccupancyGrid} OccupancyGrid */
/** @typedef {import("./world.js").Pose} Pose */
/** @typedef {"free" | "ignore"} NoReturn what a beam without return means: free cells up to zMax, or nothing */

/** One scan: a range for each bearing. */
export class Scan {
  /**
   * @param {Pose} pose the sensor's pose
   * @param {Float64Array} angles (n) bearings from the heading, radians
   * @param {Float64Array} ranges (n) metres
   */
  constructor(pose, angles, ranges) {
    this.pose = pose;
    this.angles = angles;
    this.ranges = ranges;
    Object.freeze(this);
  }
}

// [snippet: beam-angles]
/**
 * Bearings of a simulated scan.
 *
 * @param {number} fov field of view, radians
 * @param {number} nBeams number of beams
 * @returns {Float64Array} (nBeams) radians from the heading
 */
export function beamAngles(fov, nBeams) {
  const angles = new Float64Array(nBeams);
  for (let i = 0; i < nBeams && nBeams > 1; i++) {
    angles[i] = -(fov / 2) + (fov * i) / (nBeams - 1);
  }
  return angles;
}
// [/snippet]

// [snippet: flaser-angles]
/**
 * Bearings of a FLASER scan: its step is known by its count.
 *
 * @param {number} nBeams number of beams
 * @returns {Float64Array} (nBeams) radians from the heading
 */
export function flaserAngles(nBeams) {
  let step = nBeams === 1 ? 0 : PI / (nBeams - 1);
  if (nBeams === 180 || nBeams === 181) step = PI / 180;
  if (nBeams === 360 || nBeams === 361) step = PI / 360;
  if (nBeams === 400 || nBeams === 401) step = PI / 720;
  return new Float64Array(nBeams).map((_, i) => -(PI / 2) + i * step);
}
// [/snippet]

// [snippet: read-ranges]
/**
 * What ranges mean. NaN is ignored. At zMax or beyond nothing was hit
 * (lesson Problem 3): the beam is free up to zMax, or ignored.
 *
 * @param {Float64Array} ranges (n) metres
 * @param {number} zMax the sensor's maximum range, metres
 * @param {NoReturn} noReturn what a beam without return means
 * @returns {{z: Float64Array, hit: boolean[], used: boolean[]}} (n) each:
 *   metres, zMax where nothing was hit; whether something was; whether the
 *   beam says anything
 */
export function readRanges(ranges, zMax, noReturn) {
  const hit = Array.from(ranges, (range) => range < zMax - 1e-12);
  const z = ranges.map((range, i) => (hit[i] ? range : zMax));
  const free = noReturn === "free";
  const used = hit.map((h, i) => h || (free && !Number.isNaN(ranges[i])));
  return { z, hit, used };
}
// [/snippet]

// [snippet: beam-endpoints]
/**
 * Where the beams of a scan end.
 *
 * @param {Pose} pose the sensor's pose
 * @param {Float64Array} angles (n) bearings from the heading, radians
 * @param {Float64Array} z (n) lengths of the beams, metres
 * @returns {{ex: Float64Array, ey: Float64Array}} (n) metres each
 */
export function beamEndpoints(pose, angles, z) {
  const a = angles.map((angle) => pose.theta + angle);
  const ex = z.map((length, i) => pose.x + length * cos(a[i]));
  const ey = z.map((length, i) => pose.y + length * sin(a[i]));
  return { ex, ey };
}
// [/snippet]

// [snippet: update-grid-from-scan]
/**
 * The inverse sensor model: free along each beam, occupied at its hit.
 *
 * @param {OccupancyGrid} grid the grid, changed in place
 * @param {Scan} scan the scan
 * @param {number} zMax the sensor's maximum range, metres
 * @param {NoReturn} noReturn what a beam without return means
 */
export function updateGridFromScan(grid, scan, zMax, noReturn = "free") {
  const { z, hit, used } = readRanges(scan.ranges, zMax, noReturn);
  const { ex, ey } = beamEndpoints(scan.pose, scan.angles, z);
  const robot = grid.worldToGrid(scan.pose.x, scan.pose.y);
  for (let i = 0; i < z.length; i++) {
    if (!used[i]) continue;
    const end = grid.worldToGrid(ex[i], ey[i]);
    const cells = bresenham(robot.gx, robot.gy, end.gx, end.gy);
    const nFree = hit[i] ? cells.length - 1 : cells.length;
    for (let k = 0; k < nFree; k++) {
      grid.updateCell(cells[k].gx, cells[k].gy, grid.lFree);
    }
    if (hit[i]) grid.updateCell(end.gx, end.gy, grid.lOcc);
  }
}
// [/snippet]
