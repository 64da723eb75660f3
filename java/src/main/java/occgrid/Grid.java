package occgrid;

import java.util.Arrays;

/**
 * The grid of log-odds (lesson sections 1 and 3).
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
     * Numbers of a cell, which may lie outside the grid. They are longs: with
     * coordinates of 1e7 m and cells of 0.001 m they reach 2^35.
     *
     * @param gx column
     * @param gy row
     */
    public record Cell(long gx, long gy) {
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
     * section 3). A grid owns its cells: only {@link #updateCell} and
     * {@link Fast} change them.
     */
    public static final class OccupancyGrid {
        private final GridSpec spec;
        private final double l0;
        private final double lOcc;
        private final double lFree;
        private final double lMin;
        private final double lMax;
        private final double[] logOdds;

        /**
         * A grid where nothing is known yet.
         *
         * @param spec where the cells lie
         * @param p0 prior probability of occupancy
         * @param pOcc probability that the model gives to a hit cell
         * @param pFree probability that the model gives to a passed cell
         * @param lMin lower bound of a cell's log-odds
         * @param lMax upper bound of a cell's log-odds
         * @throws IllegalArgumentException if there is no cell, if there are
         *         2^31 or more, or if logit(p0) is not within [lMin, lMax]
         */
        public OccupancyGrid(GridSpec spec, double p0, double pOcc,
                double pFree, double lMin, double lMax) {
            this.spec = spec;
            this.l0 = logit(p0);
            this.lOcc = logit(pOcc);
            this.lFree = logit(pFree);
            this.lMin = lMin;
            this.lMax = lMax;
            long cells = (long) spec.width() * spec.height();
            if (spec.width() < 1 || spec.height() < 1
                    || cells > Integer.MAX_VALUE) {
                throw new IllegalArgumentException("a grid of " + spec.width()
                        + " x " + spec.height() + " cells");
            }
            // Fast relies on it
            if (!(lMin <= l0 && l0 <= lMax)) {
                throw new IllegalArgumentException("l0 outside the bounds");
            }
            this.logOdds = new double[(int) cells];
            Arrays.fill(logOdds, l0);
        }

        /**
         * Where the cells lie.
         *
         * @return the specification
         */
        public GridSpec spec() {
            return spec;
        }

        /**
         * Log-odds of the prior: every cell starts here.
         *
         * @return logit(p0)
         */
        public double l0() {
            return l0;
        }

        /**
         * Log-odds of the inverse sensor model where a beam hit.
         *
         * @return logit(pOcc)
         */
        public double lOcc() {
            return lOcc;
        }

        /**
         * Log-odds of the inverse sensor model where a beam passed.
         *
         * @return logit(pFree)
         */
        public double lFree() {
            return lFree;
        }

        /**
         * Lower bound of a cell.
         *
         * @return log-odds
         */
        public double lMin() {
            return lMin;
        }

        /**
         * Upper bound of a cell.
         *
         * @return log-odds
         */
        public double lMax() {
            return lMax;
        }

        /**
         * Log-odds of one cell.
         *
         * @param gx column
         * @param gy row
         * @return the log-odds
         * @throws IndexOutOfBoundsException if the cell is not in the grid
         */
        public double logOdds(long gx, long gy) {
            if (!inBounds(gx, gy)) {
                throw new IndexOutOfBoundsException("cell (" + gx + ", " + gy
                        + ") of " + spec.width() + " x " + spec.height());
            }
            return logOdds[(int) (gy * spec.width() + gx)];
        }

        /**
         * A copy of the log-odds.
         *
         * @return (height * width), cell (gx, gy) at gy * width + gx: the row
         *         with the smallest y comes first
         */
        public double[] logOdds() {
            return logOdds.clone();
        }

        /** The log-odds themselves, for {@link Fast} alone. */
        double[] cells() {
            return logOdds;
        }

        // [snippet: world-to-grid]
        /**
         * The cell of a point, which may lie outside the grid.
         *
         * @param x metres
         * @param y metres
         * @return the cell, exact below 2^53
         */
        public Cell worldToGrid(double x, double y) {
            double gx = Math.floor((x - spec.originX()) / spec.resolution());
            double gy = Math.floor((y - spec.originY()) / spec.resolution());
            return new Cell((long) gx, (long) gy);
        }

        /**
         * The centre of a cell.
         *
         * @param gx column
         * @param gy row
         * @return the point, metres
         */
        public Point gridToWorldCenter(long gx, long gy) {
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
        public boolean inBounds(long gx, long gy) {
            return 0 <= gx && gx < spec.width() && 0 <= gy
                    && gy < spec.height();
        }
        // [/snippet]

        // [snippet: update-cell]
        /**
         * Adds the evidence lUpdate - l0 to one cell and clamps it at once. A
         * cell outside the grid is skipped.
         *
         * @param gx column
         * @param gy row
         * @param lUpdate log-odds of the inverse sensor model
         */
        public void updateCell(long gx, long gy, double lUpdate) {
            if (inBounds(gx, gy)) {
                int cell = (int) (gy * spec.width() + gx);
                double value = logOdds[cell] + (lUpdate - l0);
                logOdds[cell] = Math.min(Math.max(value, lMin), lMax);
            }
        }
        // [/snippet]

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
