/** The mapping loop: scan after scan into the grid (the lesson's first flow chart). */

import { addRangeNoise } from "./noise.js";
import { newGrid } from "./scenario.js";
import { beamAngles, Scan, updateGridFromScan } from "./sensor.js";
import { Pose, simulateLidarScan } from "./world.js";

/** @typedef {import("./grid.js").OccupancyGrid} OccupancyGrid */
/** @typedef {import("./scenario.js").Scenario} Scenario */

// [snippet: map-scenario]
/**
 * Maps all scans of a scenario. A bare pose is simulated, with noise.
 *
 * @param {Scenario} scenario the scenario
 * @param {number | null} seed the noise's seed; null: free of noise
 * @returns {OccupancyGrid}
 * @throws {import("./scenario.js").ScenarioError} if a scan breaks a rule
 */
export function mapScenario(scenario, seed) {
  const { maxRange, noReturn } = scenario.settings;
  const grid = newGrid(scenario.settings);
  for (const scan of simulatedScans(scenario, seed)) {
    updateGridFromScan(grid, scan, maxRange, noReturn);
  }
  return grid;
}

/**
 * The scans of a scenario, in order, with ranges for all.
 *
 * @param {Scenario} scenario the scenario
 * @param {number | null} seed the noise's seed; null: free of noise
 * @returns {Generator<Scan>}
 */
export function* simulatedScans(scenario, seed) {
  const { maxRange, fov, beams, noiseStd } = scenario.settings;
  const angles = beamAngles(fov, beams);
  let number = 0;
  for (const next of scenario.scans()) {
    let scan = next;
    if (scan instanceof Pose) {
      const { walls } = scenario;
      let ranges = simulateLidarScan(scan, walls, angles, maxRange);
      if (seed !== null) {
        ranges = addRangeNoise(ranges, noiseStd, seed, number, maxRange);
      }
      scan = new Scan(scan, angles, ranges);
    }
    yield scan;
    number++;
  }
}
// [/snippet]
