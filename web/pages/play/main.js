/** play.html: the lesson's figures, held together by one lab. */

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
let idle = 0;

const changed = onceAFrame(() => {
  for (const figure of figures) figure.render();
  window.clearTimeout(idle);
  if (!lab.playing) idle = window.setTimeout(settle, 120);
});

/** What takes longer, or must not follow every frame. */
function settle() {
  const { now } = lab.maps();
  const place = `scan ${lab.scan}, beam ${lab.beam}${lab.free ? ", and the robot where you have put it" : ""}`;
  setText(element("hash"), `${hashOfMap(now)} (${place})`);
  if (lab.cell.gx !== start.gx || lab.cell.gy !== start.gy)
    touched.add("cell");
  const address = addressOf(lab, touched);
  if (own && address !== location.hash)
    history.replaceState(null, "", address);
  own = true;
}

const start = lab.cell;
/** The address follows the page only after the reader has done something. */
let own = false;

const figures = [
  new WorldView(lab, changed),
  new MapView(lab, changed),
  new Transport(lab, changed),
  new SettingsPanel(lab, changed),
  new WorldPanel(lab, changed),
  new LineFigure(lab, changed),
  new CellFigure(lab, changed),
  new WhatIf(lab, changed),
];

function follow() {
  const section = readAddress(lab, location.hash);
  changed();
  if (section !== null && section !== "world") {
    requestAnimationFrame(() => element(section).scrollIntoView());
  }
}

lab.goTo(24, lab.beams);
addEventListener("hashchange", follow);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
follow();

// for tests: what the page shows, in numbers
Object.assign(window, {
  occgridPage: {
    lab,
    changed,
    figures,
    render: () => {
      for (const figure of figures) figure.render();
    },
    hash: () => hashOfMap(lab.maps().now),
    address: () => addressOf(lab, touched),
  },
});
