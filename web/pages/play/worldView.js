/** The world: walls, path, robot and beams; the robot and the walls can be dragged. */

import { Pose, Segment } from "../../src/world.js";
import { button, byId, colour, element, setText } from "../shared/dom.js";
import { GridCanvas } from "../shared/gridCanvas.js";
import { shown } from "../shared/words.js";
import { endsOf } from "./lab.js";

/** @typedef {import("./lab.js").Lab} Lab */
/** @typedef {{x: number, y: number}} Point */
/** @typedef {(to: Point) => void} Drag */

const HANDLE = 34; // pixels from the robot to the handle that turns it
const ROBOT = 10;

/** To five centimetres. @param {number} value */
const snapped = (value) => Math.round(value * 20) / 20;

export class WorldView {
  /** @type {Drag | null} */
  #drag = null;
  /** The pointer that drags. */
  #pointer = 0;
  /** @type {Segment | null} a wall that is being drawn */
  #drawn = null;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.changed = changed;
    const canvas = byId("world-view", HTMLCanvasElement);
    this.place = canvas;
    this.view = new GridCanvas(canvas, changed);
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => {
      if (this.#isOther(event)) return;
      const to = this.#point(event);
      if (this.#drag === null) {
        canvas.style.cursor = this.#grab(to) ? "grab" : "crosshair";
        return;
      }
      this.#drag(to);
      changed();
    });
    canvas.addEventListener("pointerup", (event) => {
      if (!this.#isOther(event)) this.#up();
    });
    canvas.addEventListener("pointercancel", (event) => {
      if (this.#isOther(event)) return;
      this.#drawn = null; // the browser has taken the drag for something else
      this.#up();
    });
    // a finger on the robot drags it; elsewhere it scrolls the page
    canvas.addEventListener(
      "touchstart",
      (event) => {
        const touch = event.touches[0];
        const at = this.#point(
          /** @type {MouseEvent} */ (/** @type {unknown} */ (touch)),
        );
        if (lab.tool === "draw" || this.#grab(at)) event.preventDefault();
      },
      { passive: false },
    );
    canvas.addEventListener("keydown", (event) => this.#key(event));
    for (const tool of document.querySelectorAll("[data-tool]")) {
      tool.addEventListener("click", () => {
        const name = tool.getAttribute("data-tool");
        lab.tool = name === "draw" || name === "wall" ? name : "robot";
        changed();
      });
    }
    button("put-back").addEventListener("click", () => this.#putBack());
  }

  /** The place in the world under the pointer. @param {MouseEvent} event @returns {Point} */
  #point(event) {
    const { originX, originY, resolution } = this.lab.world.settings;
    const { gx, gy } = this.view.under(event);
    return { x: originX + gx * resolution, y: originY + gy * resolution };
  }

  /** The page's pixel of a place in the world. @param {number} x @param {number} y */
  #at(x, y) {
    const { originX, originY, resolution } = this.lab.world.settings;
    return this.view.at(
      (x - originX) / resolution,
      (y - originY) / resolution,
    );
  }

  /** @param {Point} p @param {Point} q in metres @returns {number} pixels */
  #apart(p, q) {
    const { resolution } = this.lab.world.settings;
    return (Math.hypot(p.x - q.x, p.y - q.y) / resolution) * this.view.scale;
  }

