/** Small helpers for pages. */

/**
 * The element with an id.
 *
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function byId(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`no ${type.name} #${id}`);
  return found;
}

/** @param {string} id */
export const button = (id) => byId(id, HTMLButtonElement);
/** @param {string} id */
export const input = (id) => byId(id, HTMLInputElement);
/** @param {string} id */
export const element = (id) => byId(id, HTMLElement);

/**
 * A new element.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string | number | boolean>} attributes true sets one without a value, false leaves it out
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false)
      made.setAttribute(name, value === true ? "" : `${value}`);
  }
  made.append(...children);
  return made;
}

/** Sets text where it is another: assistive technology reads a status again whenever it is set. */
export function setText(
  /** @type {Element} */ node,
  /** @type {string} */ text,
) {
  if (node.textContent !== text) node.textContent = text;
}

/**
 * A function that runs once before the next frame, however often it was asked for.
 *
 * @param {() => void} run
 */
export function onceAFrame(run) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      run();
    });
  };
}

/** How wide an element is inside its border. Looking it up for every frame would cost a layout each time. */
export class ShownWidth {
  #element;
  #width = 0;

  /** @param {Element} element @param {() => void} changed */
  constructor(element, changed) {
    this.#element = element;
    new ResizeObserver(() => {
      this.#width = element.clientWidth;
      changed();
    }).observe(element);
  }

  /** Pixels of the page. */
  get value() {
    if (this.#width === 0) this.#width = this.#element.clientWidth;
    return this.#width;
  }

  /**
   * How wide to draw a picture, in its own units: as it is shown, so that its letters keep their size.
   *
   * @param {number} most
   */
  drawn(most) {
    return Math.min(Math.max(this.value, 280), most);
  }
}

/** Hands a text to the reader as a file. @param {string} name @param {string} text */
export function save(name, text) {
  const link = make("a", {
    href: URL.createObjectURL(new Blob([text], { type: "text/plain" })),
    download: name,
  });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/**
 * A place to drop a file on, and its input.
 *
 * @param {HTMLElement} place
 * @param {HTMLInputElement} chooser
 * @param {(name: string, bytes: Uint8Array) => void} take
 * @param {(name: string) => void} fail gets a file that cannot be read, or a folder
 */
export function takeFiles(place, chooser, take, fail) {
  const read = async (/** @type {File | undefined} */ file) => {
    if (!file) return;
    let bytes;
    try {
      bytes = new Uint8Array(await file.arrayBuffer());
    } catch {
      fail(file.name);
      return;
    }
    take(file.name, bytes);
  };
  chooser.addEventListener("change", () => {
    read(chooser.files?.[0]);
    chooser.value = ""; // the same file can be chosen again
  });
  for (const name of ["dragenter", "dragover"]) {
    place.addEventListener(name, (event) => {
      event.preventDefault();
      place.classList.add("over");
    });
  }
  place.addEventListener("dragleave", () => place.classList.remove("over"));
  place.addEventListener("drop", (event) => {
    event.preventDefault();
    place.classList.remove("over");
    read(event.dataTransfer?.files[0]);
  });
}

const dark = matchMedia("(prefers-color-scheme: dark)");
/** @type {Map<string, string>} */
const known = new Map();
dark.addEventListener("change", () => known.clear());

/** A colour of the scheme at hand, by its name in shared/style.css. @param {string} name */
export function colour(name) {
  let value = known.get(name);
  if (value === undefined) {
    const style = getComputedStyle(document.documentElement);
    value = style.getPropertyValue(`--${name}`);
    known.set(name, value);
  }
  return value;
}
