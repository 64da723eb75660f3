/** SHA-256 (FIPS 180-4): browsers offer theirs to secure pages only, and a file may not be one. */

/** The first 32 bits of the fractional parts of roots of primes, by whole numbers only. */
function fractions(/** @type {number} */ count, /** @type {bigint} */ power) {
  const found = [];
  for (let n = 2n; found.length < count; n++) {
    let isPrime = true;
    for (let d = 2n; d * d <= n; d++) if (n % d === 0n) isPrime = false;
    if (!isPrime) continue;
    // floor(n^(1/power) 2^32)
    const target = n << (32n * power);
    let low = 0n;
    let high = 1n << 40n;
    while (high - low > 1n) {
      const middle = (low + high) >> 1n;
      if (middle ** power <= target) low = middle;
      else high = middle;
    }
    found.push(Number(low & 0xffffffffn));
  }
  return Uint32Array.from(found);
}

const START = fractions(8, 2n);
const ROUND = fractions(64, 3n);

/**
 * @param {Uint8Array} message
 * @returns {string} 64 hexadecimal digits
 */
export function sha256(message) {
  const blocks = Math.ceil((message.length + 9) / 64);
  const padded = new Uint8Array(64 * blocks);
  padded.set(message);
  padded[message.length] = 0x80;
  const view = new DataView(padded.buffer);
  view.setUint32(64 * blocks - 8, Math.floor(message.length / 2 ** 29));
  view.setUint32(64 * blocks - 4, (message.length * 8) >>> 0);
  const hash = START.slice();
  const w = new Int32Array(64);
  const turn = (/** @type {number} */ x, /** @type {number} */ n) =>
    (x >>> n) | (x << (32 - n));
  for (let block = 0; block < blocks; block++) {
    for (let i = 0; i < 16; i++) w[i] = view.getInt32(64 * block + 4 * i);
    for (let i = 16; i < 64; i++) {
      const s0 = turn(w[i - 15], 7) ^ turn(w[i - 15], 18) ^ (w[i - 15] >>> 3);
      const s1 = turn(w[i - 2], 17) ^ turn(w[i - 2], 19) ^ (w[i - 2] >>> 10);
      w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    let [a, b, c, d, e, f, g, h] = hash;
    for (let i = 0; i < 64; i++) {
      const s1 = turn(e, 6) ^ turn(e, 11) ^ turn(e, 25);
      const choice = (e & f) ^ (~e & g);
      const t1 = (h + s1 + choice + ROUND[i] + w[i]) | 0;
      const s0 = turn(a, 2) ^ turn(a, 13) ^ turn(a, 22);
      const majority = (a & b) ^ (a & c) ^ (b & c);
      h = g;
      g = f;
      f = e;
      e = (d + t1) | 0;
      d = c;
      c = b;
      b = a;
      a = (t1 + s0 + majority) | 0;
    }
    [a, b, c, d, e, f, g, h].forEach((value, i) => {
      hash[i] += value;
    });
  }
  return Array.from(hash, (word) => word.toString(16).padStart(8, "0")).join(
    "",
  );
}

/** As the golden results have it. @param {Float64Array} logOdds */
export function hashOfMap(logOdds) {
  const bytes = new DataView(new ArrayBuffer(8 * logOdds.length));
  logOdds.forEach((value, i) => {
    bytes.setFloat64(8 * i, value, true);
  });
  return sha256(new Uint8Array(bytes.buffer));
}
