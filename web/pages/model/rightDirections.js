/** Cosine and sine of the directions of beams in the world, by formulas that are as right as the contract's. */

import { PI } from "../../src/portableMath.js";

/** @typedef {import("./rightFormulas.js").Functions} Functions */
/** @typedef {import("../../src/fast.js").Directions} Directions */

/**
 * @typedef {object} Fan
 * @property {number} theta the heading
 * @property {Float64Array} angles the bearings
 * @property {Functions} functions
 */

const TURN = 2 * PI;

/** first, first + step, first + step + step, ... @param {number} first @param {number} step @param {number} count */
export function addedUp(first, step, count) {
  const values = new Float64Array(count);
  let value = first;
  for (let i = 0; i < count; i++) {
    values[i] = value;
    value += step;
  }
  return values;
}

/** @param {Float64Array} angles @param {Functions} functions @returns {Directions} */
export function directed(angles, { cos, sin }) {
  return { c: angles.map((a) => cos(a)), s: angles.map((a) => sin(a)) };
}

/** Less a whole turn where it is more than half a turn. @param {number} angle */
function above(angle) {
  return angle > PI ? angle - TURN : angle;
}

/** The remainder that is not negative. @param {number} angle */
function positive(angle) {
  const rest = angle % TURN;
  return rest < 0 ? rest + TURN : rest;
}

/** A formula of heading and bearing. @param {(theta: number, angle: number) => number} formula @returns {(fan: Fan) => Directions} */
function sum(formula) {
  return ({ theta, angles, functions }) =>
    directed(
      angles.map((angle) => formula(theta, angle)),
      functions,
    );
}

/** @type {Record<string, (fan: Fan) => Directions>} */
export const DIRECTIONS = {
  "heading + bearing": sum((theta, angle) => theta + angle),
  "the remainder of heading + bearing by 2 pi": sum(
    (theta, angle) => (theta + angle) % TURN,
  ),
  "the positive remainder of heading + bearing by 2 pi": sum((theta, angle) =>
    positive(theta + angle),
  ),
  "atan2 of the sine and cosine of heading + bearing": ({
    theta,
    angles,
    functions,
  }) => {
    const { cos, sin } = functions;
    const found = angles.map((angle) =>
      Math.atan2(sin(theta + angle), cos(theta + angle)),
    );
    return directed(found, functions);
  },
  "heading + bearing, less 2 pi where above pi": sum((theta, angle) =>
    above(theta + angle),
  ),
  "heading, less 2 pi where above pi, + bearing": sum(
    (theta, angle) => above(theta) + angle,
  ),
  "a rotation matrix": ({ theta, angles, functions }) => {
    const [c, s] = [functions.cos(theta), functions.sin(theta)];
    const beams = directed(angles, functions);
    return {
      c: beams.c.map((cos, i) => c * cos - s * beams.s[i]),
      s: beams.c.map((cos, i) => s * cos + c * beams.s[i]),
    };
  },
  "the first beam's direction + i steps": ({ theta, angles, functions }) => {
    const first = angles[0];
    const found = angles.map((angle) => theta + first + (angle - first));
    return directed(found, functions);
  },
  "the first beam's direction, and steps added up": ({
    theta,
    angles,
    functions,
  }) => {
    const n = angles.length;
    const step = n > 1 ? (angles[n - 1] - angles[0]) / (n - 1) : 0;
    return directed(addedUp(theta + angles[0], step, n), functions);
  },
};
