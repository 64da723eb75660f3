/** The shared vectors: exact answers that every port gives (scenarios/vectors). */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { FUNCTIONS } from "./probe.mjs";

const folder = new URL("../../scenarios/vectors/", import.meta.url);
const files = readdirSync(folder).filter((name) => name.endsWith(".csv"));

/** How many of a function's columns are its arguments. @type {Record<string, number>} */
const INPUTS = {
  world_to_grid: 5,
  bresenham: 4,
  clip_ray: 6,
  flaser_angles: 2,
  read_ranges: 3,
  beam_endpoints: 5,
  update_cell: 6,
  philox: 6,
  normal_deviate: 3,
};

test("every function of the probe has its vectors", () => {
  assert.deepEqual(
    files.map((name) => name.replace(".csv", "")).sort(),
    Object.keys(FUNCTIONS).sort(),
  );
});

for (const file of files) {
  const name = file.replace(".csv", "");
  test(`vectors of ${name}`, () => {
    const [header, ...rows] = readFileSync(new URL(file, folder), "ascii")
      .trimEnd()
      .split("\n");
    const inputs = INPUTS[name] ?? 1;
    assert.ok(rows.length > 10 && header.split(",").length > inputs);
    for (const row of rows) {
      const fields = row.split(",");
      const found = FUNCTIONS[name](...fields.slice(0, inputs));
      assert.equal(found.join(" "), fields.slice(inputs).join(" "), row);
    }
  });
}
