/** play.html: the lesson's figures, held together by one lab. */

import { MISTAKES } from "../model/mistakes.js";
import { hashOfMap } from "../model/sha256.js";
import { element, sayAfterKeys, setText } from "../shared/dom.js";
import { addressOf, readAddress } from "./address.js";
import { CellFigure } from "./cellFigure.js";
import { Lab } from "./lab.js";
import { LineFigure } from "./lineFigure.js";
import { MapView } from "./mapView.js";
import { notPossible, SettingsPanel } from "./settingsPanel.js";
import { Stage } from "./stage.js";
import { Transport } from "./transport.js";
import { WhatIf } from "./whatIf.js";
import { WorldPanel } from "./worldPanel.js";
import { WorldView } from "./worldView.js";

const lab = new Lab();
const stage = new Stage(lab, settle);
const { changed } = stage;

const figures = {
  world: new WorldView(lab, changed),
  map: new MapView(lab, changed),
  transport: new Transport(lab, changed),
  settings: new SettingsPanel(lab, changed),
  walls: new WorldPanel(lab, changed),
  line: new LineFigure(lab, changed),
  cell: new CellFigure(lab, changed),
  whatIf: new WhatIf(lab, changed),
};
stage.show(Object.values(figures));
for (const name of ["world", "map", "wrong"]) {
  sayAfterKeys(
    element(`${name}-view`),
    element(`${name}-words`),
    element("announce"),
  );
}

/** The address follows the page only after the reader has done something. */
let own = false;

/** What must not follow every frame: the hash and the address. */
function settle() {
  const { now } = lab.maps();
  const place = `scan ${lab.scan}, beam ${lab.beam}${lab.free ? ", and the robot where you have put it" : ""}`;
  setText(element("hash"), `${hashOfMap(now)} (${place})`);
  const address = addressOf(lab);
  if ((own || address !== opened) && address !== location.hash)
    history.replaceState(null, "", address);
  own = true;
}

/** Shows what the address says. @returns {string} the section that it is about */
function follow() {
  setText(element("settings-words"), "");
  const section = readAddress(lab, location.hash, (error) =>
    setText(
      element("settings-words"),
      `The address asks for other settings. ${notPossible(error)}`,
    ),
  );
  stage.opensHere();
  changed();
  return section ?? "world";
}

/** @param {string} section */
function scrollTo(section) {
  if (section === "world") return;
  requestAnimationFrame(() => element(section).scrollIntoView());
}

addEventListener("hashchange", () => scrollTo(follow()));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
const section = follow();
// a page that is loaded again stays where it was
const [navigation] = performance.getEntriesByType("navigation");
const { type } = /** @type {PerformanceNavigationTiming} */ (navigation);
if (type === "navigate") scrollTo(section);
/** What the page shows before the reader does anything. */
const opened = addressOf(lab);

// for tests: what the page shows, in numbers
Object.assign(window, {
  occgridPage: {
    lab,
    figures,
    mistakes: Array.from(MISTAKES.keys()),
    stage,
    /** Whether a figure is still to be drawn. */
    busy: () => stage.isWaiting,
    render: () => stage.drawAll(),
    hash: () => hashOfMap(lab.maps().now),
    address: () => addressOf(lab),
  },
});
