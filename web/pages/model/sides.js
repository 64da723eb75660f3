/**
 * One choice of sides for all undecided beams that draws a program's picture exactly: the proof that rounding explains
 * it. That a choice is found is a proof; that none is found says nothing.
 */

import { sigmoid } from "../../src/grid.js";
import { bresenham } from "../../src/ray.js";
import { newGrid } from "../../src/scenario.js";
import { beamsOfScan } from "./rounding.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./rounding.js").Beam} Beam */
/** @typedef {import("./rounding.js").Way} Way */
/** @typedef {{kind: "halves" | "edges", turned: {scan: number, beam: number}[], halves: number}} Explained beams that go another way, and cells with the other level */
/** @typedef {{gain: number, at: number, way: number}} Turn another way for one beam; gain < 0: it brings the map nearer */

const NOTHING = 0;
const FREE = 1;
const OCCUPIED = 2;
const MOST_CELLS = 4000;
const MOST_TRIES = 60000;
const U = 2 ** -52;
/** So many beams are listed in a step. */
const AT_A_TIME = 500;

/**
 * The two levels that rounding can make of log-odds with so many updates behind them.
 *
 * @param {number} logOdds
 * @param {number} updates
 * @returns {[number, number]}
 */
function greyLevels(logOdds, updates) {
  const grey = (1 - sigmoid(logOdds)) * 255 + 0.5;
  const blur = 255 * (16 + 2 * updates) * U;
  return [Math.floor(grey - blur), Math.floor(grey + blur)];
}

/**
 * How a picture of the right size can come about by rounding alone. It may take seconds, so it is searched step by step.
 *
 * @param {World} world
 * @param {number | null} seed
 * @param {ArrayLike<number>} pixels of the program, row 0 at the bottom
 * @returns {Generator<void, Explained | null>} null: no way was found
 */
export function* explainByRounding(world, seed, pixels) {
  /** @type {Beam[]} */
  const beams = [];
  for (let number = 0; number < world.scans.length; number++) {
    beams.push(...beamsOfScan(world, number, seed));
    yield;
  }
  const search = new Search(world, beams, pixels);
  yield* search.list();
  if (!(yield* search.solve())) return null;
  const turned = Array.from(search.turned, (at) => ({
    scan: beams[at].scan,
    beam: beams[at].beam,
  })).sort((a, b) => a.scan - b.scan || a.beam - b.beam);
  return {
    kind: turned.length ? "edges" : "halves",
    turned,
    halves: search.halves(),
  };
}

class Search {
  /** The beams that are not on the contract's side. @type {Set<number>} */
  turned = new Set();
  /** Cells that are not the program's, with how far they are off. @type {Map<number, number>} */
  open = new Map();
  #tries = 0;
  /** The visits of cell i are those from from[i] to from[i + 1]. */
  from = new Int32Array(0);
  visitBeam = new Int32Array(0);
  visitWay = new Int8Array(0);
  visitKind = new Int8Array(0);

  /** @param {World} world @param {Beam[]} beams @param {ArrayLike<number>} pixels */
  constructor(world, beams, pixels) {
    this.beams = beams;
    this.pixels = pixels;
    const { width, height } = world.settings;
    this.width = width;
    this.height = height;
    const grid = newGrid(world.settings);
    this.start = grid.l0;
    this.free = grid.lFree - grid.l0;
    this.occupied = grid.lOcc - grid.l0;
    this.lMin = grid.lMin;
    this.lMax = grid.lMax;
    /** The way that each beam goes. */
    this.chosen = new Int8Array(beams.length);
    /** @type {Map<string, Map<number, number>>} */
    this.effects = new Map();
  }

