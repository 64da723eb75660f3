/** The map, what the scan in view changes in it, and the cell under the mouse. */

import { sigmoid } from "../../src/grid.js";
import { pixel } from "../../src/mapWriter.js";
import { byId, colour, element, input, setText } from "../shared/dom.js";
import { GreyLevels, GridCanvas, palette } from "../shared/gridCanvas.js";
import { counted, plural, shown } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("./lab.js").Cell} Cell */
/** @typedef {import("./lab.js").Moment} Moment */

const GREY = palette();
const FREED = palette(0.55, [59, 156, 240]);
const FILLED = palette(0.55, [240, 118, 46]);

export class MapView {
  #grey = new GreyLevels();
  /** What the cells show now. @type {Moment | null} */
  #shown = null;
  #marked = true;
  /** Its log-odds. */
  #logOdds = new Float64Array(0);
  #freed = 0;
  #filled = 0;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.place = byId("map-view", HTMLCanvasElement);
    this.view = new GridCanvas(this.place, changed);
    const point = (/** @type {Cell | null} */ cell) => {
      lab.cursor = cell;
      changed();
    };
    const take = (/** @type {Cell | null} */ cell) => {
      if (cell === null) return;
      lab.cell = cell;
      point(cell);
    };
    this.place.addEventListener("pointermove", (event) =>
      point(this.view.cellUnder(event)),
    );
    this.place.addEventListener("click", (event) =>
      take(this.view.cellUnder(event)),
    );
    this.view.takeKeys(() => lab.cursor ?? lab.cell, point, take);
    input("show-changes").addEventListener("change", changed);
  }

  /** Draws the newest map that is done. */
  render() {
    const { lab, view } = this;
    const moment = lab.mapped;
    if (moment === null) return;
    const { settings } = moment.run.world;
    const isMarked = input("show-changes").checked;
    view.begin(settings, lab.pad);
    if (moment === this.#shown && isMarked === this.#marked) {
      view.drawCells();
    } else {
      this.#paint(moment, isMarked);
    }
    view.frame(lab.cell, "#6d28d9");
    if (lab.cursor) view.frame(lab.cursor, "#d9480f");
    const { x, y } = (moment.added ?? moment.run.scans.at(moment.scan - 1))
      .pose;
    const robot = view.at(
      (x - settings.originX) / settings.resolution,
      (y - settings.originY) / settings.resolution,
    );
    view.context.beginPath();
    view.context.arc(robot.x, robot.y, 5, 0, 7);
    view.context.fillStyle = colour("robot");
    view.context.fill();
    view.context.lineWidth = 1.5;
    view.context.strokeStyle = "#fff";
    view.context.stroke();
    const cell = lab.cursor ?? lab.cell;
    setText(
      element("map-words"),
      `${cellWords(lab, cell, this.#logOdds)} This scan makes ${plural(this.#freed, "cell")} more free and ${counted(this.#filled)} more occupied.`,
    );
  }

  /** @param {Moment} moment @param {boolean} isMarked whether what the scan changes is coloured */
  #paint(moment, isMarked) {
    this.#shown = moment;
    this.#marked = isMarked;
    const { before, now } = this.lab.maps(moment);
    const { width, height } = moment.run.world.settings;
    const grey = this.#grey.of(now);
    let freed = 0;
    let filled = 0;
    this.view.paintCells((image) => {
      for (let gy = 0; gy < height; gy++) {
        let out = (height - 1 - gy) * width;
        for (let i = gy * width; i < (gy + 1) * width; i++, out++) {
          let colours = GREY;
          if (now[i] < before[i]) {
            freed += 1;
            if (isMarked) colours = FREED;
          } else if (now[i] !== before[i]) {
            filled += 1;
            if (isMarked) colours = FILLED;
          }
          image[out] = colours[grey[i]];
        }
      }
    });
    this.#freed = freed;
    this.#filled = filled;
    if (this.#logOdds.length === now.length) this.#logOdds.set(now);
    else this.#logOdds = now.slice();
  }
}

/**
 * What a map says of a cell.
 *
 * @param {Lab} lab
 * @param {Cell} cell
 * @param {Float64Array} logOdds
 */
export function cellWords(lab, { gx, gy }, logOdds) {
  const value = logOdds[gy * lab.world.settings.width + gx];
  const { x, y } = lab.grid.gridToWorldCenter(gx, gy);
  return `cell gx=${gx} gy=${gy}, centre (${shown(x, 2)}, ${shown(y, 2)}) m: log-odds ${value}, P(occupied) ${sigmoid(value).toFixed(6)}, pixel ${pixel(value)}.`;
}
