package occgrid;

import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Settings;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;

/**
 * The map of {@link Mapper}, the same bits, sooner. Cells are independent of
 * each other, so only the order of the updates of one cell matters, and that
 * order is kept here.
 *
 * <p>
 * What makes it fast, in the order of what it buys: a line is walked over a
 * flat index without a list of its cells ({@link Beams}), only over the steps
 * inside the grid ({@link #clipRay}), with a sine and cosine at once
 * ({@link SinCos}), and on several threads if that is wanted ({@link Bands}).
 */
public final class Fast {
    private Fast() {
    }

    /**
     * Steps of a line, first to last; none if last is below first.
     *
     * @param first the first step, from 0
     * @param last the last step
     */
    public record Steps(int first, int last) {
    }

    // [snippet: clip-ray]
    /**
     * First and last step of a line that lie in the grid. No cell outside is
     * visited. A line of a steps along the longer axis and b along the
     * shorter has gone m cells along the shorter one, or more, exactly when
     * 2 k b >= 2 a m - a + 1 at its step k.
     *
     * <p>
     * For example the line from (-3, 0) to (5, 4) has a = 8, b = 4. It enters
     * a grid of 4 x 3 cells at step 3, where gx = 0, and would leave it at
     * step 7, where gx = 4. It has gone 3 cells up, which is above the grid,
     * when 8 k >= 41: at step 6. So steps 3 to 5 are inside.
     *
     * @param gx0 column of the line's first cell
     * @param gy0 row of the line's first cell
     * @param gx1 column of the line's last cell
     * @param gy1 row of the line's last cell
     * @param width the grid's columns
     * @param height the grid's rows
     * @return the steps; 0 to -1 if the line misses the grid
     * @throws IllegalArgumentException if the line has more than 2^20 steps
     * @throws ArithmeticException if its ends are 2^63 cells apart or more
     */
    public static Steps clipRay(long gx0, long gy0, long gx1, long gy1,
            int width, int height) {
        long dx = Ray.extent(gx0, gx1);
        long dy = Ray.extent(gy0, gy1);
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
        return first <= last
                ? new Steps((int) first, (int) last)
                : new Steps(0, -1);
    }

    /** The first step that has gone m cells along the shorter axis. */
    private static long firstStep(long m, long a, long b) {
        if (m <= 0) {
            return 0;
        }
        return m > b ? a + 1 : -Math.floorDiv(a - 1 - 2 * a * m, 2 * b);
    }
    // [/snippet]

    // [snippet: update-grid-from-scans]
    /**
     * {@link Sensor#updateGridFromScan} for scan after scan.
     *
     * @param grid the grid, changed in place
     * @param scans the scans, in order
     * @param zMax the sensor's maximum range, metres
     * @param noReturn what a beam without return means
     * @throws IllegalArgumentException if a beam has more than 2^20 steps
     */
    public static void updateGridFromScans(OccupancyGrid grid,
            Iterable<Scan> scans, double zMax, NoReturn noReturn) {
        int lastRow = grid.spec().height() - 1;
        Beams beams = new Beams();
        for (Scan scan : scans) {
            beams.clear();
            beams.append(grid, scan, zMax, noReturn);
            beams.updateRows(grid, 0, lastRow);
        }
    }
    // [/snippet]

    /**
     * {@link Mapper#mapScenario} on one thread.
     *
     * @param scenario the scenario, which can be mapped again
     * @param seed the noise's seed, 0 to 2^32 - 1; empty: free of noise
     * @return the grid
     * @throws Scenario.ScenarioException if a scan breaks a rule
     */
    public static OccupancyGrid mapScenarioFast(Scenario scenario,
            OptionalLong seed) {
        return mapScenarioFast(scenario, seed, 1);
    }

    /**
     * {@link Mapper#mapScenario} on several threads, with the same bits for
     * any number of them. Memory grows with the grid and not with the log.
     *
     * @param scenario the scenario, which can be mapped again
     * @param seed the noise's seed, 0 to 2^32 - 1; empty: free of noise
     * @param threads how many threads map; with more than one of them, the
     *        calling thread reads the scans meanwhile
     * @return the grid
     * @throws Scenario.ScenarioException if a scan breaks a rule
     * @throws IllegalArgumentException if threads is below 1
     */
    public static OccupancyGrid mapScenarioFast(Scenario scenario,
            OptionalLong seed, int threads) {
        Settings settings = scenario.settings();
        OccupancyGrid grid = settings.newGrid();
        Iterable<Scan> scans = Mapper.simulatedScans(scenario, seed);
        if (threads == 1) {
            updateGridFromScans(grid, scans, settings.maxRange(),
                    settings.noReturn());
        } else {
            Bands.update(grid, scans, settings, threads);
        }
        return grid;
    }
}
