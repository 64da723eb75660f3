/** Numbers in words for readers. */

/** A number with a true minus sign, for reading. @param {number} value @param {number} digits */
export function shown(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0
    ? text.replace("-", "")
    : text.replace("-", "\u2212");
}

/** Thousands apart. @param {number} n */
export function counted(n) {
  return n.toLocaleString("en");
}

/** @param {number} n @param {string} one @param {string} [many] */
export function plural(n, one, many = `${one}s`) {
  return `${counted(n)} ${n === 1 ? one : many}`;
}
