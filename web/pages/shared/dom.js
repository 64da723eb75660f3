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

/** Until a picture that a key has changed has its words. */
const UNTIL_SAID = 250;

/**
 * Says what a picture shows after a key has changed it: a description that changes is not read out by itself.
 *
 * @param {HTMLElement} picture
 * @param {HTMLElement} words that describe it
 * @param {HTMLElement} live what is read out when it changes
 */
export function sayAfterKeys(picture, words, live) {
  let timer = 0;
  picture.addEventListener("keydown", ({ key }) => {
    if (!/^(Arrow.*|Escape|[qe])$/i.test(key)) return;
    window.clearTimeout(timer);
    timer = window.setTimeout(
      () => setText(live, words.textContent ?? ""),
      UNTIL_SAID,
    );
  });
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
 * A place for a file, and its input. A file can be dropped anywhere on the page: beside the place, the browser would open
 * it and leave the page.
 *
 * @param {HTMLElement} place
 * @param {HTMLInputElement} chooser
 * @param {number} most bytes
 * @param {(name: string, bytes: Uint8Array) => void} take
 * @param {(name: string, why: string) => void} fail gets what cannot be taken
 */
export function takeFiles(place, chooser, most, take, fail) {
  const read = async (/** @type {FileList | undefined} */ files) => {
    const [file] = files ?? [];
    if (!file) return;
    if (files && files.length > 1) {
      fail(`${files.length} files`, "This page takes one file at a time.");
    } else if (file.size > most) {
      const size = Math.ceil(file.size / 1e6);
      fail(file.name, `It has ${size} MB; this page takes ${most / 1e6} MB.`);
    } else {
      let bytes;
      try {
        bytes = new Uint8Array(await file.arrayBuffer());
      } catch {
        fail(
          file.name,
          "It may be a folder, or a file that has just changed.",
        );
        return;
      }
      take(file.name, bytes);
    }
  };
  chooser.addEventListener("change", async () => {
    await read(chooser.files ?? undefined);
    chooser.value = ""; // the same file can be chosen again
  });
  const isFile = (/** @type {DragEvent} */ event) =>
    event.dataTransfer?.types.includes("Files");
  for (const name of /** @type {const} */ (["dragenter", "dragover"])) {
    document.addEventListener(name, (event) => {
      if (!isFile(event)) return;
      event.preventDefault();
      place.classList.add("over");
    });
  }
  document.addEventListener("dragleave", (event) => {
    // from one element to the next it stays over the page
    if (event.relatedTarget === null) place.classList.remove("over");
  });
  document.addEventListener("drop", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    place.classList.remove("over");
    read(event.dataTransfer?.files);
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
