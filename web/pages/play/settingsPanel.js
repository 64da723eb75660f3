/** Sliders for the sensor, the inverse model and the grid; presets; noise. */

import { lessonSettings } from "../../src/lesson.js";
import { byId, element, input, make, setText } from "../shared/dom.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("../../src/scenario.js").Settings} Settings */

/** @type {{id: string, key: keyof Settings, label: string, min: number, max: number, step: number, unit?: string}[]} */
export const SLIDERS = [
  {
    id: "p_occ",
    key: "pOcc",
    label: "p_occ, of a cell that was hit",
    min: 0.01,
    max: 0.99,
    step: 0.01,
  },
  {
    id: "p_free",
    key: "pFree",
    label: "p_free, of a cell that was passed",
    min: 0.01,
    max: 0.99,
    step: 0.01,
  },
  {
    id: "p0",
    key: "p0",
    label: "p0, the prior",
    min: 0.05,
    max: 0.95,
    step: 0.01,
  },
  {
    id: "l_min",
    key: "lMin",
    label: "l_min, the lower bound",
    min: -20,
    max: -0.25,
    step: 0.25,
  },
  {
    id: "l_max",
    key: "lMax",
    label: "l_max, the upper bound",
    min: 0.25,
    max: 20,
    step: 0.25,
  },
  {
    id: "resolution",
    key: "resolution",
    label: "side of a cell",
    min: 0.05,
    max: 1,
    step: 0.05,
    unit: " m",
  },
  {
    id: "max_range",
    key: "maxRange",
    label: "range of the sensor",
    min: 1,
    max: 30,
    step: 0.5,
    unit: " m",
  },
  {
    id: "noise_std",
    key: "noiseStd",
    label: "noise of a range",
    min: 0,
    max: 0.5,
    step: 0.01,
    unit: " m",
  },
];

/** @type {Record<string, Partial<Settings>>} */
const PRESETS = {
  weak: { p0: 0.5, pOcc: 0.6, pFree: 0.4 },
  strong: { p0: 0.5, pOcc: 0.9, pFree: 0.1 },
};

/** What the page says of settings that it refuses. @param {unknown} error */
export function notPossible(error) {
  return `Not possible: ${error instanceof Error ? error.message : error}.`;
}

export class SettingsPanel {
  #key = -1;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.changed = changed;
    this.place = element("settings");
    element("sliders").append(
      ...SLIDERS.map(({ id, label, min, max, step }) =>
        make(
          "label",
          {},
          label,
          make("output", { id: `${id}-value` }),
          make("input", { id, type: "range", min, max, step }),
        ),
      ),
    );
    for (const { id, key } of SLIDERS) {
      input(id).addEventListener("input", () =>
        this.apply({ [key]: input(id).valueAsNumber }),
      );
    }
    for (const preset of document.querySelectorAll("[data-preset]")) {
      preset.addEventListener("click", () => {
        const name = preset.getAttribute("data-preset") ?? "";
        if (name in PRESETS) {
          this.apply(PRESETS[name]);
          return;
        }
        const lesson = lessonSettings();
        const keys = SLIDERS.map(({ key }) => [key, lesson[key]]);
        lab.setSeed(0);
        this.apply({ ...Object.fromEntries(keys), noReturn: "free" });
      });
    }
    const isSeed = (/** @type {number} */ n) =>
      Number.isInteger(n) && n >= 0 && n < 2 ** 32;
    const noise = () => {
      const seed = input("seed").valueAsNumber;
      setText(
        element("settings-words"),
        isSeed(seed) ? "" : "A seed is a whole number from 0 to 4294967295.",
      );
      if (!isSeed(seed)) return;
      lab.setSeed(input("noise-free").checked ? null : seed);
      changed();
    };
    input("noise-free").addEventListener("change", () => {
      if (!isSeed(input("seed").valueAsNumber)) input("seed").value = "0";
      noise();
    });
    input("seed").addEventListener("input", noise);
    const noReturn = byId("no-return", HTMLSelectElement);
    noReturn.addEventListener("change", () =>
      this.apply({
        noReturn: noReturn.value === "ignore" ? "ignore" : "free",
      }),
    );
  }

  /** @param {Partial<Settings>} values */
  apply(values) {
    const words = element("settings-words");
    try {
      this.lab.set(values);
      setText(words, "");
    } catch (error) {
      this.#key = -1; // the slider goes back
      setText(words, notPossible(error));
    }
    this.changed();
  }

  render() {
    if (this.#key === this.lab.version) return;
    this.#key = this.lab.version;
    const { settings } = this.lab.world;
    for (const { id, key, min, max, unit = "" } of SLIDERS) {
      const value = Number(settings[key]);
      const slider = input(id);
      // values from a file may lie beyond a slider's ends
      slider.min = `${Math.min(value, min)}`;
      slider.max = `${Math.max(value, max)}`;
      slider.value = `${value}`;
      setText(
        element(`${id}-value`),
        `${`${value}`.replace("-", "\u2212")}${unit}`,
      );
    }
    input("noise-free").checked = this.lab.seed === null;
    if (this.lab.seed !== null) input("seed").value = `${this.lab.seed}`;
    input("seed").disabled = this.lab.seed === null;
    byId("no-return", HTMLSelectElement).value = settings.noReturn;
  }
}
