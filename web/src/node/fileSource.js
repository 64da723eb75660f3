/** A scenario file as a source of bytes. */

import { closeSync, fstatSync, openSync, readSync } from "node:fs";
import { toBytes } from "./paths.js";

const CHUNK = 1 << 18;

/**
 * @param {string} path a character for each byte
 * @returns {import("../lines.js").Source}
 */
export function fileSource(path) {
  return { name: path, chunks: (offset) => chunks(path, offset) };
}

/**
 * @param {string} path
 * @param {number} offset
 * @returns {Generator<Uint8Array>}
 */
function* chunks(path, offset) {
  if (path.endsWith("/")) throw new Error("a path that names a folder");
  const file = openSync(toBytes(path), "r");
  try {
    const seekable = fstatSync(file).isFile();
    if (!seekable && offset > 0) {
      throw new Error("cannot be read a second time");
    }
    let position = offset;
    for (;;) {
      const buffer = new Uint8Array(CHUNK);
      const at = seekable ? position : null;
      const count = readSync(file, buffer, 0, CHUNK, at);
      if (count === 0) return;
      position += count;
      yield buffer.subarray(0, count);
    }
  } finally {
    closeSync(file);
  }
}
