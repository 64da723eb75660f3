/** One beam through Bresenham's loop: the cells, the variables, and the line of code that has just run. */

import { LISTING, lineIsShown, traceLine } from "../model/lineTrace.js";
import {
  button,
  byId,
  element,
  input,
  make,
  ShownWidth,
  setText,
} from "../shared/dom.js";
import { plural } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("../model/lineTrace.js").Stop} Stop */

const ENDS = ["gx0", "gy0", "gx1", "gy1"];
const WIDTH = 520;
const HEIGHT_OVER_WIDTH = 400 / 520;
const LEAST_CELL = 17;

export class LineFigure {
  #key = "";
  #moment = "";
  /** @type {ReturnType<typeof traceLine>} */
  #trace = traceLine(0, 0, 0, 0);
  #timer = 0;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.changed = changed;
    this.place = element("line");
    this.shown = new ShownWidth(byId("line-view", SVGSVGElement), changed);
    element("listing").append(
      ...LISTING.map((line) => {
        const comment = /^\s*(\/\*\*|\*)/.test(line);
        return make("li", comment ? { class: "comment" } : {}, line || " ");
      }),
    );
    for (const id of ENDS) {
      input(id).addEventListener("change", () => {
        const numbers = ENDS.map((end) =>
          Math.trunc(input(end).valueAsNumber),
        );
        const [gx0, gy0, gx1, gy1] = numbers;
        if (lineIsShown(numbers)) {
          lab.line = [gx0, gy0, gx1, gy1];
          lab.step = 0;
        }
        this.#key = ""; // the fields show the line that there is
        changed();
      });
    }
    button("line-of-beam").addEventListener("click", () => {
      lab.line = null;
      lab.step = 0;
      changed();
    });
    const go = (/** @type {(step: number) => number} */ to) => () => {
      this.stop();
      this.go(to(lab.step));
    };
    button("line-start").addEventListener(
      "click",
      go(() => 0),
    );
    button("line-back").addEventListener(
      "click",
      go((step) => step - 1),
    );
    button("line-on").addEventListener(
      "click",
      go((step) => step + 1),
    );
    button("cell-on").addEventListener(
      "click",
      go((step) => this.#nextCell(step)),
    );
    input("line-step").addEventListener(
      "input",
      go(() => input("line-step").valueAsNumber),
    );
    button("line-play").addEventListener("click", () => {
      if (this.#timer) {
        this.stop();
      } else {
        if (lab.step >= this.#last) lab.step = 0;
        this.#timer = window.setInterval(() => {
          if (lab.step >= this.#last) this.stop();
          else this.go(lab.step + 1);
        }, 450);
      }
      changed();
    });
  }

  stop() {
    window.clearInterval(this.#timer);
    this.#timer = 0;
    this.changed();
  }

  get #last() {
    return this.#trace.stops.length - 1;
  }

  /** @param {number} step */
  go(step) {
    this.lab.step = Math.min(Math.max(step, 0), this.#last);
    this.changed();
  }

  /** @param {number} step */
  #nextCell(step) {
    const { stops } = this.#trace;
    const next = stops.findIndex(
      ({ mark }, i) =>
        i > step && (mark === "push" || mark === "cells" || mark === "done"),
    );
    return next < 0 ? this.#last : next;
  }

