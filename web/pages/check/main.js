/** check.html: a map from a file, held against the right one. */

import offered from "scenarios:offered";
import { cellsOf } from "../model/compareMaps.js";
import { FileError, readMapFile } from "../model/readFiles.js";
import {
  button,
  byId,
  element,
  input,
  make,
  onceAFrame,
  save,
  setText,
  takeFiles,
} from "../shared/dom.js";
import { GridCanvas, palette } from "../shared/gridCanvas.js";
import { plural } from "../shared/words.js";
import { worldOf } from "./judgeFile.js";
import { startJudging } from "./judging.js";

/** @typedef {import("./verdict.js").Verdict} Verdict */
/** @typedef {import("../model/compareMaps.js").Found} Found */
/** @typedef {{gx: number, gy: number}} Cell */

const MOST_BYTES = 500000000;

const choice = byId("scenario", HTMLSelectElement);
choice.append(
  ...Object.keys(offered).map((name) =>
    make("option", { value: name }, name === "lesson" ? "the lesson" : name),
  ),
);

/** What is shown. @type {{found: Found, verdict: Verdict, at: Cell | null} | null} */
let shownNow = null;
/** @type {{name: string, bytes: Uint8Array} | null} */
let file = null;
/** Gives up the judging that is under way. */
let stop = () => {};

/** @returns {number | null} */
function seed() {
  return input("noise-free").checked ? null : input("seed").valueAsNumber;
}

/** Paragraphs that are there already stay: they need not be read out again. @param {"good" | "note" | "bad"} tone @param {string[]} words @param {string} status */
function say(tone, words, status) {
  const verdict = element("verdict");
  verdict.dataset.status = status;
  verdict.className = `verdict ${tone}`;
  while (verdict.children.length > words.length) {
    verdict.lastElementChild?.remove();
  }
  words.forEach((text, i) => {
    if (i < verdict.children.length) setText(verdict.children[i], text);
    else verdict.append(make("p", {}, text));
  });
}

/** A verdict begins, without what was found before. @param {string} of what */
function begin(of) {
  stop();
  element("working").hidden = true;
  element("result").hidden = false;
  element("figures").hidden = true;
  setText(element("checked"), of);
  shownNow = null;
}

function check() {
  stop();
  if (file === null) return;
  const mode = seed() === null ? "without noise" : `with seed ${seed()}`;
  begin(
    `${file.name}, compared with ${choice.selectedOptions[0].text} ${mode}.`,
  );
  say("note", ["Comparing …"], "working");
  let found;
  try {
    found = readMapFile(file.bytes);
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    say("bad", ["cannot be read", error.message], "unreadable");
    return;
  }
  if ("picture" in found && found.picture.top !== 255) {
    const { top } = found.picture;
    element("checked").append(
      ` Your picture's maximum is ${top}, not 255, so its levels are scaled.`,
    );
  }
  const job = { found, name: choice.value, text: offered[choice.value] };
  stop = startJudging(
    { ...job, seed: seed() },
    ({ doing, part, known }) => {
      element("working").hidden = false;
      setText(element("doing"), `${doing} …`);
      const progress = byId("progress", HTMLProgressElement);
      if (part === null) progress.removeAttribute("value");
      else progress.value = part;
      if (known) show(found, known, "working");
    },
    (verdict) => {
      element("working").hidden = true;
      show(found, verdict, verdict.status);
    },
  );
}

/** @param {Found} found @param {Verdict} verdict @param {string} status */
function show(found, verdict, status) {
  const { tone, words, wrong, reference } = verdict;
  say(tone, words, status);
  const sameSize =
    verdict.status !== "size" &&
    cellsOf(found).values.length === reference.pixels.length;
  shownNow = { found, verdict, at: shownNow?.at ?? null };
  element("figures").hidden = !sameSize || wrong.length === 0;
  if (wrong.length > 0 && shownNow.at === null) step(1);
  draw();
}

/** The reader has seen enough. */
function giveUp() {
  stop();
  element("working").hidden = true;
  if (shownNow === null) {
    say("note", ["You stopped before there was a verdict."], "stopped");
  } else {
    const { found, verdict } = shownNow;
    const words = [
      ...verdict.words,
      "You stopped the search for known mistakes.",
    ];
    show(found, { ...verdict, words }, verdict.status);
  }
  element("verdict-title").focus();
}

// --- the pictures ---

const GREY = palette();
const WRONG = palette(0.75, [214, 48, 120]);

