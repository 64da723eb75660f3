/** A program's map held against the reference. */

import { updateGridFromScans } from "../../src/fast.js";
import { simulatedScans } from "../../src/mapper.js";
import { pixel } from "../../src/mapWriter.js";
import { newGrid, Scenario } from "../../src/scenario.js";
import { ManyMistakes } from "./manyMistakes.js";
import { MISTAKES } from "./mistakes.js";
import { saying } from "./steps.js";

/** @typedef {import("./mistakenMapper.js").World} World */
/** @typedef {import("./readFiles.js").Picture} Picture */
/** @typedef {import("./readFiles.js").LogOdds} LogOdds */
/** @typedef {{picture: Picture} | {logOdds: LogOdds}} Found */

/**
 * @typedef {object} Reference
 * @property {number} width
 * @property {number} height
 * @property {Float64Array} logOdds row 0 at the bottom, as all here
 * @property {Uint8Array} pixels
 * @property {Int32Array} firstTouch the scan, from 1, that first updates each cell; 0 for none
 * @property {Int32Array} lastTouch
 * @property {number} scans
 */

/**
 * The right map, and when each cell was touched.
 *
 * @param {World} world
 * @param {number | null} seed
 * @returns {Reference}
 */
export function referenceOf({ settings, walls, scans }, seed) {
  const { width, height, maxRange, noReturn } = settings;
  const grid = newGrid(settings);
  const scenario = new Scenario("", settings, walls, scans);
  // counts updates of both kinds, whatever they do to the log-odds
  const counter = newGrid({
    ...settings,
    pOcc: 0.75,
    pFree: 0.75,
    p0: 0.5,
    lMin: -1000,
    lMax: 1e9,
  });
  const firstTouch = new Int32Array(width * height);
  const lastTouch = new Int32Array(width * height);
  let number = 0;
  for (const scan of simulatedScans(scenario, seed)) {
    number += 1;
    updateGridFromScans(grid, [scan], maxRange, noReturn);
    const before = counter.logOdds.slice();
    updateGridFromScans(counter, [scan], maxRange, noReturn);
    for (let i = 0; i < before.length; i++) {
      if (counter.logOdds[i] === before[i]) continue;
      if (firstTouch[i] === 0) firstTouch[i] = number;
      lastTouch[i] = number;
    }
  }
  const pixels = Uint8Array.from(grid.logOdds, (l) => pixel(l));
  const { logOdds } = grid;
  return {
    width,
    height,
    logOdds,
    pixels,
    firstTouch,
    lastTouch,
    scans: number,
  };
}

/** The size of what was found. @param {Found} found */
export function sizeOf(found) {
  return "picture" in found ? found.picture : found.logOdds;
}

/** Rows turned round, so that row 0 is at the bottom. @param {Picture} picture @returns {Uint16Array} */
export function fromBelow({ width, height, pixels }) {
  const turned = new Uint16Array(pixels.length);
  for (let row = 0; row < height; row++) {
    const from = pixels.subarray(row * width, (row + 1) * width);
    turned.set(from, (height - 1 - row) * width);
  }
  return turned;
}

/**
 * What was found, cell by cell, as pixels or log-odds, row 0 at the bottom.
 *
 * @param {Found} found
 * @returns {{values: Uint16Array | Float64Array, expected: (reference: Reference) => Uint8Array | Float64Array}}
 */
export function cellsOf(found) {
  return "picture" in found
    ? { values: fromBelow(found.picture), expected: ({ pixels }) => pixels }
    : { values: found.logOdds.values, expected: ({ logOdds }) => logOdds };
}

/** The cells that are not the same. @param {Found} found @param {Reference} reference @returns {number[]} */
export function differing(found, reference) {
  const { values, expected } = cellsOf(found);
  const right = expected(reference);
  const wrong = [];
  for (let i = 0; i < right.length; i++) {
    if (values[i] !== right[i]) wrong.push(i);
  }
  return wrong;
}

