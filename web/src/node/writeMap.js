/** Writing a map's files into a folder, all of them or none (SPEC.md section 7). */

import {
  closeSync,
  lstatSync,
  mkdirSync,
  openSync,
  readdirSync,
  renameSync,
  statSync,
  unlinkSync,
} from "node:fs";
import { setImmediate } from "node:timers/promises";
import { mapLogOdds, mapPgm, mapYaml } from "../mapWriter.js";
import { printable } from "../scenario.js";
import { pieces, WriteError, writeAll } from "./output.js";
import { toBytes } from "./paths.js";

/** @typedef {import("../grid.js").OccupancyGrid} OccupancyGrid */

const TEMPORARY = /^\.occgrid-[A-Za-z0-9-]{0,40}\.part$/;
const OLD = 24 * 60 * 60 * 1000;
/** @type {NodeJS.Signals[]} */
const SIGNALS = ["SIGINT", "SIGTERM", "SIGHUP"];

/**
 * Writes NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is made where it is missing. Each file is renamed
 * into place when all of them are whole.
 *
 * It gives way to signals now and then, and removes what it has begun when one ends the program.
 *
 * @param {string} folder a character for each byte, as all names here
 * @param {string} name the files' name
 * @param {OccupancyGrid} grid the map
 * @throws {WriteError}
 */
export async function writeMap(folder, name, grid) {
  const bare = folder.replace(/\/+$/, "") || (folder === "" ? "" : "/");
  const inFolder = bare === "/" ? "/" : `${bare}/`;
  makeFolder(bare);
  removeOld(inFolder);
  const image = `${name}.pgm`;
  /** @type {{file: string, lines: Iterable<string>, temporary: string}[]} */
  const files = [
    { file: image, lines: mapPgm(grid), temporary: "" },
    { file: `${name}.yaml`, lines: [mapYaml(grid, image)], temporary: "" },
    { file: `${name}.logodds`, lines: mapLogOdds(grid), temporary: "" },
  ];
  const cleanUp = () => {
    for (const { temporary } of files) {
      if (temporary !== "") remove(temporary);
    }
  };
  const stop = (/** @type {NodeJS.Signals} */ signal) => {
    cleanUp();
    for (const one of SIGNALS) process.removeListener(one, stop);
    process.kill(process.pid, signal);
  };
  for (const signal of SIGNALS) process.on(signal, stop);
  let current = "";
  try {
    for (const [number, entry] of files.entries()) {
      current = entry.file;
      const start = `${inFolder}.occgrid-${process.pid}-${number}-`;
      const file = openNew(start, (path) => {
        entry.temporary = path;
      });
      try {
        for (const piece of pieces(entry.lines)) {
          writeAll(file, piece);
          await setImmediate(); // where signals come in
        }
      } finally {
        closeSync(file);
      }
    }
    for (const { file } of files) {
      current = file;
      if (isFolder(inFolder + file)) throw new Error("is a folder");
    }
    /** @type {string[]} */
    const renamed = [];
    for (const { file, temporary } of files) {
      current = file;
      try {
        renameSync(toBytes(temporary), toBytes(inFolder + file));
      } catch (error) {
        for (const path of renamed) remove(path);
        throw error;
      }
      renamed.push(inFolder + file);
    }
  } catch {
    cleanUp();
    throw new WriteError(printable(inFolder + current));
  } finally {
    for (const signal of SIGNALS) process.removeListener(signal, stop);
  }
}

/** @param {string} folder */
function makeFolder(folder) {
  try {
    mkdirSync(toBytes(folder), { recursive: true });
    if (!statSync(toBytes(folder)).isDirectory()) throw new Error("no folder");
  } catch {
    throw new WriteError(printable(folder));
  }
}

/**
 * Opens a file that was not there.
 *
 * @param {string} start of its path
 * @param {(path: string) => void} note is called before the file is made
 * @returns {number} descriptor
 */
function openNew(start, note) {
  for (let tries = 0; ; tries++) {
    const random = Math.floor(Math.random() * 2 ** 32).toString(36);
    const path = `${start}${random}.part`;
    try {
      const file = openSync(toBytes(path), "wx");
      note(path);
      return file;
    } catch (error) {
      const { code } = /** @type {NodeJS.ErrnoException} */ (error);
      if (code !== "EEXIST" || tries === 100) throw error;
    }
  }
}

/** Removes what runs left that were killed more than a day ago. @param {string} inFolder */
function removeOld(inFolder) {
  try {
    for (const entry of readdirSync(toBytes(inFolder), {
      encoding: "latin1",
    })) {
      if (!TEMPORARY.test(entry)) continue;
      const found = lstatSync(toBytes(inFolder + entry));
      if (found.isFile() && Date.now() - found.mtimeMs > OLD) {
        remove(inFolder + entry);
      }
    }
  } catch {
    // they are in nobody's way
  }
}

/** Whether a path is a folder, or a link to one. @param {string} path */
function isFolder(path) {
  return (
    statSync(toBytes(path), { throwIfNoEntry: false })?.isDirectory() ?? false
  );
}

/** @param {string} path */
function remove(path) {
  try {
    unlinkSync(toBytes(path));
  } catch {
    // it is not there, or the error that brought us here matters more
  }
}
