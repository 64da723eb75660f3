package occgrid;

import java.util.Arrays;
import occgrid.Fast.Steps;
import occgrid.Grid.Cell;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Readings;
import occgrid.Sensor.Scan;

/**
 * Beams that touch the grid, by their first and last cell: a list that is
 * used again and again.
 *
 * <p>
 * They lie side by side, as numbers; objects would be scattered in memory and
 * slow to go through. Cells are ints here: a beam of at most 2^20 steps that
 * touches a grid keeps that close to it.
 */
final class Beams {
    /** Numbers of a beam: gx0, gy0, gx1, gy1, and 1 for a hit, else 0. */
    private static final int NUMBERS = 5;
    /** Binary digits of a fixed-point number after its point. */
    private static final int FRACTION = 42;

    private int[] numbers = new int[NUMBERS << 8];
    private int size;

    /** Removes all beams. */
    void clear() {
        size = 0;
    }

    /** How many there are. */
    int size() {
        return size;
    }

    // names of a beam's numbers, for those who share out the work
    int gx0(int beam) {
        return numbers[NUMBERS * beam];
    }

    int gy0(int beam) {
        return numbers[NUMBERS * beam + 1];
    }

    int gx1(int beam) {
        return numbers[NUMBERS * beam + 2];
    }

    int gy1(int beam) {
        return numbers[NUMBERS * beam + 3];
    }

    /** Appends the beams of a scan that are used and touch the grid. */
    void append(OccupancyGrid grid, Scan scan, double zMax,
            NoReturn noReturn) {
        Readings read = Sensor.readRanges(scan.ranges(), zMax, noReturn);
        double x = scan.pose().x();
        double y = scan.pose().y();
        double theta = scan.pose().theta();
        double[] angles = scan.angles();
        Cell robot = grid.worldToGrid(x, y);
        int width = grid.spec().width();
        int height = grid.spec().height();
        for (int i = 0; i < read.z().length; i++) {
            if (!read.used()[i]) {
                continue;
            }
            double z = read.z()[i];
            SinCos beam = SinCos.of(theta + angles[i]);
            Cell end = grid.worldToGrid(x + z * beam.cos(),
                    y + z * beam.sin());
            Ray.extent(robot.gx(), end.gx()); // refuses long lines
            Ray.extent(robot.gy(), end.gy());
            if (touches(robot.gx(), end.gx(), width)
                    && touches(robot.gy(), end.gy(), height)) {
                add((int) robot.gx(), (int) robot.gy(), (int) end.gx(),
                        (int) end.gy(), read.hit()[i]);
            }
        }
    }

    /** Whether some of the cells from a to b are among 0 .. count - 1. */
    private static boolean touches(long a, long b, int count) {
        return Math.max(a, b) >= 0 && Math.min(a, b) < count;
    }

    /** Appends a beam. */
    void add(int gx0, int gy0, int gx1, int gy1, boolean hit) {
        int at = size * NUMBERS;
        if (at == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * at);
        }
        numbers[at] = gx0;
        numbers[at + 1] = gy0;
        numbers[at + 2] = gx1;
        numbers[at + 3] = gy1;
        numbers[at + 4] = hit ? 1 : 0;
        size++;
    }

    /**
     * Updates the rows first .. last of a grid by all beams, in order. All
     * rows of a grid, cut into bands, may be updated at the same time.
     */
    void updateRows(OccupancyGrid grid, int first, int last) {
        int width = grid.spec().width();
        int height = last - first + 1;
        for (int i = 0; i < size; i++) {
            int at = i * NUMBERS;
            int gx0 = numbers[at];
            int gy0 = numbers[at + 1];
            int gx1 = numbers[at + 2];
            int gy1 = numbers[at + 3];
            boolean hit = numbers[at + 4] != 0;
            if (Math.max(gy0, gy1) < first || last < Math.min(gy0, gy1)) {
                continue;
            }
            // the rows as a grid of their own
            Steps inside = Fast.clipRay(gx0, gy0 - first, gx1, gy1 - first,
                    width, height);
            int lastFree = inside.last();
            if (hit) {
                int a = Math.max(Math.abs(gx1 - gx0), Math.abs(gy1 - gy0));
                lastFree = Math.min(lastFree, a - 1);
            }
            updateLine(grid, gx0, gy0, gx1, gy1, inside.first(), lastFree,
                    grid.lFree());
            if (hit && first <= gy1 && gy1 <= last) {
                grid.updateCell(gx1, gy1, grid.lOcc());
            }
        }
    }

    /**
     * Applies updateCell to the steps first .. last of a line, which all lie
     * in the grid; to none if last is below first.
     *
     * <p>
     * Each step goes one cell along the longer axis, so the index of a cell
     * grows by 1 or by the width. The way along the shorter axis is the
     * closed form of SPEC.md section 2.4, (2 k b + a - 1) / (2 a), as a
     * fixed-point number: a start of (a - 1) / (2 a) and b / a more for each
     * step. For example a line of a = 4, b = 1 has gone 0.375, 0.625, 0.875,
     * 1.125, 1.375 at its steps 0 to 4, so its cells are 0, 0, 0, 1, 1 away.
     *
     * <p>
     * Start and slope are rounded up by at most one unit each, so after k
     * steps the number is too large by at most k + 1 units of 2^-42. The
     * exact value stays 1 / (2 a) or more below the next whole number, which
     * is farther: 2 a (a + 1) is below 2^42 for a up to 2^20. As l0 lies
     * within the bounds, evidence of one sign can break only one of them.
     */
    static void updateLine(OccupancyGrid grid, int gx0, int gy0, int gx1,
            int gy1, int first, int last, double lUpdate) {
        int width = grid.spec().width();
        double[] logOdds = grid.cells();
        int dx = Math.abs(gx1 - gx0);
        int dy = Math.abs(gy1 - gy0);
        int xStep = gx0 < gx1 ? 1 : -1;
        int yStep = gy0 < gy1 ? width : -width;
        boolean alongX = dx >= dy;
        int majorStep = alongX ? xStep : yStep;
        int minorStep = alongX ? yStep : xStep;
        // a line of one cell has step 0 only: any extent will do
        long a = Math.max(Math.max(dx, dy), 1);
        long b = Math.min(dx, dy);
        long slope = (b << FRACTION) / a + 1;
        long minor = ((a - 1) << FRACTION) / (2 * a) + 1 + first * slope;
        long start = (long) gy0 * width + gx0;
        // far outside these wrap around, but their sum does not
        int major = (int) (start + (long) first * majorStep);

        double delta = lUpdate - grid.l0();
        boolean down = delta < 0.0;
        double bound = down ? grid.lMin() : grid.lMax();
        for (int k = first; k <= last; k++) {
            int cell = major + (int) (minor >> FRACTION) * minorStep;
            double value = logOdds[cell] + delta;
            // no branch: the processor would guess wrong too often
            logOdds[cell] = down
                    ? Math.max(value, bound)
                    : Math.min(value, bound);
            major += majorStep;
            minor += slope;
        }
    }
}
