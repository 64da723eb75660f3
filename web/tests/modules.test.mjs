/** Small facts of the modules that neither vectors nor golden results show. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addRangeNoise,
  beamAngles,
  bresenham,
  GridSpec,
  lessonPoses,
  lessonScenario,
  lessonSettings,
  lessonWorld,
  logit,
  mapLogOdds,
  mapScenario,
  mapYaml,
  memorySource,
  newGrid,
  OccupancyGrid,
  Pose,
  philox4x32,
  pixel,
  raySegmentIntersection,
  readRanges,
  readScenario,
  Scan,
  ScenarioError,
  Segment,
  scenarioName,
  sigmoid,
  simulateLidarScan,
} from "../src/index.js";
import { fixed } from "../src/mapWriter.js";
import { parseNumber } from "../src/scenario.js";

const HEADER = `PARAM occgrid_width 5
PARAM occgrid_height 4
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 9
`;

/** @param {string} text */
const read = (text) => readScenario(memorySource("a.log", text));
/** @param {string} text */
const scansOf = (text) => Array.from(read(text).scans());

test("philox: the published answers", () => {
  const hex = (/** @type {number[]} */ words) =>
    words.map((word) => word.toString(16).padStart(8, "0")).join(" ");
  const ones = 0xffffffff;
  assert.equal(
    hex(philox4x32([ones, ones, ones, ones], [ones, ones])),
    "408f276d 41c83b0e a20bc7c6 6d5451fd",
  );
});

test("noise is added to a copy and kept within the range", () => {
  const ranges = new Float64Array(200).fill(5);
  const noisy = addRangeNoise(ranges, 50, 3, 1, 10);
  assert.ok(ranges.every((range) => range === 5));
  assert.ok(noisy.some((range) => range === 0));
  assert.ok(noisy.some((range) => range === 10));
  assert.deepEqual(addRangeNoise(ranges, 0, 3, 1, 10), ranges);
});

test("a cell outside the grid is skipped; bounds hold after each update", () => {
  const grid = new OccupancyGrid(new GridSpec(3, 2, 0.5, -1, -1));
  for (const [gx, gy] of [
    [-1, 0],
    [3, 0],
    [0, -1],
    [0, 2],
  ]) {
    grid.updateCell(gx, gy, grid.lOcc);
  }
  assert.ok(grid.logOdds.every((value) => value === 0));
  for (let i = 0; i < 20; i++) grid.updateCell(2, 1, grid.lOcc);
  assert.equal(grid.logOdds[5], 8);
  grid.updateCell(2, 1, grid.lFree);
  assert.equal(grid.logOdds[5], 8 + grid.lFree);
  assert.deepEqual(grid.worldToGrid(0.49, -1.01), { gx: 2, gy: -1 });
  assert.deepEqual(grid.gridToWorldCenter(2, 1), { x: 0.25, y: -0.25 });
  assert.equal(grid.probabilityGrid()[5], sigmoid(8 + grid.lFree));
});

test("a grid refuses what is none", () => {
  assert.throws(
    () => new OccupancyGrid(new GridSpec(0, 3, 1, 0, 0)),
    RangeError,
  );
  assert.throws(
    () => new OccupancyGrid(new GridSpec(2.5, 3, 1, 0, 0)),
    RangeError,
  );
  const spec = new GridSpec(1, 1, 1, 0, 0);
  assert.throws(
    () => new OccupancyGrid(spec, 0.5, 0.7, 0.3, 1, 2),
    RangeError,
  );
});

test("logit and sigmoid are the ends of each other", () => {
  assert.equal(logit(0.5), 0);
  assert.equal(logit(0), logit(1e-9));
  assert.equal(sigmoid(0), 0.5);
  assert.equal(pixel(-Infinity), 255);
  assert.equal(pixel(Infinity), 0);
  assert.equal(pixel(0), 128);
});

test("a line includes both ends", () => {
  assert.deepEqual(bresenham(2, 2, 2, 2), [{ gx: 2, gy: 2 }]);
  assert.deepEqual(
    bresenham(0, 0, -3, 1).map(({ gx, gy }) => [gx, gy]),
    [
      [0, 0],
      [-1, 0],
      [-2, 1],
      [-3, 1],
    ],
  );
});

test("ranges: hit, no return, ignored", () => {
  const ranges = Float64Array.of(1, 5, Infinity, NaN, 5 - 1e-12, 5 - 2e-12);
  const free = readRanges(ranges, 5, "free");
  assert.deepEqual(Array.from(free.z), [1, 5, 5, 5, 5, 5 - 2e-12]);
  assert.deepEqual(free.hit, [true, false, false, false, false, true]);
  assert.deepEqual(free.used, [true, true, true, false, true, true]);
  const ignored = readRanges(ranges, 5, "ignore");
  assert.deepEqual(ignored.used, ignored.hit);
});

