package occgrid;

import java.util.Arrays;

/**
 * The grid of log-odds (lesson sections 1 and 3). One file, one room: grid.
 */
public final class Grid {
    private Grid() {
    }

    // [snippet: grid-spec]
    /**
     * Where the cells lie in the world (lesson section 1).
     *
     * @param width number of columns
     * @param height number of rows
     * @param resolution side of a cell, metres
     * @param originX world x of the lower left corner, metres
     * @param originY world y of the lower left corner, metres
     */
    public record GridSpec(int width, int height, double resolution,
            double originX, double originY) {
    }
    // [/snippet]

    /**
     * Numbers of a cell; it may lie outside the grid.
     *
     * @param gx column
     * @param gy row
     */
    public record Cell(int gx, int gy) {
    }

    /**
     * A point of the world.
     *
     * @param x metres
     * @param y metres
     */
    public record Point(double x, double y) {
    }

    // [snippet: logit]
    /**
     * Log-odds of a probability, which is kept within [1e-9, 1 - 1e-9].
     *
     * @param p a probability
     * @return log(p / (1 - p))
     */
    public static double logit(double p) {
        double q = Math.min(Math.max(p, 1e-9), 1.0 - 1e-9);
        return PortableMath.log(q / (1.0 - q));
    }
    // [/snippet]

    // [snippet: sigmoid]
    /**
     * Probability of log-odds; no overflow at either end.
     *
     * @param logOdds any double
     * @return 1 / (1 + exp(-logOdds))
     */
    public static double sigmoid(double logOdds) {
        if (logOdds >= 0.0) {
            double z = PortableMath.exp(-logOdds);
            return 1.0 / (1.0 + z);
        }
        double z = PortableMath.exp(logOdds);
        return z / (1.0 + z);
    }
    // [/snippet]

    /**
     * Log-odds of every cell, and the steps that an update adds (lesson
     * section 3).
     */
    public static final class OccupancyGrid {
        /** Steps of the longest line: 2 a (a + 1) stays below 2^42. */
        static final int LONGEST_LINE = 1_400_000;
        /** Binary digits of a fixed-point number after its point. */
        private static final int FRACTION = 42;

        /** Where the cells lie. */
        public final GridSpec spec;
        /** Log-odds of the prior: every cell starts here. */
        public final double l0;
        /** Log-odds of the inverse sensor model where a beam hit. */
        public final double lOcc;
        /** Log-odds of the inverse sensor model where a beam passed. */
        public final double lFree;
        /** Lower bound of a cell. */
        public final double lMin;
        /** Upper bound of a cell. */
        public final double lMax;
        /**
         * The log-odds, (height * width), cell (gx, gy) at gy * width + gx:
         * the row with the smallest y comes first.
         */
        public final double[] logOdds;

        /**
         * A grid where nothing is known yet.
         *
         * @param spec where the cells lie
         * @param p0 prior probability of occupancy
         * @param pOcc probability that the model gives to a hit cell
         * @param pFree probability that the model gives to a passed cell
         * @param lMin lower bound of a cell's log-odds
         * @param lMax upper bound of a cell's log-odds
         * @throws IllegalArgumentException if logit(p0) is not within
         *         [lMin, lMax]
         */
        public OccupancyGrid(GridSpec spec, double p0, double pOcc,
                double pFree, double lMin, double lMax) {
            this.spec = spec;
            this.l0 = logit(p0);
            this.lOcc = logit(pOcc);
            this.lFree = logit(pFree);
            this.lMin = lMin;
            this.lMax = lMax;
            // updateLine relies on it
            if (!(lMin <= l0 && l0 <= lMax)) {
                throw new IllegalArgumentException("l0 outside the bounds");
            }
            this.logOdds = new double[spec.height() * spec.width()];
            Arrays.fill(logOdds, l0);
        }

        // [snippet: world-to-grid]
        /**
         * The cell of a point, which may lie outside the grid.
         *
         * @param x metres
         * @param y metres
         * @return the cell
         */
        public Cell worldToGrid(double x, double y) {
            double gx = Math.floor((x - spec.originX()) / spec.resolution());
            double gy = Math.floor((y - spec.originY()) / spec.resolution());
            return new Cell((int) gx, (int) gy);
        }

        /**
         * The centre of a cell.
         *
         * @param gx column
         * @param gy row
         * @return the point, metres
         */
        public Point gridToWorldCenter(int gx, int gy) {
            double x = spec.originX() + (gx + 0.5) * spec.resolution();
            double y = spec.originY() + (gy + 0.5) * spec.resolution();
            return new Point(x, y);
        }

        /**
         * Whether a cell lies in the grid.
         *
         * @param gx column
         * @param gy row
         * @return true inside
         */
        public boolean inBounds(int gx, int gy) {
            return 0 <= gx && gx < spec.width() && 0 <= gy
                    && gy < spec.height();
        }
        // [/snippet]

        // [snippet: update-cell]
        /**
         * Adds the evidence lUpdate - l0 to one cell and clamps it. A cell
         * outside the grid is skipped.
         *
         * @param gx column
         * @param gy row
         * @param lUpdate log-odds of the inverse sensor model
         */
        public void updateCell(int gx, int gy, double lUpdate) {
            if (inBounds(gx, gy)) {
                int cell = gy * spec.width() + gx;
                double value = logOdds[cell] + (lUpdate - l0);
                logOdds[cell] = Math.min(Math.max(value, lMin), lMax);
            }
        }
        // [/snippet]

        /**
         * Applies updateCell to the steps first .. last of the line from
         * (gx0, gy0) to (gx1, gy1), which all lie in the grid (see
         * {@link Ray#clipRay}); none if last is below first.
         *
         * <p>Each step goes one cell along the longer axis. The way along the
         * shorter one is {@link Ray#bresenham}'s closed form in fixed point:
         * its start and its slope are rounded up by at most one unit each, so
         * after a steps it is too large by at most a + 1 units of 2^-42; that
         * is less than the 1 / (2 a) by which the exact value stays below the
         * next whole number, for all lines up to LONGEST_LINE. As l0 lies
         * within the bounds, evidence of one sign can only break one of them.
         *
         * @param gx0 column of the line's first cell
         * @param gy0 row of the line's first cell
         * @param gx1 column of the line's last cell
         * @param gy1 row of the line's last cell
         * @param first the first step that is updated
         * @param last the last step that is updated
         * @param lUpdate log-odds of the inverse sensor model
         * @throws IllegalArgumentException if the line is longer than
         *         LONGEST_LINE
         */
        public void updateLine(int gx0, int gy0, int gx1, int gy1, int first,
                int last, double lUpdate) {
            int width = spec.width();
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
            if (a > LONGEST_LINE) {
                throw new IllegalArgumentException("line of " + a + " cells");
            }
            long slope = (b << FRACTION) / a + 1;
            long minor = ((a - 1) << FRACTION) / (2 * a) + 1 + first * slope;
            long start = (long) gy0 * width + gx0;
            // far outside these wrap around, but their sum does not
            int major = (int) (start + (long) first * majorStep);

            double delta = lUpdate - l0;
            boolean down = delta < 0.0;
            double bound = down ? lMin : lMax;
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

        // [snippet: probability-grid]
        /**
         * P(occupied) of every cell.
         *
         * @return (height * width), in the order of the log-odds
         */
        public double[] probabilityGrid() {
            return Arrays.stream(logOdds).map(Grid::sigmoid).toArray();
        }
        // [/snippet]
    }
}
