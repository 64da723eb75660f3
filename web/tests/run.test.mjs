/** A run of the pages takes over what it can from the run before: whatever has changed, its bits are the port's. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { Run } from "../pages/model/run.js";
import {
  mapScenario,
  Scenario,
  Segment,
  Settings,
  simulatedScans,
} from "../src/index.js";
import { worldOf } from "./pageModel.mjs";

/** @typedef {import("../pages/model/mistakenMapper.js").World} World */

/** @param {Run} run */
function check({ world, seed, timeline, scans }) {
  const { settings, walls } = world;
  const scenario = new Scenario("", settings, walls, world.scans);
  const expected = Array.from(simulatedScans(scenario, seed));
  expected.forEach(({ ranges }, i) => {
    assert.deepEqual(scans.at(i).ranges, ranges);
  });
  const { logOdds } = mapScenario(scenario, seed);
  assert.deepEqual(timeline.at(expected.length), logOdds);
}

/** @param {World} world @param {Partial<Settings>} values @returns {World} */
function withSettings(world, values) {
  return {
    ...world,
    settings: new Settings({ ...world.settings, ...values }),
  };
}

for (const name of ["asymmetric", "flaser", "no-return-ignore", "outside"]) {
  test(`${name}: one change after the other`, () => {
    let world = worldOf(name);
    let run = new Run(world, 0);
    check(run);
    /** @type {[World, number | null][]} */
    const steps = [
      [{ ...world, walls: [...world.walls, new Segment(0, 0, 1, 1)] }, 0],
      [withSettings(world, { maxRange: world.settings.maxRange / 2 }), 0],
      [withSettings(world, { maxRange: 2 * world.settings.maxRange }), 0],
      [withSettings(world, { noiseStd: 0.3 }), 0],
      [withSettings(world, { pOcc: 0.9, lMin: -1 }), 0],
      [withSettings(world, { noReturn: "ignore" }), 0],
      [world, null],
      [world, 7],
      [withSettings(world, { beams: 31 }), 7],
      [withSettings(world, { beams: 31, fov: 1 }), 7],
      [withSettings(world, { width: 20, resolution: 0.3 }), 7],
      [{ ...world, scans: world.scans.slice(1) }, 7],
      [{ ...world, walls: world.walls.slice(1) }, 0],
    ];
    for (const [next, seed] of steps) {
      world = next;
      run = new Run(world, seed, run);
      check(run);
    }
  });
}

test("a timeline goes back and on, and stops on the way", () => {
  const world = worldOf("lesson");
  const { timeline } = new Run(world, 3);
  const fresh = (/** @type {number} */ scans) =>
    new Run(world, 3).timeline.at(scans);
  const count = world.scans.length;
  for (const scans of [50, 17, 16, 15, 100, 1, 0, 90]) {
    assert.deepEqual(timeline.at(scans), fresh(scans));
  }
  assert.equal(timeline.reach(count, 0), false);
  assert.equal(timeline.reach(count, Infinity), true);
  assert.deepEqual(timeline.at(count), fresh(count));
});
