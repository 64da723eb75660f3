/**
 * One choice of sides for all undecided beams that draws a program's picture: the proof that rounding explains it. The
 * search starts where the nearest right formulas put the beams, and turns one beam after the other until every cell is
 * the program's, the best turn first. Each turn must bring the map nearer to the program's, and there is an end to
 * trying: a choice that is found is a proof, that none is found is not.
 */

import { NOTHING } from "./chosenWays.js";

/** @typedef {import("./chosenWays.js").ChosenWays} ChosenWays */
/** @typedef {import("./chosenWays.js").Chosen} Chosen */
/** @typedef {import("./programPicture.js").ProgramPicture} ProgramPicture */
/** @typedef {{gain: number, at: number, way: number}} Turn another way for one beam; gain < 0: it brings the map nearer */

/** And as many for each 10 cells that are open. */
const MOST_TRIES = 300;

export class SideSearch {
  /** The beams that the search has turned. @type {Set<number>} */
  turned = new Set();
  /** Cells that are not the program's, with how far they are off. @type {Map<number, number>} */
  #open = new Map();
  #tries = 0;

  /** @param {ChosenWays} ways @param {Chosen} chosen @param {number[]} wrong @param {ProgramPicture} picture */
  constructor(ways, chosen, wrong, picture) {
    this.ways = ways;
    this.picture = picture;
    this.chosen = chosen.slice();
    for (const cell of wrong) this.#open.set(cell, this.#off(cell));
  }

  /** @returns {Generator<void, boolean>} whether a choice was found */
  *solve() {
    const most = MOST_TRIES + Math.floor((MOST_TRIES * this.#open.size) / 10);
    /** @type {{at: number, before: number, turns: Turn[]}[]} */
    const steps = [];
    let turns = this.#turns();
    while (this.#open.size > 0) {
      yield;
      const turn = this.#tries < most ? turns.shift() : undefined;
      if (turn) {
        const { at, way } = turn;
        steps.push({ at, before: this.chosen[at], turns });
        this.turned.add(at);
        this.#apply(at, way);
        turns = this.#turns();
        continue;
      }
      const step = steps.pop();
      if (!step) return false;
      this.#apply(step.at, step.before);
      this.turned.delete(step.at);
      turns = step.turns;
    }
    return true;
  }

  /** Turns that change the first open cell, the best first. @returns {Turn[]} */
  #turns() {
    if (this.#open.size === 0) return [];
    const cell = Math.min(...this.#open.keys());
    /** @type {Turn[]} */
    const found = [];
    for (const at of this.ways.undecidedAt(cell)) {
      if (this.turned.has(at)) continue;
      const now = this.ways.effect(at, this.chosen[at]).get(cell) ?? NOTHING;
      for (let way = 0; way < this.ways.beams[at].ways.length; way++) {
        const then = this.ways.effect(at, way).get(cell) ?? NOTHING;
        if (then === now) continue;
        const gain = this.#gain(at, way);
        if (gain < 0) found.push({ gain, at, way });
      }
    }
    return found.sort((a, b) => a.gain - b.gain || a.at - b.at);
  }

  /** The cells to which another way does something else. @param {number} at @param {number} way */
  #changed(at, way) {
    const now = this.ways.effect(at, this.chosen[at]);
    const then = this.ways.effect(at, way);
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
    for (const cell of cells) {
      gain += this.#off(cell) - (this.#open.get(cell) ?? 0);
    }
    this.chosen[at] = present;
    return gain;
  }

  /** @param {number} at @param {number} way */
  #apply(at, way) {
    const cells = this.#changed(at, way);
    this.chosen[at] = way;
    for (const cell of cells) {
      const off = this.#off(cell);
      if (off > 0) this.#open.set(cell, off);
      else this.#open.delete(cell);
    }
  }

  /** How far a cell is from the program's. @param {number} cell */
  #off(cell) {
    return this.picture.off(cell, this.ways.value(cell, this.chosen));
  }
}
