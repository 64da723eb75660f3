/**
 * The contract once more, one short function for each step, so that a mistake can be planted in any of them. Without a
 * mistake it draws the same bits as the port; a test holds it to that.
 */

import { logit, sigmoid } from "../../src/grid.js";
import { normalDeviate } from "../../src/noise.js";
import { cos, sin } from "../../src/portableMath.js";
import { bresenham } from "../../src/ray.js";
import { beamAngles, Scan } from "../../src/sensor.js";
import { Pose, raySegmentIntersection } from "../../src/world.js";

/** @typedef {import("../../src/scenario.js").Settings} Settings */
/** @typedef {import("../../src/world.js").Segment} Segment */
/** @typedef {{settings: Settings, walls: Segment[], scans: (Pose | Scan)[]}} World a scenario in memory */
/** @typedef {{gx: number, gy: number}} Cell */
/** @typedef {{cells: Cell[], last: number}} Line cells in order; which of them is the last, -1 where it is missing */
/** @typedef {{gx: number, gy: number, occupied: boolean}} Update */
/** @typedef {{width: number, height: number, pixels: Uint8Array}} Picture its rows from the top */
/** @typedef {{width: number, height: number, values: Float64Array}} LogOdds the rows of the file */
/** @typedef {{from: Cell, beams: {to: Cell, hit: boolean}[]}} Beams of a scan */
/** @typedef {ReturnType<typeof contractSteps>} Steps */
/** @typedef {{name: string, title: string, lesson: string, plant: (steps: Steps) => void}} Mistake */

/** Which cells of a line are updated, and which of them as occupied. @param {Line} line @param {boolean} hit @returns {[number, boolean][]} */
function allCells(line, hit) {
  return line.cells.map((_, k) => [k, hit && k === line.last]);
}

/** @param {number} l */
function unchanged(l) {
  return l;
}

/** The updates of one scan, before they are applied. @param {Update[]} updates @returns {Update[]} */
function allUpdates(updates) {
  return updates;
}

/**
 * The steps of the contract (SPEC.md sections 2 and 3).
 *
 * @param {World} world
 */