test("rays meet walls, and miss what is parallel, behind or beside them", () => {
  const wall = new Segment(2, -1, 2, 1);
  assert.equal(raySegmentIntersection(0, 0, 1, 0, wall), 2);
  for (const [rx, ry, rdx, rdy] of [
    [0, 0, 0, 1],
    [3, 0, 1, 0],
    [0, 2, 1, 0],
  ]) {
    assert.equal(raySegmentIntersection(rx, ry, rdx, rdy, wall), Infinity);
  }
  const angles = beamAngles(Math.PI, 3);
  const ranges = simulateLidarScan(new Pose(0, 0, 0), [wall], angles, 1.5);
  assert.deepEqual(Array.from(ranges), [1.5, 1.5, 1.5]);
  assert.deepEqual(Array.from(beamAngles(2, 1)), [0]);
});

test("the lesson", () => {
  assert.equal(lessonPoses().length, 120);
  assert.equal(lessonWorld().length, 6);
  assert.deepEqual(
    { ...lessonPoses()[0] },
    { x: 0, y: 0, theta: Math.PI / 2 },
  );
  // the file says the same
  const settings = lessonSettings();
  assert.equal(settings.beams, 181);
  assert.equal(newGrid(settings).logOdds.length, 39600);
  // README's example
  const grid = mapScenario(lessonScenario(), null);
  const { gx, gy } = grid.worldToGrid(0, 2);
  assert.equal(grid.probabilityGrid()[gy * 220 + gx], 0.9892011065412029);
});

test("names of scenarios", () => {
  const names = {
    "a/b.log": "b",
    "b.tar.gz": "b.tar",
    ".log": ".log",
    "d//": "d",
    "a.b/": "a",
    "": "",
    "x\n/y.z": "y",
  };
  for (const [path, name] of Object.entries(names)) {
    assert.equal(scenarioName(path), name, path);
  }
});

test("numbers", () => {
  const good = {
    "1.": 1,
    ".5": 0.5,
    "+1e3": 1000,
    "-0": 0,
    "1e300": Infinity,
    "-1e400": -Infinity,
    "9e-301": 0,
    iNf: Infinity,
    "-Infinity": -Infinity,
  };
  for (const [token, value] of Object.entries(good)) {
    assert.ok(Object.is(parseNumber(token), value), token);
  }
  assert.ok(Number.isNaN(parseNumber("-NaN")));
  for (const token of [
    "",
    ".",
    "1e",
    "0x10",
    "1_0",
    "e5",
    "1.2.3",
    "++1",
    "in",
    "1e5.0",
  ]) {
    assert.equal(parseNumber(token), null, token);
  }
  // rounded correctly, however many digits
  const half = `1.${"0".repeat(15)}${(2 ** -53).toFixed(60).slice(2 + 15)}`;
  assert.equal(parseNumber(half), 1);
  assert.equal(parseNumber(`${half}${"0".repeat(900)}1`), 1 + 2 ** -52);
  assert.equal(parseNumber("2.2250738585072011e-308"), 0);
});

test("scans: a bare pose, FLASER, ROBOTLASER1, ignored ranges", () => {
  const text = `${HEADER}PARAM occgrid_min_range 0.5 # a comment
WALL 1 2 3 4 # and another\r
ODOM belongs to others
`;
  const [pose, flaser, robotlaser] = scansOf(
    `${text}POSE 1 2 3\nFLASER 2 0.4 nan 1 2 0.5 0 0 0 t h #1\nROBOTLASER1 0 -1 2 0.5 80 0 0 3 1 2 inf 1 9 5 6 7 ${"0 ".repeat(11)}`,
  );
  assert.deepEqual({ ...pose }, { x: 1, y: 2, theta: 3 });
  assert.ok(flaser instanceof Scan && robotlaser instanceof Scan);
  assert.deepEqual(Array.from(flaser.ranges), [NaN, NaN]);
  assert.equal(flaser.pose.theta, 0.5);
  assert.deepEqual(Array.from(robotlaser.angles), [-1, -0.5, 0]);
  assert.deepEqual({ ...robotlaser.pose }, { x: 5, y: 6, theta: 7 });
});

test("a line may come in many pieces, and a scenario twice", () => {
  const bytes = new TextEncoder().encode(`${HEADER}POSE 1 2 3\r\nPOSE 4 5 6`);
  const scenario = readScenario({
    name: "a.log",
    *chunks(offset) {
      for (let i = offset; i < bytes.length; i++)
        yield bytes.subarray(i, i + 1);
    },
  });
  for (let time = 0; time < 3; time++) {
    const scans = Array.from(scenario.scans());
    assert.deepEqual(
      scans.map((scan) => scan instanceof Pose && scan.x),
      [1, 4],
    );
  }
});

