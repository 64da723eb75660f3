/** Settings that a reader changes: within the contract's limits, and on a grid that stays where it is. */

import { memorySource } from "../../src/lines.js";
import { readScenario, ScenarioError, Settings } from "../../src/scenario.js";
import { Pose } from "../../src/world.js";
import { scenarioText } from "./scenarioText.js";

/** So many cells a page can hold and draw; the suite's programs take more. */
export const MOST_CELLS = 4000000;

/**
 * Settings with other values. Another resolution keeps the grid's place in the world.
 *
 * @param {Settings} old
 * @param {Settings} opened those with the grid's own size: rounded sizes would drift from one resolution to the next
 * @param {Partial<Settings>} values
 * @returns {Settings}
 * @throws {RangeError} where a scenario could not have them, or a page could not draw the grid
 */
export function changedSettings(old, opened, values) {
  const resolution = values.resolution ?? old.resolution;
  const cells = (/** @type {number} */ count) =>
    Math.max(1, Math.round((count * opened.resolution) / resolution));
  const isMoved = resolution !== old.resolution && resolution > 0;
  const settings = new Settings({
    ...old,
    ...(isMoved
      ? { width: cells(opened.width), height: cells(opened.height) }
      : {}),
    ...values,
  });
  const { width, height } = settings;
  if (width * height > MOST_CELLS) {
    throw new RangeError(
      `${width} x ${height} cells are too many for this page`,
    );
  }
  const scans = [new Pose(0, 0, 0)];
  try {
    // the reader of scenarios knows all limits
    readScenario(
      memorySource("", scenarioText({ settings, walls: [], scans })),
    );
  } catch (error) {
    throw error instanceof ScenarioError
      ? new RangeError(error.reason)
      : error;
  }
  return settings;
}
