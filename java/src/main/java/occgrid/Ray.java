package occgrid;

import java.util.ArrayList;
import java.util.List;
import occgrid.Grid.Cell;

/**
 * Which cells a beam crosses: Bresenham's line (lesson section 4, line
 * traversal). One file, one room: ray.
 */
public final class Ray {
    private Ray() {
    }

    /**
     * Steps of a line, first to last; none if last is below first.
     *
     * @param first the first step, from 0
     * @param last the last step
     */
    public record Steps(int first, int last) {
    }

    // [snippet: bresenham]
    /**
     * Cells of the line from (gx0, gy0) to (gx1, gy1), in order, both ends
     * included: Bresenham's integer line (1965).
     *
     * <p>Step k goes k cells along the longer axis and
     * floor((2 k b + a - 1) / (2 a)) along the shorter one, where a and b
     * are the line's extents along the two.
     *
     * @param gx0 column of the first cell
     * @param gy0 row of the first cell
     * @param gx1 column of the last cell
     * @param gy1 row of the last cell
     * @return the max(|gx1 - gx0|, |gy1 - gy0|) + 1 cells
     */
    public static List<Cell> bresenham(int gx0, int gy0, int gx1, int gy1) {
        int dx = Math.abs(gx1 - gx0);
        int dy = Math.abs(gy1 - gy0);
        int sx = gx0 < gx1 ? 1 : -1;
        int sy = gy0 < gy1 ? 1 : -1;
        int err = dx - dy;
        int gx = gx0;
        int gy = gy0;
        List<Cell> cells = new ArrayList<>();
        cells.add(new Cell(gx, gy));
        while (gx != gx1 || gy != gy1) {
            int e2 = 2 * err;
            if (e2 > -dy) {
                err -= dy;
                gx += sx;
            }
            if (e2 < dx) {
                err += dx;
                gy += sy;
            }
            cells.add(new Cell(gx, gy));
        }
        return cells;
    }
    // [/snippet]

    // [snippet: clip-ray]
    /**
     * First and last step of a line that lie in the grid. No cell outside
     * is visited: step k has gone m cells along the shorter axis, or more,
     * exactly when 2 k b >= 2 a m - a + 1.
     *
     * @param gx0 column of the line's first cell
     * @param gy0 row of the line's first cell
     * @param gx1 column of the line's last cell
     * @param gy1 row of the line's last cell
     * @param width the grid's columns
     * @param height the grid's rows
     * @return the steps; last is below first if the line misses the grid
     */
    public static Steps clipRay(int gx0, int gy0, int gx1, int gy1,
            int width, int height) {
        long dx = Math.abs(gx1 - gx0);
        long dy = Math.abs(gy1 - gy0);
        long a = Math.max(dx, dy);
        long b = Math.min(dx, dy);
        boolean alongX = dx >= dy;
        // steps that each axis may go: low <= step <= high
        long xLow = gx0 < gx1 ? -gx0 : gx0 - (width - 1);
        long yLow = gy0 < gy1 ? -gy0 : gy0 - (height - 1);
        long xHigh = xLow + (width - 1);
        long yHigh = yLow + (height - 1);
        long enters = firstStep(alongX ? yLow : xLow, a, b);
        long leaves = firstStep((alongX ? yHigh : xHigh) + 1, a, b);
        long first = Math.max(Math.max(alongX ? xLow : yLow, 0), enters);
        long last = Math.min(Math.min(alongX ? xHigh : yHigh, a), leaves - 1);
        return new Steps((int) Math.min(first, a + 1),
                (int) Math.max(last, -1));
    }

    /** The first step that has gone m cells along the shorter axis. */
    private static long firstStep(long m, long a, long b) {
        if (m <= 0) {
            return 0;
        }
        return m > b ? a + 1 : -Math.floorDiv(a - 1 - 2 * a * m, 2 * b);
    }
    // [/snippet]
}
