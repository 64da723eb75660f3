/** A canvas that shows a grid: cells, and world coordinates over them. */

import { pixel } from "../../src/mapWriter.js";
import { ShownWidth } from "./dom.js";

/** @typedef {{width: number, height: number}} Size in cells */
/** @typedef {{left: number, right: number, bottom: number, top: number}} Pad how much of the world around the grid is shown, in cells */

/** How much of the window a picture may take, in hundredths of its height. */
const MOST_OF_HEIGHT = 85;
/** @type {Pad} */
const NO_PAD = { left: 0, right: 0, bottom: 0, top: 0 };

export class GridCanvas {
  /** Side of a cell in pixels of the page. */
  scale = 1;
  #cells = document.createElement("canvas");
  /** @type {ImageData | null} */
  #image = null;
  #shown;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {() => void} redraw when its size has changed
   */
  constructor(canvas, redraw) {
    this.canvas = canvas;
    const context = canvas.getContext("2d");
    const inner = this.#cells.getContext("2d");
    if (!context || !inner) throw new Error("no canvas");
    this.context = context;
    this.inner = inner;
    /** @type {Size} */
    this.size = { width: 1, height: 1 };
    this.pad = NO_PAD;
    this.#shown = new ShownWidth(canvas, redraw);
  }

  /** Begins a drawing: clears, and sets the scale to pixels of the page. @param {Size} size @param {Pad} pad */
  begin({ width, height }, pad = NO_PAD) {
    const { canvas, context } = this;
    const columns = pad.left + width + pad.right;
    const rows = pad.bottom + height + pad.top;
    if (this.size.width !== width || this.size.height !== height) {
      this.size = { width, height };
      this.#cells.width = width;
      this.#cells.height = height;
      this.#image = null;
    }
    this.pad = pad;
    const shape = `${columns} / ${rows}`;
    if (canvas.style.aspectRatio !== shape) {
      canvas.style.aspectRatio = shape;
      // all of it is seen at a time, however tall it is
      canvas.style.width = `min(100%, ${MOST_OF_HEIGHT}vh * ${columns} / ${rows})`;
    }
    const ratio = devicePixelRatio || 1;
    const across = this.#shown.value;
    const down = (across * rows) / columns;
    if (canvas.width !== Math.round(across * ratio)) {
      canvas.width = Math.round(across * ratio);
    }
    if (canvas.height !== Math.round(down * ratio)) {
      canvas.height = Math.round(down * ratio);
    }
    this.scale = across / columns;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, across, down);
  }

  /**
   * Draws a colour for each cell.
   *
   * @param {(image: Uint32Array) => void} paint fills in colours of palettes, row with the largest y first
   */
  paintCells(paint) {
    const { width, height } = this.size;
    this.#image ??= this.inner.createImageData(width, height);
    paint(new Uint32Array(this.#image.data.buffer));
    this.inner.putImageData(this.#image, 0, 0);
    this.drawCells();
  }

  /** Draws the cells once more as they were painted. */
  drawCells() {
    const { width, height } = this.size;
    this.context.imageSmoothingEnabled = false;
    const { x, y } = this.at(0, height);
    this.context.drawImage(
      this.#cells,
      x,
      y,
      width * this.scale,
      height * this.scale,
    );
  }

  /** The page's pixel of a place in cells (column and row may be broken). @param {number} gx @param {number} gy */
  at(gx, gy) {
    return {
      x: (this.pad.left + gx) * this.scale,
      y: (this.pad.top + this.size.height - gy) * this.scale,
    };
  }

  /** The place in cells under the pointer. @param {MouseEvent} event */
  under(event) {
    const { canvas } = this;
    const box = canvas.getBoundingClientRect();
    const across = event.clientX - box.left - canvas.clientLeft;
    const down = event.clientY - box.top - canvas.clientTop;
    return {
      gx: across / this.scale - this.pad.left,
      gy: this.pad.top + this.size.height - down / this.scale,
    };
  }

  /** The cell under the pointer; null outside. @param {MouseEvent} event */
  cellUnder(event) {
    const { gx, gy } = this.under(event);
    const cell = { gx: Math.floor(gx), gy: Math.floor(gy) };
    const { width, height } = this.size;
    const inside =
      cell.gx >= 0 && cell.gx < width && cell.gy >= 0 && cell.gy < height;
    return inside ? cell : null;
  }

  /** A frame around a cell. @param {{gx: number, gy: number}} cell @param {string} colour */
  frame({ gx, gy }, colour) {
    const { context, scale } = this;
    const { x, y } = this.at(gx, gy + 1);
    const side = Math.max(scale, 3);
    context.lineWidth = 4;
    context.strokeStyle = "#fff";
    context.strokeRect(x - 1, y - 1, side + 2, side + 2);
    context.lineWidth = 2;
    context.strokeStyle = colour;
    context.strokeRect(x - 1, y - 1, side + 2, side + 2);
  }

  /**
   * Arrow keys choose a cell, Enter takes it.
   *
   * @param {() => {gx: number, gy: number} | null} get
   * @param {(cell: {gx: number, gy: number}) => void} set
   * @param {(cell: {gx: number, gy: number}) => void} take
   */
  takeKeys(get, set, take) {
    this.canvas.addEventListener("keydown", (event) => {
      const { width, height } = this.size;
      const cell = get() ?? { gx: width >> 1, gy: height >> 1 };
      const far = event.shiftKey ? 10 : 1;
      /** @type {Record<string, [number, number]>} */
      const moves = {
        ArrowLeft: [-far, 0],
        ArrowRight: [far, 0],
        ArrowUp: [0, far],
        ArrowDown: [0, -far],
      };
      const move = moves[event.key];
      if (move) {
        event.preventDefault();
        set({
          gx: Math.min(Math.max(cell.gx + move[0], 0), width - 1),
          gy: Math.min(Math.max(cell.gy + move[1], 0), height - 1),
        });
      } else if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        take(cell);
      }
    });
  }
}

/**
 * The colours of the grey levels 0 to 255, mixed with a part of another colour, as a picture's memory holds them.
 *
 * @param {number} part of the other colour, 0 to 1
 * @param {[number, number, number]} other red, green and blue, 0 to 255
 * @returns {Uint32Array}
 */
export function palette(part = 0, other = [0, 0, 0]) {
  const bytes = new Uint8ClampedArray(4 * 256);
  for (let level = 0; level < 256; level++) {
    other.forEach((value, i) => {
      bytes[4 * level + i] = (1 - part) * level + part * value;
    });
    bytes[4 * level + 3] = 255;
  }
  return new Uint32Array(bytes.buffer);
}

/** Grey levels of a map, computed anew only where it has changed. */
export class GreyLevels {
  /** @type {Float64Array} */
  #values = new Float64Array(0);
  /** @type {Uint8Array} */
  #pixels = new Uint8Array(0);

  /** @param {Float64Array} logOdds @returns {Uint8Array} in the same order */
  of(logOdds) {
    if (this.#values.length !== logOdds.length) {
      this.#values = new Float64Array(logOdds.length).fill(NaN);
      this.#pixels = new Uint8Array(logOdds.length);
    }
    for (let i = 0; i < logOdds.length; i++) {
      if (logOdds[i] !== this.#values[i]) {
        this.#values[i] = logOdds[i];
        this.#pixels[i] = pixel(logOdds[i]);
      }
    }
    return this.#pixels;
  }
}