const ERRORS = {
  "": "0: no scan",
  "POSE 1 2 3": "1: occgrid_width is missing",
  [`${HEADER}\n# é\nPOSE 1 2`]: "9: POSE takes 3 values, found 2",
  [`${HEADER}POSE 1 2 3\nWALL 1 2 3 4`]:
    "8: WALL must stand before the first scan",
  [`${HEADER}é`]: "7: not plain ASCII text",
  [`${HEADER}1a`]: "7: '1a' is not a keyword",
  [`${HEADER}PARAM occgrid_width 5`]: "7: occgrid_width is given twice",
  [`${HEADER}PARAM occgrid_toString 5`]:
    "7: unknown parameter occgrid_toString",
  [`${HEADER}PARAM occgrid_p0 nan`]:
    "7: occgrid_p0 'nan' is not between 0 and 1",
  [`${HEADER}PARAM occgrid_beams 1.0`]:
    "7: occgrid_beams '1.0' is not a whole number",
  [`${HEADER}PARAM occgrid_fov 7`]:
    "7: occgrid_fov '7' is not from 0 to 6.283185307179586",
  [`${HEADER}PARAM occgrid_no_return no`]:
    "7: occgrid_no_return 'no' is not free or ignore",
  [`${HEADER}PARAM occgrid_min_range 9\nPOSE 0 0 0`]:
    "7: occgrid_min_range is not below occgrid_max_range",
  [`${HEADER}PARAM occgrid_l_min 0.1\nPOSE 0 0 0`]:
    "7: logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max",
  [`${HEADER}FLASER`]: "7: FLASER has no beam count",
  [`${HEADER}FLASER 2 -1 0 0 0 0 0 0 0 0 0`]:
    "7: FLASER with 2 beams takes 12 values, found 11",
  [`${HEADER}FLASER 1 -1 0 0 0 0 0 0 0 0 0`]: "7: range 0 '-1' is negative",
  [`${HEADER}ROBOTLASER1 1 2 3 4 5 6 7`]: "7: ROBOTLASER1 has no beam count",
  [`${HEADER}ROBOTLASER1 0 0 0 0 0 0 0 1 1 0`]:
    "7: ROBOTLASER1 with 1 beams takes at least 24 values, found 10",
};
for (const [text, expected] of Object.entries(ERRORS)) {
  test(`error ${expected}`, () => {
    assert.throws(
      () => scansOf(text),
      (error) => {
        assert.ok(error instanceof ScenarioError);
        assert.equal(error.message, `a.log:${expected}`);
        return true;
      },
    );
  });
}

test("the log-odds read back to the same doubles", () => {
  const grid = new OccupancyGrid(new GridSpec(4, 1, 1, 0, 0));
  grid.logOdds.set([-0, 5e-324, 0.1 + 0.2, -8]);
  const [header, row] = Array.from(mapLogOdds(grid));
  assert.equal(header, "# logodds 4 1\n");
  const values = row.trimEnd().split(" ").map(Number);
  assert.ok(values.every((value, i) => Object.is(value, grid.logOdds[i])));
});

test("YAML: names are quoted where they must be, thresholds follow the prior", () => {
  const spec = new GridSpec(4, 1, 0.1, -11, 1 / 1024);
  const yaml = (/** @type {number} */ p0, /** @type {string} */ name) =>
    mapYaml(new OccupancyGrid(spec, p0), name).split("\n");
  assert.deepEqual(yaml(0.5, "a-1.pgm"), [
    "image: a-1.pgm",
    "mode: trinary",
    "resolution: 0.1",
    "origin: [-11.0, 0.000976562, 0.0]",
    "negate: 0",
    "occupied_thresh: 0.65",
    "free_thresh: 0.196",
    "",
  ]);
  const names = {
    "-a": '"-a"',
    ".a": '".a"',
    'a"\\b': '"a\\"\\\\b"',
    "a\n\x7f": '"a\\x0A\\x7F"',
    "é #": '"é #"',
  };
  for (const [name, quoted] of Object.entries(names)) {
    assert.equal(yaml(0.5, name)[0], `image: ${quoted}`);
  }
  for (const p0 of [0.001, 0.15, 0.3, 0.7, 0.85, 0.999]) {
    const lines = yaml(p0, "a");
    const p = 1 - pixel(logit(p0)) / 255; // as map_server reads it
    assert.ok(p <= Number(lines[5].split(" ")[1]), `${p0}: ${lines[5]}`);
    assert.ok(p >= Number(lines[6].split(" ")[1]), `${p0}: ${lines[6]}`);
  }
});

test("fixed: nine decimals, ties to even", () => {
  const texts = {
    "1/1024": fixed(1 / 1024),
    "3/1024": fixed(3 / 1024),
    "-3/1024": fixed(-3 / 1024),
    tiny: fixed(-1e-10),
    one: fixed(1),
    third: fixed(1 / 3),
    million: fixed(-1e7),
  };
  assert.deepEqual(texts, {
    "1/1024": "0.000976562",
    "3/1024": "0.002929688",
    "-3/1024": "-0.002929688",
    tiny: "0.0",
    one: "1.0",
    third: "0.333333333",
    million: "-10000000.0",
  });
});
