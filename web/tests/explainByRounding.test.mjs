/** Programs with other formulas that are as right as the contract's are right; those that leave out a scan are not. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { explainByRounding } from "../pages/model/explainByRounding.js";
import { bresenham } from "../src/index.js";
import { pixel } from "../src/mapWriter.js";
import { newGrid } from "../src/scenario.js";
import { ended, worldOf } from "./pageModel.mjs";

const { cos, sin, floor, min } = Math;
const LESSON = worldOf("lesson");

/** The lesson's program as somebody else writes it; what another one does in another way can be exchanged. */
const PROGRAM = {
  headings: () =>
    Array.from({ length: 120 }, (_, t) => (2 * Math.PI * t) / 120),
  bearings: () =>
    Array.from({ length: 181 }, (_, i) => (Math.PI * i) / 180 - Math.PI / 2),
  /** @type {(heading: number, bearing: number) => [number, number]} */
  seen: (heading, bearing) => [cos(heading + bearing), sin(heading + bearing)],
  /** @type {(heading: number, bearing: number) => [number, number]} */
  drawn: (heading, bearing) => [
    cos(heading + bearing),
    sin(heading + bearing),
  ],
  /** Whether a beam is mapped. @type {(scan: number, beam: number) => boolean} */
  mapped: () => true,
};

/** @param {Partial<typeof PROGRAM>} other @returns {Uint16Array} the rows from the bottom */
function drawn(other) {
  const program = { ...PROGRAM, ...other };
  const grid = newGrid(LESSON.settings);
  const cell = (/** @type {number} */ x, /** @type {number} */ y) => ({
    gx: floor((x + 11) / 0.1),
    gy: floor((y + 9) / 0.1),
  });
  for (const [scan, angle] of program.headings().entries()) {
    const [x, y] = [-6 + 6 * cos(angle), 4 * sin(angle)];
    const heading = angle + Math.PI / 2;
    const from = cell(x, y);
    for (const [beam, bearing] of program.bearings().entries()) {
      if (!program.mapped(scan, beam)) continue;
      const z = min(distance(x, y, program.seen(heading, bearing)), 10);
      const [dx, dy] = program.drawn(heading, bearing);
      const to = cell(x + z * dx, y + z * dy);
      const cells = bresenham(from.gx, from.gy, to.gx, to.gy);
      const last = cells.length - 1;
      cells.forEach(({ gx, gy }, k) => {
        const hit = k === last && z < 10 - 1e-12;
        grid.updateCell(gx, gy, hit ? grid.lOcc : grid.lFree);
      });
    }
  }
  return Uint16Array.from(grid.logOdds, (l) => pixel(l));
}

/** To the nearest wall. @param {number} x @param {number} y @param {[number, number]} ray */
function distance(x, y, [dx, dy]) {
  let nearest = Infinity;
  for (const { x0, y0, x1, y1 } of LESSON.walls) {
    const [sx, sy] = [x1 - x0, y1 - y0];
    const across = dx * sy - dy * sx;
    if (Math.abs(across) < 1e-12) continue;
    const t = ((x0 - x) * sy - (y0 - y) * sx) / across;
    const u = ((x0 - x) * dy - (y0 - y) * dx) / across;
    if (t >= 0 && u >= 0 && u <= 1) nearest = min(nearest, t);
  }
  return nearest;
}

/** @param {Partial<typeof PROGRAM>} program */
function explained(program) {
  return ended(explainByRounding(LESSON, null, drawn(program), true));
}

/** @type {(heading: number, bearing: number) => [number, number]} */
const rotated = (heading, bearing) => {
  const [c, s] = [cos(heading), sin(heading)];
  const [x, y] = [cos(bearing), sin(bearing)];
  return [c * x - s * y, s * x + c * y];
};
/** @type {(heading: number, bearing: number) => [number, number]} */
const wrapped = (heading, bearing) => {
  const angle = (heading + bearing) % (2 * Math.PI);
  return [cos(angle), sin(angle)];
};
/** @param {number} step @param {number} count @param {number} first */
function sums(step, count, first) {
  const found = [];
  for (let angle = first; found.length < count; angle += step) {
    found.push(angle);
  }
  return found;
}
const headings = () => sums((2 * Math.PI) / 120, 120, 0);
const bearings = () => sums(Math.PI / 180, 181, -Math.PI / 2);

/** @type {[string, Partial<typeof PROGRAM>, string[]][]} */
const RIGHT = [
  [
    "headings added up",
    { headings },
    ["the robot's angle on the ellipse: added up"],
  ],
  ["bearings added up", { bearings }, ["bearings: added up"]],
  [
    "beams turned by a rotation matrix",
    { drawn: rotated },
    ["directions of beams on the map: a rotation matrix"],
  ],
  [
    "angles modulo 2 pi",
    { seen: wrapped, drawn: wrapped },
    [
      "directions of beams on the map: the remainder of heading + bearing by 2 pi",
    ],
  ],
  [
    "headings added up and a rotation matrix",
    { headings, drawn: rotated },
    [
      "the robot's angle on the ellipse: added up",
      "directions of beams on the map: a rotation matrix",
    ],
  ],
];

for (const [name, program, named] of RIGHT) {
  test(`right, and named: ${name}`, () => {
    const { kind, formulas, turned } = explained(program);
    assert.equal(kind, "edges");
    for (const formula of named)
      assert.ok(formulas.includes(formula), formulas.join("; "));
    assert.ok(turned.length > 0);
  });
}

for (const number of [0, 10, 50, 105]) {
  test(`not right: scan ${number} is missing`, () => {
    const mapped = (/** @type {number} */ scan) => scan !== number;
    const { kind, gap } = explained({ mapped });
    assert.equal(kind, "no choice");
    assert.deepEqual(gap, { what: "scan", number });
  });
}

for (const number of [0, 90, 180]) {
  test(`not right: beam ${number} of every scan is missing`, () => {
    /** @param {number} _ @param {number} beam */
    const mapped = (_, beam) => beam !== number;
    const { kind, gap } = explained({ headings, mapped });
    // without the first beam, some cells are untouched that rounding cannot spare
    assert.equal(kind, number === 0 ? "mistake" : "no choice");
    assert.deepEqual(gap, number === 0 ? null : { what: "beam", number });
  });
}
