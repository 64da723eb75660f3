/** The simulated world: walls, ray casting, range scans (lesson section 6). */

import { cos, sin } from "./portableMath.js";

/** Where the robot (or its laser) stands. */
export class Pose {
  /**
   * @param {number} x metres
   * @param {number} y metres
   * @param {number} theta heading, radians
   */
  constructor(x, y, theta) {
    this.x = x;
    this.y = y;
    this.theta = theta;
    Object.freeze(this);
  }
}

/** A wall from (x0, y0) to (x1, y1). */
export class Segment {
  /**
   * @param {number} x0 metres
   * @param {number} y0 metres
   * @param {number} x1 metres
   * @param {number} y1 metres
   */
  constructor(x0, y0, x1, y1) {
    this.x0 = x0;
    this.y0 = y0;
    this.x1 = x1;
    this.y1 = y1;
    Object.freeze(this);
  }
}

// [snippet: box-world]
/**
 * The four walls of a rectangle, counterclockwise from the lower one.
 *
 * @param {number} xmin left, metres
 * @param {number} ymin below, metres
 * @param {number} xmax right, metres
 * @param {number} ymax above, metres
 * @returns {Segment[]} a list that more walls may be added to
 */
export function buildBoxWorld(xmin, ymin, xmax, ymax) {
  return [
    new Segment(xmin, ymin, xmax, ymin),
    new Segment(xmax, ymin, xmax, ymax),
    new Segment(xmax, ymax, xmin, ymax),
    new Segment(xmin, ymax, xmin, ymin),
  ];
}

/**
 * A wall along y.
 *
 * @param {number} x metres
 * @param {number} y0 metres
 * @param {number} y1 metres
 * @returns {Segment}
 */
export function addVerticalWall(x, y0, y1) {
  return new Segment(x, y0, x, y1);
}

/**
 * A wall along x.
 *
 * @param {number} y metres
 * @param {number} x0 metres
 * @param {number} x1 metres
 * @returns {Segment}
 */
export function addHorizontalWall(y, x0, x1) {
  return new Segment(x0, y, x1, y);
}
// [/snippet]

// [snippet: ray-segment-intersection]
/**
 * The distance at which a ray meets a wall.
 *
 * @param {number} rx the ray's point, metres
 * @param {number} ry the ray's point, metres
 * @param {number} rdx the ray's direction
 * @param {number} rdy the ray's direction
 * @param {Segment} wall the wall
 * @returns {number} metres; infinity where the ray is parallel or misses
 */
export function raySegmentIntersection(rx, ry, rdx, rdy, wall) {
  const sx = wall.x1 - wall.x0;
  const sy = wall.y1 - wall.y0;
  const rxs = rdx * sy - rdy * sx;
  if (Math.abs(rxs) < 1e-12) return Infinity;
  const qpx = wall.x0 - rx;
  const qpy = wall.y0 - ry;
  const t = (qpx * sy - qpy * sx) / rxs;
  const u = (qpx * rdy - qpy * rdx) / rxs;
  return t >= 0 && u >= 0 && u <= 1 ? t : Infinity;
}
// [/snippet]

// [snippet: simulate-lidar-scan]
/**
 * Ranges along bearings from a pose. A beam that meets no wall within
 * zMax reads zMax.
 *
 * @param {Pose} pose the sensor's pose
 * @param {Segment[]} walls the world
 * @param {Float64Array} angles (n) bearings from the heading, radians
 * @param {number} zMax the sensor's maximum range, metres
 * @returns {Float64Array} (n) metres
 */
export function simulateLidarScan(pose, walls, angles, zMax) {
  return angles.map((angle) => {
    const a = pose.theta + angle;
    const rdx = cos(a);
    const rdy = sin(a);
    let range = zMax;
    for (const wall of walls) {
      const t = raySegmentIntersection(pose.x, pose.y, rdx, rdy, wall);
      range = Math.min(range, t);
    }
    return range;
  });
}
// [/snippet]
