/**
 * Judging takes seconds, so a worker does it while the page goes on answering. Some browsers start no worker for a page
 * that was opened from a folder; then the page does it itself, a step at a time, with the same results.
 */

import program from "worker:./worker.js";
import { judgeFile } from "./judgeFile.js";

/** @typedef {import("./judgeFile.js").Job} Job */
/** @typedef {import("./verdict.js").Step} Step */
/** @typedef {import("./verdict.js").Verdict} Verdict */

/** How long the page may be without an answer, in milliseconds. */
const MOST_AT_A_TIME = 30;

/**
 * Judges a file.
 *
 * @param {Job} job
 * @param {(step: Step) => void} follow gets each step
 * @param {(verdict: Verdict) => void} end gets the verdict
 * @returns {() => void} gives up; nothing is called any more
 */
export function startJudging(job, follow, end) {
  let stopped = false;
  /** @type {Worker | null} */
  let worker = null;
  const stop = () => {
    stopped = true;
    worker?.terminate();
  };
  /** Takes a step; whether it was the last. @param {IteratorResult<Step, Verdict>} next */
  const take = (next) => {
    if (stopped) return true;
    if (!next.done) {
      follow(next.value);
      return false;
    }
    stop();
    end(next.value);
    return true;
  };
  const here = async () => {
    const steps = judgeFile(job);
    let answered = 0;
    while (!take(steps.next())) {
      if (performance.now() - answered < MOST_AT_A_TIME) continue;
      await new Promise((resolve) => setTimeout(resolve, 0));
      answered = performance.now();
    }
  };
  try {
    const blob = new Blob([program], { type: "text/javascript" });
    const address = URL.createObjectURL(blob);
    worker = new Worker(address);
    worker.addEventListener("message", ({ data }) => {
      URL.revokeObjectURL(address); // it has started
      take(data);
    });
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      worker?.terminate();
      if (!stopped) here();
    });
    worker.postMessage(job);
  } catch {
    here();
  }
  return stop;
}
