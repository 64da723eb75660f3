/**
 * The mistakes that the pages know, each planted in a step of the contract. Names, titles and what the lesson says are
 * those of docs/mistakes.md.
 */

import catalogue from "docs:mistakes";
import { philox4x32 } from "../../src/noise.js";
import { cos, exp, log, PI, sin } from "../../src/portableMath.js";
import { Pose, raySegmentIntersection } from "../../src/world.js";
import {
  lineFromEnd,
  lineWith,
  roundHalfEven,
  straightLine,
  supercover,
  walkedLine,
} from "./mistakenLines.js";

/** @typedef {import("./mistakenMapper.js").Mistake} Mistake */
/** @typedef {import("./mistakenMapper.js").Steps} Steps */
/** @typedef {import("./mistakenMapper.js").Update} Update */
/** @typedef {import("./mistakenMapper.js").LogOdds} LogOdds */
/** @typedef {import("./mistakenMapper.js").Picture} Picture */

/** Rows and columns of anything that is stored row by row. @template {Float64Array | Uint8Array} T */
function transposed(
  /** @type {T} */ values,
  /** @type {number} */ width,
  /** @type {number} */ height,
) {
  const turned = values.slice();
  for (let i = 0; i < values.length; i++) {
    turned[(i % width) * height + Math.floor(i / width)] = values[i];
  }
  return /** @type {T} */ (turned);
}

/** The floor of the quotient before it is rounded, as Python's // has it. The remainder of % is exact. */
function floorDivision(
  /** @type {number} */ a,
  /** @type {number} positive */ b,
) {
  const remainder = a % b;
  return Math.round((a - remainder) / b) - (remainder < 0 ? 1 : 0);
}

/** Box and Muller's deviate of chosen words. */
function deviateOf(
  /** @type {number} */ first,
  /** @type {number} */ second,
  angle = cos,
  part = 0.5,
) {
  return (
    /** @type {number} */ seed,
    /** @type {number} */ scan,
    /** @type {number} */ beam,
  ) => {
    const words = philox4x32([scan, beam, 0, 0], [seed, 0]);
    const u1 = (words[first] + part) / 4294967296;
    const u2 = (words[second] + part) / 4294967296;
    return Math.sqrt(-2 * log(u1)) * angle(2 * PI * u2);
  };
}

/** Of the cell in which the robot stands. @param {Steps} m @param {Pose} pose */
function centre(m, { x, y }) {
  const { gx, gy } = m.toGrid(x, y);
  const { originX, originY, resolution } = m.settings;
  return {
    x: originX + (gx + 0.5) * resolution,
    y: originY + (gy + 0.5) * resolution,
  };
}

/** The first update of each cell. @param {Update[]} updates */
function firstOfEach(updates) {
  const seen = new Set();
  return updates.filter(({ gx, gy }) => {
    const key = `${gx},${gy}`;
    return !seen.has(key) && seen.add(key);
  });
}

