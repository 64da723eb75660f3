/**
 * The scans of a world and their map after any number of them. While a wall or a setting is dragged, each frame has a
 * run of its own. It takes over from the one before what the change does not touch, and the bits are the same: the
 * sines of the beams, how far they go, their noise.
 */

import {
  castRays,
  directionsOf,
  updateFromDirections,
  updateGridFromScans,
} from "../../src/fast.js";
import { noisyRange, normalDeviate } from "../../src/noise.js";
import { newGrid } from "../../src/scenario.js";
import { beamAngles, Scan } from "../../src/sensor.js";
import { Pose } from "../../src/world.js";
import { Timeline } from "./timeline.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("../../src/fast.js").Directions} Directions */
/** @typedef {import("../../src/grid.js").OccupancyGrid} OccupancyGrid */
/** @typedef {import("../../src/world.js").Segment} Segment */

/** Mapping a few scans again takes less time than keeping every map. */
const KEPT_EVERY = 32;

/** A list whose entries are made when they are first asked for. @template T */
class Lazy {
  /** @type {T[]} */
  #made = [];
  #make;

  /** @param {(i: number) => T} make */
  constructor(make) {
    this.#make = make;
  }

  /** @param {number} i @returns {T} */
  at(i) {
    this.#made[i] ??= this.#make(i);
    return this.#made[i];
  }
}

/** Whether the beams of all scans have the same directions. @param {World} one @param {World} other */
function sameBeams(one, other) {
  return (
    one.scans === other.scans &&
    one.settings.fov === other.settings.fov &&
    one.settings.beams === other.settings.beams
  );
}

export class Run {
  /** @type {World} */
  world;
  /** What `maps` has drawn last. @type {OccupancyGrid} */
  grid;

  /**
   * @param {World} world
   * @param {number | null} seed null: without noise
   * @param {Run | null} old the run before, of any world
   */
  constructor(world, seed, old = null) {
    const { settings, walls, scans } = world;
    this.world = world;
    /** @type {number | null} */
    this.seed = seed;
    const known = old !== null && sameBeams(old.world, world) ? old : null;
    /** Bearings of simulated scans. @type {Float64Array} */
    this.angles = known?.angles ?? beamAngles(settings.fov, settings.beams);
    /** @type {Lazy<Directions>} */
    this.directions = known?.directions ?? directionsOfAll(scans, this.angles);
    /** @type {Lazy<Float64Array>} */
    this.distances =
      known?.world.walls === walls
        ? known.distances
        : distancesOfAll(scans, walls, this.directions);
    /** @type {Lazy<Float64Array>} */
    this.deviates =
      known?.seed === seed ? known.deviates : deviates(seed, settings.beams);
    /** @type {Lazy<Scan>} */
    this.scans = new Lazy((i) => this.#scan(i));
    this.grid =
      old?.world.settings === settings ? old.grid : newGrid(settings);
  }

  /** @type {Timeline | null} */
  #timeline = null;

  /** The maps after whole scans. Many runs of a drag are never mapped: a newer one comes first. */
  get timeline() {
    if (this.#timeline === null) {
      const grid = newGrid(this.world.settings);
      this.#timeline = new Timeline(
        this.world.scans.length,
        grid.logOdds,
        (i) => this.#add(grid, i, this.scans.at(i)),
        KEPT_EVERY,
      );
    }
    return this.#timeline;
  }

  /** Adds a scan to a map, or its first beams. @param {OccupancyGrid} grid @param {number} i @param {Scan} scan */
  #add(grid, i, scan) {
    const { maxRange, noReturn } = this.world.settings;
    const directions = this.directions.at(i);
    updateFromDirections(grid, scan, directions, maxRange, noReturn);
  }

  /**
   * The map after some beams of a scan; and before them, or before a scan that is added on top. Both are overwritten by
   * the next call, also of a run that takes over from this one, and by the timeline's next.
   *
   * @param {number} scan from 1
   * @param {number} beam how many of its beams
   * @param {Scan | null} added
   */
  maps(scan, beam, added) {
    const { grid } = this;
    let before = this.timeline.at(scan - 1);
    grid.logOdds.set(before);
    const { pose, angles, ranges } = this.scans.at(scan - 1);
    const part = new Scan(pose, angles, ranges.subarray(0, beam));
    this.#add(grid, scan - 1, part);
    if (added !== null) {
      const { maxRange, noReturn } = this.world.settings;
      before = grid.logOdds.slice();
      updateGridFromScans(grid, [added], maxRange, noReturn);
    }
    return { before, now: grid.logOdds };
  }

  /** A scan with its ranges: simulated, with noise, or recorded. @param {number} i @returns {Scan} */
  #scan(i) {
    const scan = this.world.scans[i];
    if (!(scan instanceof Pose)) return scan;
    const { maxRange, noiseStd } = this.world.settings;
    const ranges = this.distances.at(i).map((z) => Math.min(z, maxRange));
    if (this.seed !== null) {
      const deviates = this.deviates.at(i);
      for (let beam = 0; beam < ranges.length; beam++) {
        const noise = noiseStd * deviates[beam];
        ranges[beam] = noisyRange(ranges[beam], noise, maxRange);
      }
    }
    return new Scan(scan, this.angles, ranges);
  }
}

// What makes an entry must not hold on to a run, or each run would keep all before it.

/** @param {World["scans"]} scans @param {Float64Array} angles of simulated scans @returns {Lazy<Directions>} */
function directionsOfAll(scans, angles) {
  return new Lazy((i) => {
    const scan = scans[i];
    return scan instanceof Pose
      ? directionsOf(scan, angles)
      : directionsOf(scan.pose, scan.angles);
  });
}

/**
 * How far the beams of simulated scans go, whatever the sensor's range: infinitely where they meet no wall.
 *
 * @param {World["scans"]} scans
 * @param {Segment[]} walls
 * @param {Lazy<Directions>} directions
 * @returns {Lazy<Float64Array>}
 */
function distancesOfAll(scans, walls, directions) {
  return new Lazy((i) =>
    castRays(
      /** @type {Pose} */ (scans[i]),
      walls,
      directions.at(i),
      Infinity,
    ),
  );
}

/** @param {number | null} seed @param {number} beams @returns {Lazy<Float64Array>} */
function deviates(seed, beams) {
  return new Lazy((i) =>
    new Float64Array(beams).map((_, beam) =>
      normalDeviate(seed ?? 0, i, beam),
    ),
  );
}
