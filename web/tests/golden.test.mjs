/** Every scenario against its golden results: after every scan, on both paths. */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import {
  lessonScenario,
  mapPgm,
  mapScenario,
  mapScenarioFast,
  newGrid,
  readScenario,
  simulatedScans,
  updateGridFromScan,
  updateGridFromScans,
} from "../src/index.js";
import { fileSource } from "../src/node/fileSource.js";
import { hashOf } from "./bits.mjs";

const folder = new URL("../../scenarios/", import.meta.url);
const names = readdirSync(folder)
  .filter((name) => name.endsWith(".log"))
  .map((name) => name.slice(0, -4));

/** @param {string} name */
function scenarioOf(name) {
  return readScenario(
    fileSource(fileURLToPath(new URL(`${name}.log`, folder))),
  );
}

/** @param {string} name */
function golden(name) {
  return readFileSync(new URL(`golden/${name}`, folder), "ascii");
}

/** @param {import("../src/index.js").Scenario} scenario @param {string} name */
function holds(scenario, name) {
  for (const [mode, seed] of /** @type {[string, number | null][]} */ ([
    ["noise-free", null],
    ["seed-0", 0],
  ])) {
    const expected = golden(`${name}.${mode}.sha256`)
      .trimEnd()
      .split("\n")
      .map((line) => line.split(" ")[2]);
    const { settings } = scenario;
    const plain = newGrid(settings);
    const fast = newGrid(settings);
    let number = 0;
    for (const scan of simulatedScans(scenario, seed)) {
      updateGridFromScan(plain, scan, settings.maxRange, settings.noReturn);
      updateGridFromScans(fast, [scan], settings.maxRange, settings.noReturn);
      const place = `${name}, ${mode}, scan ${number}`;
      assert.equal(hashOf(plain.logOdds), expected[number], `${place}, plain`);
      assert.equal(hashOf(fast.logOdds), expected[number], `${place}, fast`);
      number += 1;
    }
    assert.equal(number, expected.length);
    // the scenario again, from its first scan
    for (const map of [mapScenario, mapScenarioFast]) {
      const grid = map(scenario, seed);
      assert.equal(hashOf(grid.logOdds), expected[number - 1], map.name);
      assert.equal(
        Array.from(mapPgm(grid)).join(""),
        golden(`${name}.${mode}.pgm`),
      );
    }
  }
}

test("there are scenarios", () => {
  assert.ok(names.length >= 10);
});

for (const name of names) {
  test(`${name}: the golden results`, () => holds(scenarioOf(name), name));
}

test("the built-in lesson: the golden results", () => {
  holds(lessonScenario(), "lesson");
});