/** What a map is of the right one; each says where the cell (gx, gy) of the right map lies in it. */
const SYMMETRIES =
  /** @type {[string, boolean, (gx: number, gy: number, w: number, h: number) => [number, number]][]} */ ([
    ["flipped upside down", false, (x, y, _, h) => [x, h - 1 - y]],
    ["mirrored left to right", false, (x, y, w) => [w - 1 - x, y]],
    ["turned by 180 degrees", false, (x, y, w, h) => [w - 1 - x, h - 1 - y]],
    ["transposed (rows and columns exchanged)", true, (x, y) => [y, x]],
    [
      "transposed as a picture (rows and columns exchanged, counted from the top)",
      true,
      (x, y, w, h) => [h - 1 - y, w - 1 - x],
    ],
    ["turned by 90 degrees to the left", true, (x, y, _, h) => [h - 1 - y, x]],
    ["turned by 90 degrees to the right", true, (x, y, w) => [y, w - 1 - x]],
  ]);

/**
 * How a map is the right one turned or flipped, if it is so exactly.
 *
 * @param {Found} found
 * @param {Reference} reference
 * @returns {string[]}
 */
export function symmetriesOf(found, reference) {
  const { width: w, height: h } = reference;
  const size = sizeOf(found);
  const { values, expected } = cellsOf(found);
  const right = expected(reference);
  return SYMMETRIES.filter(([, exchanged, place]) => {
    const [width, height] = exchanged ? [h, w] : [w, h];
    if (size.width !== width || size.height !== height) return false;
    for (let gy = 0; gy < h; gy++) {
      for (let gx = 0; gx < w; gx++) {
        const [x, y] = place(gx, gy, w, h);
        if (values[y * width + x] !== right[gy * w + gx]) return false;
      }
    }
    return true;
  }).map(([name]) => name);
}

/**
 * After how many scans the reference looked like this map; -1 for never.
 *
 * @param {Found} found
 * @param {World} world
 * @param {number | null} seed
 */
export function prefixThatFits(found, { settings, walls, scans }, seed) {
  const { maxRange, noReturn } = settings;
  const { values } = cellsOf(found);
  const grid = newGrid(settings);
  const fits = () => {
    if ("logOdds" in found) {
      return values.every((value, i) => value === grid.logOdds[i]);
    }
    return values.every((value, i) => value === pixel(grid.logOdds[i]));
  };
  if (fits()) return 0;
  let number = 0;
  let best = -1;
  for (const scan of simulatedScans(
    new Scenario("", settings, walls, scans),
    seed,
  )) {
    updateGridFromScans(grid, [scan], maxRange, noReturn);
    number += 1;
    if (fits()) best = number;
  }
  return best;
}

/**
 * Up to where the map follows the reference: a cell that no later scan touches has its value of then for good.
 *
 * @param {number[]} wrong the cells that differ
 * @param {Reference} reference
 */
export function firstTrouble(wrong, { firstTouch, lastTouch, scans }) {
  let touched = scans + 1;
  let settled = scans + 1;
  let never = 0;
  for (const cell of wrong) {
    if (firstTouch[cell] === 0) {
      never += 1;
      continue;
    }
    touched = Math.min(touched, firstTouch[cell]);
    settled = Math.min(settled, lastTouch[cell]);
  }
  return { touched, settled, never, known: touched <= scans };
}

/** @typedef {{tried: number, of: number, same: import("./mistakenMapper.js").Mistake | null}} Trial */

/**
 * Mistakes of the page's that draw the same map, tried one after the other; `same` tells of one.
 *
 * @param {Found} found
 * @param {World} world
 * @param {number | null} seed
 * @returns {Generator<Trial, void>}
 */
export function* tryMistakes(found, world, seed) {
  const all = Array.from(MISTAKES.values()).filter(
    ({ name }) => seed !== null || !/^(noise-|no-noise)/.test(name),
  );
  const size = sizeOf(found);
  const maps = new ManyMistakes(world, seed);
  /** @param {number} tried @returns {Trial} */
  const soFar = (tried) => ({ tried, of: all.length, same: null });
  yield* saying(soFar(0), maps.prepare());
  for (const [i, mistake] of all.entries()) {
    const drawn = yield* saying(soFar(i), maps.draw(mistake));
    const right = "picture" in found ? drawn.picture : drawn.logOdds;
    const values =
      "picture" in found ? found.picture.pixels : found.logOdds.values;
    const expected =
      "picture" in found ? drawn.picture.pixels : drawn.logOdds.values;
    const same =
      size.width === right.width &&
      size.height === right.height &&
      expected.every((value, k) => value === values[k]);
    yield { ...soFar(i + 1), same: same ? mistake : null };
  }
}