const draw = onceAFrame(() => {
  if (shownNow === null || element("figures").hidden) return;
  const { found, verdict, at } = shownNow;
  const { reference, wrong } = verdict;
  const { width, height } = reference;
  const { values } = cellsOf(found);
  const differs = new Uint8Array(width * height);
  for (const cell of wrong) differs[cell] = 1;
  const coloured = input("colour").checked;
  for (const [view, level] of /** @type {const} */ ([
    [foundView, (/** @type {number} */ i) => levelOf(found, values, i)],
    [rightView, (/** @type {number} */ i) => reference.pixels[i]],
  ])) {
    view.begin(reference);
    view.paintCells((image) => {
      for (let i = 0; i < differs.length; i++) {
        const out = (height - 1 - Math.floor(i / width)) * width + (i % width);
        const colours = coloured && differs[i] ? WRONG : GREY;
        image[out] = colours[level(i)];
      }
    });
    if (at) view.frame(at, "#6d28d9");
  }
  setText(element("readout"), readOut());
});

/** A grey level to look at. @param {Found} found @param {ArrayLike<number>} values @param {number} i */
function levelOf(found, values, i) {
  if ("picture" in found) return values[i];
  return Math.round(255 - 255 / (1 + Math.E ** -values[i]));
}

function readOut() {
  if (shownNow === null) return "";
  const { found, verdict, at } = shownNow;
  const { reference, wrong } = verdict;
  if (at === null) return plural(wrong.length, "cell differs", "cells differ");
  const i = at.gy * reference.width + at.gx;
  const { values, expected } = cellsOf(found);
  const kind = "picture" in found ? "pixel" : "log-odds";
  const right = expected(reference)[i];
  const [first, last] = [reference.firstTouch[i], reference.lastTouch[i]];
  let touched = `Scans ${first} to ${last} touch it.`;
  if (first === last) touched = `Scan ${first} touches it.`;
  if (first === 0) touched = "No scan touches it.";
  return `cell gx=${at.gx} gy=${at.gy}: your ${kind} is ${values[i]}, the right one ${right}${values[i] === right ? ", the same" : ""}. ${touched}`;
}

/** @param {1 | -1} by */
function step(by) {
  if (shownNow === null || shownNow.verdict.wrong.length === 0) return;
  const { verdict, at } = shownNow;
  const { wrong, reference } = verdict;
  const now = at ? at.gy * reference.width + at.gx : by > 0 ? -1 : Infinity;
  const left = wrong.filter((cell) => (by > 0 ? cell > now : cell < now));
  const turn = left.length > 0 ? left : wrong; // round to the other end
  const next = by > 0 ? turn[0] : turn[turn.length - 1];
  point({
    gx: next % reference.width,
    gy: Math.floor(next / reference.width),
  });
}

/** @param {Cell | null} cell */
function point(cell) {
  if (shownNow) shownNow.at = cell;
  draw();
}

/** @param {string} id */
function viewOf(id) {
  const canvas = byId(id, HTMLCanvasElement);
  const view = new GridCanvas(canvas, draw);
  for (const name of /** @type {const} */ (["pointermove", "click"])) {
    // a finger that taps does not move
    canvas.addEventListener(name, (event) => {
      const cell = view.cellUnder(event);
      if (cell) point(cell);
    });
  }
  view.takeKeys(() => shownNow?.at ?? null, point, point);
  return view;
}
const foundView = viewOf("found-view");
const rightView = viewOf("right-view");

// --- the controls ---

function choose() {
  const { settings, scans } = worldOf(choice.value, offered[choice.value]);
  setText(
    element("scenario-words"),
    `${settings.width} x ${settings.height} cells of ${settings.resolution} m, ${plural(scans.length, "scan")}.`,
  );
  check();
}

takeFiles(
  element("drop"),
  input("file"),
  MOST_BYTES,
  (name, bytes) => {
    file = { name, bytes };
    check();
    element("verdict-title").focus();
  },
  (name, why) => {
    file = null;
    begin(name);
    say("bad", ["cannot be read", why], "unreadable");
    element("verdict-title").focus();
  },
);
choice.addEventListener("change", choose);
for (const id of ["noise-free", "seeded"]) {
  input(id).addEventListener("change", choose);
}
input("seed").addEventListener("change", () => {
  input("seeded").checked = true;
  const typed = Math.trunc(input("seed").valueAsNumber) || 0;
  input("seed").value = `${Math.min(Math.max(typed, 0), 2 ** 32 - 1)}`;
  choose();
});
button("save-scenario").addEventListener("click", () =>
  save(`${choice.value}.log`, offered[choice.value]),
);
button("stop").addEventListener("click", giveUp);
button("next").addEventListener("click", () => step(1));
button("previous").addEventListener("click", () => step(-1));
input("colour").addEventListener("change", draw);
choose();
