// The scenarios that play.html saves read back to the same bits.

import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import { scenarioText } from "../pages/model/scenarioText.js";
import { memorySource, readScenario } from "../src/index.js";
import { fileSource } from "../src/node/fileSource.js";

const FOLDER = new URL("../../scenarios/", import.meta.url);

/** @param {import("../src/index.js").Scenario} scenario */
function worldOf(scenario) {
  const { settings, walls } = scenario;
  return { settings, walls, scans: Array.from(scenario.scans()) };
}

for (const file of readdirSync(FOLDER).filter((n) => n.endsWith(".log"))) {
  test(file, () => {
    const source = fileSource(new URL(file, FOLDER).pathname);
    const world = worldOf(readScenario(source));
    const text = scenarioText(world);
    const again = worldOf(readScenario(memorySource(file, text)));
    assert.deepEqual(again.walls, world.walls);
    assert.deepEqual(again.scans, world.scans);
    // shorter ranges are NaN by now
    const settings = { ...world.settings, minRange: 0 };
    assert.deepEqual({ ...again.settings }, settings);
  });
}
