/** The page's state in its address, so that a link can open it where a text needs it. */

import { lineIsShown } from "../model/lineTrace.js";
import { MISTAKES } from "../model/mistakes.js";
import { SLIDERS } from "./settingsPanel.js";

/** @typedef {import("./lab.js").Lab} Lab */

/** @param {string | null} text @param {number} count @returns {number[] | null} */
function wholes(text, count) {
  const parts = text?.split(",") ?? [];
  return parts.length === count &&
    parts.every((part) => /^-?[0-9]{1,9}$/.test(part))
    ? parts.map(Number)
    : null;
}

/**
 * Takes the address in. What it does not say is as the world was opened, so that a link always shows the same, and the
 * browser's way back undoes what the way here has done; walls and a file are no part of it.
 *
 * @param {Lab} lab
 * @param {string} hash
 * @param {(error: unknown) => void} refuse gets what is wrong with the settings that are asked for
 * @returns {string | null} the section that it is about
 */
export function readAddress(lab, hash, refuse) {
  if (!hash.includes("=")) return null;
  const asked = new URLSearchParams(hash.replace(/^#/, ""));
  let section = "world";

  const { settings } = lab.opened;
  try {
    const values = SLIDERS.map(({ id, key }) => {
      const text = asked.get(id);
      return [key, text === null ? settings[key] : Number(text.trim() || NaN)];
    });
    const noReturn = asked.get("no_return") ?? settings.noReturn;
    if (noReturn !== "free" && noReturn !== "ignore") {
      throw new RangeError("no_return must be free or ignore");
    }
    lab.set({ ...Object.fromEntries(values), noReturn });
  } catch (error) {
    refuse(error); // the page stays as it is
  }

  const seed = asked.get("seed");
  if (seed !== null && /^[0-9]{1,10}$/.test(seed) && Number(seed) < 2 ** 32) {
    lab.setSeed(Number(seed));
  } else {
    lab.setSeed(asked.get("noise") === "free" ? null : 0);
  }

  const scan = wholes(asked.get("scan"), 1);
  const beam = wholes(asked.get("beam"), 1);
  lab.free = null;
  lab.goTo(scan?.[0] ?? lab.opened.scan, beam?.[0]);

  const names = (asked.get("mistake") ?? "").split(",");
  lab.mistakes = new Set(names.filter((name) => MISTAKES.has(name)));
  if (lab.mistakes.size > 0) section = "what-if";

  const cell = wholes(asked.get("cell"), 2);
  const { width, height } = lab.world.settings;
  const isCell =
    cell !== null &&
    cell[0] >= 0 &&
    cell[0] < width &&
    cell[1] >= 0 &&
    cell[1] < height;
  if (isCell) section = "cell";
  lab.cell = isCell ? { gx: cell[0], gy: cell[1] } : lab.startCell;

  const line = wholes(asked.get("line"), 4);
  lab.line = null;
  if (line !== null && lineIsShown(line)) {
    lab.line = [line[0], line[1], line[2], line[3]];
    section = "line";
  }
  const step = wholes(asked.get("step"), 1);
  lab.step = Math.max(step?.[0] ?? 0, 0);
  if (step !== null) section = "line";
  return section;
}

/**
 * The address of the state at hand, as short as it can be.
 *
 * @param {Lab} lab
 * @returns {string}
 */
export function addressOf(lab) {
  const { opened, cell, startCell } = lab;
  const { settings } = lab.world;
  const parts = [`scan=${lab.scan}`];
  if (lab.beam !== lab.beams) parts.push(`beam=${lab.beam}`);
  if (lab.seed === null) parts.push("noise=free");
  else if (lab.seed !== 0) parts.push(`seed=${lab.seed}`);
  for (const { id, key } of SLIDERS) {
    const value = settings[key];
    if (value !== opened.settings[key]) parts.push(`${id}=${value}`);
  }
  if (settings.noReturn !== opened.settings.noReturn)
    parts.push(`no_return=${settings.noReturn}`);
  if (lab.mistakes.size)
    parts.push(`mistake=${Array.from(lab.mistakes).join()}`);
  if (cell.gx !== startCell.gx || cell.gy !== startCell.gy)
    parts.push(`cell=${cell.gx},${cell.gy}`);
  if (lab.line) parts.push(`line=${lab.line.join()}`);
  if (lab.step > 0) parts.push(`step=${lab.step}`);
  return `#${parts.join("&")}`;
}
