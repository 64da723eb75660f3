/** Writing that notices when it fails: Node's streams put a failed write off, and cut a text short at the exit. */

import { writeSync } from "node:fs";

/** A folder, file or stream that cannot be written; its message is `PATH: cannot be written`. */
export class WriteError extends Error {
  /** @param {string} path as it is printed */
  constructor(path) {
    super(`${path}: cannot be written`);
    this.name = "WriteError";
  }
}

const FULL = 1 << 16;
const wait = new Int32Array(new SharedArrayBuffer(4));

/**
 * Writes all bytes.
 *
 * @param {number} file descriptor
 * @param {Uint8Array} bytes
 */
export function writeAll(file, bytes) {
  let done = 0;
  while (done < bytes.length) {
    try {
      done += writeSync(file, bytes, done);
    } catch (error) {
      // a pipe that somebody else has set not to wait
      if (/** @type {NodeJS.ErrnoException} */ (error).code !== "EAGAIN") {
        throw error;
      }
      Atomics.wait(wait, 0, 0, 5);
    }
  }
}

/**
 * Joins lines into larger pieces.
 *
 * @param {Iterable<string>} lines a character for each byte
 * @returns {Generator<Buffer>}
 */
export function* pieces(lines) {
  let text = "";
  for (const line of lines) {
    text += line;
    if (text.length >= FULL) {
      yield Buffer.from(text, "latin1");
      text = "";
    }
  }
  yield Buffer.from(text, "latin1");
}

/**
 * Writes to standard output.
 *
 * @param {Iterable<string>} lines
 * @throws {WriteError}
 */
export function print(lines) {
  try {
    for (const piece of pieces(lines)) writeAll(1, piece);
  } catch {
    throw new WriteError("standard output");
  }
}

/**
 * Writes a message to standard error; where that fails, nobody can be asked.
 *
 * @param {string} text a character for each byte
 */
export function complain(text) {
  try {
    writeAll(2, Buffer.from(text, "latin1"));
  } catch {
    // the exit status says it all the same
  }
}
