/** What all figures show: a world, a moment, and what the reader has done to them. */

import { lessonScenario } from "../../src/lesson.js";
import { addRangeNoise } from "../../src/noise.js";
import {
  beamAngles,
  beamEndpoints,
  readRanges,
  Scan,
} from "../../src/sensor.js";
import { Pose, simulateLidarScan } from "../../src/world.js";
import { MistakenMapper } from "../model/mistakenMapper.js";
import { MISTAKES } from "../model/mistakes.js";
import { Run } from "../model/run.js";
import { changedSettings } from "../model/settings.js";
import { Timeline } from "../model/timeline.js";

/** @typedef {import("../model/mistakenMapper.js").World} World */
/** @typedef {import("../../src/scenario.js").Settings} Settings */
/** @typedef {import("../../src/world.js").Segment} Segment */
/** @typedef {{gx: number, gy: number}} Cell */
/** @typedef {import("../shared/gridCanvas.js").Pad} Pad */
/**
 * @typedef {object} Moment what a map shows
 * @property {Run} run
 * @property {number} scan the scan that is being added, from 1
 * @property {number} beam how many of its beams have been added
 * @property {Scan | null} added a scan on top, from where the reader has put the robot
 */

/** The scan that the lesson is shown after first. */
const FIRST = 24;

/** So many cells are shown beyond a path that leaves the grid. */
const ROOM = 5;

export class Lab {
  /** Goes up whenever settings, walls, scans or the seed change. */
  version = 0;
  name = "lesson";
  /** @type {number | null} null: without noise */
  seed = 0;
  /** The scan that is being added, from 1. */
  scan = 1;
  /** How many of its beams have been added. */
  beam = 0;
  /** Where the reader has put the robot. @type {Pose | null} */
  free = null;
  /** @type {"robot" | "draw" | "wall"} */
  tool = "robot";
  /** The cell whose history is shown. @type {Cell} */
  cell = { gx: 109, gy: 90 };
  /** The cell that is read out in the map. @type {Cell | null} */
  cursor = null;
  /** A line that was asked for; null: that of the current beam. @type {[number, number, number, number] | null} */
  line = null;
  step = 0;
  /** @type {Set<string>} */
  mistakes = new Set();
  playing = false;

  /** @type {World} */
  world;
  /** What the world was opened with. @type {{settings: Settings, scan: number, cell: Cell}} */
  opened;
  /** Its scans, and the map after each. @type {Run} */
  run;
  /** Where each scan is taken. @type {Pose[]} */
  poses = [];
  /** What the pictures show around the grid. @type {Pad} */
  pad = { left: 0, right: 0, bottom: 0, top: 0 };

  constructor() {
    const lesson = lessonScenario();
    this.world = {
      settings: lesson.settings,
      walls: lesson.walls,
      scans: Array.from(lesson.scans()),
    };
    this.run = new Run(this.world, this.seed);
    this.opened = {
      settings: lesson.settings,
      scan: FIRST,
      cell: this.cell,
    };
    this.#changed();
    this.goTo(FIRST);
  }

  /** A grid like that of the map. */
  get grid() {
    return this.run.grid;
  }

  /** How many beams the current scan has. */
  get beams() {
    return this.scanAt(this.scan - 1).ranges.length;
  }

  /** How many scans there are. */
  get count() {
    return this.poses.length;
  }

  /** A scan with its ranges, which are simulated when they are first needed. @param {number} number from 0 @returns {Scan} */
  scanAt(number) {
    return this.run.scans.at(number);
  }

  /** All scans. */
  get scans() {
    return this.poses.map((_, number) => this.scanAt(number));
  }

  /** @param {World} world @param {string} name */
  open(world, name) {
    this.world = world;
    this.name = name;
    this.free = null;
    this.line = null;
    this.step = 0;
    this.scan = 1;
    this.cursor = null;
    const { settings } = world;
    this.cell = { gx: settings.width >> 1, gy: settings.height >> 1 };
    this.opened = { settings, scan: this.scan, cell: this.cell };
    this.#changed();
    this.#coming = null;
    this.#mapped = null;
    this.beam = this.beams;
  }

  /** The cell that is shown first, on the grid of now. @returns {Cell} */
  get startCell() {
    return this.#onGridOfNow(this.opened.cell, this.opened.settings);
  }

