/**
 * Whether a map is that of right formulas without one scan, or without one beam of every scan. Rounding may explain such
 * a map, too, if many beams may be turned one by one. What is left out explains it more simply.
 */

import { NO_WAY } from "./chosenWays.js";

/** @typedef {{what: "scan" | "beam", number: number}} Gap a scan, or a beam of every scan; counted from 0 */

/**
 * @param {import("./nearestFormulas.js").NearestFormulas} nearest
 * @returns {Generator<void, Gap | null>} null where nothing of this kind gives all cells
 */
export function* leftOut(nearest) {
  const { beams } = nearest.ways;
  for (const what of /** @type {const} */ (["scan", "beam"])) {
    const numbers = new Set(beams.map((beam) => beam[what]));
    for (const number of Array.from(numbers).sort((a, b) => a - b)) {
      yield;
      const chosen = nearest.chosen.map((way, at) =>
        beams[at][what] === number ? NO_WAY : way,
      );
      // most choices leave one of the open cells wrong, which is quickly seen
      const open = yield* nearest.misfits(nearest.open, chosen);
      if (open.length > 0) continue;
      const wrong = yield* nearest.misfits(nearest.touched, chosen);
      if (wrong.length === 0) return { what, number };
    }
  }
  return null;
}
