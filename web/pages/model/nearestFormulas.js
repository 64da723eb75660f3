/** Where a right program puts its beams: the right formulas whose map is nearest to a program's. */

import { DIRECTIONS } from "./rightDirections.js";
import { CHOICES, CONTRACT, STEP_NAMES } from "./rightFormulas.js";

/** @typedef {import("./rightFormulas.js").Formulas} Formulas */
/** @typedef {import("./rightEnds.js").RightEnds} RightEnds */
/** @typedef {import("./rightEnds.js").Ends} Ends */
/** @typedef {import("./chosenWays.js").ChosenWays} ChosenWays */
/** @typedef {import("./chosenWays.js").Chosen} Chosen */
/** @typedef {import("./programPicture.js").ProgramPicture} ProgramPicture */
/** @typedef {import("./rounding.js").Beam} Beam */

/** @type {Formulas[]} */
const STARTS = [CONTRACT, { ...CONTRACT, functions: "this machine's" }];
const ROUNDS = 2;
/** So many cells are looked at in a step. */
const AT_A_TIME = 2000;

/** Takes one other formula after the other, as long as that brings the map nearer to the program's. */
export class NearestFormulas {
  /** @type {Formulas} */
  formulas = STARTS[0];
  /** The way of each beam with these formulas. @type {Chosen} */
  chosen;
  /** The cells in which the map is not the program's then. @type {number[]} */
  open = [];
  /** The cells that were wrong with one of the formulas taken: the quick look is at these alone. @type {Set<number>} */
  #watched = new Set();

  /**
   * @param {RightEnds} ends
   * @param {ChosenWays} ways
   * @param {ProgramPicture} picture
   * @param {number[]} touched the cells that rounding can change
   */
  constructor(ends, ways, picture, touched) {
    this.ends = ends;
    this.ways = ways;
    this.picture = picture;
    this.touched = touched;
    this.chosen = ways.contract();
  }

  /** @returns {Generator<void, void>} */
  *search() {
    this.open = yield* this.misfits(this.touched, this.chosen);
    this.#watched = new Set(this.open);
    for (const start of STARTS.slice(1)) yield* this.#try(start);
    for (let round = 0; round < ROUNDS; round++) {
      const before = this.open.length;
      for (const other of this.#others()) {
        if (this.open.length === 0) return;
        yield* this.#try(other);
      }
      if (this.open.length === before) return;
    }
  }

  /** Takes these formulas if the map is nearer with them. @param {Formulas} formulas @returns {Generator<void, void>} */
  *#try(formulas) {
    const ends = yield* this.ends.of(formulas);
    const chosen = this.ways.contract();
    for (const [at, beam] of this.ways.beams.entries()) {
      if (beam.ways.length > 1) chosen[at] = wayOf(beam, ends[beam.scan]);
    }
    const quick = yield* this.misfits(Array.from(this.#watched), chosen);
    if (quick.length >= this.open.length) return;
    const found = yield* this.misfits(this.touched, chosen);
    for (const cell of found) this.#watched.add(cell);
    if (found.length >= this.open.length) return;
    this.formulas = formulas;
    this.chosen = chosen;
    this.open = found;
  }

  /** The formulas taken, with another one for a single step, or for the directions of rays and beams together. @returns {Generator<Formulas>} */
  *#others() {
    for (const step of STEP_NAMES) {
      if (step === "seen") {
        for (const name of Object.keys(DIRECTIONS)) {
          yield { ...this.formulas, seen: name, drawn: name };
        }
      }
      for (const name of CHOICES[step]) {
        if (name === this.formulas[step]) continue;
        yield { ...this.formulas, [step]: name };
      }
    }
  }

  /** Which of the cells are not the program's. @param {number[]} cells @param {Chosen} chosen @returns {Generator<void, number[]>} */
  *misfits(cells, chosen) {
    const found = [];
    for (const [i, cell] of cells.entries()) {
      if (i % AT_A_TIME === AT_A_TIME - 1) yield;
      const value = this.ways.value(cell, chosen);
      if (!this.picture.fits(cell, value)) found.push(cell);
    }
    return found;
  }
}

/** The way between these ends, or the contract's where it is none of the beam's. @param {Beam} beam @param {Ends} ends */
export function wayOf({ ways, beam }, { gx0, gy0, gx1, gy1, hit }) {
  const [x, y, h] = [gx1[beam], gy1[beam], hit[beam]];
  for (let i = 0; i < ways.length; i++) {
    const way = ways[i];
    if (way.gx1 !== x || way.gy1 !== y || way.hit !== h) continue;
    if (way.gx0 === gx0 && way.gy0 === gy0) return i;
  }
  return 0;
}
