/** Time: play, steps, the two sliders. */

import { button, byId, element, input, setText } from "../shared/dom.js";

/** @typedef {import("./lab.js").Lab} Lab */

export class Transport {
  #due = 0;
  #last = 0;

  /** @param {Lab} lab @param {() => void} changed */
  constructor(lab, changed) {
    this.lab = lab;
    this.changed = changed;
    this.place = document.body; // keys of the world press its buttons, too
    this.speed = byId("speed", HTMLSelectElement);
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.speed.value = "scan 1";
    }
    const act = (/** @type {() => void} */ step) => () => {
      lab.playing = false;
      lab.free = null;
      lab.line = null;
      step();
      this.#announce();
      changed();
    };
    const on = (/** @type {string} */ id, /** @type {() => void} */ step) =>
      button(id).addEventListener("click", act(step));
    on("scan-back", () =>
      lab.scan > 1 ? lab.goTo(lab.scan - 1) : lab.goTo(1, 0),
    );
    on("scan-on", () =>
      lab.goTo(lab.beam < lab.beams ? lab.scan : lab.scan + 1),
    );
    on("beam-back", () => lab.moveBeam(-1));
    on("beam-on", () => lab.moveBeam(1));
    button("play").addEventListener("click", () => this.toggle());
    input("scan").addEventListener(
      "input",
      act(() => lab.goTo(input("scan").valueAsNumber)),
    );
    input("beam").addEventListener(
      "input",
      act(() => lab.goTo(lab.scan, input("beam").valueAsNumber)),
    );
  }

  toggle() {
    const { lab } = this;
    lab.playing = !lab.playing;
    if (lab.playing) {
      lab.free = null;
      lab.line = null;
      if (lab.atEnd) lab.goTo(1, 0);
      this.#due = 0;
      this.#last = performance.now();
      requestAnimationFrame((now) => this.#tick(now));
    } else {
      this.#announce();
    }
    this.changed();
  }

  /** @param {number} now */
  #tick(now) {
    const { lab } = this;
    if (!lab.playing) return;
    const [unit, rate] = this.speed.value.split(" ");
    this.#due += (Math.min(now - this.#last, 250) / 1000) * Number(rate);
    this.#last = now;
    for (; this.#due >= 1 && !lab.atEnd; this.#due--) {
      if (unit === "beam") lab.moveBeam(1);
      else lab.goTo(lab.beam < lab.beams ? lab.scan : lab.scan + 1);
    }
    if (lab.atEnd) {
      lab.playing = false;
      this.#announce();
    }
    this.changed();
    requestAnimationFrame((next) => this.#tick(next));
  }

  #announce() {
    const { lab } = this;
    setText(
      element("announce"),
      `Scan ${lab.scan} of ${lab.count}, beam ${lab.beam} of ${lab.beams}.`,
    );
  }

  render() {
    const { lab } = this;
    const [scan, beam] = [input("scan"), input("beam")];
    scan.max = `${lab.count}`;
    scan.value = `${lab.scan}`;
    beam.max = `${lab.beams}`;
    beam.value = `${lab.beam}`;
    setText(element("scan-text"), `scan ${lab.scan} of ${lab.count}`);
    setText(element("beam-text"), `beam ${lab.beam} of ${lab.beams}`);
    const play = button("play");
    setText(play, lab.playing ? "❚❚ Pause" : "▶ Play");
    play.setAttribute("aria-label", lab.playing ? "Pause" : "Play");
    button("beam-back").disabled = lab.scan === 1 && lab.beam === 0;
    button("scan-back").disabled = lab.scan === 1 && lab.beam === 0;
    button("beam-on").disabled = lab.atEnd;
    button("scan-on").disabled = lab.atEnd;
  }
}
