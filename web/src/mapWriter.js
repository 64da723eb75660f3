/**
 * The files of a map: picture (PGM), its description (YAML), log-odds (SPEC.md section 7). Each is text that comes line
 * by line, for a grid may have 25 million cells.
 *
 * Differs from the other ports: writeMap, which needs a folder to write into, stands in node/writeMap.js.
 */

import { logit, sigmoid } from "./grid.js";

/** @typedef {import("./grid.js").OccupancyGrid} OccupancyGrid */

// [snippet: pixel]
/**
 * Grey value of a cell: 0 is occupied, 255 is free.
 *
 * @param {number} logOdds the cell's log-odds
 * @returns {number} 0 to 255
 */
export function pixel(logOdds) {
  const free = 1 - sigmoid(logOdds);
  return Math.floor(free * 255 + 0.5);
}
// [/snippet]

// [snippet: map-pgm]
/**
 * The map as an ASCII PGM (P2), the row with the largest y first.
 *
 * @param {OccupancyGrid} grid the map
 * @returns {Generator<string>} its lines, with their ends
 */
export function* mapPgm(grid) {
  const { width, height } = grid.spec;
  yield `P2\n${width} ${height}\n255\n`;
  for (let gy = height - 1; gy >= 0; gy--) {
    const row = grid.logOdds.subarray(gy * width, (gy + 1) * width);
    yield `${Array.from(row, pixel).join(" ")}\n`;
  }
}
// [/snippet]

/**
 * The description that map_server and Nav2 read beside the picture. Its thresholds follow the prior, so that a cell that
 * nothing touched loads as unknown.
 *
 * @param {OccupancyGrid} grid the map
 * @param {string} image the picture's file name, a character for each byte
 * @returns {string}
 */
export function mapYaml(grid, image) {
  const { resolution, originX, originY } = grid.spec;
  const grey = 255 - pixel(grid.l0);
  const occupied = sigmoid(grid.l0 + logit(0.65));
  const free = sigmoid(grid.l0 + logit(0.196));
  const occupiedThresh = Math.min(Math.max(occupied, (grey + 0.5) / 255), 1);
  const freeThresh = Math.max(Math.min(free, (grey - 0.5) / 255), 0);
  return [
    `image: ${quoted(image)}`,
    "mode: trinary",
    `resolution: ${fixed(resolution)}`,
    `origin: [${fixed(originX)}, ${fixed(originY)}, 0.0]`,
    "negate: 0",
    `occupied_thresh: ${fixed(occupiedThresh)}`,
    `free_thresh: ${fixed(freeThresh)}`,
    "",
  ].join("\n");
}

/**
 * The log-odds as text that reads back to the same doubles, the row with the smallest y first.
 *
 * @param {OccupancyGrid} grid the map
 * @returns {Generator<string>} its lines, with their ends
 */
export function* mapLogOdds(grid) {
  const { width, height } = grid.spec;
  yield `# logodds ${width} ${height}\n`;
  for (let gy = 0; gy < height; gy++) {
    const row = grid.logOdds.subarray(gy * width, (gy + 1) * width);
    yield `${Array.from(row, decimal).join(" ")}\n`;
  }
}

/** The shortest decimal that reads back to the same double. @param {number} value */
function decimal(value) {
  return Object.is(value, -0) ? "-0" : String(value);
}

/** A YAML scalar. @param {string} name a character for each byte */
function quoted(name) {
  if (/^[A-Za-z0-9_][A-Za-z0-9_.-]*$/.test(name)) return name;
  const escaped = name
    .replace(/["\\]/g, "\\$&")
    // biome-ignore lint/suspicious/noControlCharactersInRegex: these are what YAML cannot have
    .replace(/[\x00-\x1f\x7f]/g, (character) => {
      const digits = character.charCodeAt(0).toString(16).toUpperCase();
      return `\\x${digits.padStart(2, "0")}`;
    });
  return `"${escaped}"`;
}

/**
 * The exact value rounded to nine decimals, ties to even, without zeros at the end but for the first decimal.
 *
 * @param {number} value below 1e21
 * @returns {string}
 */
export function fixed(value) {
  const magnitude = Math.abs(value);
  let text = magnitude.toFixed(9); // of the exact value, but ties go up
  const halves = magnitude * 1024;
  const tie = Number.isInteger(halves) && halves % 2 === 1;
  if (tie && Number(text.slice(-1)) % 2 === 1) {
    // a tie has ten decimals, the last of them 5: cut that off
    text = magnitude.toFixed(10).slice(0, -1);
  }
  text = text.replace(/0+$/, "").replace(/\.$/, ".0");
  return value < 0 && text !== "0.0" ? `-${text}` : text;
}
