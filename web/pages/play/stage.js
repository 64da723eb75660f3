/**
 * When each figure is drawn. What is in sight follows every frame; the rest waits until the page rests, or comes into
 * sight. Where the whole map changes, as when a wall is dragged, it is mapped in slices between frames, so that what is
 * dragged never waits for it.
 */

import { element, onceAFrame } from "../shared/dom.js";

/** @typedef {import("./lab.js").Lab} Lab */
/**
 * @typedef {object} Figure
 * @property {() => void} render
 * @property {HTMLElement} place what the reader sees of it
 * @property {boolean} [whole] it needs all scans, and waits while walls or settings change
 */

/** How long the page waits for more, in milliseconds, before it does what takes longer. */
const PAUSE = 120;
/** How long it maps at a time, in milliseconds; 16 lie between two frames. */
const SLICE = 3;

export class Stage {
  /** @type {Figure[]} */
  #figures = [];
  /** Figures that have not been drawn since something changed. @type {Set<Figure>} */
  #waiting = new Set();
  /** @type {Set<Element>} */
  #inSight = new Set();
  #timer = 0;
  /** The lab's version when the page rested last. */
  #version = -1;
  /** Whether the map has been behind since then. */
  #late = false;
  #isOpen = false;

  /** @param {Lab} lab @param {() => void} settle does what is only done when the page rests */
  constructor(lab, settle) {
    this.lab = lab;
    this.settle = settle;
    this.changed = onceAFrame(() => this.frame());
    this.mapOn = betweenFrames(() => {
      const { mapped } = lab;
      lab.mapOn(SLICE);
      if (lab.mapped !== mapped) this.changed();
      else this.mapOn();
    });
    this.watch = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) {
          if (isIntersecting) this.#inSight.add(target);
          else this.#inSight.delete(target);
        }
        if (this.isWaiting) this.changed();
      },
      { rootMargin: "50px" },
    );
  }

  /** @param {Figure[]} figures */
  show(figures) {
    this.#figures = figures;
    for (const { place } of figures) {
      this.#inSight.add(place); // until the observer has looked
      this.watch.observe(place);
    }
  }

  /** Whether a figure has still to be drawn as things are now. */
  get isWaiting() {
    return this.#waiting.size > 0 || !this.lab.isMapped;
  }

  /** Takes what has just changed for a state that the page opens in, not for a step of a drag. */
  opensHere() {
    this.#version = this.lab.version;
  }

  frame() {
    const { lab } = this;
    if (!this.#isOpen) this.drawAll(); // a page opens whole
    this.#isOpen = true;
    const isMapped = lab.mapOn(SLICE);
    const moves = lab.version !== this.#version || !isMapped;
    for (const figure of this.#figures) {
      const { place, whole } = figure;
      if (this.#isSeen(place) && !(whole && moves)) {
        this.#draw(figure);
      } else {
        this.#waiting.add(figure);
        if (whole) place.setAttribute("aria-busy", `${moves}`);
      }
    }
    this.#tellLate(!isMapped);
    window.clearTimeout(this.#timer);
    if (!isMapped) this.mapOn();
    else if (!lab.playing) {
      this.#timer = window.setTimeout(() => this.#rest(), PAUSE);
    }
  }

  /** Draws all figures as things are now. */
  drawAll() {
    this.#version = this.lab.version;
    this.lab.mapOn(Infinity);
    for (const figure of this.#figures) this.#draw(figure);
  }

  #rest() {
    this.#version = this.lab.version;
    for (const figure of this.#waiting) this.#draw(figure);
    this.#late = false;
    this.#tellLate(false);
    this.settle();
  }

  /** @param {Figure} figure */
  #draw(figure) {
    figure.render();
    this.#waiting.delete(figure);
    if (figure.whole) figure.place.setAttribute("aria-busy", "false");
  }

  /** @param {HTMLElement} place */
  #isSeen(place) {
    return this.#inSight.has(place) || place.contains(document.activeElement);
  }

  /** Says that the map is behind, and leaves it said until the page rests. @param {boolean} isLate */
  #tellLate(isLate) {
    this.#late ||= isLate;
    element("map-late").hidden = !this.#late;
    element("map-words").setAttribute("aria-busy", `${isLate}`);
  }
}

/** A function that runs once between two frames, after what waits there already. @param {() => void} run */
function betweenFrames(run) {
  const { port1, port2 } = new MessageChannel();
  let asked = false;
  port1.addEventListener("message", () => {
    asked = false;
    run();
  });
  port1.start();
  return () => {
    if (asked) return;
    asked = true;
    port2.postMessage(null);
  };
}
