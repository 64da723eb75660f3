package occgrid;

import java.util.ArrayList;
import java.util.List;
import occgrid.Grid.Cell;

/**
 * Which cells a beam crosses: Bresenham's line (lesson section 4, line
 * traversal).
 */
public final class Ray {
    private Ray() {
    }

    // [snippet: bresenham]
    /** The longest line (SPEC.md section 2.4). */
    static final int MAX_STEPS = 1 << 20;

    /** |to - from|, which is refused where it is above MAX_STEPS. */
    static int extent(long from, long to) {
        long extent = Math.abs(Math.subtractExact(to, from));
        if (extent > MAX_STEPS) {
            throw new IllegalArgumentException("a line of " + extent
                    + " steps");
        }
        return (int) extent;
    }

    /**
     * Cells of the line from (gx0, gy0) to (gx1, gy1), in order, both ends
     * included: Bresenham's integer line (1965).
     *
     * @param gx0 column of the first cell
     * @param gy0 row of the first cell
     * @param gx1 column of the last cell
     * @param gy1 row of the last cell
     * @return the max(|gx1 - gx0|, |gy1 - gy0|) + 1 cells
     * @throws IllegalArgumentException if the line has more than 2^20 steps
     * @throws ArithmeticException if its ends are 2^63 cells apart or more
     */
    public static List<Cell> bresenham(long gx0, long gy0, long gx1,
            long gy1) {
        int dx = extent(gx0, gx1);
        int dy = extent(gy0, gy1);
        int sx = gx0 < gx1 ? 1 : -1;
        int sy = gy0 < gy1 ? 1 : -1;
        int err = dx - dy;
        long gx = gx0;
        long gy = gy0;
        List<Cell> cells = new ArrayList<>(Math.max(dx, dy) + 1);
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
}
