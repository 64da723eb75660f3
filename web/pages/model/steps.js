/** Long work, step by step: between two steps, whoever waits for it may do something else. */

/**
 * Takes steps that say nothing by themselves, and says the same before each of them.
 *
 * @template Said
 * @template Result
 * @param {Said} said
 * @param {Generator<void, Result>} steps
 * @returns {Generator<Said, Result>}
 */
export function* saying(said, steps) {
  for (;;) {
    yield said;
    const { done, value } = steps.next();
    if (done) return value;
  }
}
