/**
 * Paths as the system has them: any bytes but NUL. Node decodes arguments as UTF-8 and loses what is not; so a path here
 * is a string with one character for each byte, which becomes bytes again where a file is opened or a message printed.
 */

import { readFileSync } from "node:fs";

/**
 * The command line's arguments, a character for each byte.
 *
 * @returns {string[]}
 */
export function byteArguments() {
  const decoded = process.argv.slice(2);
  const asBytes = decoded.map((argument) => fromText(argument));
  if (!decoded.some((argument) => argument.includes("\ufffd"))) return asBytes;
  try {
    // Linux keeps what was given
    const all = readFileSync("/proc/self/cmdline", "latin1").split("\0");
    const given = all.slice(0, -1).slice(-decoded.length);
    const same = given.every((argument, i) => toText(argument) === decoded[i]);
    return same ? given : asBytes;
  } catch {
    return asBytes; // names no file, which is an error like any other
  }
}

/** @param {string} text @returns {string} its bytes in UTF-8, a character for each */
export function fromText(text) {
  return Buffer.from(text, "utf8").toString("latin1");
}

/** @param {string} path a character for each byte @returns {string} the text of these bytes */
function toText(path) {
  return toBytes(path).toString("utf8");
}

/** @param {string} path a character for each byte @returns {Buffer} */
export function toBytes(path) {
  return Buffer.from(path, "latin1");
}