  /** The visits of all ways to each cell, in the order of the beams: one after another, found by `from`. */
  *list() {
    const cells = this.width * this.height;
    const count = new Int32Array(cells + 1);
    let total = 0;
    yield* this.#visits((cell) => {
      count[cell + 1] += 1;
      total += 1;
    });
    for (let i = 0; i < cells; i++) count[i + 1] += count[i];
    this.from = count;
    const next = count.slice();
    this.visitBeam = new Int32Array(total);
    this.visitWay = new Int8Array(total);
    this.visitKind = new Int8Array(total);
    yield* this.#visits((cell, at, way, kind) => {
      const place = next[cell]++;
      this.visitBeam[place] = at;
      this.visitWay[place] = way;
      this.visitKind[place] = kind;
    });
  }

  /** @param {(cell: number, at: number, way: number, kind: number) => void} visit */
  *#visits(visit) {
    for (const [at, { ways }] of this.beams.entries()) {
      if (at % AT_A_TIME === 0) yield;
      for (const [number, way] of ways.entries()) {
        for (const [cell, kind] of this.#trace(way)) {
          visit(cell, at, number, kind);
        }
      }
    }
  }

  /** What a way does to each of its cells in the grid. @param {Way} way @returns {Generator<[number, number]>} */
  *#trace(way) {
    if (!way.used) return;
    const cells = bresenham(way.gx0, way.gy0, way.gx1, way.gy1);
    for (let k = 0; k < cells.length; k++) {
      const { gx, gy } = cells[k];
      if (gx < 0 || gx >= this.width || gy < 0 || gy >= this.height) continue;
      const hit = way.hit && k === cells.length - 1;
      yield [gy * this.width + gx, hit ? OCCUPIED : FREE];
    }
  }

  /** @param {number} at @param {number} way @returns {Map<number, number>} */
  #effect(at, way) {
    const key = `${at} ${way}`;
    let effect = this.effects.get(key);
    if (!effect) {
      effect = new Map(this.#trace(this.beams[at].ways[way]));
      this.effects.set(key, effect);
    }
    return effect;
  }

  /** The value of a cell, with the ways chosen now. @param {number} cell */
  #value(cell) {
    let value = this.start;
    for (let i = this.from[cell]; i < this.from[cell + 1]; i++) {
      if (this.chosen[this.visitBeam[i]] !== this.visitWay[i]) continue;
      value += this.visitKind[i] === FREE ? this.free : this.occupied;
      if (value > this.lMax) value = this.lMax;
      else if (value < this.lMin) value = this.lMin;
    }
    return value;
  }

  /** How far a cell is from the program's level; 0 where rounding can make it. @param {number} cell */
  #off(cell) {
    const value = this.#value(cell);
    const level = this.pixels[cell];
    if (greyLevels(value, this.beams.length).includes(level)) return 0;
    return Math.max(Math.abs((1 - sigmoid(value)) * 255 - level), 1e-6);
  }

  /** @returns {Generator<void, boolean>} whether a choice was found */
  *solve() {
    for (let cell = 0; cell < this.width * this.height; cell++) {
      const off = this.#off(cell);
      if (off > 0) this.open.set(cell, off);
    }
    if (this.open.size > MOST_CELLS) return false;
    for (const cell of this.open.keys()) {
      if (!this.#isUndecided(cell)) return false;
    }
    for (const aside of [0, 1, 2]) {
      if (yield* this.#solveWith(aside)) return true;
    }
    return false;
  }

  /** Whether a beam that can go several ways can touch the cell. @param {number} cell */
  #isUndecided(cell) {
    for (let i = this.from[cell]; i < this.from[cell + 1]; i++) {
      if (this.beams[this.visitBeam[i]].ways.length > 1) return true;
    }
    return false;
  }

  /** Turns beams one after the other, the best turn first; some turns may bring the map no nearer. @param {number} aside @returns {Generator<void, boolean>} */
  *#solveWith(aside) {
    this.#tries = 0;
    /** @type {{at: number, before: number, aside: number, turns: Turn[]}[]} */
    const steps = [];
    let turns = this.#turns(aside);
    while (this.open.size > 0) {
      yield;
      const turn = turns.shift();
      if (turn && this.#tries < MOST_TRIES) {
        steps.push({
          at: turn.at,
          before: this.chosen[turn.at],
          aside,
          turns,
        });
        if (turn.gain >= 0) aside -= 1;
        this.turned.add(turn.at);
        this.#apply(turn.at, turn.way);
        turns = this.open.size > 0 ? this.#turns(aside) : [];
      } else {
        const step = steps.pop();
        if (!step) return false;
        this.#apply(step.at, step.before);
        this.turned.delete(step.at);
        ({ aside, turns } = step);
      }
    }
    return true;
  }

  /** Turns that change the first open cell. @param {number} aside @returns {Turn[]} */
  #turns(aside) {
    const cell = Math.min(...this.open.keys());
    /** @type {Turn[]} */
    const found = [];
    const seen = new Set();
    for (let i = this.from[cell]; i < this.from[cell + 1]; i++) {
      const at = this.visitBeam[i];
      if (seen.has(at) || this.turned.has(at)) continue;
      seen.add(at);
      const { ways } = this.beams[at];
      if (ways.length === 1) continue;
      const now = this.#effect(at, this.chosen[at]).get(cell) ?? NOTHING;
      for (let way = 0; way < ways.length; way++) {
        if ((this.#effect(at, way).get(cell) ?? NOTHING) === now) continue;
        const gain = this.#gain(at, way);
        if (gain < 0 || aside > 0) found.push({ gain, at, way });
      }
    }
    return found.sort((a, b) => a.gain - b.gain || a.at - b.at);
  }

  /** The cells to which another way does something else. @param {number} at @param {number} way */
  #changed(at, way) {
    const now = this.#effect(at, this.chosen[at]);
    const then = this.#effect(at, way);
    const cells = new Set([...now.keys(), ...then.keys()]);
    return Array.from(cells).filter(
      (cell) => now.get(cell) !== then.get(cell),
    );
  }

  /** How much farther the map is after a turn. @param {number} at @param {number} way */
  #gain(at, way) {
    this.#tries += 1;
    const cells = this.#changed(at, way);
    const present = this.chosen[at];
    let gain = 0;
    this.chosen[at] = way;
    for (const cell of cells)
      gain += this.#off(cell) - (this.open.get(cell) ?? 0);
    this.chosen[at] = present;
    return gain;
  }

  /** @param {number} at @param {number} way */
  #apply(at, way) {
    const cells = this.#changed(at, way);
    this.chosen[at] = way;
    for (const cell of cells) {
      const off = this.#off(cell);
      if (off > 0) this.open.set(cell, off);
      else this.open.delete(cell);
    }
  }

  /** Cells whose level is the other one of the two that rounding can make. */
  halves() {
    let count = 0;
    for (let cell = 0; cell < this.width * this.height; cell++) {
      const level = Math.floor((1 - sigmoid(this.#value(cell))) * 255 + 0.5);
      if (level !== this.pixels[cell]) count += 1;
    }
    return count;
  }
}
