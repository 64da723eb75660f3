/** The bad scenarios that all ports refuse with the same line (scenarios/bad). */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { memorySource, readScenario, ScenarioError } from "../src/index.js";

const folder = new URL("../../scenarios/bad/", import.meta.url);
const expected = readFileSync(new URL("expected.txt", folder), "latin1")
  .trimEnd()
  .split("\n");

test("there are bad scenarios", () => {
  assert.ok(expected.length > 100);
});

for (const line of expected) {
  const name = line.slice(0, line.indexOf(":"));
  test(`refuses ${line}`, () => {
    const bytes = readFileSync(new URL(name, folder));
    assert.throws(
      () => Array.from(readScenario(memorySource(name, bytes)).scans()),
      (error) => error instanceof ScenarioError && error.message === line,
    );
  });
}
