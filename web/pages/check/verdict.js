/**
 * What the page says about a file, put together from the comparisons. It never says more than they show. Some take
 * seconds, so they are made step by step.
 */

import {
  differing,
  firstTrouble,
  fromBelow,
  prefixThatFits,
  referenceOf,
  sizeOf,
  symmetriesOf,
  tryMistakes,
} from "../model/compareMaps.js";
import { explainByRounding } from "../model/explainByRounding.js";
import { CONTRACT, STEPS } from "../model/rightFormulas.js";
import { saying } from "../model/steps.js";
import { counted, plural } from "../shared/words.js";

/** @typedef {import("../model/mistakenMapper.js").World} World */
/** @typedef {import("../model/compareMaps.js").Found} Found */
/** @typedef {import("../model/compareMaps.js").Reference} Reference */

/**
 * @typedef {object} Verdict
 * @property {"identical" | "size" | "turned" | "halves" | "edges" | "differs"} status
 * @property {"good" | "note" | "bad"} tone
 * @property {string[]} words the first is the verdict itself
 * @property {number[]} wrong the cells that differ
 * @property {Reference} reference
 */

/**
 * @typedef {object} Step
 * @property {string} doing what comes next
 * @property {number | null} part how much of it is done, from 0 to 1; null where nobody can know
 * @property {Verdict} [known] the verdict, but for mistakes that draw the same map
 */

/**
 * @param {Found} found
 * @param {World} world
 * @param {number | null} seed
 * @param {boolean} ownPoses the program may compute the lesson's poses itself; then the world is the lesson
 * @returns {Generator<Step, Verdict>}
 */
export function* judge(found, world, seed, ownPoses) {
  yield { doing: "Drawing the right map", part: null };
  const reference = referenceOf(world, seed);
  const what = "picture" in found ? "picture" : "log-odds";
  const { width, height } = reference;
  const size = sizeOf(found);
  const turned = symmetriesOf(found, reference);
  const sameSize = size.width === width && size.height === height;
  const wrong = sameSize ? differing(found, reference) : [];
  const base = { wrong, reference };
  if (sameSize && wrong.length === 0) {
    return {
      ...base,
      status: "identical",
      tone: "good",
      words: [
        "identical",
        what === "picture"
          ? `All ${counted(width * height)} pixels are those of the right map.`
          : `All ${counted(width * height)} log-odds are those of the right map, in every bit.`,
      ],
    };
  }
  if (turned.length > 0) {
    const words = [
      `flipped or transposed`,
      `Your map is exactly the right one, ${turned.join(", or ")}.`,
    ];
    const known = verdict("turned", words, base);
    return yield* withMistakes(known, found, world, seed);
  }
  if (!sameSize) {
    const words = [
      "wrong size",
      `Your ${what === "picture" ? "picture has" : "map has"} ${size.width} x ${size.height} cells, the right one ${width} x ${height} (columns x rows).`,
    ];
    if (size.width === height && size.height === width) {
      words.push(
        "Width and height are exchanged, but the cells differ as well.",
      );
    }
    const known = verdict("size", words, base);
    return yield* withMistakes(known, found, world, seed);
  }
  const explained =
    "picture" in found
      ? yield* saying(
          { doing: "Looking at beams that rounding decides", part: null },
          explainByRounding(world, seed, fromBelow(found.picture), ownPoses),
        )
      : null;
  if (explained?.kind === "halves" || explained?.kind === "edges") {
    return { ...base, ...rounding(explained, wrong.length) };
  }
  const words = [
    `differs in ${plural(wrong.length, "cell")} of ${counted(width * height)}`,
  ];
  if ("logOdds" in found && differOnlyInLastBits(found, reference, wrong)) {
    words.push(
      "All of them differ by less than 0.000000001, so it may be another logarithm's last bits and nothing more. This page does not follow that up for log-odds; the full check does.",
    );
  }
  yield { doing: "Looking at maps of fewer scans", part: null };
  const other = otherMode(found, world, seed);
  const prefix = prefixThatFits(found, world, seed);
  if (other !== null) {
    words.push(
      `It is exactly the right map ${other}. Choose that above if it is what you wanted to draw.`,
    );
  } else if (prefix >= 0) {
    words.push(
      `It is exactly the right map after ${plural(prefix, "scan")} of ${reference.scans}: ${reference.scans - prefix === 1 ? "the last scan is missing" : `the last ${reference.scans - prefix} scans are missing`}.`,
    );
  } else if (explained?.gap) {
    words.push(...missing(explained.gap, explained.formulas));
  } else {
    if (explained?.kind === "no choice") {
      words.push(
        "Some beams end on a cell's edge, where rounding may choose either side, but this page found no such choice that gives all of your cells.",
      );
    }
    words.push(...trouble(wrong, reference));
  }
  const known = verdict("differs", words, base);
  // no mistake that the page knows adds noise
  if (other !== null && seed === null) return known;
  return yield* withMistakes(known, found, world, seed);
}

