/** Scenarios as text: written, and made of a log that has none of our parameters. */

import { ScenarioError } from "../../src/scenario.js";
import { flaserAngles } from "../../src/sensor.js";
import { Pose } from "../../src/world.js";

/** @typedef {import("./mistakenMapper.js").World} World */

/** The parameters' names in files. @type {Record<string, string>} */
const NAMES = {
  width: "width",
  height: "height",
  resolution: "resolution",
  originX: "origin_x",
  originY: "origin_y",
  maxRange: "max_range",
  minRange: "min_range",
  p0: "p0",
  pOcc: "p_occ",
  pFree: "p_free",
  lMin: "l_min",
  lMax: "l_max",
  noReturn: "no_return",
  fov: "fov",
  beams: "beams",
  noiseStd: "noise_std",
};

const MOST_ULPS = 4096;

/**
 * A scenario file (SPEC.md section 5) that reads back to the same numbers.
 *
 * @param {World} world
 * @returns {string}
 */
export function scenarioText({ settings, walls, scans }) {
  const lines = Object.entries(NAMES)
    // recorded ranges below it are NaN by now
    .filter(([key]) => key !== "minRange")
    .map(
      ([key, name]) => `PARAM occgrid_${name} ${Reflect.get(settings, key)}`,
    );
  for (const { x0, y0, x1, y1 } of walls) {
    lines.push(`WALL ${x0} ${y0} ${x1} ${y1}`);
  }
  for (const scan of scans) {
    if (scan instanceof Pose) {
      lines.push(`POSE ${scan.x} ${scan.y} ${scan.theta}`);
      continue;
    }
    lines.push(recordedLine(scan));
  }
  return `${lines.join("\n")}\n`;
}

/** @param {import("../../src/sensor.js").Scan} scan */
function recordedLine({ pose: { x, y, theta }, angles, ranges }) {
  const count = ranges.length;
  const read = Array.from(ranges, (range) =>
    range === Infinity ? "inf" : `${range}`,
  ).join(" ");
  const known = flaserAngles(count);
  if (angles.every((angle, i) => angle === known[i])) {
    return `FLASER ${count} ${read} ${x} ${y} ${theta} 0 0 0 0 0 0`;
  }
  const head = `ROBOTLASER1 0 ${angles[0]} 0 ${stepOf(angles)} 0 0 0`;
  return `${head} ${count} ${read} 0 ${x} ${y} ${theta} 0 0 0 0 0 0 0 0 0 0 0`;
}

/** The step by which angles[0] + i * step gives the same doubles again. @param {Float64Array} angles */
function stepOf(angles) {
  const [first, last] = [angles[0], angles[angles.length - 1]];
  const about = angles.length > 1 ? (last - first) / (angles.length - 1) : 0;
  const fits = (/** @type {number} */ step) =>
    angles.every((angle, i) => angle === first + i * step);
  for (let ulps = 0; ulps <= MOST_ULPS; ulps++) {
    for (const sign of [1, -1]) {
      const step = about * (1 + sign * ulps * 2 ** -53);
      if (fits(step)) return step;
    }
  }
  throw new RangeError("bearings that are not evenly spaced");
}

/**
 * Whether a log lacks what a scenario needs.
 *
 * @param {unknown} error
 */
export function lacksParameters(error) {
  return error instanceof ScenarioError && error.reason.endsWith("is missing");
}

/**
 * PARAM lines for a log of recorded scans: a grid around its poses of at most a quarter of a million cells.
 *
 * @param {string} text
 * @returns {string} empty where there is no scan to go by
 */
export function guessedParameters(text) {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  /** @type {number[]} */
  const ranges = [];
  for (const line of text.split("\n")) {
    const fields = line.trim().split(/[ \t]+/);
    let n = 0;
    let at = 0;
    let first = 0;
    if (fields[0] === "FLASER") {
      n = Number(fields[1]);
      first = 2;
      at = 2 + n;
    } else if (fields[0] === "ROBOTLASER1") {
      n = Number(fields[8]);
      first = 9;
      at = 10 + n + Number(fields[9 + n]);
    }
    const [x, y] = [Number(fields[at]), Number(fields[at + 1])];
    if (!(n > 0) || Number.isNaN(x + y)) continue;
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [low, high] = [Math.min(low, y), Math.max(high, y)];
    for (let i = first; i < first + n; i += 7) ranges.push(Number(fields[i]));
  }
  const real = ranges.filter((range) => range > 0 && range < 50);
  if (!(left <= right) || real.length === 0) return "";
  real.sort((a, b) => a - b);
  const reach = Math.ceil(real[Math.floor(0.98 * (real.length - 1))]) + 1;
  const [spanX, spanY] = [right - left + 2 * reach, high - low + 2 * reach];
  const resolution = [0.05, 0.1, 0.2, 0.25, 0.5, 1].find(
    (side) => (spanX / side) * (spanY / side) <= 250000,
  );
  const side = resolution ?? Math.sqrt((spanX * spanY) / 250000);
  return [
    `width ${Math.ceil(spanX / side)}`,
    `height ${Math.ceil(spanY / side)}`,
    `resolution ${side}`,
    `origin_x ${Math.floor(left - reach)}`,
    `origin_y ${Math.floor(low - reach)}`,
    `max_range ${reach}`,
    "no_return ignore",
  ]
    .map((line) => `PARAM occgrid_${line}\n`)
    .join("");
}
