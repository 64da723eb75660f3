/** How a picture can come about by rounding alone: the rule of `occgrid-parity check` (compare, module closeness). */

import { ChosenWays } from "./chosenWays.js";
import { leftOut } from "./leftOut.js";
import { NearestFormulas } from "./nearestFormulas.js";
import { ProgramPicture } from "./programPicture.js";
import { RightEnds } from "./rightEnds.js";
import { otherFormulas } from "./rightFormulas.js";
import { beamsOfScan } from "./rounding.js";
import { SideSearch } from "./sides.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./chosenWays.js").Chosen} Chosen */
/** @typedef {import("./rounding.js").Beam} Beam */
/** @typedef {import("./leftOut.js").Gap} Gap */

/**
 * @typedef {object} Explanation
 * @property {"halves" | "edges" | "no choice" | "mistake"} kind by rounding, for the first two; "no choice": each cell
 *   alone could come from rounding; "mistake": some cell could not
 * @property {{scan: number, beam: number}[]} turned the beams that go another way
 * @property {number} halves cells with the other level
 * @property {string[]} formulas those with which the right program draws the picture in every cell, or all but the gap,
 *   where they are known and not the contract's
 * @property {Gap | null} gap what right formulas must leave out to draw the picture
 */

const MOST_CELLS = 4000;
/** Cells with the nearest right formulas. */
const MOST_OPEN = 500;

/** @type {Explanation} */
const NO_CHOICE = {
  kind: "no choice",
  turned: [],
  halves: 0,
  formulas: [],
  gap: null,
};
/** @type {Explanation} */
const MISTAKE = { ...NO_CHOICE, kind: "mistake" };

/**
 * How a picture of the right size can come about by rounding alone. It may take seconds, so it is searched step by step.
 *
 * @param {World} world
 * @param {number | null} seed
 * @param {ArrayLike<number>} pixels of the program, row 0 at the bottom
 * @param {boolean} ownPoses the program computes the lesson's poses itself; then the world is the lesson
 * @returns {Generator<void, Explanation>}
 */
export function* explainByRounding(world, seed, pixels, ownPoses) {
  /** @type {Beam[]} */
  const beams = [];
  for (let number = 0; number < world.scans.length; number++) {
    beams.push(...beamsOfScan(world, number, seed, ownPoses));
    yield;
  }
  const ways = new ChosenWays(world, beams);
  yield* ways.list();
  const picture = new ProgramPicture(pixels, beams.length);
  const contract = ways.contract();
  const touched = [];
  const open = [];
  for (let cell = 0; cell < ways.cells; cell++) {
    if (cell % MOST_CELLS === 0) yield;
    const isTouched = ways.isUndecided(cell);
    if (isTouched) touched.push(cell);
    const value = ways.value(cell, contract);
    // where exp(0) is all that is computed, no last bit decides: 127.5 goes up
    const isExact = value === 0 && ways.isUntouched(cell);
    if (isExact ? picture.equals(cell, value) : picture.fits(cell, value)) {
      continue;
    }
    if (!isTouched) return MISTAKE;
    open.push(cell);
  }
  if (open.length > MOST_CELLS) return MISTAKE;
  /** @param {Chosen} chosen */
  const halves = (chosen) => {
    let count = 0;
    for (let cell = 0; cell < ways.cells; cell++) {
      if (!picture.equals(cell, ways.value(cell, chosen))) count += 1;
    }
    return count;
  };
  if (open.length === 0) {
    return { ...NO_CHOICE, kind: "halves", halves: halves(contract) };
  }
  const ends = new RightEnds(world, seed, ownPoses);
  const nearest = new NearestFormulas(ends, ways, picture, touched);
  yield* nearest.search();
  const formulas = otherFormulas(nearest.formulas);
  const search = new SideSearch(ways, nearest.chosen, nearest.open, picture);
  const found = nearest.open.length <= MOST_OPEN && (yield* search.solve());
  // one beam that is turned is as simple as a scan that is missing
  if (!found || search.turned.size > 1) {
    const gap = yield* leftOut(nearest);
    if (gap !== null) return { ...NO_CHOICE, gap, formulas };
    if (!found) return NO_CHOICE;
  }
  // those that change none of the cells in question are not named
  const wrong = [];
  for (let cell = 0; cell < ways.cells; cell++) {
    if (!picture.equals(cell, ways.value(cell, contract))) wrong.push(cell);
  }
  const turned = ways.turned(wrong, search.chosen);
  if (turned.length === 0) return NO_CHOICE;
  return {
    kind: "edges",
    turned: turned.map((at) => ({
      scan: beams[at].scan,
      beam: beams[at].beam,
    })),
    halves: halves(search.chosen),
    formulas: nearest.open.length === 0 ? formulas : [],
    gap: null,
  };
}
