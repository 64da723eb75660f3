/** Everything that ever happened to one cell. */

import { GridSpec, OccupancyGrid } from "../../src/grid.js";
import { beamEndpoints, readRanges } from "../../src/sensor.js";

/** @typedef {import("../../src/scenario.js").Settings} Settings */
/** @typedef {import("../../src/sensor.js").Scan} Scan */

/**
 * @typedef {object} CellUpdate
 * @property {number} scan from 0
 * @property {number} beam from 0
 * @property {boolean} occupied
 * @property {number} before log-odds
 * @property {number} after
 */

/**
 * The updates that a cell gets, in order.
 *
 * @param {Settings} settings
 * @param {Scan[]} scans
 * @param {number} gx
 * @param {number} gy
 * @returns {CellUpdate[]}
 */
export function cellHistory(settings, scans, gx, gy) {
  const { resolution, originX, originY, p0, pOcc, pFree } = settings;
  // a grid of this cell alone: worldToGrid counts from it
  const spec = new GridSpec(1, 1, resolution, originX, originY);
  const grid = new OccupancyGrid(
    spec,
    p0,
    pOcc,
    pFree,
    settings.lMin,
    settings.lMax,
  );
  /** @type {CellUpdate[]} */
  const updates = [];
  scans.forEach((scan, number) => {
    const { z, hit, used } = readRanges(
      scan.ranges,
      settings.maxRange,
      settings.noReturn,
    );
    const { ex, ey } = beamEndpoints(scan.pose, scan.angles, z);
    const from = grid.worldToGrid(scan.pose.x, scan.pose.y);
    for (let beam = 0; beam < z.length; beam++) {
      if (!used[beam]) continue;
      const to = grid.worldToGrid(ex[beam], ey[beam]);
      if (!isOnLine(from, to, gx, gy)) continue;
      const occupied = hit[beam] && gx === to.gx && gy === to.gy;
      const before = grid.logOdds[0];
      grid.updateCell(0, 0, occupied ? grid.lOcc : grid.lFree);
      const after = grid.logOdds[0];
      updates.push({ scan: number, beam, occupied, before, after });
    }
  });
  return updates;
}

/**
 * Whether bresenham lists a cell, by its closed form (SPEC.md section 2.4).
 *
 * @param {{gx: number, gy: number}} from
 * @param {{gx: number, gy: number}} to
 * @param {number} gx
 * @param {number} gy
 */
export function isOnLine(from, to, gx, gy) {
  const dx = Math.abs(to.gx - from.gx);
  const dy = Math.abs(to.gy - from.gy);
  const goneX = from.gx < to.gx ? gx - from.gx : from.gx - gx;
  const goneY = from.gy < to.gy ? gy - from.gy : from.gy - gy;
  if (goneX < 0 || goneX > dx || goneY < 0 || goneY > dy) return false;
  const alongX = dx >= dy;
  const a = Math.max(dx, dy);
  const k = alongX ? goneX : goneY;
  if (a === 0) return true;
  const minor = Math.floor((2 * k * Math.min(dx, dy) + a - 1) / (2 * a));
  return minor === (alongX ? goneY : goneX);
}
