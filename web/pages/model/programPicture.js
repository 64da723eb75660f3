/** The picture of a program: which log-odds can be behind each of its pixels. */

import { sigmoid } from "../../src/grid.js";

const U = 2 ** -52;

export class ProgramPicture {
  /** @param {ArrayLike<number>} pixels row 0 at the bottom @param {number} beams how many, each an update of a cell at the most */
  constructor(pixels, beams) {
    this.pixels = pixels;
    this.blur = 255 * (16 + 2 * beams) * U;
  }

  /** Whether the pixel is one of the two levels that rounding can make of these log-odds. @param {number} cell @param {number} logOdds */
  fits(cell, logOdds) {
    const grey = (1 - sigmoid(logOdds)) * 255 + 0.5;
    const level = this.pixels[cell];
    return (
      level === Math.floor(grey - this.blur) ||
      level === Math.floor(grey + this.blur)
    );
  }

  /** How far the pixel is from these log-odds; 0 where it fits. @param {number} cell @param {number} logOdds */
  off(cell, logOdds) {
    if (this.fits(cell, logOdds)) return 0;
    const grey = (1 - sigmoid(logOdds)) * 255;
    return Math.max(Math.abs(grey - this.pixels[cell]), 1e-6);
  }

  /** Whether the pixel is the contract's of these log-odds. @param {number} cell @param {number} logOdds */
  equals(cell, logOdds) {
    const level = Math.floor((1 - sigmoid(logOdds)) * 255 + 0.5);
    return level === this.pixels[cell];
  }
}