/** @type {Record<string, (m: Steps) => void>} */
const PLANTED = {
  // --- between a point and a cell ---
  "rows-and-columns-swapped": (m) => {
    const { width, height } = m.settings;
    m.place = (gx, gy) =>
      gx >= 0 && gx < height && gy >= 0 && gy < width ? gx * width + gy : -1;
  },
  "picture-transposed": (m) => {
    const { picture } = m;
    m.fileOrder = ({ width, height, values }) => ({
      width: height,
      height: width,
      values: transposed(values, width, height),
    });
    m.picture = (map) => {
      const { width, height, pixels } = picture(map);
      const turned = transposed(pixels, width, height);
      return { width: height, height: width, pixels: turned };
    };
  },
  "y-flipped": (m) => {
    const { picture } = m;
    m.picture = (map) => {
      const { width, height, pixels } = picture(map);
      const flipped = pixels.map(
        (_, i) =>
          pixels[(height - 1 - Math.floor(i / width)) * width + (i % width)],
      );
      return { width, height, pixels: flipped };
    };
  },
  "y-axis-down": (m) => {
    const { toGrid } = m;
    m.toGrid = (x, y) => {
      const { gx, gy } = toGrid(x, y);
      return { gx, gy: m.settings.height - 1 - gy };
    };
  },
  "x-flipped": (m) => {
    const { picture } = m;
    m.picture = (map) => {
      const { width, height, pixels } = picture(map);
      const flipped = pixels.map(
        (_, i) => pixels[i - (i % width) + width - 1 - (i % width)],
      );
      return { width, height, pixels: flipped };
    };
  },
  truncation: (m) => {
    m.index = Math.trunc;
  },
  "off-by-one": (m) => {
    const { index } = m;
    m.index = (cells) => index(cells) + 1;
  },
  "index-rounded": (m) => {
    m.index = (cells) => Math.floor(cells + 0.5);
  },
  "index-rounded-half-even": (m) => {
    m.index = roundHalfEven;
  },
  "index-by-floor-division": (m) => {
    const { resolution, originX, originY } = m.settings;
    m.toGrid = (x, y) => ({
      gx: floorDivision(x - originX, resolution),
      gy: floorDivision(y - originY, resolution),
    });
  },
  "index-by-reciprocal": (m) => {
    const { resolution, originX, originY } = m.settings;
    const perMetre = 1 / resolution;
    m.toGrid = (x, y) => ({
      gx: m.index((x - originX) * perMetre),
      gy: m.index((y - originY) * perMetre),
    });
  },
  "index-by-difference": (m) => {
    const { resolution: r, originX, originY } = m.settings;
    m.toGrid = (x, y) => ({
      gx: m.index(x / r - originX / r),
      gy: m.index(y / r - originY / r),
    });
  },
  "origin-ignored": (m) => {
    const { resolution } = m.settings;
    m.toGrid = (x, y) => ({
      gx: m.index(x / resolution),
      gy: m.index(y / resolution),
    });
  },
  "negative-index-wraps": (m) => {
    const { width: w, height: h } = m.settings;
    m.place = (gx, gy) =>
      gx >= -w && gx < w && gy >= -h && gy < h
        ? ((gy + h) % h) * w + ((gx + w) % w)
        : -1;
  },
  "robot-outside-skipped": (m) => {
    const { width, height } = m.settings;
    const { kept } = m;
    m.kept = (from, to) =>
      kept(from, to) &&
      from.gx >= 0 &&
      from.gx < width &&
      from.gy >= 0 &&
      from.gy < height;
  },
  "end-outside-skipped": (m) => {
    const { width, height } = m.settings;
    const { kept } = m;
    m.kept = (from, to) =>
      kept(from, to) &&
      to.gx >= 0 &&
      to.gx < width &&
      to.gy >= 0 &&
      to.gy < height;
  },
  "ends-moved-into-grid": (m) => {
    const { width, height } = m.settings;
    const { toGrid } = m;
    m.toGrid = (x, y) => {
      const { gx, gy } = toGrid(x, y);
      return {
        gx: Math.min(Math.max(gx, 0), width - 1),
        gy: Math.min(Math.max(gy, 0), height - 1),
      };
    };
  },

  // --- a beam's direction, range and cells ---
  "heading-ignored": (m) => {
    m.direction = (_, angle) => angle;
  },
  "bearings-clockwise": (m) => {
    m.direction = (theta, angle) => theta - angle;
  },
  "radians-as-degrees": (m) => {
    m.direction = (theta, angle) => (theta + angle) * (PI / 180);
  },
  "degrees-for-radians": (m) => {
    m.direction = (theta, angle) => (theta + angle) * (180 / PI);
  },
  "sine-and-cosine-swapped": (m) => {
    m.endpoint = (pose, direction, z) => ({
      x: pose.x + z * sin(direction),
      y: pose.y + z * cos(direction),
    });
  },
  "last-bearing-missing": (m) => {
    const { fov, beams } = m.settings;
    m.bearings = () =>
      new Float64Array(beams).map((_, i) => -(fov / 2) + (fov * i) / beams);
  },
  "bearings-half-a-step-off": (m) => {
    const { fov, beams } = m.settings;
    m.bearings = () =>
      new Float64Array(beams).map(
        (_, i) => -(fov / 2) + (fov * (i + 0.5)) / beams,
      );
  },
  "bearings-from-zero": (m) => {
    const { fov, beams } = m.settings;
    m.bearings = () =>
      new Float64Array(beams).map((_, i) =>
        beams === 1 ? 0 : (fov * i) / (beams - 1),
      );
  },
  "coarse-parallel-test": (m) => {
    m.cast = ({ x, y }, direction) => {
      const rdx = cos(direction);
      const rdy = sin(direction);
      const met = m.walls
        .filter(
          ({ x0, y0, x1, y1 }) =>
            Math.abs(rdx * (y1 - y0) - rdy * (x1 - x0)) >= 1e-9,
        )
        .map((wall) => raySegmentIntersection(x, y, rdx, rdy, wall));
      return Math.min(m.settings.maxRange, ...met);
    };
  },
  "one-beam-fewer": (m) => {
    const { fov, beams } = m.settings;
    if (beams < 3) return;
    m.bearings = () =>
      new Float64Array(beams - 1).map(
        (_, i) => -(fov / 2) + (fov * i) / (beams - 2),
      );
  },
  "last-beam-left-out": (m) => {
    const { bearings, recorded } = m;
    m.bearings = () => bearings().slice(0, -1);
    m.recorded = (...scan) => recorded(...scan).slice(0, -1);
  },
  "max-range-occupied": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) =>
      evidence(line, hit).map(([k, occupied]) => [
        k,
        occupied || k === line.last,
      ]);
  },
  "max-range-without-margin": (m) => {
    const { maxRange, noReturn } = m.settings;
    m.read = (range) => {
      const hit = range < maxRange;
      const used = noReturn === "ignore" ? hit : !Number.isNaN(range);
      return { z: hit ? range : maxRange, hit, used };
    };
  },
  "max-range-wide-margin": (m) => {
    const { maxRange, noReturn } = m.settings;
    m.read = (range) => {
      const hit = range < maxRange - 1e-6;
      const used = noReturn === "ignore" ? hit : !Number.isNaN(range);
      return { z: hit ? range : maxRange, hit, used };
    };
  },
  "end-counted-from-robot-cell": (m) => {
    const { endpoint } = m;
    const { resolution } = m.settings;
    m.endpoint = (pose, direction, z) => {
      const moved = endpoint(new Pose(0, 0, 0), direction, z);
      const { x, y } = centre(m, pose);
      return {
        x: x + Math.floor(moved.x / resolution) * resolution,
        y: y + Math.floor(moved.y / resolution) * resolution,
      };
    };
  },
  "beam-from-cell-centre": (m) => {
    const { endpoint } = m;
    m.endpoint = (pose, direction, z) => {
      const { x, y } = centre(m, pose);
      return endpoint(new Pose(x, y, pose.theta), direction, z);
    };
  },
  "no-return-not-freed": (m) => {
    const { read } = m;
    m.read = (range) => {
      const { z, hit } = read(range);
      return { z, hit, used: hit };
    };
  },
  "no-return-ignore-unknown": (m) => {
    const { read } = m;
    m.read = (range) => ({ ...read(range), used: !Number.isNaN(range) });
  },
  "no-return-end-not-freed": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) =>
      evidence(line, hit).filter(([k]) => hit || k !== line.last);
  },
  "nan-is-no-return": (m) => {
    const { read } = m;
    m.read = (range) => {
      const { z, hit } = read(range);
      return { z, hit, used: m.settings.noReturn === "ignore" ? hit : true };
    };
  },
  "hit-also-free": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) =>
      evidence(line, hit).flatMap(([k, occupied]) =>
        occupied
          ? [
              [k, false],
              [k, true],
            ]
          : [[k, false]],
      );
  },
  "last-cell-missed": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) =>
      evidence(line, hit).filter(([k]) => k !== line.last);
  },
  "hit-one-cell-short": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) => {
      const left = evidence(line, hit).filter(([k]) => k !== line.last);
      return left.map(([k], i) => [k, hit && i === left.length - 1]);
    };
  },
  "robot-cell-not-freed": (m) => {
    const { evidence } = m;
    m.evidence = (line, hit) =>
      evidence(line, hit).filter(([k]) => k !== 0 || k === line.last);
  },
  "ties-up": (m) => {
    m.line = lineWith((k, a, b) => Math.floor((2 * k * b + a) / (2 * a)));
  },
  "ties-with-equality": (m) => {
    m.line = walkedLine((e2, dx, dy) => [e2 >= -dy, e2 <= dx]);
  },
  "ties-with-equality-in-x": (m) => {
    m.line = walkedLine((e2, dx, dy) => [e2 >= -dy, e2 < dx]);
  },
  "ties-with-equality-in-y": (m) => {
    m.line = walkedLine((e2, dx, dy) => [e2 > -dy, e2 <= dx]);
  },
  "rounded-line": (m) => {
    m.line = lineWith((k, a, b) => roundHalfEven((k * b) / a));
  },
  "rounded-cells": (m) => {
    m.line = straightLine(roundHalfEven);
  },
  "rounded-cells-up": (m) => {
    m.line = straightLine((v) => Math.floor(v + 0.5));
  },
  "line-from-the-lesser-end": (m) => {
    const { line } = m;
    m.line = (from, to, most) => {
      const isSteep = Math.abs(to.gy - from.gy) > Math.abs(to.gx - from.gx);
      const isTurned = isSteep ? from.gy > to.gy : from.gx > to.gx;
      return isTurned ? lineFromEnd(from, to) : line(from, to, most);
    };
  },
  "line-from-the-left": (m) => {
    const { line } = m;
    m.line = (from, to, most) =>
      from.gx > to.gx ? lineFromEnd(from, to) : line(from, to, most);
  },
  "line-from-the-end": (m) => {
    m.line = lineFromEnd;
  },
  supercover: (m) => {
    m.line = supercover(false);
  },
  "supercover-with-corners": (m) => {
    m.line = supercover(true);
  },

  // --- log-odds, bounds, picture ---
  "prior-not-subtracted": (m) => {
    const { pFree, pOcc } = m.settings;
    m.deltas = () => [m.logit(pFree), m.logit(pOcc)];
  },
  "starts-at-zero": (m) => {
    m.start = () => 0;
  },
  "free-and-occupied-swapped": (m) => {
    const { deltas } = m;
    m.deltas = () => {
      const [free, occupied] = deltas();
      return [occupied, free];
    };
  },
  "complement-updated": (m) => {
    const { deltas } = m;
    m.deltas = () => {
      const [free, occupied] = deltas();
      return [-free, -occupied];
    };
  },
  "common-logarithm": (m) => {
    const { logit } = m;
    m.logit = (p) => logit(p) / log(10);
  },
  "no-clamp": (m) => {
    m.clamp = (l) => l;
  },
  "clamp-at-the-end": (m) => {
    const { clamp } = m;
    m.clamp = (l) => l;
    m.finish = clamp;
  },
  "no-lower-clamp": (m) => {
    m.clamp = (l) => Math.min(l, m.settings.lMax);
  },
  "clamp-once-per-scan": (m) => {
    m.afterScan = m.clamp;
    m.updated = (l, delta) => l + delta;
  },
  "clamp-before-update": (m) => {
    m.updated = (l, delta) => m.clamp(l) + delta;
  },
  "stops-at-limit": (m) => {
    const { updated } = m;
    const { lMin, lMax } = m.settings;
    m.updated = (l, delta) => (l > lMin && l < lMax ? updated(l, delta) : l);
  },
  "update-beyond-limit-skipped": (m) => {
    const { lMin, lMax } = m.settings;
    m.updated = (l, delta) =>
      l + delta < lMin || l + delta > lMax ? l : l + delta;
  },
  "limits-of-ten": (m) => {
    m.clamp = (l) => Math.min(Math.max(l, -10), 10);
  },
  "limits-of-eight": (m) => {
    m.clamp = (l) => Math.min(Math.max(l, -8), 8);
  },
  "once-per-scan": (m) => {
    m.withinScan = firstOfEach;
  },
  "once-per-scan-occupied-wins": (m) => {
    m.withinScan = (updates) =>
      firstOfEach([
        ...updates.filter(({ occupied }) => occupied),
        ...updates.filter(({ occupied }) => !occupied),
      ]);
  },
  "once-per-scan-each-kind": (m) => {
    m.withinScan = (updates) => [
      ...firstOfEach(updates.filter(({ occupied }) => !occupied)),
      ...firstOfEach(updates.filter(({ occupied }) => occupied)),
    ];
  },
  "free-before-occupied": (m) => {
    m.withinScan = (updates) => [
      ...updates.filter(({ occupied }) => !occupied),
      ...updates.filter(({ occupied }) => occupied),
    ];
  },
  "beams-in-reverse-order": (m) => {
    m.withinScan = (updates) => [...updates].reverse();
  },
  "exp-of-reduced-argument": (m) => {
    const ln2 = Math.LN2;
    m.probability = (l) => {
      const x = -Math.abs(l);
      const rest = x - roundHalfEven(x / ln2) * ln2;
      const lost = x < -0.5 * ln2 && Math.abs(rest) < 2 ** -28;
      const z = lost ? 1 + rest : exp(x);
      return (l >= 0 ? 1 : z) / (1 + z);
    };
  },
  "picture-inverted": (m) => {
    m.pixel = (p) => Math.floor(p * 255 + 0.5);
  },
  "pixel-half-even": (m) => {
    m.pixel = (p) => roundHalfEven((1 - p) * 255);
  },
  "pixel-half-down": (m) => {
    m.pixel = (p) => 255 - Math.floor(p * 255 + 0.5);
  },
  "pixel-rounded-up": (m) => {
    m.pixel = (p) => 255 - Math.floor(p * 255);
  },
  "pixel-truncated": (m) => {
    m.pixel = (p) => Math.floor((1 - p) * 255);
  },
  "pixel-of-256": (m) => {
    m.pixel = (p) => Math.min(Math.floor((1 - p) * 256), 255);
  },

  // --- noise ---
  "noise-of-next-beam": (m) => {
    const { deviate } = m;
    m.deviate = (seed, scan, beam) => deviate(seed, scan, beam + 1);
  },
  "noise-of-next-scan": (m) => {
    const { deviate } = m;
    m.deviate = (seed, scan, beam) => deviate(seed, scan + 1, beam);
  },
  "noise-of-one-scan": (m) => {
    const { deviate } = m;
    m.deviate = (seed, _, beam) => deviate(seed, 0, beam);
  },
  "noise-scan-and-beam-swapped": (m) => {
    const { deviate } = m;
    m.deviate = (seed, scan, beam) => deviate(seed, beam, scan);
  },
  "noise-seed-ignored": (m) => {
    const { deviate } = m;
    m.deviate = (_, scan, beam) => deviate(0, scan, beam);
  },
  "noise-of-next-seed": (m) => {
    const { deviate } = m;
    m.deviate = (seed, scan, beam) => deviate(seed + 1, scan, beam);
  },
  "noise-with-sine": (m) => {
    m.deviate = deviateOf(0, 1, sin);
  },
  "noise-of-other-words": (m) => {
    m.deviate = deviateOf(2, 3);
  },
  "noise-words-swapped": (m) => {
    m.deviate = deviateOf(1, 0);
  },
  "noise-of-whole-words": (m) => {
    m.deviate = deviateOf(0, 1, cos, 1);
  },
  "noise-on-hits-only": (m) => {
    const { noisy } = m;
    m.noisy = (range, ...which) =>
      range < m.settings.maxRange ? noisy(range, ...which) : range;
  },
  "noise-subtracted": (m) => {
    const { deviate } = m;
    m.deviate = (...which) => -deviate(...which);
  },
  "noise-variance": (m) => {
    const { noiseStd, maxRange } = m.settings;
    m.noisy = (range, ...which) => {
      const noisy = range + Math.sqrt(noiseStd) * m.deviate(...which);
      return Math.min(Math.max(noisy, 0), maxRange);
    };
  },
  "noise-not-clamped": (m) => {
    const { noiseStd, maxRange } = m.settings;
    m.noisy = (range, ...which) =>
      Math.min(range + noiseStd * m.deviate(...which), maxRange);
  },
  "no-noise": (m) => {
    m.noisy = (range) => range;
  },
  "noise-on-recorded-scans": (m) => {
    m.recorded = (ranges, seed, scan) =>
      seed === null
        ? ranges
        : ranges.map((range, beam) => m.noisy(range, seed, scan, beam));
  },
  "simulated-scans-numbered-apart": (m) => {
    m.numbered = (scan) =>
      m.scans.slice(0, scan).filter((one) => one instanceof Pose).length;
  },
};

/** All mistakes, by name, in the catalogue's order. @type {Map<string, Mistake>} */
export const MISTAKES = new Map(
  Object.entries(PLANTED).map(([name, plant]) => {
    const { title, lesson } = catalogue[name];
    return [name, { name, title, lesson, plant }];
  }),
);
