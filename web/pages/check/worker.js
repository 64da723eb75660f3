/** What check.html runs beside itself: it judges one file, and says on the way how far it is. */

import { judgeFile } from "./judgeFile.js";

/** How long a page needs not know how far it is, in milliseconds. */
const UNTOLD = 50;

addEventListener(
  "message",
  (/** @type {MessageEvent<import("./judgeFile.js").Job>} */ { data }) => {
    const steps = judgeFile(data);
    let told = -Infinity;
    for (let next = steps.next(); ; next = steps.next()) {
      const isNews = next.done || next.value.known || next.value.part === 1;
      if (isNews || performance.now() - told >= UNTOLD) {
        postMessage(next);
        told = performance.now();
      }
      if (next.done) return;
    }
  },
);
