/** Reading a scenario: a CARMEN log with PARAM, WALL and POSE lines (SPEC.md sections 5 and 8). */

import { GridSpec, logit, OccupancyGrid } from "./grid.js";
import { readLines } from "./lines.js";
import { PI } from "./portableMath.js";
import { flaserAngles, Scan } from "./sensor.js";
import { Pose, Segment } from "./world.js";

/** @typedef {import("./sensor.js").NoReturn} NoReturn */
/** @typedef {import("./lines.js").Source} Source */

const MAX_CELLS = 25000000;
const MAX_RANGE_CELLS = 1000000;

/** What the PARAM lines set: metres, radians, probabilities, log-odds; the table of SPEC.md section 5.2. */
export class Settings {
  /**
   * @param {{width: number, height: number, resolution: number, originX: number, originY: number, maxRange: number,
   *   minRange?: number, p0?: number, pOcc?: number, pFree?: number, lMin?: number, lMax?: number,
   *   noReturn?: NoReturn, fov?: number, beams?: number, noiseStd?: number}} values
   */
  constructor(values) {
    this.width = values.width;
    this.height = values.height;
    this.resolution = values.resolution;
    this.originX = values.originX;
    this.originY = values.originY;
    this.maxRange = values.maxRange;
    this.minRange = values.minRange ?? 0;
    this.p0 = values.p0 ?? 0.5;
    this.pOcc = values.pOcc ?? 0.75;
    this.pFree = values.pFree ?? 0.3;
    this.lMin = values.lMin ?? -8;
    this.lMax = values.lMax ?? 8;
    this.noReturn = values.noReturn ?? "free";
    this.fov = values.fov ?? PI;
    this.beams = values.beams ?? 181;
    this.noiseStd = values.noiseStd ?? 0.02;
    Object.freeze(this);
  }
}

/**
 * An empty map.
 *
 * @param {Settings} settings
 * @returns {OccupancyGrid}
 */
export function newGrid(settings) {
  const { width, height, resolution, originX, originY } = settings;
  const spec = new GridSpec(width, height, resolution, originX, originY);
  const { p0, pOcc, pFree, lMin, lMax } = settings;
  return new OccupancyGrid(spec, p0, pOcc, pFree, lMin, lMax);
}

/** Settings, walls and scans. It can be mapped any number of times. */
export class Scenario {
  #scans;

  /**
   * @param {string} name
   * @param {Settings} settings
   * @param {Segment[]} walls
   * @param {(Pose | Scan)[] | (() => Iterable<Pose | Scan>)} scans a list, or a function that starts with the first
   *   scan whenever it is called
   */
  constructor(name, settings, walls, scans) {
    this.name = name;
    this.settings = settings;
    this.walls = walls;
    this.#scans = scans;
  }

  /**
   * The scans from the first one on, read as they are asked for: a Pose for a simulated one, a Scan for a recorded one.
   *
   * @returns {Iterable<Pose | Scan>}
   * @throws {ScenarioError} on the way, at a line that breaks a rule; and where a file cannot be read a second time
   */
  scans() {
    return typeof this.#scans === "function" ? this.#scans() : this.#scans;
  }
}

/** A scenario that breaks a rule; its message is `FILE:LINE: REASON`. */
export class ScenarioError extends Error {
  /**
   * @param {string} file
   * @param {number} line from 1; 0 where no line was read
   * @param {string} reason
   */
  constructor(file, line, reason) {
    super(`${printable(file)}:${line}: ${reason}`);
    this.name = "ScenarioError";
    this.line = line;
    this.reason = reason;
  }
}

/**
 * A path as it stands in a message of one line.
 *
 * @param {string} path
 * @returns {string}
 */
export function printable(path) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: these are what is replaced
  return path.replace(/[\x00-\x1f\x7f]/g, "?");
}

/**
 * A scenario's name: its file name without the part from its last dot on.
 *
 * @param {string} path
 * @returns {string}
 */
