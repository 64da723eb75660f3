/** The cells in which beams start and end, with one right formula or another for each step. */

import { noisyRange, philox4x32 } from "../../src/noise.js";
import { PI } from "../../src/portableMath.js";
import { readRanges, Scan } from "../../src/sensor.js";
import { DIRECTIONS, directed } from "./rightDirections.js";
import {
  ALONG_AXIS,
  BEARINGS,
  CELLS,
  CONTRACT,
  FUNCTIONS,
  HEADINGS,
  SHARE,
  TURNED_POINTS,
} from "./rightFormulas.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./rightFormulas.js").Formulas} Formulas */
/** @typedef {import("./rightFormulas.js").Functions} Functions */
/** @typedef {import("./rightDirections.js").Fan} Fan */
/** @typedef {import("../../src/fast.js").Directions} Directions */
/** @typedef {{gx0: number, gy0: number, gx1: Float64Array, gy1: Float64Array, hit: boolean[]}} Ends where the beams of a scan start and end */
/** @typedef {{x: number, y: number, theta: number}} Place */

export class RightEnds {
  /** What several formulas have in common. @type {Map<string, unknown>} */
  #known = new Map();

  /**
   * @param {World} world
   * @param {number | null} seed
   * @param {boolean} ownPoses the program computes the lesson's poses itself; then the world is the lesson
   */
  constructor(world, seed, ownPoses) {
    this.world = world;
    this.seed = seed;
    this.ownPoses = ownPoses;
  }

