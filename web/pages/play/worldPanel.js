/** Walls as numbers, and scenarios from files and to files. */

import { lessonScenario } from "../../src/lesson.js";
import { memorySource } from "../../src/lines.js";
import { readScenario } from "../../src/scenario.js";
import { Segment } from "../../src/world.js";
import {
  guessedParameters,
  lacksParameters,
  scenarioText,
} from "../model/scenarioText.js";
import { MOST_CELLS } from "../model/settings.js";
import {
  button,
  byId,
  element,
  input,
  make,
  save,
  setText,
  takeFiles,
} from "../shared/dom.js";
import { plural } from "../shared/words.js";

/** @typedef {import("./lab.js").Lab} Lab */

const ENDS = /** @type {const} */ (["x0", "y0", "x1", "y1"]);
/** So many walls are listed; a table of thousands takes seconds. */
const MOST_ROWS = 200;
/** So many times as long as wide may a grid be to be shown. */
const LONGEST = 40;
/** The suite's programs take more. */
const MOST_BYTES = 50000000;

export class WorldPanel {
  #key = -1;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.changed = changed;
    button("add-wall").addEventListener("click", () => {
      const { originX, originY, resolution, width, height } =
        lab.world.settings;
      const x = Math.round(originX + (width * resolution) / 2);
      const y = Math.round(originY + (height * resolution) / 2);
      lab.setWalls([...lab.world.walls, new Segment(x - 1, y, x + 1, y)]);
      changed();
    });
    const table = byId("walls", HTMLTableElement);
    this.place = table;
    table.addEventListener("change", (event) => {
      const row = /** @type {Element} */ (event.target).closest("tr");
      if (!row) return;
      const numbers = Array.from(
        row.querySelectorAll("input"),
        (field) => field.valueAsNumber,
      );
      if (numbers.some((n) => !Number.isFinite(n))) {
        this.#key = -1; // the wall's own numbers come back
        changed();
        return;
      }
      const [x0, y0, x1, y1] = numbers;
      const at = Number(row.dataset.wall);
      lab.setWalls(
        lab.world.walls.map((wall, i) =>
          i === at ? new Segment(x0, y0, x1, y1) : wall,
        ),
      );
      changed();
    });
    table.addEventListener("click", (event) => {
      const chosen = /** @type {Element} */ (event.target).closest("button");
      if (!chosen) return;
      const at = Number(chosen.dataset.wall);
      lab.setWalls(lab.world.walls.filter((_, i) => i !== at));
      changed();
      button("add-wall").focus();
    });
    takeFiles(
      element("drop"),
      input("file"),
      MOST_BYTES,
      (name, bytes) => this.open(name, bytes),
      (name, why) => this.#say(`${name}: cannot be read. ${why}`),
    );
    button("download").addEventListener("click", () =>
      save(`${lab.name}.log`, scenarioText(lab.world)),
    );
    button("restore").addEventListener("click", () => {
      const lesson = lessonScenario();
      const { settings, walls } = lesson;
      lab.open(
        { settings, walls, scans: Array.from(lesson.scans()) },
        "lesson",
      );
      setText(element("file-words"), "");
      changed();
    });
  }

  /** Says what became of a file, where it can be seen. @param {string} words */
  #say(words) {
    const said = element("file-words");
    const details = said.closest("details");
    if (details) details.open = true;
    setText(said, words);
    said.scrollIntoView({ block: "nearest" });
  }

  /** @param {string} name @param {Uint8Array} bytes */
  open(name, bytes) {
    try {
      const { world, guessed } = readWorld(name, bytes);
      const { width, height } = world.settings;
      const cells = `${name}: ${width} x ${height} cells are`;
      if (width * height > MOST_CELLS) {
        throw new RangeError(
          `${cells} too many for this page; the suite's programs map them.`,
        );
      }
      if (Math.max(width, height) > LONGEST * Math.min(width, height)) {
        throw new RangeError(
          `${cells} too long a strip for this page; the suite's programs map it.`,
        );
      }
      this.lab.open(world, name.replace(/\.[^.]+$/, ""));
      this.#say(
        `${name}: ${plural(world.scans.length, "scan")}, ${plural(world.walls.length, "wall")}.${guessed ? " The log says nothing of a grid, so this page has chosen one." : ""}`,
      );
    } catch (error) {
      this.#say(error instanceof Error ? error.message : `${error}`);
    }
    this.changed();
  }

  render() {
    if (this.#key === this.lab.version) return;
    this.#key = this.lab.version;
    const table = byId("walls", HTMLTableElement);
    const body = table.tBodies[0];
    const { walls } = this.lab.world;
    const listed = walls.slice(0, MOST_ROWS);
    const more = walls.length - listed.length;
    setText(
      element("more-walls"),
      more > 0 ? `and ${plural(more, "more wall")}` : "",
    );
    while (body.rows.length > listed.length) body.deleteRow(-1);
    listed.forEach((wall, i) => {
      if (i >= body.rows.length) body.append(wallRow(i));
      ENDS.forEach((end, k) => {
        const field = body.rows[i].querySelectorAll("input")[k];
        if (
          field !== document.activeElement ||
          field.valueAsNumber !== wall[end]
        ) {
          field.value = `${wall[end]}`;
        }
      });
    });
  }
}

/** @param {number} i */
function wallRow(i) {
  return make(
    "tr",
    { "data-wall": i },
    make("th", { scope: "row" }, `${i + 1}`),
    ...ENDS.map((end) =>
      make(
        "td",
        {},
        make("input", {
          type: "number",
          step: 0.1,
          "aria-label": `${end} of wall ${i + 1}`,
        }),
      ),
    ),
    make(
      "td",
      {},
      make(
        "button",
        {
          type: "button",
          "data-wall": i,
          "aria-label": `Remove wall ${i + 1}`,
        },
        "×",
      ),
    ),
  );
}

/**
 * A scenario; or a log without our parameters, with a grid around it.
 *
 * @param {string} name
 * @param {Uint8Array} bytes
 */
function readWorld(name, bytes) {
  const read = (/** @type {Uint8Array | string} */ content) => {
    const scenario = readScenario(memorySource(name, content));
    const scans = Array.from(scenario.scans());
    return { settings: scenario.settings, walls: scenario.walls, scans };
  };
  try {
    return { world: read(bytes), guessed: false };
  } catch (error) {
    if (!lacksParameters(error)) throw error;
    const text = new TextDecoder("latin1").decode(bytes);
    const parameters = guessedParameters(text);
    if (parameters === "") throw error;
    return { world: read(`${parameters}${text}`), guessed: true };
  }
}
