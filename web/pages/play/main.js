/** play.html: the lesson's figures, held together by one lab. */

import { MISTAKES } from "../model/mistakes.js";
import { hashOfMap } from "../model/sha256.js";
import { element, onceAFrame, setText } from "../shared/dom.js";
import { addressOf, readAddress } from "./address.js";
import { CellFigure } from "./cellFigure.js";
import { Lab } from "./lab.js";
import { LineFigure } from "./lineFigure.js";
import { MapView } from "./mapView.js";
import { SettingsPanel } from "./settingsPanel.js";
import { Transport } from "./transport.js";
import { WhatIf } from "./whatIf.js";
import { WorldPanel } from "./worldPanel.js";
import { WorldView } from "./worldView.js";

const lab = new Lab();
/** @type {Set<string>} */
const touched = new Set();
const start = lab.cell;
/** How long the page waits for more, in milliseconds, before it does what takes longer. */
const PAUSE = 120;

/** How long a frame maps, in milliseconds; of the 16 between two frames the figures need some, too. */
const MAPPING = 7;

const changed = onceAFrame(() => {
  frame();
  if (lab.version === calmVersion && !busy) draw(Object.values(calm));
  else if (lab.version !== seenVersion) calmDown(drawCalm);
  seenVersion = lab.version;
  if (!lab.playing) quiet(settle);
});

/** The figures that follow every frame. */
const live = {
  world: new WorldView(lab, changed),
  transport: new Transport(lab, changed),
  settings: new SettingsPanel(lab, changed),
  walls: new WorldPanel(lab, changed),
  line: new LineFigure(lab, changed),
};
/** The map follows too, where it is mapped in time; else it shows the newest moment that is. */
const map = new MapView(lab, changed);
let busy = false;

/** Draws what follows every frame. */
function frame() {
  const done = lab.mapOn(MAPPING);
  draw(Object.values(live));
  if (done) map.show(done);
  busy = !lab.isNow(done);
  element("map-words").setAttribute("aria-busy", `${busy}`);
  if (busy) changed();
}

/** Those that need the whole run: while a wall or a slider is dragged, they wait. */
const calm = {
  cell: new CellFigure(lab, changed),
  whatIf: new WhatIf(lab, changed),
};
let calmVersion = lab.version;
let seenVersion = lab.version;
const calmDown = afterPause();
const quiet = afterPause();

/** @param {{render: () => void}[]} figures */
function draw(figures) {
  for (const figure of figures) figure.render();
}

function drawCalm() {
  calmVersion = lab.version;
  draw(Object.values(calm));
}

/** Runs what it was given last, after a pause. */
function afterPause() {
  let timer = 0;
  return (/** @type {() => void} */ run) => {
    window.clearTimeout(timer);
    timer = window.setTimeout(run, PAUSE);
  };
}

/** The address follows the page only after the reader has done something. */
let own = false;

/** What must not follow every frame: the hash and the address. */
function settle() {
  const { now } = lab.maps();
  const place = `scan ${lab.scan}, beam ${lab.beam}${lab.free ? ", and the robot where you have put it" : ""}`;
  setText(element("hash"), `${hashOfMap(now)} (${place})`);
  const address = addressNow();
  if ((own || address !== opened) && address !== location.hash)
    history.replaceState(null, "", address);
  own = true;
}

function addressNow() {
  if (lab.cell.gx !== start.gx || lab.cell.gy !== start.gy)
    touched.add("cell");
  return addressOf(lab, touched);
}

function follow() {
  const section = readAddress(lab, location.hash);
  calmVersion = lab.version;
  changed();
  if (section !== null && section !== "world") {
    requestAnimationFrame(() => element(section).scrollIntoView());
  }
}

lab.goTo(24, lab.beams);
addEventListener("hashchange", follow);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
follow();
/** What the page shows before the reader does anything. */
const opened = addressNow();

// for tests: what the page shows, in numbers
Object.assign(window, {
  occgridPage: {
    lab,
    figures: { ...live, map, ...calm },
    mistakes: Array.from(MISTAKES.keys()),
    frame,
    /** Whether the map is still to come. */
    busy: () => busy,
    render: () => {
      draw(Object.values(live));
      map.show(lab.moment);
      drawCalm();
    },
    hash: () => hashOfMap(lab.maps().now),
    address: () => addressOf(lab, touched),
  },
});