/**
 * @param {Verdict["status"]} status
 * @param {string[]} words
 * @param {{wrong: number[], reference: Reference}} base
 * @returns {Verdict}
 */
function verdict(status, words, base) {
  return { ...base, status, tone: "bad", words };
}

/** @typedef {import("../model/explainByRounding.js").Explanation} Explanation */

/** What the picture leaves out. @param {import("../model/leftOut.js").Gap} gap @param {string[]} formulas not the contract's */
function missing({ what, number }, formulas) {
  const words = [
    `It is exactly the right map without ${what} ${number + 1}${what === "beam" ? " of every scan" : ""} (${what} ${number} if the first is 0).`,
  ];
  if (formulas.length > 0) {
    words.push(`Your program draws it ${withFormulas(formulas)}`);
  }
  return words;
}

/** With which formulas, and whether they are right elsewhere, too. @param {string[]} formulas */
function withFormulas(formulas) {
  const named = formulas.join("; ");
  if (!formulas.some((one) => one.startsWith(`${STEPS.cell}: `))) {
    return `with formulas that are as right as the contract's (${named}).`;
  }
  return `with other formulas (${named}). They are right on this map, but where a pose lies exactly on a cell's edge, this one for the cell can give the cell beside it: write ${CONTRACT.cell}.`;
}

/** @param {Explanation} explained @param {number} count */
function rounding({ kind, turned, halves, formulas }, count) {
  if (kind === "halves") {
    return {
      status: /** @type {const} */ ("halves"),
      tone: /** @type {const} */ ("note"),
      words: [
        `differs in ${plural(count, "cell")}, only by rounding`,
        `In each of them the grey value lies halfway between two levels, so that the last bit of exp or log decides the level.`,
      ],
    };
  }
  const named = turned
    .slice(0, 8)
    .map(({ scan, beam }) => `scan ${scan + 1}, beam ${beam + 1}`);
  const more = turned.length - named.length;
  return {
    status: /** @type {const} */ ("edges"),
    tone: /** @type {const} */ ("note"),
    words: [
      `differs in ${plural(count, "cell")}, only at cell edges`,
      `${plural(turned.length, "beam ends", "beams end")} so close to a cell's edge that the last bits of a sine decide the cell. Put on the other side, they draw exactly your picture: ${named.join("; ")}${more > 0 ? `; and ${more} more` : ""}.${halves ? ` In ${plural(halves, "cell")} the last bit of exp or log decides the level.` : ""}`,
      ...(formulas.length > 0
        ? [`The right program draws your picture ${withFormulas(formulas)}`]
        : []),
      "Your program may be right. It is equal to the others in every bit only with the contract's own formulas, sine and cosine.",
    ],
  };
}

/** @param {number[]} wrong @param {Reference} reference */
function trouble(wrong, reference) {
  const { touched, settled, never, known } = firstTrouble(wrong, reference);
  const words = [];
  if (never > 0) {
    words.push(
      `${plural(never, "of these cells is", "of these cells are")} touched by no beam of the right program.`,
    );
  }
  if (known && touched > 1) {
    words.push(
      `No scan before scan ${touched} touches any of ${never ? "the others" : "them"}, so up to there your program may be right.`,
    );
  }
  if (known) {
    words.push(
      `It has gone wrong by scan ${settled} at the latest: one of ${never ? "the other" : "these"} cells gets its last update there.`,
    );
  }
  return words;
}

/**
 * The other mode of the scenario that draws exactly this map, or null: with the noise of seed 0, or without.
 *
 * @param {Found} found
 * @param {World} world
 * @param {number | null} seed
 */
function otherMode(found, world, seed) {
  const other = seed === null ? 0 : null;
  if (differing(found, referenceOf(world, other)).length > 0) return null;
  return other === null ? "without noise" : `with the noise of seed ${other}`;
}

/**
 * @param {{logOdds: import("../model/readFiles.js").LogOdds}} found
 * @param {Reference} reference
 * @param {number[]} wrong
 */
function differOnlyInLastBits({ logOdds }, reference, wrong) {
  return wrong.every(
    (i) => Math.abs(logOdds.values[i] - reference.logOdds[i]) < 1e-9,
  );
}

/**
 * A verdict, with the mistakes that draw the same map.
 *
 * @param {Verdict} known
 * @param {Found} found
 * @param {World} world
 * @param {number | null} seed
 * @returns {Generator<Step, Verdict>}
 */
function* withMistakes(known, found, world, seed) {
  const doing = "Trying known mistakes";
  yield { doing, part: 0, known };
  const same = [];
  for (const step of tryMistakes(found, world, seed)) {
    if (step.same) same.push(step.same);
    yield { doing, part: step.tried / step.of };
  }
  const words = [...known.words];
  if (same.length === 0) {
    words.push("None of the mistakes that this page knows draws this map.");
  } else {
    words.push(
      same.length === 1
        ? "A known mistake draws exactly this map:"
        : "Known mistakes draw exactly this map:",
      ...same.map(({ title, lesson }) => `• ${title}. ${lesson}`),
    );
  }
  return { ...known, words };
}
