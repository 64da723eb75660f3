/** What check.html runs beside itself: it judges one file, and says on the way how far it is. */

import { judgeFile } from "./judgeFile.js";

addEventListener(
  "message",
  (/** @type {MessageEvent<import("./judgeFile.js").Job>} */ { data }) => {
    const steps = judgeFile(data);
    for (let next = steps.next(); ; next = steps.next()) {
      postMessage(next);
      if (next.done) return;
    }
  },
);
