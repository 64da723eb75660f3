/** The grid of log-odds (lesson sections 1 and 3). */

import { exp, log } from "./portableMath.js";

// [snippet: grid-spec]
/** Where the cells lie in the world (lesson section 1). */
export class GridSpec {
  /**
   * @param {number} width number of columns
   * @param {number} height number of rows
   * @param {number} resolution side of a cell, metres
   * @param {number} originX world x of the lower left corner, metres
   * @param {number} originY world y of the lower left corner, metres
   */
  constructor(width, height, resolution, originX, originY) {
    this.width = width;
    this.height = height;
    this.resolution = resolution;
    this.originX = originX;
    this.originY = originY;
    Object.freeze(this);
  }
}
// [/snippet]

// [snippet: logit]
/**
 * Log-odds of a probability, which is kept within [1e-9, 1 - 1e-9].
 *
 * @param {number} p a probability
 * @returns {number} log(p / (1 - p))
 */
export function logit(p) {
  const q = Math.min(Math.max(p, 1e-9), 1 - 1e-9);
  return log(q / (1 - q));
}
// [/snippet]

// [snippet: sigmoid]
/**
 * Probability of log-odds; no overflow at either end.
 *
 * @param {number} logOdds any double
 * @returns {number} 1 / (1 + exp(-logOdds))
 */
export function sigmoid(logOdds) {
  const z = exp(-Math.abs(logOdds));
  return (logOdds >= 0 ? 1 : z) / (1 + z);
}
// [/snippet]

/**
 * Log-odds of every cell, and what an update adds (lesson section 3). Each
 * grid owns its cells.
 */
export class OccupancyGrid {
  /**
   * A grid where nothing is known yet: every cell has the prior's log-odds.
   *
   * @param {GridSpec} spec where the cells lie
   * @param {number} p0 prior probability of occupancy
   * @param {number} pOcc probability that the model gives to a hit cell
   * @param {number} pFree probability that the model gives to a passed cell
   * @param {number} lMin lower bound of a cell's log-odds
   * @param {number} lMax upper bound of a cell's log-odds
   * @throws {RangeError} if the size is not one of a grid, or if logit(p0) does not lie within [lMin, lMax]
   */
  constructor(spec, p0 = 0.5, pOcc = 0.75, pFree = 0.3, lMin = -8, lMax = 8) {
    if (!(isSize(spec.width) && isSize(spec.height))) {
      throw new RangeError(`a grid of ${spec.width} x ${spec.height} cells`);
    }
    /** @readonly */
    this.spec = spec;
    /** @readonly log-odds of the prior */
    this.l0 = logit(p0);
    /** @readonly log-odds of the model where a beam hit */
    this.lOcc = logit(pOcc);
    /** @readonly log-odds of the model where a beam passed */
    this.lFree = logit(pFree);
    /** @readonly */
    this.lMin = lMin;
    /** @readonly */
    this.lMax = lMax;
    if (!(lMin <= this.l0 && this.l0 <= lMax)) {
      throw new RangeError(`logit(${p0}) is not from ${lMin} to ${lMax}`);
    }
    /**
     * (height * width) log-odds, cell (gx, gy) at gy * width + gx: the row with the smallest y comes first.
     *
     * @readonly
     */
    this.logOdds = new Float64Array(spec.width * spec.height).fill(this.l0);
  }

  // [snippet: world-to-grid]
  /**
   * The cell of a point; it may lie outside the grid.
   *
   * @param {number} x metres
   * @param {number} y metres
   * @returns {{gx: number, gy: number}}
   */
  worldToGrid(x, y) {
    const gx = Math.floor((x - this.spec.originX) / this.spec.resolution);
    const gy = Math.floor((y - this.spec.originY) / this.spec.resolution);
    return { gx, gy };
  }

  /**
   * The centre of a cell.
   *
   * @param {number} gx column
   * @param {number} gy row
   * @returns {{x: number, y: number}} metres
   */
  gridToWorldCenter(gx, gy) {
    const x = this.spec.originX + (gx + 0.5) * this.spec.resolution;
    const y = this.spec.originY + (gy + 0.5) * this.spec.resolution;
    return { x, y };
  }

  /**
   * Whether a cell lies in the grid.
   *
   * @param {number} gx column
   * @param {number} gy row
   * @returns {boolean}
   */
  inBounds(gx, gy) {
    const { width, height } = this.spec;
    return 0 <= gx && gx < width && 0 <= gy && gy < height;
  }
  // [/snippet]

  // [snippet: update-cell]
  /**
   * Adds the evidence lUpdate - l0 to one cell and clamps it. A cell
   * outside the grid is skipped.
   *
   * @param {number} gx column
   * @param {number} gy row
   * @param {number} lUpdate log-odds of the inverse sensor model
   */
  updateCell(gx, gy, lUpdate) {
    if (this.inBounds(gx, gy)) {
      const cell = gy * this.spec.width + gx;
      const value = this.logOdds[cell] + (lUpdate - this.l0);
      this.logOdds[cell] = Math.min(Math.max(value, this.lMin), this.lMax);
    }
  }
  // [/snippet]

  // [snippet: probability-grid]
  /**
   * P(occupied) of every cell.
   *
   * @returns {Float64Array} (height * width), in the order of the log-odds
   */
  probabilityGrid() {
    return this.logOdds.map(sigmoid);
  }
  // [/snippet]
}

/** @param {number} n @returns {boolean} */
function isSize(n) {
  return Number.isInteger(n) && n > 0;
}
