/** One cell: its log-odds over the scans, and every update that it got. */

import { logit, sigmoid } from "../../src/grid.js";
import { pixel } from "../../src/mapWriter.js";
import { cellHistory } from "../model/cellHistory.js";
import {
  byId,
  element,
  input,
  make,
  ShownWidth,
  setText,
} from "../shared/dom.js";
import { plural, shown } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("../model/cellHistory.js").CellUpdate} CellUpdate */

const WIDTH = 720;
const VIEW = {
  height: 320,
  left: 46,
  right: 44,
  top: 30,
  bottom: 34,
};
/** So far apart, names beside the curve can be read. */
const APART = 14;
const MOST_ROWS = 400;

export class CellFigure {
  #key = "";
  #moment = "";
  #width = WIDTH;
  /** @type {CellUpdate[]} */
  #updates = [];

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.place = element("cell");
    /** Its updates come from all scans. */
    this.whole = true;
    this.shown = new ShownWidth(byId("curve", SVGSVGElement), changed);
    for (const id of ["cell-gx", "cell-gy"]) {
      input(id).addEventListener("change", () => {
        const { width, height } = lab.world.settings;
        const number = (
          /** @type {string} */ name,
          /** @type {number} */ size,
        ) =>
          Math.min(
            Math.max(Math.trunc(input(name).valueAsNumber) || 0, 0),
            size - 1,
          );
        this.#key = ""; // the fields show what was made of the numbers
        lab.cell = {
          gx: number("cell-gx", width),
          gy: number("cell-gy", height),
        };
        changed();
      });
    }
    byId("updates", HTMLTableElement).addEventListener("click", (event) => {
      const chosen =
        event.target instanceof Element
          ? event.target.closest("button")
          : null;
      if (!chosen) return;
      lab.playing = false;
      lab.free = null;
      lab.line = null;
      lab.goTo(Number(chosen.dataset.scan), Number(chosen.dataset.beam));
      changed();
    });
  }

  render() {
    const { lab } = this;
    const { settings } = lab.world;
    const { gx, gy } = lab.cell;
    const key = `${lab.version} ${gx} ${gy}`;
    const fresh = key !== this.#key;
    if (fresh) {
      this.#key = key;
      this.#updates = cellHistory(settings, lab.scans, gx, gy);
      const [column, row] = [input("cell-gx"), input("cell-gy")];
      column.max = `${settings.width - 1}`;
      row.max = `${settings.height - 1}`;
      column.value = `${gx}`;
      row.value = `${gy}`;
      this.#rows();
    }
    const width = this.shown.drawn(WIDTH);
    const moment = `${key} ${lab.scan} ${lab.beam} ${width}`;
    if (moment === this.#moment) return;
    const resized = width !== this.#width;
    this.#width = width;
    this.#moment = moment;
    const updates = this.#updates;
    const past = updates.filter(
      ({ scan, beam }) =>
        scan < lab.scan - 1 || (scan === lab.scan - 1 && beam < lab.beam),
    ).length;
    const value = past > 0 ? updates[past - 1].after : logit(settings.p0);
    const hits = updates
      .slice(0, past)
      .filter(({ occupied }) => occupied).length;
    setText(
      element("cell-words"),
      `Cell gx=${gx} gy=${gy}: ${plural(past, "update")} of ${updates.length} so far, ${past - hits} free and ${hits} occupied. Log-odds ${value}, P(occupied) ${sigmoid(value).toFixed(6)}, pixel ${pixel(value)}. Its bounds are ${shown(settings.lMin, 2)} and ${shown(settings.lMax, 2)}.`,
    );
    this.#curve(past, value, fresh || resized);
    this.#current(past);
  }

  #rows() {
    const rows = this.#updates.slice(0, MOST_ROWS).map((update) => {
      const [scan, beam] = [update.scan + 1, update.beam + 1];
      const place = make(
        "button",
        { type: "button", "data-scan": scan, "data-beam": beam },
        `${scan}, ${beam}`,
      );
      return make(
        "tr",
        {},
        make("td", {}, place),
        make("td", {}, update.occupied ? "occupied" : "free"),
        make("td", {}, shown(update.after, 4)),
        make("td", {}, sigmoid(update.after).toFixed(4)),
      );
    });
    const more = this.#updates.length - MOST_ROWS;
    if (more > 0) {
      rows.push(
        make(
          "tr",
          {},
          make("td", { colspan: 4 }, `and ${plural(more, "more update")}`),
        ),
      );
    }
    if (rows.length === 0) {
      rows.push(
        make(
          "tr",
          {},
          make("td", { colspan: 4 }, "No beam ever crosses this cell."),
        ),
      );
    }
    byId("updates", HTMLTableElement).tBodies[0].replaceChildren(...rows);
  }

  /** @param {number} past */
  #current(past) {
    const body = byId("updates", HTMLTableElement).tBodies[0];
    const row = past > 0 ? body.rows[Math.min(past, MOST_ROWS) - 1] : null;
    const old = body.querySelector(".now");
    if (old === row) return;
    old?.classList.remove("now");
    old?.removeAttribute("aria-current");
    row?.classList.add("now");
    row?.setAttribute("aria-current", "step");
    const scroll = body.closest(".scroll");
    if (row && scroll)
      scroll.scrollTop = row.offsetTop - scroll.clientHeight / 2;
  }

  /** @param {number} past @param {number} value now @param {boolean} fresh whether it is another curve */
  #curve(past, value, fresh) {
    const { lab } = this;
    const { settings } = lab.world;
    const { lMin, lMax } = settings;
    const { height, left, right, top, bottom } = VIEW;
    const width = this.#width;
    const updates = this.#updates;
    const values = [logit(settings.p0), ...updates.map(({ after }) => after)];
    const least = Math.max(Math.min(lMin, ...values.slice(0, 1)), -1000);
    const span = lMax - least || 1;
    const { count } = lab;
    const x = (/** @type {number} */ time) =>
      left + ((width - left - right) * time) / count;
    const y = (/** @type {number} */ l) =>
      height - bottom - ((height - top - bottom) * (l - least)) / span;
    const time = ({ scan, beam } = updates[0]) =>
      scan + (beam + 1) / lab.scanAt(scan).ranges.length;
    const parts = [];
    const line = (
      /** @type {number} */ l,
      /** @type {number} */ at,
      /** @type {string} */ name,
      /** @type {string} */ dashes,
    ) => {
      parts.push(
        `<path d="M${left} ${y(l)}H${width - right}" stroke="var(--strong)" stroke-dasharray="${dashes}"/>`,
        `<text x="${left - 6}" y="${at + 4}" text-anchor="end">${shown(l, l % 1 ? 2 : 0)}</text>`,
        `<text x="${width - right + 6}" y="${at + 4}">${name}</text>`,
      );
    };
    const [high, low] = [y(lMax), y(lMin)];
    line(lMax, high, "l_max", "6 4");
    line(lMin, low, "l_min", "6 4");
    // beside a bound, the prior's name makes room for the bound's
    const at = Math.min(Math.max(y(values[0]), high + APART), low - APART);
    line(values[0], at, "prior", "2 3");
    const marks = [0, 0.25, 0.5, 0.75, 1].map((part) =>
      Math.round(part * count),
    );
    for (const mark of new Set(marks)) {
      parts.push(
        `<text x="${x(mark)}" y="${height - bottom + 18}" text-anchor="middle">${mark}</text>`,
      );
    }
    parts.push(
      `<text x="${(left + width - right) / 2}" y="${height - 3}" text-anchor="middle">scans</text>`,
      `<text x="6" y="14">log-odds</text>`,
    );
    let path = `M${x(0)} ${y(values[0])}`;
    updates.forEach((update, i) => {
      path += `H${x(time(update)).toFixed(1)}V${y(values[i + 1]).toFixed(1)}`;
    });
    path += `H${x(count)}`;
    parts.push(
      `<path d="${path}" fill="none" stroke="var(--ink)" stroke-width="1.6"/>`,
    );
    const dots = updates.length > 1500 ? [] : updates;
    for (const update of dots) {
      parts.push(
        `<circle cx="${x(time(update)).toFixed(1)}" cy="${y(update.after).toFixed(1)}" r="${update.occupied ? 3 : 2.2}" fill="var(--${update.occupied ? "hit" : "free"})"/>`,
      );
    }
    const now = [
      `<path d="M${x(lab.scan - 1 + lab.beam / lab.beams)} ${top - 6}V${height - bottom}" stroke="var(--robot)" stroke-width="2"/>`,
    ];
    if (past > 0) {
      const at = updates[past - 1];
      now.push(
        `<circle cx="${x(time(at))}" cy="${y(value)}" r="6" fill="none" stroke="var(--robot)" stroke-width="2.5"/>`,
      );
    }
    const curve = byId("curve", SVGSVGElement);
    curve.setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (fresh) curve.innerHTML = `<g>${parts.join("")}</g><g></g>`;
    const moving = curve.lastElementChild;
    if (moving) moving.innerHTML = now.join("");
  }
}
