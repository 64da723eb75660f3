/** Lines that people draw in place of Bresenham's. */

import { bresenham } from "../../src/ray.js";

/** @typedef {import("./mistakenMapper.js").Cell} Cell */
/** @typedef {import("./mistakenMapper.js").Line} Line */

/** The nearest whole number, halves to even ones. @param {number} x */
export function roundHalfEven(x) {
  const low = Math.floor(x);
  const rest = x - low;
  if (rest !== 0.5) return rest < 0.5 ? low : low + 1;
  return low % 2 === 0 ? low : low + 1;
}

/**
 * One cell along the longer axis at each step, `minor` along the other.
 *
 * @param {(k: number, a: number, b: number) => number} minor
 * @returns {(from: Cell, to: Cell) => Line}
 */
export function lineWith(minor) {
  return (from, to) => {
    const dx = Math.abs(to.gx - from.gx);
    const dy = Math.abs(to.gy - from.gy);
    const sx = from.gx < to.gx ? 1 : -1;
    const sy = from.gy < to.gy ? 1 : -1;
    const a = Math.max(dx, dy);
    const b = Math.min(dx, dy);
    const cells = Array.from({ length: a + 1 }, (_, k) => {
      const m = minor(k, Math.max(a, 1), b);
      return dx >= dy
        ? { gx: from.gx + sx * k, gy: from.gy + sy * m }
        : { gx: from.gx + sx * m, gy: from.gy + sy * k };
    });
    return { cells, last: a };
  };
}

/**
 * Points of the straight line, one for each step along the longer axis, rounded to cells.
 *
 * @param {(v: number) => number} rounded
 * @returns {(from: Cell, to: Cell) => Line}
 */
export function straightLine(rounded) {
  return (from, to) => {
    const dx = to.gx - from.gx;
    const dy = to.gy - from.gy;
    const a = Math.max(Math.abs(dx), Math.abs(dy));
    const cells = Array.from({ length: a + 1 }, (_, k) => ({
      gx: rounded(from.gx + (dx * k) / Math.max(a, 1)),
      gy: rounded(from.gy + (dy * k) / Math.max(a, 1)),
    }));
    return { cells, last: a };
  };
}

/**
 * The lesson's loop with other conditions. A line that misses its end is given up after twice as many steps as all lines
 * of its scan should need, and has no last cell.
 *
 * @param {(e2: number, dx: number, dy: number) => [boolean, boolean]} step whether to go along x, and along y
 * @returns {(from: Cell, to: Cell, most: number) => Line}
 */
export function walkedLine(step) {
  return (from, to, most) => {
    const dx = Math.abs(to.gx - from.gx);
    const dy = Math.abs(to.gy - from.gy);
    const sx = from.gx < to.gx ? 1 : -1;
    const sy = from.gy < to.gy ? 1 : -1;
    let { gx, gy } = from;
    let err = dx - dy;
    const cells = [];
    for (let i = 0; i < most; i++) {
      cells.push({ gx, gy });
      if (gx === to.gx && gy === to.gy) {
        return { cells, last: cells.length - 1 };
      }
      const [alongX, alongY] = step(2 * err, dx, dy);
      if (alongX) {
        err -= dy;
        gx += sx;
      }
      if (alongY) {
        err += dx;
        gy += sy;
      }
    }
    return { cells, last: -1 };
  };
}

/** The contract's line, computed from its far end. @param {Cell} from @param {Cell} to @returns {Line} */
export function lineFromEnd(from, to) {
  const cells = bresenham(to.gx, to.gy, from.gx, from.gy).reverse();
  return { cells, last: cells.length - 1 };
}

/**
 * Every cell that the line between the two centres passes through; where it passes through a corner, with `corners` both
 * cells beside it too.
 *
 * @param {boolean} corners
 * @returns {(from: Cell, to: Cell) => Line}
 */
export function supercover(corners) {
  return (from, to) => {
    const dx = Math.abs(to.gx - from.gx);
    const dy = Math.abs(to.gy - from.gy);
    const sx = from.gx < to.gx ? 1 : -1;
    const sy = from.gy < to.gy ? 1 : -1;
    let { gx, gy } = from;
    let goneX = 0;
    let goneY = 0;
    const cells = [{ gx, gy }];
    while (goneX !== dx || goneY !== dy) {
      // which border comes first: (2 i + 1) / (2 dx) against (2 j + 1) / (2 dy)
      const first = (2 * goneX + 1) * dy - (2 * goneY + 1) * dx;
      if (corners && first === 0) {
        cells.push({ gx: gx + sx, gy }, { gx, gy: gy + sy });
      }
      if (first <= 0) {
        gx += sx;
        goneX += 1;
      }
      if (first >= 0) {
        gy += sy;
        goneY += 1;
      }
      cells.push({ gx, gy });
    }
    return { cells, last: cells.length - 1 };
  };
}
