/** Doubles and their bits, as the vectors and the probe write them; hashes of maps. */

import { createHash } from "node:crypto";

const view = new DataView(new ArrayBuffer(8));

/** @param {string} text 16 hexadecimal digits @returns {number} */
export function doubleOf(text) {
  view.setBigUint64(0, BigInt(`0x${text}`));
  return view.getFloat64(0);
}

/** @param {number} value @returns {string} 16 hexadecimal digits; NaN is 7ff8000000000000 */
export function hexOf(value) {
  if (Number.isNaN(value)) return "7ff8000000000000";
  view.setFloat64(0, value);
  return view.getBigUint64(0).toString(16).padStart(16, "0");
}

/** @param {Float64Array} logOdds @returns {string} SHA-256 of their bits, in little-endian order */
export function hashOf(logOdds) {
  const bytes = new DataView(new ArrayBuffer(8 * logOdds.length));
  logOdds.forEach((value, i) => {
    bytes.setFloat64(8 * i, value, true);
  });
  return createHash("sha256")
    .update(new Uint8Array(bytes.buffer))
    .digest("hex");
}