export function contractSteps({ settings, walls, scans }) {
  const s = settings;
  const steps = {
    settings,
    scans,
    walls,

    // --- the model (2.2) ---
    logit,
    start: () => steps.logit(s.p0),
    /** What a free cell and an occupied one add. @returns {[number, number]} */
    deltas: () => {
      const l0 = steps.logit(s.p0);
      return [steps.logit(s.pFree) - l0, steps.logit(s.pOcc) - l0];
    },
    clamp: (/** @type {number} */ l) => Math.min(Math.max(l, s.lMin), s.lMax),
    /** After one update. */
    updated: (/** @type {number} */ l, /** @type {number} */ delta) =>
      steps.clamp(l + delta),
    /** After all updates of a scan. */
    afterScan: unchanged,
    /** After the last scan. */
    finish: (/** @type {number} */ l) => l,

    // --- the simulated sensor (3) ---
    bearings: () => beamAngles(s.fov, s.beams),
    cast: (/** @type {Pose} */ pose, /** @type {number} */ direction) => {
      const rdx = cos(direction);
      const rdy = sin(direction);
      let range = s.maxRange;
      for (const wall of walls) {
        range = Math.min(
          range,
          raySegmentIntersection(pose.x, pose.y, rdx, rdy, wall),
        );
      }
      return range;
    },
    deviate: normalDeviate,
    /** The number that a scan has for its noise. @param {number} scan */
    numbered: (scan) => scan,
    noisy: (
      /** @type {number} */ range,
      /** @type {number} */ seed,
      /** @type {number} */ scan,
      /** @type {number} */ beam,
    ) => {
      const noisy = range + s.noiseStd * steps.deviate(seed, scan, beam);
      return Math.min(Math.max(noisy, 0), s.maxRange);
    },
    /** What becomes of recorded ranges. */
    recorded: (
      /** @type {Float64Array} */ ranges,
      /** @type {number | null} */ _seed,
      /** @type {number} */ _scan,
    ) => ranges,

    // --- beams (2.3) ---
    direction: (/** @type {number} */ theta, /** @type {number} */ angle) =>
      theta + angle,
    read: (/** @type {number} */ range) => {
      const hit = range < s.maxRange - 1e-12;
      const used = s.noReturn === "ignore" ? hit : hit || !Number.isNaN(range);
      return { z: hit ? range : s.maxRange, hit, used };
    },
    endpoint: (
      /** @type {Pose} */ pose,
      /** @type {number} */ direction,
      /** @type {number} */ z,
    ) => ({
      x: pose.x + z * cos(direction),
      y: pose.y + z * sin(direction),
    }),

    // --- the grid (2.1) ---
    index: Math.floor,
    toGrid: (/** @type {number} */ x, /** @type {number} */ y) => ({
      gx: steps.index((x - s.originX) / s.resolution),
      gy: steps.index((y - s.originY) / s.resolution),
    }),
    /** Where a cell lies in the array; -1 where it lies outside. */
    place: (/** @type {number} */ gx, /** @type {number} */ gy) =>
      gx >= 0 && gx < s.width && gy >= 0 && gy < s.height
        ? gy * s.width + gx
        : -1,

    // --- the update (2.4, 2.5) ---
    kept: (/** @type {Cell} */ _from, /** @type {Cell} */ _to) => true,
    /** @returns {Line} */
    line: (
      /** @type {Cell} */ from,
      /** @type {Cell} */ to,
      /** @type {number} the most cells that a lost line may have */ _most,
    ) => {
      const cells = bresenham(from.gx, from.gy, to.gx, to.gy);
      return { cells, last: cells.length - 1 };
    },
    evidence: allCells,
    withinScan: allUpdates,

    // --- the files (2.6, 7) ---
    probability: sigmoid,
    pixel: (/** @type {number} */ p) => Math.floor((1 - p) * 255 + 0.5),
    /** @returns {LogOdds} */
    fileOrder: (/** @type {LogOdds} */ map) => map,
    /** @returns {Picture} */
    picture: (/** @type {LogOdds} */ map) => {
      const { width, height, values } = map;
      const pixels = new Uint8Array(values.length);
      for (let gy = 0; gy < height; gy++) {
        for (let gx = 0; gx < width; gx++) {
          const p = steps.probability(values[gy * width + gx]);
          pixels[(height - 1 - gy) * width + gx] = steps.pixel(p);
        }
      }
      return { width, height, pixels };
    },
  };
  return steps;
}

/** @param {Steps} steps @returns {(keyof Steps)[]} */
function stepNames(steps) {
  return /** @type {(keyof Steps)[]} */ (Object.keys(steps));
}

/** Maps a world scan by scan, with mistakes. */
export class MistakenMapper {
  /**
   * @param {World} world
   * @param {number | null} seed
   * @param {Mistake[]} mistakes
   */
  constructor(world, seed, mistakes) {
    this.world = world;
    this.seed = seed;
    this.steps = contractSteps(world);
    const right = { ...this.steps };
    for (const mistake of mistakes) mistake.plant(this.steps);
    /** The steps that are not the contract's. */
    this.changed = stepNames(right).filter(
      (name) => this.steps[name] !== right[name],
    );
    this.bearings = this.steps.bearings();
  }

  /** An empty map. */
  start() {
    const { width, height } = this.world.settings;
    return new Float64Array(width * height).fill(this.steps.start());
  }

  /**
   * Adds one scan to a map.
   *
   * @param {Float64Array} logOdds
   * @param {number} number the scan's
   */
  add(logOdds, number) {
    const { steps } = this;
    const [free, occupied] = steps.deltas();
    /** @type {Set<number>} */
    const touched = new Set();
    const isKept = steps.afterScan !== unchanged;
    for (const update of this.updates(number)) {
      const at = update >> 1;
      logOdds[at] = steps.updated(logOdds[at], update & 1 ? occupied : free);
      if (isKept) touched.add(at);
    }
    for (const at of touched) logOdds[at] = steps.afterScan(logOdds[at]);
  }

