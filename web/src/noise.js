/**
 * Range noise that depends on nothing but the seed, the scan and the beam
 * (SPEC.md section 3.3; lesson section 6.3).
 */

import { cos, log, PI } from "./portableMath.js";

// [snippet: philox]
const PHILOX_M0 = 0xd2511f53;
const PHILOX_M1 = 0xcd9e8d57;
const PHILOX_W0 = 0x9e3779b9;
const PHILOX_W1 = 0xbb67ae85;

/**
 * Philox4x32-10 (Salmon et al. 2011): four random words per counter.
 *
 * @param {ArrayLike<number>} counter four words, 0 to 2^32 - 1
 * @param {ArrayLike<number>} key two words
 * @returns {[number, number, number, number]} four words
 */
export function philox4x32(counter, key) {
  let [c0, c1, c2, c3] = Array.from(counter);
  let [k0, k1] = Array.from(key);
  for (let round = 0; round < 10; round++) {
    const high0 = highProduct(PHILOX_M0, c0);
    const low0 = Math.imul(PHILOX_M0, c0);
    const high1 = highProduct(PHILOX_M1, c2);
    const low1 = Math.imul(PHILOX_M1, c2);
    c0 = (high1 ^ c1 ^ k0) >>> 0;
    c1 = low1 >>> 0;
    c2 = (high0 ^ c3 ^ k1) >>> 0;
    c3 = low0 >>> 0;
    k0 = (k0 + PHILOX_W0) >>> 0;
    k1 = (k1 + PHILOX_W1) >>> 0;
  }
  return [c0, c1, c2, c3];
}

/** The upper 32 of the 64 bits of a product: school method in halves. */
function highProduct(/** @type {number} */ a, /** @type {number} */ b) {
  const [aHigh, aLow] = [a >>> 16, a & 0xffff];
  const [bHigh, bLow] = [b >>> 16, b & 0xffff];
  const low = aLow * bLow;
  const middle1 = aHigh * bLow + (low >>> 16);
  const middle2 = aLow * bHigh + (middle1 & 0xffff);
  return aHigh * bHigh + (middle1 >>> 16) + (middle2 >>> 16);
}
// [/snippet]

// [snippet: normal-deviate]
/**
 * A standard normal deviate (Box and Muller 1958).
 *
 * @param {number} seed from 0 to 2^32 - 1
 * @param {number} scan the scan's number, from 0
 * @param {number} beam the beam's number in its scan, from 0
 * @returns {number} the deviate of this beam
 */
export function normalDeviate(seed, scan, beam) {
  const counter = [scan >>> 0, beam >>> 0, 0, 0];
  const [w0, w1] = philox4x32(counter, [seed >>> 0, 0]);
  const u1 = (w0 + 0.5) / 4294967296;
  const u2 = (w1 + 0.5) / 4294967296;
  return Math.sqrt(-2 * log(u1)) * cos(2 * PI * u2);
}
// [/snippet]

// [snippet: range-noise]
/**
 * Ranges of a simulated scan with noise, kept within [0, zMax]. A beam
 * that met no wall gets noise too, as in the lesson.
 *
 * @param {Float64Array} ranges (n) metres
 * @param {number} noiseStd standard deviation, metres
 * @param {number} seed from 0 to 2^32 - 1
 * @param {number} scan the scan's number, from 0
 * @param {number} zMax the sensor's maximum range, metres
 * @returns {Float64Array} (n) metres; the argument is not changed
 */
export function addRangeNoise(ranges, noiseStd, seed, scan, zMax) {
  return ranges.map((range, beam) => {
    const noise = noiseStd * normalDeviate(seed, scan, beam);
    return noisyRange(range, noise, zMax);
  });
}

/** A range with its noise, within [0, zMax]; all in metres. */
export function noisyRange(
  /** @type {number} */ range,
  /** @type {number} */ noise,
  /** @type {number} */ zMax,
) {
  return Math.min(Math.max(range + noise, 0), zMax);
}
// [/snippet]
