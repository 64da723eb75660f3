/**
 * The loop of bresenham in src/ray.js, stopped at every line. The listing is that file's text; here the same steps are
 * taken again with a note of where they stand, and the cells are held against those of the port.
 */

import source from "text:../../src/ray.js";
import { bresenham } from "../../src/ray.js";

/** What each stop does, and how its line of the source begins. */
const MARKS = {
  dx: "const dx =",
  dy: "const dy =",
  sx: "const sx =",
  sy: "const sy =",
  err: "let err =",
  gx: "let gx =",
  gy: "let gy =",
  cells: "const cells =",
  loop: "while (",
  e2: "const e2 =",
  ifX: "if (e2 > -dy)",
  errX: "err -= dy",
  stepX: "gx += sx",
  ifY: "if (e2 < dx)",
  errY: "err += dx",
  stepY: "gy += sy",
  push: "cells.push(",
  done: "return cells",
};

/** @typedef {keyof typeof MARKS} Mark */

/** The printed lines of the snippet, without its comment. */
export const LISTING = source.split("\n").slice(
  source.split("\n").findIndex((line) => line.startsWith("export function")),
  source.split("\n").findIndex((line) => line.includes("[/snippet]")),
);

/** The line of the listing of each stop. @type {Record<Mark, number>} */
const LINE_OF = /** @type {Record<Mark, number>} */ (
  Object.fromEntries(
    Object.entries(MARKS).map(([mark, text]) => {
      const at = LISTING.findIndex((line) => line.trim().startsWith(text));
      if (at < 0) throw new Error(`src/ray.js has no line '${text}'`);
      return [mark, at];
    }),
  )
);

/** A line for the eye, not for the record. */
const MOST_STEPS = 5000;
const FARTHEST = 1e9;

/** Whether a line is short enough to be followed step by step. @param {number[]} line its ends */
export function lineIsShown([gx0, gy0, gx1, gy1]) {
  return (
    [gx0, gy0, gx1, gy1].every((number) => Math.abs(number) <= FARTHEST) &&
    Math.max(Math.abs(gx1 - gx0), Math.abs(gy1 - gy0)) <= MOST_STEPS
  );
}

/**
 * @typedef {object} Stop
 * @property {Mark} mark
 * @property {number} line of the listing, from 0: it has just been carried out
 * @property {Record<string, number>} values of the variables that exist
 * @property {number} count of the cells listed so far
 * @property {string} words what happened
 */

/**
 * @param {number} gx0
 * @param {number} gy0
 * @param {number} gx1
 * @param {number} gy1
 * @returns {{stops: Stop[], cells: {gx: number, gy: number}[]}}
 */
export function traceLine(gx0, gy0, gx1, gy1) {
  const cells = bresenham(gx0, gy0, gx1, gy1);
  /** @type {Stop[]} */
  const stops = [];
  /** @type {Record<string, number>} */
  let values = {};
  let count = 0;
  const stop = (/** @type {Mark} */ mark, /** @type {string} */ words) => {
    stops.push({ mark, line: LINE_OF[mark], values, count, words });
  };
  const set = (
    /** @type {Mark} */ mark,
    /** @type {string} */ name,
    /** @type {number} */ value,
  ) => {
    values = { ...values, [name]: value };
    stop(mark, `${name} = ${value}`);
  };
  /** The body of the loop ends, and e2 with it. */
  const leave = () => {
    const { e2: _, ...others } = values;
    values = others;
  };
  const dx = Math.abs(gx1 - gx0);
  const dy = Math.abs(gy1 - gy0);
  set("dx", "dx", dx);
  set("dy", "dy", dy);
  const sx = gx0 < gx1 ? 1 : -1;
  const sy = gy0 < gy1 ? 1 : -1;
  set("sx", "sx", sx);
  set("sy", "sy", sy);
  let err = dx - dy;
  set("err", "err", err);
  let gx = gx0;
  set("gx", "gx", gx);
  let gy = gy0;
  set("gy", "gy", gy);
  count = 1;
  stop("cells", `the first cell is (${gx}, ${gy})`);
  while (gx !== gx1 || gy !== gy1) {
    leave();
    stop("loop", `(${gx}, ${gy}) is not the last cell yet`);
    const e2 = 2 * err;
    set("e2", "e2", e2);
    if (e2 > -dy) {
      stop("ifX", `${e2} > ${-dy}: a step along x`);
      err -= dy;
      set("errX", "err", err);
      gx += sx;
      set("stepX", "gx", gx);
    } else {
      stop("ifX", `${e2} > ${-dy} does not hold: no step along x`);
    }
    if (e2 < dx) {
      stop("ifY", `${e2} < ${dx}: a step along y`);
      err += dx;
      set("errY", "err", err);
      gy += sy;
      set("stepY", "gy", gy);
    } else {
      stop("ifY", `${e2} < ${dx} does not hold: no step along y`);
    }
    count += 1;
    stop("push", `cell ${count} is (${gx}, ${gy})`);
    const listed = cells[count - 1];
    if (listed?.gx !== gx || listed.gy !== gy) {
      throw new Error("the trace does not follow bresenham");
    }
  }
  leave();
  stop("loop", `(${gx}, ${gy}) is the last cell`);
  stop("done", `${count} cells`);
  return { stops, cells };
}
