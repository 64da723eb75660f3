/** A file held against the right map of a scenario, which is given as text: a worker gets it as a message. */

import { memorySource } from "../../src/lines.js";
import { readScenario } from "../../src/scenario.js";
import { judge } from "./verdict.js";

/**
 * @typedef {object} Job
 * @property {import("../model/compareMaps.js").Found} found
 * @property {string} name of the scenario
 * @property {string} text
 * @property {number | null} seed null: without noise
 */

/** @param {Job} job */
export function judgeFile({ found, name, text, seed }) {
  // who has the lesson built in need not read its poses from the file
  return judge(found, worldOf(name, text), seed, name === "lesson");
}

/** @param {string} name @param {string} text */
export function worldOf(name, text) {
  const scenario = readScenario(memorySource(`${name}.log`, text));
  const scans = Array.from(scenario.scans());
  return { settings: scenario.settings, walls: scenario.walls, scans };
}
