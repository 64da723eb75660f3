/**
 * The lesson's mapping written down plainly: a list of cells for each beam, a look at the borders for each update. The
 * lesson has no program in JavaScript; this one follows its Python.
 *
 * usage: node lesson_driver.mjs WORK
 */

import { answerRequests, readWork } from "../../web/driver.mjs";

/** @typedef {import("../../web/driver.mjs").Work} Work */
/** @typedef {import("../../web/driver.mjs").WorkScan} WorkScan */

/** @param {number} p */
function logit(p) {
  return Math.log(p / (1 - p));
}

class Grid {
  l0 = logit(0.5);
  lOcc = logit(0.75);
  lFree = logit(0.3);
  lMin = -8;
  lMax = 8;

  /** @param {Work} work */
  constructor({ width, height, resolution, originX, originY }) {
    this.width = width;
    this.height = height;
    this.resolution = resolution;
    this.originX = originX;
    this.originY = originY;
    this.logOdds = new Float64Array(width * height).fill(this.l0);
  }

  /** @param {number} x @param {number} y @returns {[number, number]} */
  worldToGrid(x, y) {
    return [
      Math.floor((x - this.originX) / this.resolution),
      Math.floor((y - this.originY) / this.resolution),
    ];
  }

  /** @param {number} gx @param {number} gy */
  inBounds(gx, gy) {
    return 0 <= gx && gx < this.width && 0 <= gy && gy < this.height;
  }

  /** @param {number} gx @param {number} gy @param {number} lUpdate */
  updateCell(gx, gy, lUpdate) {
    if (!this.inBounds(gx, gy)) return;
    const cell = gy * this.width + gx;
    this.logOdds[cell] += lUpdate - this.l0;
    if (this.logOdds[cell] > this.lMax) this.logOdds[cell] = this.lMax;
    else if (this.logOdds[cell] < this.lMin) this.logOdds[cell] = this.lMin;
  }
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} xEnd
 * @param {number} yEnd
 */
function bresenham(x, y, xEnd, yEnd) {
  /** @type {[number, number][]} */
  const cells = [];
  const dx = Math.abs(xEnd - x);
  const dy = Math.abs(yEnd - y);
  const xStep = x < xEnd ? 1 : -1;
  const yStep = y < yEnd ? 1 : -1;
  let error = dx - dy;
  for (;;) {
    cells.push([x, y]);
    if (x === xEnd && y === yEnd) return cells;
    const twice = 2 * error;
    if (twice > -dy) {
      error -= dy;
      x += xStep;
    }
    if (twice < dx) {
      error += dx;
      y += yStep;
    }
  }
}

/**
 * @param {Grid} grid
 * @param {WorkScan} scan
 * @param {Float64Array} angles
 * @param {number} zMax
 */
function updateFromScan(grid, { x, y, theta, ranges }, angles, zMax) {
  const [gx0, gy0] = grid.worldToGrid(x, y);
  for (let i = 0; i < angles.length; i++) {
    const heading = theta + angles[i];
    const z = Math.min(ranges[i], zMax);
    const [gx1, gy1] = grid.worldToGrid(
      x + z * Math.cos(heading),
      y + z * Math.sin(heading),
    );
    const cells = bresenham(gx0, gy0, gx1, gy1);
    const hit = z < zMax - 1e-12;
    for (const [gx, gy] of hit ? cells.slice(0, -1) : cells) {
      grid.updateCell(gx, gy, grid.lFree);
    }
    if (hit) grid.updateCell(gx1, gy1, grid.lOcc);
  }
}

const work = readWork(process.argv[2]);
let grid = new Grid(work);

await answerRequests(
  () => {
    grid = new Grid(work);
    for (const scan of work.scans) {
      updateFromScan(grid, scan, work.angles, work.maxRange);
    }
  },
  () => [
    `# logodds ${grid.width} ${grid.height}\n`,
    ...Array.from(grid.logOdds, (value) => `${value}\n`),
  ],
);
