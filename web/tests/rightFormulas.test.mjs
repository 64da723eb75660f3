/** Other formulas that are as right as the contract's: beams may end elsewhere with them, but only where rounding decides. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { wayOf } from "../pages/model/nearestFormulas.js";
import { RightEnds } from "../pages/model/rightEnds.js";
import {
  CHOICES,
  CONTRACT,
  FUNCTIONS,
  STEP_NAMES,
} from "../pages/model/rightFormulas.js";
import { beamsOfScan } from "../pages/model/rounding.js";
import { ended, worldOf } from "./pageModel.mjs";

/** @typedef {import("../pages/model/rightFormulas.js").Formulas} Formulas */

/** @param {string} name @param {boolean} ownPoses @param {(formulas: Formulas) => boolean} isFirst whether every beam must go its first way, the contract's */
function check(name, ownPoses, isFirst) {
  const world = worldOf(name);
  const beams = world.scans.flatMap((_, i) =>
    beamsOfScan(world, i, 0, ownPoses),
  );
  const ends = new RightEnds(world, 0, ownPoses);
  /** @param {Formulas} formulas */
  const checkWith = (formulas) => {
    const found = ended(ends.of(formulas));
    for (const one of beams) {
      const way =
        one.ways[isFirst(formulas) ? 0 : wayOf(one, found[one.scan])];
      if (!way.used) continue;
      const { gx0, gy0, gx1, gy1, hit } = found[one.scan];
      const cells = [gx0, gy0, gx1[one.beam], gy1[one.beam], hit[one.beam]];
      const same = [way.gx0, way.gy0, way.gx1, way.gy1, way.hit];
      if (same.every((value, i) => value === cells[i])) continue;
      assert.deepEqual(same, cells, JSON.stringify({ formulas, one }));
    }
  };
  for (const functions of Object.keys(FUNCTIONS)) {
    for (const step of STEP_NAMES) {
      for (const formula of CHOICES[step]) {
        checkWith({ ...CONTRACT, functions, [step]: formula });
      }
    }
  }
}

/** @param {Formulas} formulas */
function areContract(formulas) {
  return STEP_NAMES.every((step) => formulas[step] === CONTRACT[step]);
}

for (const name of ["lesson", "formats", "asymmetric", "mixed"]) {
  test(`${name}: every formula puts every beam on one of its ways`, () =>
    check(name, false, areContract));
}
test("and the poses of a program that computes them itself are within their bounds", () =>
  check("lesson", true, areContract));