  get #pose() {
    return this.lab.free ?? this.lab.poses[this.lab.scan - 1];
  }

  #handle() {
    const { x, y, theta } = this.#pose;
    const away =
      (HANDLE * this.lab.world.settings.resolution) / this.view.scale;
    return { x: x + away * Math.cos(theta), y: y + away * Math.sin(theta) };
  }

  /** What a drag from here would do. @param {Point} from @returns {Drag | null} */
  #grab(from) {
    const { lab } = this;
    if (lab.tool === "robot") {
      const pose = this.#pose;
      if (this.#apart(from, this.#handle()) < 16) {
        return ({ x, y }) => {
          const { x: rx, y: ry } = this.#pose;
          lab.free = new Pose(rx, ry, Math.atan2(y - ry, x - rx));
        };
      }
      if (this.#apart(from, pose) < 26) {
        const { theta } = pose;
        const [offX, offY] = [pose.x - from.x, pose.y - from.y];
        return ({ x, y }) => {
          lab.free = new Pose(x + offX, y + offY, theta);
        };
      }
      return null;
    }
    if (lab.tool === "draw") {
      const start = { x: snapped(from.x), y: snapped(from.y) };
      return ({ x, y }) => {
        this.#drawn = new Segment(start.x, start.y, snapped(x), snapped(y));
      };
    }
    return this.#grabWall(from);
  }

  /** @param {Point} from @returns {Drag | null} */
  #grabWall(from) {
    const { lab } = this;
    const { walls } = lab.world;
    const replace = (/** @type {number} */ i, /** @type {Segment} */ wall) =>
      lab.setWalls(walls.map((old, k) => (k === i ? wall : old)));
    for (const [i, { x0, y0, x1, y1 }] of walls.entries()) {
      if (this.#apart(from, { x: x0, y: y0 }) < 12) {
        return ({ x, y }) =>
          replace(i, new Segment(snapped(x), snapped(y), x1, y1));
      }
      if (this.#apart(from, { x: x1, y: y1 }) < 12) {
        return ({ x, y }) =>
          replace(i, new Segment(x0, y0, snapped(x), snapped(y)));
      }
    }
    for (const [i, { x0, y0, x1, y1 }] of walls.entries()) {
      const [dx, dy] = [x1 - x0, y1 - y0];
      const along =
        ((from.x - x0) * dx + (from.y - y0) * dy) / (dx * dx + dy * dy);
      const t = Math.min(Math.max(along, 0), 1);
      if (this.#apart(from, { x: x0 + t * dx, y: y0 + t * dy }) < 10) {
        return ({ x, y }) => {
          const [mx, my] = [snapped(x - from.x), snapped(y - from.y)];
          replace(i, new Segment(x0 + mx, y0 + my, x1 + mx, y1 + my));
        };
      }
    }
    return null;
  }

  /** Whether a pointer is not the one that drags, as a second finger is not. @param {PointerEvent} event */
  #isOther(event) {
    return this.#drag !== null && event.pointerId !== this.#pointer;
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (event.button !== 0 || this.#drag !== null) return;
    this.#drag = this.#grab(this.#point(event));
    if (this.#drag === null) return;
    this.#pointer = event.pointerId;
    this.lab.playing = false;
    this.view.canvas.setPointerCapture(event.pointerId);
    this.view.canvas.style.cursor = "grabbing";
    this.changed();
  }

  #up() {
    if (this.#drag === null) return;
    this.#drag = null;
    const wall = this.#drawn;
    this.#drawn = null;
    if (wall && (wall.x0 !== wall.x1 || wall.y0 !== wall.y1)) {
      this.lab.setWalls([...this.lab.world.walls, wall]);
    }
    this.view.canvas.style.cursor = "crosshair";
    this.changed();
  }

  #putBack() {
    this.lab.free = null;
    this.view.canvas.focus();
    this.changed();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { x, y, theta } = this.#pose;
    const far = event.shiftKey ? 1 : 0.1;
    const turn = Math.PI / 36;
    /** @type {Record<string, [number, number, number]>} */
    const moves = {
      ArrowLeft: [-far, 0, 0],
      ArrowRight: [far, 0, 0],
      ArrowUp: [0, far, 0],
      ArrowDown: [0, -far, 0],
      q: [0, 0, turn],
      e: [0, 0, -turn],
    };
    const move =
      moves[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (event.key === "Escape" && this.lab.free !== null) {
      this.#putBack();
    } else if (event.key === " ") {
      event.preventDefault();
      button("play").click();
    } else if (event.key === "." || event.key === ",") {
      button(event.key === "." ? "beam-on" : "beam-back").click();
    } else if (move) {
      event.preventDefault();
      this.lab.free = new Pose(x + move[0], y + move[1], theta + move[2]);
      this.changed();
    }
  }

  render() {
    const { lab, view } = this;
    const { settings, walls } = lab.world;
    const { context } = view;
    view.begin(settings, lab.pad);
    const scan = lab.inView();
    const ends = endsOf(lab.grid, scan, settings);
    const count = lab.free === null ? lab.beam : ends.length;
    const robot = this.#at(scan.pose.x, scan.pose.y);

    // the grid, where more of the world is shown
    const corner = view.at(0, settings.height);
    context.lineWidth = 1;
    context.strokeStyle = colour("line");
    context.strokeRect(
      corner.x,
      corner.y,
      settings.width * view.scale,
      settings.height * view.scale,
    );

    // the path
    context.beginPath();
    for (const pose of lab.poses) {
      const { x, y } = this.#at(pose.x, pose.y);
      context.lineTo(x, y);
    }
    context.setLineDash([2, 4]);
    context.lineWidth = 1;
    context.strokeStyle = colour("strong");
    context.stroke();
    context.setLineDash([]);

    // the beams, those to come faint
    let hits = 0;
    let ignored = 0;
    for (const past of [false, true]) {
      context.beginPath();
      ends.forEach((end, i) => {
        if (end === null || i < count !== past) return;
        const { x, y } = this.#at(end.x, end.y);
        context.moveTo(robot.x, robot.y);
        context.lineTo(x, y);
      });
      context.globalAlpha = past ? 0.42 : 0.08;
      context.strokeStyle = colour("free");
      context.stroke();
    }
    context.globalAlpha = 1;
    context.fillStyle = colour("hit");
    ends.forEach((end, i) => {
      if (end === null) ignored += 1;
      if (!end?.hit) return;
      hits += 1;
      if (i >= count) return;
      const { x, y } = this.#at(end.x, end.y);
      context.beginPath();
      context.arc(x, y, 1.8, 0, 7);
      context.fill();
    });

    context.lineCap = "round";
    context.lineWidth = 3;
    context.strokeStyle = colour("wall");
    for (const wall of this.#drawn ? [...walls, this.#drawn] : walls) {
      const from = this.#at(wall.x0, wall.y0);
      const to = this.#at(wall.x1, wall.y1);
      context.beginPath();
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
      context.stroke();
      if (lab.tool === "wall") {
        context.fillStyle = colour("accent");
        for (const { x, y } of [from, to])
          context.fillRect(x - 4, y - 4, 8, 8);
      }
    }

    // the beam at hand
    const last = lab.free === null ? ends[count - 1] : null;
    if (last) {
      const { x, y } = this.#at(last.x, last.y);
      context.beginPath();
      context.moveTo(robot.x, robot.y);
      context.lineTo(x, y);
      context.lineWidth = 2.5;
      context.strokeStyle = last.hit ? colour("hit") : colour("free");
      context.stroke();
    }

    // the robot and its handle
    const handle = this.#handle();
    const knob = this.#at(handle.x, handle.y);
    context.lineWidth = 2.5;
    context.strokeStyle = colour("robot");
    context.beginPath();
    context.moveTo(robot.x, robot.y);
    context.lineTo(knob.x, knob.y);
    context.stroke();
    context.fillStyle = colour("page");
    context.beginPath();
    context.arc(knob.x, knob.y, 6, 0, 7);
    context.fill();
    context.stroke();
    context.fillStyle = colour("robot");
    context.beginPath();
    context.arc(robot.x, robot.y, ROBOT, 0, 7);
    context.fill();

    for (const tool of document.querySelectorAll("[data-tool]")) {
      const on = tool.getAttribute("data-tool") === lab.tool;
      tool.setAttribute("aria-pressed", `${on}`);
    }
    button("put-back").hidden = lab.free === null;
    const { x, y, theta } = scan.pose;
    const degrees = ((((theta * 180) / Math.PI) % 360) + 360) % 360;
    const missed = ends.length - hits - ignored;
    setText(
      element("world-words"),
      `The robot stands at x ${shown(x, 2)} m, y ${shown(y, 2)} m and looks to ${shown(degrees, 0)}°. Of ${ends.length} beams ${hits} hit something, ${missed} met nothing within ${settings.maxRange} m${ignored ? `, ${ignored} are ignored` : ""}.`,
    );
  }
}
