/** The map, what the scan in view changes in it, and the cell under the mouse. */

import { sigmoid } from "../../src/grid.js";
import { pixel } from "../../src/mapWriter.js";
import { colour, element, input, setText } from "../shared/dom.js";
import { GreyLevels, GridCanvas } from "../shared/gridCanvas.js";
import { shown } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {import("./lab.js").Cell} Cell */
/** @typedef {import("./lab.js").Moment} Moment */

export class MapView {
  #grey = new GreyLevels();

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    const canvas = /** @type {HTMLCanvasElement} */ (element("map-view"));
    this.view = new GridCanvas(canvas, changed);
    const point = (/** @type {Cell | null} */ cell) => {
      lab.cursor = cell;
      changed();
    };
    const take = (/** @type {Cell | null} */ cell) => {
      if (cell === null) return;
      lab.cell = cell;
      point(cell);
    };
    canvas.addEventListener("pointermove", (event) =>
      point(this.view.cellUnder(event)),
    );
    canvas.addEventListener("click", (event) =>
      take(this.view.cellUnder(event)),
    );
    this.view.takeKeys(() => lab.cursor ?? lab.cell, point, take);
    input("show-changes").addEventListener("change", changed);
  }

  /** Draws the map of a moment: of the newest one that is mapped. @param {Moment} moment */
  show(moment) {
    const { lab, view } = this;
    const { settings } = moment.run.world;
    const { width, height } = settings;
    const { before, now } = lab.maps(moment);
    const grey = this.#grey.of(now);
    const marks = input("show-changes").checked;
    let freed = 0;
    let filled = 0;
    view.begin(settings, lab.pad);
    view.paintCells((image) => {
      for (let gy = 0; gy < height; gy++) {
        let out = 4 * (height - 1 - gy) * width;
        for (let i = gy * width; i < (gy + 1) * width; i++, out += 4) {
          const level = grey[i];
          let [red, green, blue] = [level, level, level];
          if (now[i] !== before[i]) {
            const free = now[i] < before[i];
            if (free) freed += 1;
            else filled += 1;
            if (marks) {
              red = 0.45 * level + 0.55 * (free ? 59 : 240);
              green = 0.45 * level + 0.55 * (free ? 156 : 118);
              blue = 0.45 * level + 0.55 * (free ? 240 : 46);
            }
          }
          image[out] = red;
          image[out + 1] = green;
          image[out + 2] = blue;
          image[out + 3] = 255;
        }
      }
    });
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
      `${cellWords(lab, cell, now)} This scan makes ${freed} cells more free and ${filled} more occupied.`,
    );
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