export function scenarioName(path) {
  const fileName = path.replace(/\/+$/, "").replace(/^.*\//s, "");
  const dot = fileName.lastIndexOf(".");
  return dot > 0 ? fileName.slice(0, dot) : fileName;
}

/**
 * Opens a scenario and reads it up to its first scan.
 *
 * Differs from the other ports: it takes a source of bytes and not a path, because a browser has no paths.
 *
 * @param {Source} source
 * @returns {Scenario}
 * @throws {ScenarioError} for what is wrong before the first scan; the rest is checked when the scans are read
 */
export function readScenario(source) {
  const first = new Reader(source, 0, 0);
  const start = first.readSettings();
  /** @type {Reader | null} */
  let unused = first;
  return new Scenario(
    scenarioName(source.name),
    start.settings,
    start.walls,
    () => {
      const reader = unused ?? new Reader(source, start.offset, start.line);
      unused = null;
      return reader.readScans(start.settings.minRange);
    },
  );
}

/** @typedef {{name: string, kind: "whole" | "real" | "probability" | "noReturn", low?: string, high?: string}} Row */

/** @type {Record<string, Row>} the table of SPEC.md section 5.2; limits as they are printed */
const PARAMETERS = {
  width: { name: "width", kind: "whole", low: "1", high: "25000000" },
  height: { name: "height", kind: "whole", low: "1", high: "25000000" },
  resolution: { name: "resolution", kind: "real", low: "0.001", high: "1000" },
  origin_x: {
    name: "originX",
    kind: "real",
    low: "-10000000",
    high: "10000000",
  },
  origin_y: {
    name: "originY",
    kind: "real",
    low: "-10000000",
    high: "10000000",
  },
  max_range: { name: "maxRange", kind: "real", low: "0.001", high: "10000" },
  min_range: { name: "minRange", kind: "real", low: "0", high: "10000" },
  p0: { name: "p0", kind: "probability" },
  p_occ: { name: "pOcc", kind: "probability" },
  p_free: { name: "pFree", kind: "probability" },
  l_min: { name: "lMin", kind: "real", low: "-1000", high: "1000" },
  l_max: { name: "lMax", kind: "real", low: "-1000", high: "1000" },
  no_return: { name: "noReturn", kind: "noReturn" },
  fov: { name: "fov", kind: "real", low: "0", high: "6.283185307179586" },
  beams: { name: "beams", kind: "whole", low: "1", high: "100000" },
  noise_std: { name: "noiseStd", kind: "real", low: "0", high: "1000" },
};
const REQUIRED = [
  "width",
  "height",
  "resolution",
  "origin_x",
  "origin_y",
  "max_range",
];
const SCAN_KEYWORDS = ["POSE", "FLASER", "ROBOTLASER1"];

/** Goes through a source line by line; `line` is the number of the last one read. */
class Reader {
  /**
   * @param {Source} source
   * @param {number} offset the byte to start at
   * @param {number} line the lines before it
   */
  constructor(source, offset, line) {
    this.file = source.name;
    this.line = line;
    this.offset = offset;
    this.fields = this.#fields(source, offset);
  }

  /**
   * @param {string} reason
   * @param {number} [line]
   * @returns {never}
   */
  fail(reason, line = this.line) {
    throw new ScenarioError(this.file, line, reason);
  }

  /**
   * Fields of the lines that are neither blank nor comments. `offset` is where the line begins.
   *
   * @param {Source} source
   * @param {number} start
   * @returns {Generator<string[]>}
   */
  *#fields(source, start) {
    const lines = readLines(source, start);
    for (;;) {
      let next;
      try {
        next = lines.next();
      } catch {
        this.fail("cannot be read");
      }
      if (next.done) return;
      this.line += 1;
      this.offset = next.value.offset;
      const text = next.value.text.replace(/^[ \t]+|[ \t]+$/g, "");
      if (text === "" || text.startsWith("#")) continue;
      if (/[^\t\x20-\x7e]/.test(text)) this.fail("not plain ASCII text");
      const fields = text.split(/[ \t]+/);
      if (!/^[A-Za-z_][A-Za-z0-9_]*$/.test(fields[0])) {
        this.fail(`'${fields[0]}' is not a keyword`);
      }
      yield fields;
    }
  }

  /**
   * The settings and walls, up to the first scan.
   *
   * @returns {{settings: Settings, walls: Segment[], offset: number, line: number}} offset and line say where the
   *   first scan's line begins
   */
  readSettings() {
    /** @type {Map<string, {value: number | string, line: number}>} */
    const given = new Map();
    /** @type {Segment[]} */
    const walls = [];
    // not for-of: that would end the generator, which reads on after the first scan
    for (
      let next = this.fields.next();
      !next.done;
      next = this.fields.next()
    ) {
      const [keyword, ...values] = next.value;
      if (SCAN_KEYWORDS.includes(keyword)) {
        const settings = this.#settings(given);
        this.first = next.value;
        return { settings, walls, offset: this.offset, line: this.line - 1 };
      }
      if (isParameter(keyword, values)) {
        this.#parameter(withoutComment(values), given);
      } else if (keyword === "WALL") {
        const numbers = this.#expect("WALL", 4, withoutComment(values));
        const [x0, y0, x1, y1] = ["x0", "y0", "x1", "y1"].map((field, i) =>
          this.#coordinate(field, numbers[i]),
        );
        walls.push(new Segment(x0, y0, x1, y1));
      }
    }
    this.fail("no scan");
  }

  /**
   * The scans.
   *
   * @param {number} minRange
   * @returns {Generator<Pose | Scan>}
   */
  *readScans(minRange) {
    if (this.first !== undefined) yield this.#scan(this.first, minRange);
    for (const fields of this.fields) {
      const [keyword, ...values] = fields;
      if (SCAN_KEYWORDS.includes(keyword)) {
        yield this.#scan(fields, minRange);
      } else if (keyword === "WALL" || isParameter(keyword, values)) {
        this.fail(`${keyword} must stand before the first scan`);
      }
    }
  }

  /**
   * @param {string[]} fields
   * @param {number} minRange
   */
  #scan([keyword, ...values], minRange) {
    if (keyword === "POSE") {
      return this.#pose(this.#expect("POSE", 3, withoutComment(values)));
    }
    return keyword === "FLASER"
      ? this.#flaser(values, minRange)
      : this.#robotlaser1(values, minRange);
  }

  // --- PARAM ---

  /**
   * @param {string[]} values
   * @param {Map<string, {value: number | string, line: number}>} given
   */
  #parameter(values, given) {
    const [field, token] = this.#expect("PARAM", 2, values);
    const name = field.slice("occgrid_".length);
    const row = Object.hasOwn(PARAMETERS, name) ? PARAMETERS[name] : undefined;
    if (row === undefined) this.fail(`unknown parameter ${field}`);
    if (given.has(name)) this.fail(`${field} is given twice`);
    given.set(name, {
      value: this.#parameterValue(row, field, token),
      line: this.line,
    });
  }

  /**
   * @param {Row} row
   * @param {string} field
   * @param {string} token
   */
  #parameterValue(row, field, token) {
    const { kind, low = "", high = "" } = row;
    if (kind === "noReturn") {
      if (token !== "free" && token !== "ignore") {
        this.fail(`${field} '${token}' is not free or ignore`);
      }
      return token;
    }
    if (kind === "whole") return this.#whole(field, token, low, high);
    if (kind === "real") return this.#real(field, token, low, high);
    const p = this.#number(field, token);
    if (!(p > 0 && p < 1)) {
      this.fail(`${field} '${token}' is not between 0 and 1`);
    }
    return p;
  }

  /**
   * The parameters as a whole, at the first scan.
   *
   * @param {Map<string, {value: number | string, line: number}>} given
   */
  #settings(given) {
    for (const name of REQUIRED) {
      if (!given.has(name)) this.fail(`occgrid_${name} is missing`);
    }
    const values = Object.fromEntries(
      Array.from(given, ([name, { value }]) => [PARAMETERS[name].name, value]),
    );
    const s = new Settings(
      /** @type {ConstructorParameters<typeof Settings>[0]} */ (values),
    );
    const latest = (/** @type {string[]} */ ...names) =>
      Math.max(...names.map((name) => given.get(name)?.line ?? 0));
    const rule = (
      /** @type {boolean} */ holds,
      /** @type {string} */ reason,
      /** @type {string[]} */ ...names
    ) => {
      if (!holds) this.fail(reason, latest(...names));
    };
    rule(
      s.width * s.height <= MAX_CELLS,
      `the grid has more than ${MAX_CELLS} cells`,
      "width",
      "height",
    );
    rule(
      s.maxRange / s.resolution <= MAX_RANGE_CELLS,
      `occgrid_max_range is more than ${MAX_RANGE_CELLS} cells`,
      "max_range",
      "resolution",
    );
    rule(
      s.lMin < s.lMax,
      "occgrid_l_min is not below occgrid_l_max",
      "l_min",
      "l_max",
    );
    const l0 = logit(s.p0);
    rule(
      s.lMin <= l0 && l0 <= s.lMax,
      "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
      "p0",
      "l_min",
      "l_max",
    );
    rule(
      s.minRange < s.maxRange,
      "occgrid_min_range is not below occgrid_max_range",
      "min_range",
      "max_range",
    );
    return s;
  }

  // --- scans ---

  /** @param {string[]} values x, y, theta, and whatever follows */
  #pose(values) {
    const x = this.#coordinate("x", values[0]);
    const y = this.#coordinate("y", values[1]);
    return new Pose(x, y, this.#angle("theta", values[2]));
  }

  /**
   * @param {string[]} values
   * @param {number} minRange
   */
  #flaser(values, minRange) {
    if (values.length < 1) this.fail("FLASER has no beam count");
    const n = this.#whole("beam count", values[0], "1", "100000");
    if (values.length !== n + 10) {
      this.fail(
        `FLASER with ${n} beams takes ${n + 10} values, found ${values.length}`,
      );
    }
    const ranges = this.#ranges(values, 1, n, minRange);
    const pose = this.#pose(values.slice(n + 1));
    return new Scan(pose, flaserAngles(n), ranges);
  }

  /**
   * @param {string[]} values
   * @param {number} minRange
   */
  #robotlaser1(values, minRange) {
    const found = values.length;
    if (found < 8) this.fail("ROBOTLASER1 has no beam count");
    const n = this.#whole("beam count", values[7], "1", "100000");
    if (found < n + 23) {
      this.fail(
        `ROBOTLASER1 with ${n} beams takes at least ${n + 23} values, found ${found}`,
      );
    }
    const m = this.#whole("remission count", values[8 + n], "0", "100000");
    if (found !== n + m + 23) {
      this.fail(
        `ROBOTLASER1 with ${n} beams and ${m} remissions takes ${n + m + 23} values, found ${found}`,
      );
    }
    const start = this.#angle("start", values[1]);
    const step = this.#angle("step", values[3]);
    const ranges = this.#ranges(values, 8, n, minRange);
    const pose = this.#pose(values.slice(9 + n + m));
    const angles = new Float64Array(n).map((_, i) => start + i * step);
    return new Scan(pose, angles, ranges);
  }

  /**
   * Ranges; NaN where a beam is to be ignored, because it is NaN or below minRange.
   *
   * @param {string[]} values
   * @param {number} from
   * @param {number} n
   * @param {number} minRange
   */
  #ranges(values, from, n, minRange) {
    const ranges = new Float64Array(n);
    for (let i = 0; i < n; i++) {
      const token = values[from + i];
      const range = parseNumber(token);
      if (range === null) this.fail(`range ${i} '${token}' is not a number`);
      if (range < 0) this.fail(`range ${i} '${token}' is negative`);
      ranges[i] = range < minRange ? NaN : range;
    }
    return ranges;
  }

  // --- values ---

  /**
   * @param {string} keyword
   * @param {number} count
   * @param {string[]} values
   */
  #expect(keyword, count, values) {
    if (values.length !== count) {
      this.fail(`${keyword} takes ${count} values, found ${values.length}`);
    }
    return values;
  }

  /** @param {string} field @param {string} token */
  #number(field, token) {
    const value = parseNumber(token);
    if (value === null) this.fail(`${field} '${token}' is not a number`);
    return value;
  }

  /** @param {string} field @param {string} token @param {string} low @param {string} high */
  #real(field, token, low, high) {
    const value = this.#number(field, token);
    return this.#within(value, field, token, low, high);
  }

  /** @param {string} field @param {string} token @param {string} low @param {string} high */
  #whole(field, token, low, high) {
    if (!/^[0-9]+$/.test(token)) {
      this.fail(`${field} '${token}' is not a whole number`);
    }
    return this.#within(Number(token), field, token, low, high);
  }

  /** @param {number} value @param {string} field @param {string} token @param {string} low @param {string} high */
  #within(value, field, token, low, high) {
    if (!(Number(low) <= value && value <= Number(high))) {
      this.fail(`${field} '${token}' is not from ${low} to ${high}`);
    }
    return value;
  }

  /** @param {string} field @param {string} token */
  #coordinate(field, token) {
    return this.#real(field, token, "-10000000", "10000000");
  }

  /** @param {string} field @param {string} token */
  #angle(field, token) {
    return this.#real(field, token, "-1000000", "1000000");
  }
}

/** Whether a line is a PARAM line of ours. @param {string} keyword @param {string[]} values */
function isParameter(keyword, values) {
  return (
    keyword === "PARAM" &&
    values.length > 0 &&
    values[0].startsWith("occgrid_")
  );
}

/** @param {string[]} values */
function withoutComment(values) {
  const comment = values.findIndex((value) => value.startsWith("#"));
  return comment < 0 ? values : values.slice(0, comment);
}

/**
 * A number of SPEC.md section 5.1. `Number` rounds a decimal correctly, but it takes other texts, too.
 *
 * @param {string} token
 * @returns {number | null} null where it is none
 */
export function parseNumber(token) {
  if (/^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$/.test(token)) {
    const value = Number(token);
    if (Math.abs(value) >= 1e300) return value < 0 ? -Infinity : Infinity;
    return Math.abs(value) < 1e-300 ? 0 : value;
  }
  const word = /^([+-]?)(nan|inf|infinity)$/i.exec(token);
  if (word === null) return null;
  if (word[2].toLowerCase() === "nan") return NaN;
  return word[1] === "-" ? -Infinity : Infinity;
}
