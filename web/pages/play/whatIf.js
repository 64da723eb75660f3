/** Mistakes as switches: the map that comes out, and the cells that differ. */

import { sigmoid } from "../../src/grid.js";
import { MISTAKES } from "../model/mistakes.js";
import { byId, element, input, make, setText } from "../shared/dom.js";
import { GreyLevels, GridCanvas, palette } from "../shared/gridCanvas.js";
import { counted, plural } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("./lab.js").Cell} Cell */
/** @typedef {import("../model/mistakenMapper.js").Picture} Picture */

export const SWITCHES = [
  "truncation",
  "off-by-one",
  "rows-and-columns-swapped",
  "y-flipped",
  "robot-outside-skipped",
  "heading-ignored",
  "bearings-clockwise",
  "last-bearing-missing",
  "max-range-occupied",
  "no-return-not-freed",
  "hit-also-free",
  "last-cell-missed",
  "ties-with-equality-in-x",
  "supercover",
  "prior-not-subtracted",
  "free-and-occupied-swapped",
  "no-clamp",
  "clamp-at-the-end",
  "once-per-scan",
  "pixel-half-even",
];

const GREY = palette();
/** Of cells that differ in the picture, and of those that differ in their log-odds alone. */
const SEEN = palette(0.7, [214, 48, 120]);
const UNSEEN = palette(0.7, [180, 120, 210]);

export class WhatIf {
  #grey = new GreyLevels();
  /** @type {Cell | null} */
  #cursor = null;
  #key = "";

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.place = element("what-if");
    /** Its maps are those of all scans. */
    this.whole = true;
    const canvas = /** @type {HTMLCanvasElement} */ (element("wrong-view"));
    const redraw = () => {
      this.#key = "";
      changed();
    };
    this.view = new GridCanvas(canvas, redraw);
    this.right = new GridCanvas(byId("right-view", HTMLCanvasElement), redraw);
    this.changed = changed;
    for (const name of SWITCHES) this.#addSwitch(name);
    const point = (/** @type {Cell | null} */ cell) => {
      this.#cursor = cell;
      this.#key = "";
      changed();
    };
    for (const name of /** @type {const} */ (["pointermove", "click"])) {
      // a finger that taps does not move
      canvas.addEventListener(name, (event) =>
        point(this.view.cellUnder(event)),
      );
    }
    this.view.takeKeys(
      () => this.#cursor,
      point,
      (cell) => {
        lab.cell = cell;
        changed();
      },
    );
    input("show-differences").addEventListener("change", () => {
      this.#key = "";
      changed();
    });
  }

  /** @param {string} name of a mistake */
  #addSwitch(name) {
    const { lab, changed } = this;
    const mistake = MISTAKES.get(name);
    if (!mistake) throw new Error(`no mistake ${name}`);
    const box = make("input", { type: "checkbox", "data-mistake": name });
    box.addEventListener("change", () => {
      if (box.checked) lab.mistakes.add(name);
      else lab.mistakes.delete(name);
      changed();
    });
    element("switches").append(
      make(
        "label",
        {},
        box,
        make("span", {}, mistake.title),
        make("small", {}, mistake.lesson),
      ),
    );
  }

  render() {
    const { lab } = this;
    const scheme = matchMedia("(prefers-color-scheme: dark)").matches;
    const key = [
      lab.version,
      lab.scan,
      lab.beam,
      lab.free === null,
      scheme,
      ...lab.mistakes,
    ].join(" ");
    if (key === this.#key) return;
    this.#key = key;
    for (const name of lab.mistakes) {
      // a link can ask for any mistake that the page knows
      if (!document.querySelector(`[data-mistake="${name}"]`))
        this.#addSwitch(name);
    }
    for (const box of document.querySelectorAll("[data-mistake]")) {
      const name = box.getAttribute("data-mistake") ?? "";
      /** @type {HTMLInputElement} */ (box).checked = lab.mistakes.has(name);
    }
    const { settings } = lab.world;
    const { scans, right, wrong } = lab.compared();
    const { width, height } = settings;
    const grey = this.#grey.of(right);
    const found = wrong?.picture ?? pictureOf(grey, width);
    const sameSize = found.width === width;
    const coloured = input("show-differences").checked;
    let inLogOdds = 0;
    let inPicture = 0;
    const values = sameSize ? wrong?.logOdds.values : undefined;
    this.view.begin(found);
    this.view.paintCells((image) => {
      const { pixels } = found;
      for (let i = 0; i < pixels.length; i++) {
        let colours = GREY;
        if (values) {
          const at =
            (height - 1 - Math.floor(i / width)) * width + (i % width);
          const other = values[at] !== right[at];
          const seen = pixels[i] !== grey[at];
          if (other) inLogOdds += 1;
          if (seen) inPicture += 1;
          if (coloured && seen) colours = SEEN;
          else if (coloured && other) colours = UNSEEN;
        }
        image[i] = colours[pixels[i]];
      }
    });
    if (this.#cursor) this.view.frame(this.#cursor, "#6d28d9");
    const after = `after ${plural(scans, "scan")}`;
    setText(
      element("difference-words"),
      lab.mistakes.size === 0
        ? "No mistake is switched on."
        : !sameSize
          ? `The picture has ${found.width} x ${found.height} pixels in place of ${width} x ${height}.`
          : `${counted(inPicture)} of ${counted(width * height)} cells differ in the picture ${after}, ${counted(inLogOdds)} in their log-odds.${inPicture + inLogOdds === 0 ? " Here nobody would notice." : ""}`,
    );
    this.right.begin(settings);
    this.right.paintCells((image) => {
      for (let gy = 0, i = 0; gy < height; gy++) {
        let out = (height - 1 - gy) * width;
        for (let gx = 0; gx < width; gx++) image[out++] = GREY[grey[i++]];
      }
    });
    if (this.#cursor) this.right.frame(this.#cursor, "#6d28d9");
    this.#readOut(right, found, wrong?.logOdds.values ?? right);
  }

  /** @param {Float64Array} right @param {Picture} picture @param {Float64Array} logOdds */
  #readOut(right, picture, logOdds) {
    const { width, height } = picture;
    const cell = this.#cursor;
    if (cell === null || width !== this.lab.world.settings.width) {
      setText(element("wrong-words"), "Point at a cell to read both values.");
      return;
    }
    const at = cell.gy * width + cell.gx;
    const value = logOdds[at];
    const level = picture.pixels[(height - 1 - cell.gy) * width + cell.gx];
    setText(
      element("wrong-words"),
      `cell gx=${cell.gx} gy=${cell.gy}: log-odds ${value}, pixel ${level}; right are ${right[at]} (P ${sigmoid(right[at]).toFixed(4)}) and ${this.#grey.of(right)[at]}.`,
    );
  }
}

/** Grey levels as a picture: the row with the largest y first. @param {Uint8Array} grey @param {number} width @returns {Picture} */
function pictureOf(grey, width) {
  const height = grey.length / width;
  const pixels = new Uint8Array(grey.length);
  for (let gy = 0; gy < height; gy++) {
    const row = grey.subarray(gy * width, (gy + 1) * width);
    pixels.set(row, (height - 1 - gy) * width);
  }
  return { width, height, pixels };
}