  /** Of all scans, in their order. @param {Formulas} f @returns {Generator<void, Ends[]>} */
  *of(f) {
    /** @type {Ends[]} */
    const found = [];
    for (let i = 0; i < this.world.scans.length; i++) {
      found.push(this.#scan(f, i));
      yield;
    }
    return found;
  }

  /** @param {Formulas} f @param {number} i the scan's number @returns {Ends} */
  #scan(f, i) {
    const s = this.world.settings;
    const { x, y } = this.#place(f, i);
    const cell = CELLS[f.cell];
    // a pose from a file has no rounding errors
    const startCell = this.ownPoses ? cell : CELLS[CONTRACT.cell];
    const { z, hit } = readRanges(this.#ranges(f, i), s.maxRange, s.noReturn);
    const end = this.#points(f, i, z);
    return {
      gx0: startCell(x, s.originX, s.resolution),
      gy0: startCell(y, s.originY, s.resolution),
      gx1: end.x.map((ex) => cell(x + ex, s.originX, s.resolution)),
      gy1: end.y.map((ey) => cell(y + ey, s.originY, s.resolution)),
      hit,
    };
  }

  /** @template T @param {(string | number)[]} what @param {() => T} make @returns {T} */
  #kept(what, make) {
    const key = what.join("; ");
    if (!this.#known.has(key)) this.#known.set(key, make());
    return /** @type {T} */ (this.#known.get(key));
  }

  /** Where the robot is. @param {Formulas} f @param {number} i @returns {Place} */
  #place(f, i) {
    const scan = this.world.scans[i];
    if (!this.ownPoses) return scan instanceof Scan ? scan.pose : scan;
    const places = this.#kept(["poses", f.heading, f.functions], () => {
      const { cos, sin } = FUNCTIONS[f.functions];
      const angles = HEADINGS[f.heading](this.world.scans.length);
      return Array.from(angles, (angle) => ({
        x: -6 + 6 * cos(angle),
        y: 4 * sin(angle),
        theta: angle + PI / 2,
      }));
    });
    return places[i];
  }

  /** The beams of a simulated scan, or each beam of a recorded one by itself. @param {Formulas} f @param {number} i @returns {Fan[]} */
  #fans(f, i) {
    const scan = this.world.scans[i];
    const functions = FUNCTIONS[f.functions];
    const { theta } = this.#place(f, i);
    if (scan instanceof Scan) {
      return Array.from(scan.angles, (angle) => ({
        theta,
        angles: Float64Array.of(angle),
        functions,
      }));
    }
    const { fov, beams } = this.world.settings;
    const angles = this.#kept(["bearings", f.bearing], () =>
      beams > 1 ? BEARINGS[f.bearing](fov, beams) : new Float64Array(1),
    );
    return [{ theta, angles, functions }];
  }

  /** @param {Formulas} f @param {string} name of the formula @param {number} i @returns {Directions} */
  #directions(f, name, i) {
    const what = ["directions", name, f.heading, f.bearing, f.functions, i];
    return this.#kept(what, () =>
      joined(this.#fans(f, i).map(DIRECTIONS[name])),
    );
  }

  /** @param {Formulas} f @param {number} i @returns {Float64Array} */
  #ranges(f, i) {
    const scan = this.world.scans[i];
    if (scan instanceof Scan) return scan.ranges;
    const { heading, bearing, seen, distance, functions } = f;
    return this.#kept(
      ["ranges", heading, bearing, seen, distance, functions, i],
      () => {
        const { c, s } = this.#directions(f, seen, i);
        const place = this.#place(f, i);
        return c.map((rdx, beam) => {
          const range = this.#cast(place, rdx, s[beam], distance);
          return this.#noisy(range, i, beam, functions);
        });
      },
    );
  }

  /** @param {number} range @param {number} scan @param {number} beam @param {string} functions */
  #noisy(range, scan, beam, functions) {
    const { seed } = this;
    if (seed === null) return range;
    const { noiseStd, maxRange } = this.world.settings;
    const deviate = this.#kept(["noise", functions, scan, beam], () =>
      normalDeviate(seed, scan, beam, FUNCTIONS[functions]),
    );
    return noisyRange(range, noiseStd * deviate, maxRange);
  }

  /** The distance to the nearest wall. @param {Place} place @param {number} rdx @param {number} rdy @param {string} distance */
  #cast({ x, y }, rdx, rdy, distance) {
    const longest = this.world.settings.maxRange;
    if (distance === SHARE) {
      rdx = x + longest * rdx - x;
      rdy = y + longest * rdy - y;
    }
    let nearest = Infinity;
    for (const wall of this.world.walls) {
      const [sx, sy] = [wall.x1 - wall.x0, wall.y1 - wall.y0];
      const [qpx, qpy] = [wall.x0 - x, wall.y0 - y];
      const rxs = rdx * sy - rdy * sx;
      if (Math.abs(rxs) < 1e-12) continue;
      let t = (qpx * sy - qpy * sx) / rxs;
      const u = (qpx * rdy - qpy * rdx) / rxs;
      if (!(t >= 0 && u >= 0 && u <= 1)) continue;
      if (distance === SHARE) t *= longest;
      else if (distance === ALONG_AXIS && sx === 0) t = qpx / rdx;
      else if (distance === ALONG_AXIS && sy === 0) t = qpy / rdy;
      if (t < nearest) nearest = t;
    }
    return Math.min(nearest, longest);
  }

  /** The ends of beams of the lengths z, from the robot. @param {Formulas} f @param {number} i @param {Float64Array} z */
  #points(f, i, z) {
    if (f.drawn !== TURNED_POINTS) {
      const { c, s } = this.#directions(f, f.drawn, i);
      return { x: z.map((l, k) => l * c[k]), y: z.map((l, k) => l * s[k]) };
    }
    const what = ["own frame", f.heading, f.bearing, f.functions, i];
    const { c, s } = this.#kept(what, () =>
      joined(
        this.#fans(f, i).map((fan) => directed(fan.angles, fan.functions)),
      ),
    );
    const { theta } = this.#place(f, i);
    const { cos, sin } = FUNCTIONS[f.functions];
    const [ct, st] = [cos(theta), sin(theta)];
    return {
      x: z.map((l, k) => ct * (l * c[k]) - st * (l * s[k])),
      y: z.map((l, k) => st * (l * c[k]) + ct * (l * s[k])),
    };
  }
}

/** @param {Directions[]} parts @returns {Directions} */
function joined(parts) {
  if (parts.length === 1) return parts[0];
  return {
    c: Float64Array.from(parts.flatMap(({ c }) => Array.from(c))),
    s: Float64Array.from(parts.flatMap(({ s }) => Array.from(s))),
  };
}

/** SPEC.md section 3.3. @param {number} seed @param {number} scan @param {number} beam @param {Functions} functions */
function normalDeviate(seed, scan, beam, { log, cos }) {
  const [w0, w1] = philox4x32([scan, beam, 0, 0], [seed, 0]);
  const u1 = (w0 + 0.5) / 4294967296;
  const u2 = (w1 + 0.5) / 4294967296;
  return Math.sqrt(-2 * log(u1)) * cos(2 * PI * u2);
}
