/** Maps after any number of scans: kept now and then, and mapped on from there. */

const MOST_BYTES = 48 * 1024 * 1024;
/** So many scans are added between two looks at the clock. */
const AT_A_TIME = 4;

export class Timeline {
  /** @type {Float64Array[]} the map after 0, every, 2 every, ... scans */
  #kept;
  #every;
  #add;
  #map;
  #after = 0;

  /**
   * @param {number} count of scans
   * @param {Float64Array} map the empty map, which becomes that of the scans
   * @param {(scan: number) => void} add adds a scan to it
   * @param {number} every how many scans lie between two maps that are kept, at the least
   */
  constructor(count, map, add, every = 1) {
    const most = Math.max(2, Math.floor(MOST_BYTES / (8 * map.length)));
    this.#every = Math.max(Math.ceil((count + 1) / most), every);
    this.#kept = [map.slice()];
    this.#map = map;
    this.#add = add;
  }

  /**
   * The map after some scans; it is overwritten by the next call.
   *
   * @param {number} scans
   * @returns {Float64Array}
   */
  at(scans) {
    this.reach(scans, Infinity);
    return this.#map;
  }

  /**
   * Goes on towards the map after some scans.
   *
   * @param {number} scans
   * @param {number} until when to stop on the way, by performance.now()
   * @returns {boolean} whether it is there
   */
  reach(scans, until) {
    const nearest = Math.min(
      Math.floor(scans / this.#every),
      this.#kept.length - 1,
    );
    if (this.#after > scans || nearest * this.#every > this.#after) {
      this.#map.set(this.#kept[nearest]);
      this.#after = nearest * this.#every;
    }
    for (let done = 0; this.#after < scans; done++) {
      if (done % AT_A_TIME === 0 && performance.now() >= until) return false;
      this.#add(this.#after);
      this.#after += 1;
      if (this.#after === this.#kept.length * this.#every) {
        this.#kept.push(this.#map.slice());
      }
    }
    return true;
  }
}
