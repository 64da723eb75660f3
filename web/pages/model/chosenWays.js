/** The map that one way for each beam draws, cell by cell. */

import { bresenham } from "../../src/ray.js";
import { newGrid } from "../../src/scenario.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./rounding.js").Beam} Beam */
/** @typedef {import("./rounding.js").Way} Way */
/** @typedef {Int8Array} Chosen the number of the way that each beam goes; NO_WAY for none */

export const NOTHING = 0;
const FREE = 1;
const OCCUPIED = 2;
export const NO_WAY = -1;
/** So many beams are listed in a step. */
const AT_A_TIME = 500;

export class ChosenWays {
  /** The visits of cell i are those from from[i] to from[i + 1], in the order of the beams. */
  #from = new Int32Array(0);
  #beam = new Int32Array(0);
  #way = new Int8Array(0);
  #kind = new Int8Array(0);
  /** What ways do that were asked for. @type {Map<string, Map<number, number>>} */
  #effects = new Map();

  /** @param {World} world @param {Beam[]} beams */
  constructor({ settings }, beams) {
    this.beams = beams;
    this.width = settings.width;
    this.height = settings.height;
    const grid = newGrid(settings);
    this.start = grid.l0;
    this.free = grid.lFree - grid.l0;
    this.occupied = grid.lOcc - grid.l0;
    this.lMin = grid.lMin;
    this.lMax = grid.lMax;
  }

  /** How many cells the grid has. */
  get cells() {
    return this.width * this.height;
  }

  /** The contract's way for each beam. @returns {Chosen} */
  contract() {
    return new Int8Array(this.beams.length);
  }

  /** Lists the visits of all ways to each cell; it comes first. */
  *list() {
    const count = new Int32Array(this.cells + 1);
    let total = 0;
    yield* this.#visits((cell) => {
      count[cell + 1] += 1;
      total += 1;
    });
    for (let i = 0; i < this.cells; i++) count[i + 1] += count[i];
    this.#from = count;
    const next = count.slice();
    this.#beam = new Int32Array(total);
    this.#way = new Int8Array(total);
    this.#kind = new Int8Array(total);
    yield* this.#visits((cell, at, way, kind) => {
      const place = next[cell]++;
      this.#beam[place] = at;
      this.#way[place] = way;
      this.#kind[place] = kind;
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

  /** What a way does to each of its cells. @param {number} at the beam @param {number} way @returns {Map<number, number>} */
  effect(at, way) {
    const key = `${at} ${way}`;
    let effect = this.#effects.get(key);
    if (!effect) {
      effect = new Map(this.#trace(this.beams[at].ways[way]));
      this.#effects.set(key, effect);
    }
    return effect;
  }

  /** The log-odds of a cell. @param {number} cell @param {Chosen} chosen */
  value(cell, chosen) {
    let value = this.start;
    for (let i = this.#from[cell]; i < this.#from[cell + 1]; i++) {
      if (chosen[this.#beam[i]] !== this.#way[i]) continue;
      value += this.#kind[i] === FREE ? this.free : this.occupied;
      if (value > this.lMax) value = this.lMax;
      else if (value < this.lMin) value = this.lMin;
    }
    return value;
  }

  /** Whether no beam can touch the cell. @param {number} cell */
  isUntouched(cell) {
    return this.#from[cell] === this.#from[cell + 1];
  }

  /** Whether a beam that can go several ways can touch the cell. @param {number} cell */
  isUndecided(cell) {
    for (let i = this.#from[cell]; i < this.#from[cell + 1]; i++) {
      if (this.beams[this.#beam[i]].ways.length > 1) return true;
    }
    return false;
  }

  /** The beams that can go several ways, one of them through the cell. @param {number} cell @returns {number[]} in order */
  undecidedAt(cell) {
    const found = new Set();
    for (let i = this.#from[cell]; i < this.#from[cell + 1]; i++) {
      const at = this.#beam[i];
      if (this.beams[at].ways.length > 1) found.add(at);
    }
    return Array.from(found);
  }

  /** The beams that do something else to one of the cells with these ways than with the contract's. @param {number[]} cells @param {Chosen} chosen @returns {number[]} in order */
  turned(cells, chosen) {
    const found = new Set();
    for (const cell of cells) {
      for (const at of this.undecidedAt(cell)) {
        const now = this.effect(at, chosen[at]).get(cell) ?? NOTHING;
        const right = this.effect(at, 0).get(cell) ?? NOTHING;
        if (now !== right) found.add(at);
      }
    }
    return Array.from(found).sort((a, b) => a - b);
  }
}