  render() {
    const { lab } = this;
    const beam = Math.max(lab.beam, 1) - 1;
    const ends = lab.line === null ? lab.cellsOfBeam(beam) : null;
    const line =
      lab.line ??
      (ends
        ? [ends.from.gx, ends.from.gy, ends.to.gx, ends.to.gy]
        : [0, 0, 0, 0]);
    const isShown = lineIsShown(line);
    const hit = (ends?.hit ?? false) && isShown;
    const key = line.join();
    if (key !== this.#key) {
      const [gx0, gy0, gx1, gy1] = isShown ? line : [0, 0, 0, 0];
      if (this.#key !== "" && lab.line === null) lab.step = 0;
      this.#key = key;
      this.#trace = traceLine(gx0, gy0, gx1, gy1);
      ENDS.forEach((id, i) => {
        input(id).value = `${line[i]}`;
      });
    }
    lab.step = Math.min(lab.step, this.#last);
    const width = this.shown.drawn(WIDTH);
    const moment = [
      key,
      lab.step,
      this.#timer,
      lab.scan,
      beam,
      ends,
      hit,
      width,
    ];
    if (JSON.stringify(moment) === this.#moment) return;
    this.#moment = JSON.stringify(moment);
    const { stops, cells } = this.#trace;
    const stop = stops[lab.step];
    const slider = input("line-step");
    slider.max = `${this.#last}`;
    slider.value = `${lab.step}`;
    setText(
      element("line-step-text"),
      `Step ${lab.step + 1} of ${this.#last + 1}`,
    );
    button("line-back").disabled = lab.step === 0;
    button("line-start").disabled = lab.step === 0;
    button("line-on").disabled = lab.step === this.#last || !isShown;
    button("cell-on").disabled = lab.step === this.#last || !isShown;
    button("line-play").disabled = !isShown;
    slider.disabled = !isShown;
    button("line-play").setAttribute("aria-pressed", `${this.#timer !== 0}`);
    setText(button("line-play"), this.#timer ? "Pause" : "Play");

    this.#mark(stop.line);
    this.#variables(stop, lab.step > 0 ? stops[lab.step - 1] : null);
    setText(element("line-happened"), isShown ? stop.words : "");
    const what =
      lab.line !== null
        ? "A line of your own"
        : ends === null
          ? `Beam ${beam + 1} of scan ${lab.scan} is ignored`
          : `Beam ${beam + 1} of scan ${lab.scan}, which ${hit ? "hits something in its last cell" : "meets nothing"}`;
    const from = `${what}: from cell (${line[0]}, ${line[1]}) to (${line[2]}, ${line[3]})`;
    byId("line-view", SVGSVGElement).style.visibility = isShown
      ? "visible"
      : "hidden";
    setText(
      element("line-words"),
      !isShown
        ? `${from}. These are too many cells to follow step by step.`
        : `${from}, ${plural(cells.length, "cell")}. ${stop.count} of them are listed so far${stop.count ? `, the last is (${cells[stop.count - 1].gx}, ${cells[stop.count - 1].gy})` : ""}.`,
    );
    this.#draw(stop, hit, width);
  }

  /** @param {number} line of the listing */
  #mark(line) {
    const listing = element("listing");
    const items = listing.children;
    const old = listing.querySelector("[aria-current]");
    if (old === items[line]) return;
    old?.removeAttribute("aria-current");
    items[line].setAttribute("aria-current", "step");
    const item = /** @type {HTMLElement} */ (items[line]);
    const top = item.offsetTop - listing.offsetTop;
    if (
      top < listing.scrollTop ||
      top > listing.scrollTop + listing.clientHeight - 60
    ) {
      listing.scrollTop = top - listing.clientHeight / 2;
    }
  }

  /** @param {Stop} stop @param {Stop | null} before */
  #variables(stop, before) {
    const items = Object.entries(stop.values).map(([name, value]) => {
      const changed = before !== null && before.values[name] !== value;
      return make(
        "li",
        changed ? { class: "changed" } : {},
        `${name} = ${value}`,
      );
    });
    element("variables").replaceChildren(...items);
  }

  /** @param {Stop} stop @param {boolean} hit @param {number} width */
  #draw(stop, hit, width) {
    const height = Math.round(width * HEIGHT_OVER_WIDTH);
    const { cells } = this.#trace;
    const [first, last] = [cells[0], cells[cells.length - 1]];
    const now = cells[Math.max(stop.count - 1, 0)];
    // the whole line where its cells can be seen, else a window that follows
    const spanX = Math.abs(last.gx - first.gx) + 3;
    const spanY = Math.abs(last.gy - first.gy) + 3;
    const side = Math.min(
      Math.max(Math.min(width / spanX, height / spanY), LEAST_CELL),
      64,
    );
    const columns = width / side;
    const rows = height / side;
    const place = (
      /** @type {number} */ a,
      /** @type {number} */ b,
      /** @type {number} */ at,
      /** @type {number} */ room,
    ) => {
      const [low, high] = [Math.min(a, b) - 1, Math.max(a, b) + 2];
      if (high - low <= room) return (low + high) / 2 - room / 2;
      return Math.min(Math.max(at + 0.5 - room / 2, low), high - room);
    };
    const left = place(first.gx, last.gx, now.gx, columns);
    const bottom = place(first.gy, last.gy, now.gy, rows);
    const x = (/** @type {number} */ gx) => (gx - left) * side;
    const y = (/** @type {number} */ gy) => height - (gy - bottom) * side;
    const parts = [];
    const isSeen = (/** @type {{gx: number, gy: number}} */ { gx, gy }) =>
      gx > left - 1 &&
      gx < left + columns &&
      gy > bottom - 1 &&
      gy < bottom + rows;
    cells.slice(0, stop.count).forEach((cell, k) => {
      if (!isSeen(cell)) return;
      const { gx, gy } = cell;
      const end = k === cells.length - 1;
      const fill = end && hit ? "var(--hit)" : "var(--free)";
      parts.push(
        `<rect x="${x(gx) + 1}" y="${y(gy + 1) + 1}" width="${side - 2}" height="${side - 2}" rx="2" fill="${fill}" fill-opacity="${k === stop.count - 1 ? 0.75 : 0.35}"/>`,
      );
    });
    let borders = "";
    for (let gx = Math.ceil(left); gx <= left + columns; gx++) {
      borders += `M${x(gx)} 0V${height}`;
    }
    for (let gy = Math.ceil(bottom); gy <= bottom + rows; gy++) {
      borders += `M0 ${y(gy)}H${width}`;
    }
    parts.push(`<path d="${borders}" stroke="var(--line)"/>`);
    const middle = ({ gx, gy } = first) => `${x(gx + 0.5)} ${y(gy + 0.5)}`;
    parts.push(
      `<path d="M${middle(first)}L${middle(last)}" stroke="var(--ink)" stroke-width="2"/>`,
      `<circle cx="${x(first.gx + 0.5)}" cy="${y(first.gy + 0.5)}" r="5" fill="var(--robot)"/>`,
      `<rect x="${x(last.gx) + 2}" y="${y(last.gy + 1) + 2}" width="${side - 4}" height="${side - 4}" fill="none" stroke="var(--hit)" stroke-width="2" stroke-dasharray="4 3"/>`,
      `<rect x="${x(now.gx)}" y="${y(now.gy + 1)}" width="${side}" height="${side}" fill="none" stroke="var(--ink)" stroke-width="3"/>`,
    );
    const every = side < 24 ? 5 : 1;
    for (let gx = Math.ceil(left); gx < left + columns; gx++) {
      if (gx % every) continue;
      parts.push(
        `<text x="${x(gx + 0.5)}" y="${height - 4}" text-anchor="middle">${gx}</text>`,
      );
    }
    for (let gy = Math.ceil(bottom); gy < bottom + rows; gy++) {
      if (gy % every || y(gy + 0.5) > height - 18) continue;
      parts.push(`<text x="4" y="${y(gy + 0.5) + 4}">${gy}</text>`);
    }
    const view = byId("line-view", SVGSVGElement);
    view.setAttribute("viewBox", `0 0 ${width} ${height}`);
    view.innerHTML = parts.join("");
  }
}
