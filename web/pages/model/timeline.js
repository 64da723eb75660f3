/** Maps after any number of scans: kept now and then, and mapped on from there. */

const MOST_BYTES = 48 * 1024 * 1024;

export class Timeline {
  /** @type {Float64Array[]} the map after 0, every, 2 every, ... scans */
  #kept;
  #every;
  #apply;
  #values;
  #after = 0;

  /**
   * @param {number} count of scans
   * @param {Float64Array} start the empty map
   * @param {(values: Float64Array, scan: number) => void} apply adds a scan to a map
   */
  constructor(count, start, apply) {
    const most = Math.max(2, Math.floor(MOST_BYTES / (8 * start.length)));
    this.#every = Math.ceil((count + 1) / most);
    this.#kept = [start];
    this.#values = start.slice();
    this.#apply = apply;
  }

  /**
   * The map after some scans; it is overwritten by the next call.
   *
   * @param {number} scans
   * @returns {Float64Array}
   */
  at(scans) {
    const nearest = Math.min(
      Math.floor(scans / this.#every),
      this.#kept.length - 1,
    );
    if (this.#after > scans || nearest * this.#every > this.#after) {
      this.#values.set(this.#kept[nearest]);
      this.#after = nearest * this.#every;
    }
    while (this.#after < scans) {
      this.#apply(this.#values, this.#after);
      this.#after += 1;
      if (this.#after === this.#kept.length * this.#every) {
        this.#kept.push(this.#values.slice());
      }
    }
    return this.#values;
  }
}
