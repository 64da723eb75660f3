/**
 * The maps of many mistakes in one world. Each mistake changes a step or two of the contract; what comes before is the same
 * for all, and is done once. The maps are those of MistakenMapper.
 */

import { updateFromBeam } from "../../src/fast.js";
import { newGrid } from "../../src/scenario.js";
import { MistakenMapper } from "./mistakenMapper.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./mistakenMapper.js").Mistake} Mistake */
/** @typedef {import("./mistakenMapper.js").Beams} Beams */
/** @typedef {import("./mistakenMapper.js").Steps} Steps */
/** @typedef {import("../../src/sensor.js").Scan} Scan */

/** The steps up to the ranges, to the ends of the beams, and to the cells that are updated; and those after the map. */
const RANGES = steps(
  "bearings",
  "cast",
  "deviate",
  "numbered",
  "noisy",
  "recorded",
  "direction",
);
const ENDS = steps(...RANGES, "read", "endpoint", "index", "toGrid", "kept");
const UPDATES = steps(...ENDS, "place", "line", "evidence", "withinScan");
const FILES = steps("probability", "pixel", "fileOrder", "picture");

/** @param {(keyof Steps)[]} names @returns {(keyof Steps)[]} */
function steps(...names) {
  return names;
}

export class ManyMistakes {
  /** @type {Scan[]} */
  #scans = [];
  /** @type {Beams[]} */
  #beams = [];
  /** @type {Int32Array[]} */
  #updates = [];
  /** @type {Float64Array} */
  #map = new Float64Array(0);

  /** @param {World} world @param {number | null} seed */
  constructor(world, seed) {
    this.world = world;
    this.seed = seed;
  }

  /** What all mistakes have in common; it comes first. @returns {Generator<void, void>} */
  *prepare() {
    const right = new MistakenMapper(this.world, this.seed, []);
    const numbers = Array.from(this.world.scans.keys());
    for (const number of numbers) {
      yield;
      this.#scans.push(right.scan(number));
    }
    right.scan = (number) => this.#scans[number];
    for (const number of numbers) {
      yield;
      this.#beams.push(right.beams(number));
    }
    right.beams = (number) => this.#beams[number];
    for (const number of numbers) {
      yield;
      this.#updates.push(Int32Array.from(right.updates(number)));
    }
    right.updates = (number) => this.#updates[number];
    this.#map = yield* this.#added(right);
  }

  /** What the files of a mistake's map hold. @param {Mistake} mistake */
  *draw(mistake) {
    const mapper = new MistakenMapper(this.world, this.seed, [mistake]);
    return mapper.files(yield* this.#mapOf(mapper));
  }

  /** @param {MistakenMapper} mapper @returns {Generator<void, Float64Array>} */
  *#mapOf(mapper) {
    const differs = (/** @type {(keyof Steps)[]} */ names) =>
      mapper.changed.some((name) => names.includes(name));
    if (mapper.changed.every((name) => FILES.includes(name))) return this.#map;
    if (!differs(RANGES)) mapper.scan = (number) => this.#scans[number];
    if (!differs(ENDS)) mapper.beams = (number) => this.#beams[number];
    if (!differs(UPDATES)) mapper.updates = (number) => this.#updates[number];
    if (mapper.changed.every((name) => ENDS.includes(name))) {
      return yield* this.#drawn(mapper);
    }
    return yield* this.#added(mapper);
  }

  /** The map of all scans. @param {MistakenMapper} mapper */
  *#added(mapper) {
    const map = mapper.start();
    for (const number of this.#scans.keys()) {
      yield;
      mapper.add(map, number);
    }
    return map;
  }

  /** The map where nothing but the ends of beams may be wrong. @param {MistakenMapper} mapper */
  *#drawn(mapper) {
    const grid = newGrid(this.world.settings);
    for (const number of this.#scans.keys()) {
      yield;
      const { from, beams } = mapper.beams(number);
      for (const { to, hit } of beams) {
        updateFromBeam(grid, from.gx, from.gy, to.gx, to.gy, hit);
      }
    }
    return grid.logOdds;
  }
}
