/** The page's state in its address, so that a link can open it where a text needs it. */

import { lessonSettings } from "../../src/lesson.js";
import { MISTAKES } from "../model/mistakes.js";
import { SLIDERS } from "./settingsPanel.js";

/** @typedef {import("./lab.js").Lab} Lab */

/** @param {string} text @param {number} count @returns {number[] | null} */
function wholes(text, count) {
  const numbers = text.split(",").map(Number);
  return numbers.length === count && numbers.every(Number.isSafeInteger)
    ? numbers
    : null;
}

/**
 * Takes the address in; what it does not say stays.
 *
 * @param {Lab} lab
 * @param {string} hash
 * @returns {string | null} the section that it is about
 */
export function readAddress(lab, hash) {
  const asked = new URLSearchParams(hash.replace(/^#/, ""));
  if (!hash.includes("=")) return null;
  let section = "world";
  const settings = SLIDERS.filter(({ id }) => asked.has(id)).map(
    ({ id, key }) => [key, Number(asked.get(id))],
  );
  if (settings.length > 0) {
    try {
      lab.set(Object.fromEntries(settings));
    } catch {
      // not a possible grid: the page stays as it is
    }
  }
  if (asked.get("noise") === "free") lab.setSeed(null);
  const seed = asked.get("seed");
  if (seed !== null && /^[0-9]{1,10}$/.test(seed) && Number(seed) < 2 ** 32) {
    lab.setSeed(Number(seed));
  }
  const scan = wholes(asked.get("scan") ?? "", 1);
  const beam = wholes(asked.get("beam") ?? "", 1);
  if (asked.has("scan") && scan)
    lab.goTo(scan[0], asked.has("beam") && beam ? beam[0] : undefined);
  else if (asked.has("beam") && beam) lab.goTo(lab.scan, beam[0]);
  if (asked.has("beam")) lab.line = null;
  const names = (asked.get("mistake") ?? "").split(",");
  const mistakes = names.filter((name) => MISTAKES.has(name));
  if (mistakes.length > 0) {
    lab.mistakes = new Set(mistakes);
    section = "what-if";
  }
  const cell = wholes(asked.get("cell") ?? "", 2);
  const { width, height } = lab.world.settings;
  if (
    cell &&
    cell[0] >= 0 &&
    cell[0] < width &&
    cell[1] >= 0 &&
    cell[1] < height
  ) {
    lab.cell = { gx: cell[0], gy: cell[1] };
    section = "cell";
  }
  const line = wholes(asked.get("line") ?? "", 4);
  if (
    line &&
    Math.max(Math.abs(line[2] - line[0]), Math.abs(line[3] - line[1])) <= 5000
  ) {
    lab.line = [line[0], line[1], line[2], line[3]];
    lab.step = 0;
    section = "line";
  }
  const step = wholes(asked.get("step") ?? "", 1);
  if (asked.has("step") && step) {
    lab.step = Math.max(step[0], 0);
    section = "line";
  }
  return section;
}

/**
 * The address of the state at hand, as short as it can be.
 *
 * @param {Lab} lab
 * @param {Set<string>} touched what the reader has had a hand on
 * @returns {string}
 */
export function addressOf(lab, touched) {
  const parts = [`scan=${lab.scan}`];
  if (lab.beam !== lab.beams) parts.push(`beam=${lab.beam}`);
  if (lab.seed === null) parts.push("noise=free");
  else if (lab.seed !== 0) parts.push(`seed=${lab.seed}`);
  const lesson = lessonSettings();
  for (const { id, key } of SLIDERS) {
    const value = lab.world.settings[key];
    if (value !== lesson[key]) parts.push(`${id}=${value}`);
  }
  if (lab.mistakes.size)
    parts.push(`mistake=${Array.from(lab.mistakes).join()}`);
  if (touched.has("cell")) parts.push(`cell=${lab.cell.gx},${lab.cell.gy}`);
  if (lab.line) parts.push(`line=${lab.line.join()}`);
  if (lab.step > 0) parts.push(`step=${lab.step}`);
  return `#${parts.join("&")}`;
}
