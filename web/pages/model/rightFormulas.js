/**
 * Other formulas that right programs use. The contract fixes one formula for each step. A program may take another one
 * that is as right: it may add up its headings, count bearings in degrees, or turn beams by a rotation matrix. The last
 * bits of its coordinates then differ, and a beam that ends on a cell edge may end on the other side. The formulas are
 * those of `occgrid-parity check` (compare, module right_formulas).
 */

import { cos, log, PI, sin } from "../../src/portableMath.js";
import { addedUp, DIRECTIONS } from "./rightDirections.js";

/** @typedef {{sin: (x: number) => number, cos: (x: number) => number, log: (x: number) => number}} Functions */
/** @typedef {keyof typeof CONTRACT} Step */
/** @typedef {Record<Step, string>} Formulas one for each step, by its name */

const TURN = 2 * PI;

/** @param {number} count @param {(i: number) => number} formula */
function each(count, formula) {
  return new Float64Array(count).map((_, i) => formula(i));
}

/** The lesson's n angles on its ellipse. @type {Record<string, (n: number) => Float64Array>} */
export const HEADINGS = {
  "2 pi (t / n)": (n) => each(n, (t) => TURN * (t / n)),
  "(2 pi t) / n": (n) => each(n, (t) => (TURN * t) / n),
  "t (2 pi / n)": (n) => each(n, (t) => t * (TURN / n)),
  "added up": (n) => addedUp(0, TURN / n, n),
  "degrees, times pi, over 180": (n) =>
    each(n, (t) => ((360 / n) * t * PI) / 180),
  "degrees, times pi / 180": (n) => each(n, (t) => (360 / n) * t * (PI / 180)),
};

/** @param {number} fov @param {number} n @param {number} i */
function degrees(fov, n, i) {
  const wide = fov * (180 / PI);
  return -wide / 2 + i * (wide / (n - 1));
}

/** Bearings of simulated scans with n beams, n > 1. @type {Record<string, (fov: number, n: number) => Float64Array>} */
export const BEARINGS = {
  "-fov / 2 + (fov i) / (n - 1)": (fov, n) =>
    each(n, (i) => -fov / 2 + (fov * i) / (n - 1)),
  "-fov / 2 + i (fov / (n - 1))": (fov, n) =>
    each(n, (i) => -fov / 2 + i * (fov / (n - 1))),
  "-fov / 2 + fov (i / (n - 1))": (fov, n) =>
    each(n, (i) => -fov / 2 + fov * (i / (n - 1))),
  "added up": (fov, n) => addedUp(-fov / 2, fov / (n - 1), n),
  "degrees, times pi, over 180": (fov, n) =>
    each(n, (i) => (degrees(fov, n, i) * PI) / 180),
  "degrees, times pi / 180": (fov, n) =>
    each(n, (i) => degrees(fov, n, i) * (PI / 180)),
  "(i - (n - 1) / 2) (fov / (n - 1))": (fov, n) =>
    each(n, (i) => (i - (n - 1) / 2) * (fov / (n - 1))),
  "(i / (n - 1) - 1 / 2) fov": (fov, n) =>
    each(n, (i) => (i / (n - 1) - 0.5) * fov),
};

/** Ends in the robot's frame, turned as points: for the beams on the map only. */
export const TURNED_POINTS = "ends turned by a rotation matrix";

export const CROSS_PRODUCTS = "a quotient of cross products";
/** Where the wall is parallel to the other axis. */
export const ALONG_AXIS = "along x or y";
/** Of a ray that is as long as the maximum range. */
export const SHARE = "a share of the maximum range";

/**
 * The cell of a coordinate v, of the grid's origin o and resolution r. The difference of quotients is as right as the
 * quotient only for coordinates that have rounding errors themselves; a pose from a file has none.
 *
 * @type {Record<string, (v: number, o: number, r: number) => number>}
 */
export const CELLS = {
  "(x - origin) / resolution": (v, o, r) => Math.floor((v - o) / r),
  "x / resolution - origin / resolution": (v, o, r) =>
    Math.floor(v / r - o / r),
};

/** @type {Record<string, Functions>} */
export const FUNCTIONS = {
  "the reference's": { sin, cos, log },
  "this machine's": { sin: Math.sin, cos: Math.cos, log: Math.log },
};

export const CONTRACT = {
  heading: "2 pi (t / n)",
  bearing: "-fov / 2 + (fov i) / (n - 1)",
  seen: "heading + bearing",
  drawn: "heading + bearing",
  distance: CROSS_PRODUCTS,
  cell: "(x - origin) / resolution",
  functions: "the reference's",
};

/** The formulas of each step. @type {Record<Step, string[]>} */
export const CHOICES = {
  heading: Object.keys(HEADINGS),
  bearing: Object.keys(BEARINGS),
  seen: Object.keys(DIRECTIONS),
  drawn: [...Object.keys(DIRECTIONS), TURNED_POINTS],
  distance: [CROSS_PRODUCTS, ALONG_AXIS, SHARE],
  cell: Object.keys(CELLS),
  functions: Object.keys(FUNCTIONS),
};

/** What each formula computes. @type {Record<Step, string>} */
export const STEPS = {
  heading: "the robot's angle on the ellipse",
  bearing: "bearings",
  seen: "directions in which ranges are simulated",
  drawn: "directions of beams on the map",
  distance: "distance to a wall",
  cell: "cells",
  functions: "sine and cosine",
};

/** The steps, in the order in which they are tried. */
export const STEP_NAMES = /** @type {Step[]} */ (Object.keys(CHOICES));

/** Those that are not the contract's, as `bearings: added up`. @param {Formulas} formulas */
export function otherFormulas(formulas) {
  return STEP_NAMES.filter((step) => formulas[step] !== CONTRACT[step]).map(
    (step) => `${STEPS[step]}: ${formulas[step]}`,
  );
}
