/**
 * Lays open what the contract is made of (CONTRIBUTING.md): `node probe.mjs FUNCTION INPUT OUTPUT`. Each line of INPUT is
 * a question, each line of OUTPUT its answer.
 */

import { readFileSync, writeFileSync } from "node:fs";
import * as occgrid from "../src/index.js";
import { doubleOf, hexOf } from "./bits.mjs";

/** @typedef {(...words: string[]) => (string | number)[]} Answer */

const whole = Number;
const word32 = (/** @type {string} */ text) => Number.parseInt(text, 16);
const hex32 = (/** @type {number} */ word) =>
  (word >>> 0).toString(16).padStart(8, "0");
const flag = (/** @type {boolean} */ value) => (value ? 1 : 0);
const noReturnOf = (/** @type {string} */ text) =>
  /** @type {import("../src/sensor.js").NoReturn} */ (text);

/** @param {(x: number) => number} f @returns {Answer} */
const ofDouble = (f) => (x) => [hexOf(f(doubleOf(x)))];

/** @type {Record<string, Answer>} */
export const FUNCTIONS = {
  sin: ofDouble(occgrid.sin),
  cos: ofDouble(occgrid.cos),
  exp: ofDouble(occgrid.exp),
  log: ofDouble(occgrid.log),
  logit: ofDouble(occgrid.logit),
  sigmoid: ofDouble(occgrid.sigmoid),
  world_to_grid: (resolution, originX, originY, x, y) => {
    const [r, ox, oy] = [resolution, originX, originY].map(doubleOf);
    const spec = new occgrid.GridSpec(1, 1, r, ox, oy);
    const { gx, gy } = new occgrid.OccupancyGrid(spec).worldToGrid(
      doubleOf(x),
      doubleOf(y),
    );
    return [gx, gy];
  },
  bresenham: (...ends) => {
    const [gx0, gy0, gx1, gy1] = ends.map(whole);
    const cells = occgrid.bresenham(gx0, gy0, gx1, gy1);
    return cells.map(({ gx, gy }) => `${gx}:${gy}`);
  },
  clip_ray: (...numbers) => {
    const [gx0, gy0, gx1, gy1, width, height] = numbers.map(whole);
    const steps = occgrid.clipRay(gx0, gy0, gx1, gy1, width, height);
    return [steps.first, steps.last];
  },
  flaser_angles: (n, beam) => [
    hexOf(occgrid.flaserAngles(whole(n))[whole(beam)]),
  ],
  read_ranges: (range, zMax, noReturn) => {
    const ranges = Float64Array.of(doubleOf(range));
    const read = occgrid.readRanges(
      ranges,
      doubleOf(zMax),
      noReturnOf(noReturn),
    );
    return [hexOf(read.z[0]), flag(read.hit[0]), flag(read.used[0])];
  },
  beam_endpoints: (x, y, theta, angle, z) => {
    const pose = new occgrid.Pose(doubleOf(x), doubleOf(y), doubleOf(theta));
    const { ex, ey } = occgrid.beamEndpoints(
      pose,
      Float64Array.of(doubleOf(angle)),
      Float64Array.of(doubleOf(z)),
    );
    return [hexOf(ex[0]), hexOf(ey[0])];
  },
  update_cell: (p0, pOcc, pFree, lMin, lMax, updates) => {
    const [a, b, c, d, e] = [p0, pOcc, pFree, lMin, lMax].map(doubleOf);
    const spec = new occgrid.GridSpec(1, 1, 1, 0, 0);
    const grid = new occgrid.OccupancyGrid(spec, a, b, c, d, e);
    for (const update of updates) {
      grid.updateCell(0, 0, update === "o" ? grid.lOcc : grid.lFree);
    }
    return [hexOf(grid.logOdds[0])];
  },
  pixel: (logOdds) => [occgrid.pixel(doubleOf(logOdds))],
  philox: (...words) => {
    const numbers = words.map(word32);
    return occgrid
      .philox4x32(numbers.slice(0, 4), numbers.slice(4))
      .map(hex32);
  },
  normal_deviate: (seed, scan, beam) => [
    hexOf(occgrid.normalDeviate(whole(seed), whole(scan), whole(beam))),
  ],
};

if (process.argv[1]?.endsWith("probe.mjs")) {
  const [name, input, output] = process.argv.slice(2);
  const answer = Object.hasOwn(FUNCTIONS, name) ? FUNCTIONS[name] : undefined;
  if (answer === undefined || output === undefined) {
    console.error(
      `usage: probe.mjs ${Object.keys(FUNCTIONS).join("|")} INPUT OUTPUT`,
    );
    process.exit(2);
  }
  const questions = readFileSync(input, "ascii").split("\n").slice(0, -1);
  const answers = questions.map((line) =>
    answer(...line.split(" ")).join(" "),
  );
  writeFileSync(output, answers.map((line) => `${line}\n`).join(""));
}
