/** What the tests of the pages' model have in common. */

import { readScenario } from "../src/index.js";
import { fileSource } from "../src/node/fileSource.js";

/** @typedef {import("../pages/model/mistakenMapper.js").World} World */

/** A scenario of the suite in memory. @param {string} name @returns {World} */
export function worldOf(name) {
  const path = new URL(`../../scenarios/${name}.log`, import.meta.url);
  const scenario = readScenario(fileSource(path.pathname));
  const scans = Array.from(scenario.scans());
  return { settings: scenario.settings, walls: scenario.walls, scans };
}

/** What work that is done step by step comes to. @template T @param {Generator<void, T>} steps @returns {T} */
export function ended(steps) {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