  /** The cell of now at the place of one of another grid. @param {Cell} cell @param {Settings} old @returns {Cell} */
  #onGridOfNow({ gx, gy }, { resolution }) {
    const { settings } = this.world;
    const zoom = resolution / settings.resolution;
    return {
      gx: Math.min(Math.floor(gx * zoom), settings.width - 1),
      gy: Math.min(Math.floor(gy * zoom), settings.height - 1),
    };
  }

  /** @param {Partial<Settings>} values @throws {RangeError} where they are not possible */
  set(values) {
    const old = this.world.settings;
    const settings = changedSettings(old, this.opened.settings, values);
    const whole = this.beam === this.beams;
    this.world = { ...this.world, settings };
    if (settings.resolution !== old.resolution) {
      this.cursor = null;
      this.cell = this.#onGridOfNow(this.cell, old);
    }
    this.#changed();
    this.beam = whole ? this.beams : Math.min(this.beam, this.beams);
  }

  /** @param {Segment[]} walls */
  setWalls(walls) {
    this.world = { ...this.world, walls };
    this.#changed();
  }

  /** @param {number | null} seed */
  setSeed(seed) {
    this.seed = seed;
    this.#changed();
  }

  #changed() {
    this.version += 1;
    this.poses = this.world.scans.map((scan) =>
      scan instanceof Pose ? scan : scan.pose,
    );
    this.run = new Run(this.world, this.seed, this.run);
    this.scan = Math.min(this.scan, this.count);
    this.#wrong = null;
    this.pad = this.#padOf();
  }

  /** Room for a path that leaves the grid, up to a quarter of the grid on each side. @returns {Pad} */
  #padOf() {
    const { width, height } = this.world.settings;
    const pad = { left: 0, right: 0, bottom: 0, top: 0 };
    for (const { x, y } of this.poses) {
      const { gx, gy } = this.grid.worldToGrid(x, y);
      pad.left = Math.max(pad.left, -gx);
      pad.right = Math.max(pad.right, gx - (width - 1));
      pad.bottom = Math.max(pad.bottom, -gy);
      pad.top = Math.max(pad.top, gy - (height - 1));
    }
    const shown = (
      /** @type {number} */ beyond,
      /** @type {number} */ size,
    ) => (beyond > 0 ? Math.min(beyond + ROOM, Math.ceil(size / 4)) : 0);
    return {
      left: shown(pad.left, width),
      right: shown(pad.right, width),
      bottom: shown(pad.bottom, height),
      top: shown(pad.top, height),
    };
  }

  /** Goes to a moment. @param {number} scan from 1 @param {number} [beam] beams of it; all without */
  goTo(scan, beam) {
    this.scan = Math.min(Math.max(scan, 1), this.count);
    this.beam = Math.min(Math.max(beam ?? this.beams, 0), this.beams);
  }

  /** One beam on or back, across scans. @param {number} by 1 or -1 */
  moveBeam(by) {
    const next = this.beam + by;
    if (next > this.beams && this.scan < this.count) {
      this.goTo(this.scan + 1, 1);
    } else if (next < 0 && this.scan > 1) {
      this.goTo(this.scan - 1);
      this.goTo(this.scan, this.beams - 1);
    } else {
      this.goTo(this.scan, next);
    }
  }

  get atEnd() {
    return this.scan === this.count && this.beam === this.beams;
  }

  /** @type {{free: Pose, scan: number, version: number, made: Scan} | null} */
  #looked = null;

  /** The scan in view: of the path, or from where the reader has put the robot. @returns {Scan} */
  inView() {
    const { free, scan, version } = this;
    if (free === null) return this.scanAt(scan - 1);
    const old = this.#looked;
    if (old?.free !== free || old.scan !== scan || old.version !== version) {
      this.#looked = { free, scan, version, made: this.#lookFrom(free) };
    }
    return /** @type {NonNullable<typeof old>} */ (this.#looked).made;
  }

  /** @param {Pose} pose */
  #lookFrom(pose) {
    const { settings, walls } = this.world;
    const { fov, beams, maxRange, noiseStd } = settings;
    const angles = beamAngles(fov, beams);
    let ranges = simulateLidarScan(pose, walls, angles, maxRange);
    if (this.seed !== null) {
      const number = this.scan - 1;
      ranges = addRangeNoise(ranges, noiseStd, this.seed, number, maxRange);
    }
    return new Scan(pose, angles, ranges);
  }

  /** @returns {Moment} */
  get moment() {
    const { run, scan, beam } = this;
    const added = this.free === null ? null : this.inView();
    return { run, scan, beam, added };
  }

  /** The map now, and the map before what the scan in view has done; both are overwritten by the next call. */
  maps({ run, scan, beam, added } = this.moment) {
    return run.maps(scan, beam, added);
  }

  /** The moment that is being mapped. @type {Moment | null} */
  #coming = null;
  /** The newest moment that has been mapped. @type {Moment | null} */
  #mapped = null;

  /**
   * Maps for a while, towards the moment of now; or of an earlier call, where that is not done yet. So the map follows a
   * hand that changes the walls again before it is done, too.
   *
   * @param {number} time milliseconds
   * @returns {boolean} whether the map of now is done
   */
  mapOn(time) {
    if (this.isMapped) return true;
    const now = this.moment;
    let coming = this.#coming ?? now;
    // the same run comes to the moment of now as soon; and a map of other cells has no place in the picture
    if (coming.run === now.run || !sameCells(coming.run, now.run)) {
      coming = now;
    }
    const { run, scan } = coming;
    const done = run.timeline.reach(scan - 1, performance.now() + time);
    this.#coming = done ? null : coming;
    if (done) this.#mapped = coming;
    return this.isMapped;
  }

  /** The newest moment that has been mapped; null if its cells are not those of now. */
  get mapped() {
    const mapped = this.#mapped;
    return mapped !== null && sameCells(mapped.run, this.run) ? mapped : null;
  }

  /** Whether the map of now is done. */
  get isMapped() {
    return this.isNow(this.#mapped);
  }

  /** Whether a moment is that of now. @param {Moment | null} moment */
  isNow(moment) {
    const now = this.moment;
    return (
      moment !== null &&
      moment.run === now.run &&
      moment.scan === now.scan &&
      moment.beam === now.beam &&
      moment.added === now.added
    );
  }

  /** @type {{key: string, mapper: MistakenMapper, timeline: Timeline} | null} */
  #wrong = null;

  /**
   * The map after the whole scans so far, right and with the chosen mistakes; `wrong` is null where none is chosen.
   *
   * @returns {{scans: number, right: Float64Array, wrong: ReturnType<MistakenMapper["files"]> | null}}
   */
  compared() {
    const scans = this.beam === this.beams ? this.scan : this.scan - 1;
    const right = this.run.timeline.at(scans);
    if (this.mistakes.size === 0) return { scans, right, wrong: null };
    const key = Array.from(this.mistakes).join(" ");
    if (this.#wrong?.key !== key) {
      const chosen = Array.from(this.mistakes, (name) => MISTAKES.get(name));
      const mapper = new MistakenMapper(
        this.world,
        this.seed,
        chosen.filter((mistake) => mistake !== undefined),
      );
      const map = mapper.start();
      const timeline = new Timeline(this.count, map, (number) =>
        mapper.add(map, number),
      );
      this.#wrong = { key, mapper, timeline };
    }
    const { mapper, timeline } = this.#wrong;
    return { scans, right, wrong: mapper.files(timeline.at(scans)) };
  }

  /** First and last cell of a beam of the scan in view; null where the beam is ignored. @param {number} beam from 0 */
  cellsOfBeam(beam) {
    const { pose, angles, ranges } = this.inView();
    const one = new Scan(
      pose,
      angles.subarray(beam, beam + 1),
      ranges.subarray(beam, beam + 1),
    );
    return endsOf(this.grid, one, this.world.settings)[0] ?? null;
  }
}

/** Whether two runs have the same grid. @param {Run} one @param {Run} other */
function sameCells({ world: { settings: a } }, { world: { settings: b } }) {
  return (
    a.width === b.width &&
    a.height === b.height &&
    a.resolution === b.resolution &&
    a.originX === b.originX &&
    a.originY === b.originY
  );
}

/**
 * Where the beams of a scan go.
 *
 * @param {import("../../src/grid.js").OccupancyGrid} grid
 * @param {Scan} scan
 * @param {Settings} settings
 */
export function endsOf(grid, scan, { maxRange, noReturn }) {
  const { z, hit, used } = readRanges(scan.ranges, maxRange, noReturn);
  const { ex, ey } = beamEndpoints(scan.pose, scan.angles, z);
  const from = grid.worldToGrid(scan.pose.x, scan.pose.y);
  return Array.from(z, (length, i) =>
    used[i]
      ? {
          from,
          to: grid.worldToGrid(ex[i], ey[i]),
          x: ex[i],
          y: ey[i],
          z: length,
          hit: hit[i],
        }
      : null,
  );
}
