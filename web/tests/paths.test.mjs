/** The plain program and the fast one, on random worlds: the same bits. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  bresenham,
  clipRay,
  GridSpec,
  mapScenario,
  mapScenarioFast,
  OccupancyGrid,
  Pose,
  philox4x32,
  Scan,
  Scenario,
  Segment,
  Settings,
  updateGridFromScan,
  updateGridFromScans,
} from "../src/index.js";
import { hexOf } from "./bits.mjs";

/** Numbers that are the same in every run. @param {number} world */
function random(world) {
  let count = 0;
  const next = () => philox4x32([world, count++, 0, 0], [17, 0])[0] / 2 ** 32;
  return {
    real: (/** @type {number} */ low, /** @type {number} */ high) =>
      low + (high - low) * next(),
    whole: (/** @type {number} */ low, /** @type {number} */ high) =>
      low + Math.floor((high - low + 1) * next()),
  };
}

/** @param {Float64Array} found @param {Float64Array} expected @param {string} place */
function sameBits(found, expected, place) {
  for (let i = 0; i < expected.length; i++) {
    if (!Object.is(found[i], expected[i])) {
      assert.fail(
        `${place}, cell ${i}: ${hexOf(found[i])}, expected ${hexOf(expected[i])}`,
      );
    }
  }
}

/** @param {number} world */
function randomScenario(world) {
  const { real, whole } = random(world);
  const signs = whole(0, 1) === 1;
  const resolution = [0.05, 0.1, 0.25, 0.3][whole(0, 3)];
  const offset = whole(0, 4) === 0 ? 1e7 - 100 : 0;
  const settings = new Settings({
    width: whole(1, 60),
    height: whole(1, 60),
    resolution,
    originX: offset - real(0, 4),
    originY: -offset - real(0, 4),
    maxRange: real(0.5, 9),
    minRange: 0.2,
    p0: real(0.2, 0.8),
    pOcc: signs ? real(0.1, 0.4) : real(0.6, 0.95),
    pFree: signs ? real(0.6, 0.9) : real(0.1, 0.45),
    lMin: -real(1.5, 4),
    lMax: real(1.5, 4),
    noReturn: whole(0, 1) === 0 ? "free" : "ignore",
    fov: real(0, 6.28),
    beams: whole(1, 40),
    noiseStd: real(0, 0.3),
  });
  const { maxRange } = settings;
  const ulp = maxRange * 2 ** -52;
  const walls = Array.from(
    { length: whole(0, 5) },
    () =>
      new Segment(
        offset + real(-6, 6),
        -offset + real(-6, 6),
        offset + real(-6, 6),
        -offset + real(-6, 6),
      ),
  );
  const scans = Array.from({ length: whole(1, 8) }, () => {
    // often outside the grid, now and then on a cell's edge
    const x = whole(0, 2) === 0 ? whole(-9, 9) * resolution : real(-7, 7);
    const pose = new Pose(offset + x, -offset + real(-7, 7), real(-7, 7));
    if (whole(0, 1) === 0) return pose;
    const n = whole(1, 30);
    const angles = new Float64Array(n).map(() => real(-4, 4));
    const special = [
      0,
      NaN,
      Infinity,
      maxRange,
      maxRange - 1e-12,
      maxRange - ulp,
      maxRange + ulp,
      1e-9,
      resolution,
    ];
    const ranges = new Float64Array(n).map(() => {
      const kind = whole(0, 2 * special.length);
      return kind < special.length ? special[kind] : real(0, 1.2 * maxRange);
    });
    return new Scan(pose, angles, ranges);
  });
  return new Scenario(`world ${world}`, settings, walls, scans);
}

test("mapScenario and mapScenarioFast give the same bits", () => {
  let touched = 0;
  for (let world = 0; world < 400; world++) {
    const scenario = randomScenario(world);
    for (const seed of [null, world]) {
      const plain = mapScenario(scenario, seed);
      const fast = mapScenarioFast(scenario, seed);
      sameBits(fast.logOdds, plain.logOdds, scenario.name);
      touched += plain.logOdds.filter((value) => value !== plain.l0).length;
    }
  }
  assert.ok(touched > 50000, `only ${touched} cells are touched`);
});

test("clipRay finds the steps whose cells lie in the grid", () => {
  const { whole } = random(1000);
  let inside = 0;
  for (let i = 0; i < 20000; i++) {
    const ends = Array.from({ length: 4 }, () => whole(-12, 20));
    const [gx0, gy0, gx1, gy1] = ends;
    const [width, height] = [whole(1, 9), whole(1, 9)];
    const grid = new OccupancyGrid(new GridSpec(width, height, 1, 0, 0));
    const steps = bresenham(gx0, gy0, gx1, gy1)
      .map(({ gx, gy }, k) => (grid.inBounds(gx, gy) ? k : -1))
      .filter((k) => k >= 0);
    const expected = steps.length
      ? { first: steps[0], last: steps[steps.length - 1] }
      : { first: 0, last: -1 };
    assert.deepEqual(
      clipRay(gx0, gy0, gx1, gy1, width, height),
      expected,
      `${ends}`,
    );
    inside += steps.length;
  }
  assert.ok(inside > 10000);
});

test("two grids at once do not touch each other", () => {
  const spec = new GridSpec(9, 9, 1, 0, 0);
  const [first, second] = [new OccupancyGrid(spec), new OccupancyGrid(spec)];
  const scan = new Scan(
    new Pose(0.5, 0.5, 0),
    Float64Array.of(0, 1),
    Float64Array.of(5, 20),
  );
  updateGridFromScan(first, scan, 8);
  assert.ok(second.logOdds.every((value) => value === 0));
  updateGridFromScans(second, [scan], 8);
  sameBits(second.logOdds, first.logOdds, "second");
  updateGridFromScans(second, [scan], 8);
  assert.equal(first.logOdds[5], first.lOcc);
  assert.equal(second.logOdds[5], first.lOcc + first.lOcc);
});

test("lines of more than 2^20 steps are refused on both paths", () => {
  const spec = new GridSpec(2, 2, 0.001, 0, 0);
  const scan = new Scan(
    new Pose(0, 0, 0),
    Float64Array.of(0),
    Float64Array.of(1100),
  );
  for (const update of [
    () => updateGridFromScan(new OccupancyGrid(spec), scan, 2000),
    () => updateGridFromScans(new OccupancyGrid(spec), [scan], 2000),
  ]) {
    assert.throws(update, {
      name: "RangeError",
      message: "a line of 1100000 steps",
    });
  }
  assert.equal(bresenham(0, 0, -(2 ** 20), 3).length, 2 ** 20 + 1);
});
