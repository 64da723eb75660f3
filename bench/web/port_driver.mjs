/**
 * The JavaScript port at the benchmark's work: node port_driver.mjs WORK [plain]
 *
 * Without more: updateGridFromScans, all scans at once. plain: updateGridFromScan, scan after scan.
 */

import {
  GridSpec,
  mapLogOdds,
  OccupancyGrid,
  Pose,
  Scan,
  updateGridFromScan,
  updateGridFromScans,
} from "../../web/src/index.js";
import { answerRequests, readWork } from "./driver.mjs";

const work = readWork(process.argv[2]);
const plain = process.argv[3] === "plain";
const { width, height, resolution, originX, originY, maxRange } = work;
const spec = new GridSpec(width, height, resolution, originX, originY);
const scans = work.scans.map(
  ({ x, y, theta, ranges }) =>
    new Scan(new Pose(x, y, theta), work.angles, ranges),
);
let grid = new OccupancyGrid(spec);

await answerRequests(
  () => {
    grid = new OccupancyGrid(spec);
    if (plain) {
      for (const scan of scans) updateGridFromScan(grid, scan, maxRange);
    } else {
      updateGridFromScans(grid, scans, maxRange);
    }
  },
  () => mapLogOdds(grid),
);
