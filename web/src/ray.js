/** Which cells a beam crosses: Bresenham's line (lesson section 4, line traversal). */

/** The longest line that bresenham walks, in steps (SPEC.md section 2.4). */
export const LONGEST_LINE = 2 ** 20;

// [snippet: bresenham]
/**
 * Cells of the line from (gx0, gy0) to (gx1, gy1), in order, both ends
 * included: Bresenham's integer line (1965).
 *
 * @param {number} gx0 column of the first cell
 * @param {number} gy0 row of the first cell
 * @param {number} gx1 column of the last cell
 * @param {number} gy1 row of the last cell
 * @returns {{gx: number, gy: number}[]} max(|gx1-gx0|, |gy1-gy0|) + 1 cells
 * @throws {RangeError} if the line has more than 2^20 steps
 */
export function bresenham(gx0, gy0, gx1, gy1) {
  const dx = Math.abs(gx1 - gx0);
  const dy = Math.abs(gy1 - gy0);
  if (!(dx <= LONGEST_LINE && dy <= LONGEST_LINE)) {
    throw new RangeError(`a line of ${Math.max(dx, dy)} steps`);
  }
  const sx = gx0 < gx1 ? 1 : -1;
  const sy = gy0 < gy1 ? 1 : -1;
  let err = dx - dy;
  let gx = gx0;
  let gy = gy0;
  const cells = [{ gx, gy }];
  while (gx !== gx1 || gy !== gy1) {
    const e2 = 2 * err;
    if (e2 > -dy) {
      err -= dy;
      gx += sx;
    }
    if (e2 < dx) {
      err += dx;
      gy += sy;
    }
    cells.push({ gx, gy });
  }
  return cells;
}
// [/snippet]
