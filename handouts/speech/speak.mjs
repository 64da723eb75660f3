/**
 * How equations are read aloud: a JSON list of MathML on standard input becomes a JSON list of English words on standard
 * output, by the rules of ClearSpeak. Commas stand where a reader pauses.
 */

import { text } from "node:stream/consumers";
import sre from "speech-rule-engine";

// The ends of fractions, roots and absolute values are said, and the bar in p(a | b) is "given".
const STYLE = [
  "AbsoluteValue_AbsEnd",
  "Fraction_GeneralEndFrac",
  "Roots_RootEnd",
  "VerticalLine_Given",
].join(":");

await sre.setupEngine({
  locale: "en",
  domain: "clearspeak",
  style: STYLE,
  modality: "speech",
  markup: "punctuation",
});
await sre.engineReady();
const equations = JSON.parse(await text(process.stdin));
process.stdout.write(JSON.stringify(equations.map((e) => sre.toSpeech(e))));
