/** What the JavaScript programs of the benchmark share: the work, and the answers to its requests (see cpp/driver.hpp). */

import { readFileSync, writeFileSync } from "node:fs";
import { createInterface } from "node:readline";

/** @typedef {{x: number, y: number, theta: number, ranges: Float64Array}} WorkScan metres, radians */

/**
 * Poses and ranges that every contestant maps; metres, radians.
 *
 * @typedef {object} Work
 * @property {number} width
 * @property {number} height
 * @property {number} resolution
 * @property {number} originX
 * @property {number} originY
 * @property {number} maxRange
 * @property {Float64Array} angles
 * @property {WorkScan[]} scans
 */

/** @param {string} file @returns {Work} */
export function readWork(file) {
  const lines = readFileSync(file, "ascii").trimEnd().split("\n");
  const numbers = (/** @type {string} */ line) =>
    Float64Array.from(line.split(" "), Number);
  const [width, height, resolution, originX, originY, maxRange] = numbers(
    lines[0],
  );
  const scans = lines.slice(2).map((line) => {
    const [x, y, theta, ...ranges] = numbers(line);
    return { x, y, theta, ranges: Float64Array.from(ranges) };
  });
  return {
    width,
    height,
    resolution,
    originX,
    originY,
    maxRange,
    angles: numbers(lines[1]),
    scans,
  };
}

/**
 * Answers requests until the input ends.
 *
 * @param {() => void} map maps the work into a grid of its own
 * @param {() => Iterable<string>} write the lines of what it mapped last
 */
export async function answerRequests(map, write) {
  for await (const line of createInterface({ input: process.stdin })) {
    const [verb, argument] = line.split(" ");
    if (verb === "map") {
      const seconds = [];
      for (let i = 0; i < Number(argument); i++) {
        const start = performance.now();
        map();
        seconds.push((performance.now() - start) / 1000);
      }
      console.log(seconds.join(" "));
    } else {
      writeFileSync(argument, Array.from(write()).join(""));
      console.log("written");
    }
  }
}