  /**
   * The updates of a scan, in order: twice the cell's place, and one more where it is occupied. Lists of numbers are
   * quicker than lists of objects.
   *
   * @param {number} number
   * @returns {Iterable<number>}
   */
  updates(number) {
    const { steps } = this;
    /** @type {number[]} */
    const updates = [];
    const add = (
      /** @type {Cell} */ { gx, gy },
      /** @type {boolean} */ occupied,
    ) => {
      const at = steps.place(gx, gy);
      if (at >= 0) updates.push(2 * at + (occupied ? 1 : 0));
    };
    const whole = steps.evidence === allCells;
    /** @type {Update[]} */
    const listed = [];
    for (const { line, hit } of this.lines(number)) {
      const { cells, last } = line;
      if (whole && steps.withinScan === allUpdates) {
        // the same without a list
        cells.forEach((cell, k) => {
          add(cell, hit && k === last);
        });
        continue;
      }
      // not taken apart as [k, isOccupied], which takes twice as long
      for (const one of steps.evidence(line, hit)) {
        const { gx, gy } = cells[one[0]];
        listed.push({ gx, gy, occupied: one[1] });
      }
    }
    for (const one of steps.withinScan(listed)) add(one, one.occupied);
    return updates;
  }

  /**
   * The lines of a scan, in order.
   *
   * @param {number} number
   */
  lines(number) {
    const { steps } = this;
    const { from, beams } = this.beams(number);
    let most = 0;
    for (const { to } of beams) {
      const span = Math.abs(to.gx - from.gx) + Math.abs(to.gy - from.gy);
      most = Math.max(most, 2 * span + 1);
    }
    return beams.map(({ to, hit }) => ({
      line: steps.line(from, to, most),
      hit,
    }));
  }

  /**
   * The beams of a scan that say anything: their first cell, and the last cell of each.
   *
   * @param {number} number
   * @returns {Beams}
   */
  beams(number) {
    const { steps } = this;
    const { pose, angles, ranges } = this.scan(number);
    const from = steps.toGrid(pose.x, pose.y);
    const beams = [];
    for (let i = 0; i < ranges.length; i++) {
      const { z, hit, used } = steps.read(ranges[i]);
      if (!used) continue;
      const direction = steps.direction(pose.theta, angles[i]);
      const end = steps.endpoint(pose, direction, z);
      const to = steps.toGrid(end.x, end.y);
      if (!steps.kept(from, to)) continue;
      beams.push({ to, hit });
    }
    return { from, beams };
  }

  /** @param {number} number @returns {Scan} */
  scan(number) {
    const { steps, seed, bearings } = this;
    const next = this.world.scans[number];
    if (!(next instanceof Pose)) {
      const { pose, angles } = next;
      return new Scan(pose, angles, steps.recorded(next.ranges, seed, number));
    }
    const scan = steps.numbered(number);
    const ranges = bearings.map((angle, beam) => {
      const range = steps.cast(next, steps.direction(next.theta, angle));
      return seed === null ? range : steps.noisy(range, seed, scan, beam);
    });
    return new Scan(next, bearings, ranges);
  }

  /**
   * What the files of a map hold.
   *
   * @param {Float64Array} logOdds
   * @returns {{logOdds: LogOdds, picture: Picture}}
   */
  files(logOdds) {
    const { width, height } = this.world.settings;
    const values = logOdds.map((l) => this.steps.finish(l));
    const map = { width, height, values };
    return {
      logOdds: this.steps.fileOrder(map),
      picture: this.steps.picture(map),
    };
  }

  /** The map of all scans. */
  draw() {
    const logOdds = this.start();
    for (let i = 0; i < this.world.scans.length; i++) this.add(logOdds, i);
    return this.files(logOdds);
  }
}
