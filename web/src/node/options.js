/** The command line's arguments, read from left to right (SPEC.md section 6). */

import { printable, scenarioName } from "../scenario.js";

/** The version of this port. */
export const VERSION = "1.0.0";

export const USAGE = `usage: occgrid [--noise-free | --seed N] [--plain] [--out DIR] [SCENARIO...]

Map range scans into an occupancy grid. Without a scenario: the built-in lesson.

  --noise-free  simulate ranges without noise
  --seed N      seed of the noise, 0 to 4294967295 (default: 0)
  --plain       map with the program as the handouts print it
  --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds there
                (without it: the picture on standard output)
  --version     the version
  --help        this text
`;

const MAX_SEED = 4294967295;

/** A wrong command line. */
export class UsageError extends Error {}

/**
 * @typedef {object} Options
 * @property {string} text the answer to --help or --version; empty without
 * @property {number | null} seed null: free of noise
 * @property {boolean} plain
 * @property {string | null} out
 * @property {string[]} scenarios
 */

/**
 * @param {string[]} given the arguments, a character for each byte
 * @returns {Options}
 * @throws {UsageError}
 */
export function parseOptions(given) {
  /** @type {Options} */
  const options = {
    text: "",
    seed: 0,
    plain: false,
    out: null,
    scenarios: [],
  };
  let noiseFree = false;
  let seeded = false;
  for (let i = 0; i < given.length; i++) {
    const argument = given[i];
    const value = () => {
      i += 1;
      if (i >= given.length || given[i] === "" || given[i].startsWith("--")) {
        throw new UsageError(`${argument} needs a value`);
      }
      return given[i];
    };
    if (argument === "--help") {
      options.text = USAGE;
      return options;
    } else if (argument === "--version") {
      options.text = `occgrid ${VERSION} (Node.js ${process.versions.node})\n`;
      return options;
    } else if (argument === "--noise-free") {
      noiseFree = true;
    } else if (argument === "--seed") {
      seeded = true;
      options.seed = seedOf(value());
    } else if (argument === "--plain") {
      options.plain = true;
    } else if (argument === "--out") {
      options.out = value();
    } else if (argument.startsWith("-")) {
      throw new UsageError(`unknown option ${argument}`);
    } else {
      options.scenarios.push(argument);
    }
  }
  if (noiseFree && seeded) {
    throw new UsageError("--noise-free and --seed exclude each other");
  }
  if (noiseFree) options.seed = null;
  if (options.scenarios.length > 1 && options.out === null) {
    throw new UsageError("several scenarios need --out");
  }
  const names = options.scenarios.map((path) => scenarioName(path));
  const twin = names.find((name, i) => names.indexOf(name) !== i);
  if (twin !== undefined) {
    throw new UsageError(`two scenarios are named ${twin}`);
  }
  return options;
}

/** @param {UsageError} error @returns {string} the reason and the usage */
export function usageText(error) {
  return `occgrid: ${printable(error.message)}\n${USAGE}`;
}

/** @param {string} text */
function seedOf(text) {
  if (!/^[0-9]+$/.test(text) || Number(text) > MAX_SEED) {
    throw new UsageError(
      `--seed needs a whole number from 0 to ${MAX_SEED}, not '${text}'`,
    );
  }
  return Number(text);
}
