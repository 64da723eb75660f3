package occgrid;

import java.util.Arrays;
import occgrid.Grid.Cell;
import occgrid.Grid.OccupancyGrid;
import occgrid.PortableMath.SinCos;
import occgrid.Ray.Steps;
import occgrid.World.Pose;

/**
 * The range sensor: bearings, what a range means, and the update of the grid
 * (lesson section 4). One file, one room: sensor.
 */
public final class Sensor {
    /** The double nearest to pi. */
    static final double PI = 3.141592653589793;

    private Sensor() {
    }

    /** What a beam without return means. */
    public enum NoReturn {
        /** Its cells are free, up to the maximum range. */
        FREE,
        /** Nothing. */
        IGNORE
    }

    /**
     * One scan.
     *
     * @param pose the sensor's pose
     * @param angles (n) bearings from the heading, radians
     * @param ranges (n) metres
     */
    public record Scan(Pose pose, double[] angles, double[] ranges)
            implements
                Scenario.Observation {
    }

    /**
     * Points of the world where the beams of a scan end.
     *
     * @param ex (n) metres
     * @param ey (n) metres
     */
    public record Endpoints(double[] ex, double[] ey) {
    }

    /**
     * A beam that says something, by its first and last cell; both may lie
     * outside the grid.
     *
     * @param gx0 column of the robot
     * @param gy0 row of the robot
     * @param gx1 column of the beam's end
     * @param gy1 row of the beam's end
     * @param hit whether something stands there
     */
    public record Beam(int gx0, int gy0, int gx1, int gy1, boolean hit) {
    }

    /**
     * A list of beams that is used again and again. They lie side by side, as
     * numbers: objects would be scattered in memory, and slow to go through.
     */
    public static final class Beams {
        private static final int NUMBERS = 5;

        private int[] numbers = new int[NUMBERS << 10];
        private int size;

        /** Removes all beams. */
        public void clear() {
            size = 0;
        }

        /**
         * How many there are.
         *
         * @return the number of beams
         */
        public int size() {
            return size;
        }

        /**
         * Appends a beam.
         *
         * @param beam the beam
         */
        public void add(Beam beam) {
            int at = size * NUMBERS;
            if (at == numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * at);
            }
            numbers[at] = beam.gx0();
            numbers[at + 1] = beam.gy0();
            numbers[at + 2] = beam.gx1();
            numbers[at + 3] = beam.gy1();
            numbers[at + 4] = beam.hit() ? 1 : 0;
            size++;
        }

        /**
         * One of the beams.
         *
         * @param i its place, from 0
         * @return the beam
         */
        public Beam get(int i) {
            int at = i * NUMBERS;
            return new Beam(numbers[at], numbers[at + 1], numbers[at + 2],
                    numbers[at + 3], numbers[at + 4] != 0);
        }
    }

    /**
     * Rows of a grid; none if last is below first.
     *
     * @param first the first of them
     * @param last the last of them
     */
    public record Rows(int first, int last) {
    }

    // [snippet: beam-angles]
    /**
     * Bearings of a simulated scan.
     *
     * @param fov field of view, radians
     * @param beams number of beams
     * @return (beams) radians from the heading
     */
    public static double[] beamAngles(double fov, int beams) {
        double[] angles = new double[beams];
        for (int i = 0; i < beams && beams > 1; i++) {
            angles[i] = -(fov / 2.0) + (fov * i) / (beams - 1);
        }
        return angles;
    }
    // [/snippet]

    // [snippet: flaser-angles]
    /**
     * Bearings of a FLASER scan: its step is known by its count.
     *
     * @param beams number of beams
     * @return (beams) radians from the heading
     */
    public static double[] flaserAngles(int beams) {
        double step = switch (beams) {
            case 180, 181 -> PI / 180.0;
            case 360, 361 -> PI / 360.0;
            case 400, 401 -> PI / 720.0;
            case 1 -> 0.0;
            default -> PI / (beams - 1);
        };
        double[] angles = new double[beams];
        for (int i = 0; i < beams; i++) {
            angles[i] = -(PI / 2.0) + i * step;
        }
        return angles;
    }
    // [/snippet]

    // [snippet: read-ranges]
    /**
     * What ranges mean. NaN is ignored. At zMax or beyond nothing was hit
     * (lesson Problem 3): the beam is free up to zMax, or ignored.
     *
     * @param ranges (n) metres
     * @param zMax the sensor's maximum range, metres
     * @param noReturn what a beam without return means
     * @return (n) metres: below zMax a hit, zMax no return, NaN ignored
     */
    public static double[] readRanges(double[] ranges, double zMax,
            NoReturn noReturn) {
        double[] z = ranges.clone();
        for (int i = 0; i < z.length; i++) {
            if (z[i] >= zMax - 1e-12) {
                z[i] = noReturn == NoReturn.FREE ? zMax : Double.NaN;
            }
        }
        return z;
    }
    // [/snippet]

    // [snippet: beam-endpoints]
    /**
     * Where the beams of a scan end.
     *
     * @param pose the sensor's pose
     * @param angles (n) bearings from the heading, radians
     * @param z (n) lengths of the beams, metres
     * @return (n) points, metres; NaN where z is NaN
     */
    public static Endpoints beamEndpoints(Pose pose, double[] angles,
            double[] z) {
        double[] ex = new double[z.length];
        double[] ey = new double[z.length];
        for (int i = 0; i < z.length; i++) {
            SinCos beam = PortableMath.sinCos(pose.theta() + angles[i]);
            ex[i] = pose.x() + z[i] * beam.cos();
            ey[i] = pose.y() + z[i] * beam.sin();
        }
        return new Endpoints(ex, ey);
    }
    // [/snippet]

    // [snippet: update-grid-from-scan]
    /**
     * The inverse sensor model: free along each beam, occupied at its hit.
     *
     * @param grid the grid, changed in place
     * @param scan the scan
     * @param zMax the sensor's maximum range, metres
     * @param noReturn what a beam without return means
     */
    public static void updateGridFromScan(OccupancyGrid grid, Scan scan,
            double zMax, NoReturn noReturn) {
        double[] z = readRanges(scan.ranges(), zMax, noReturn);
        Endpoints ends = beamEndpoints(scan.pose(), scan.angles(), z);
        Cell robot = grid.worldToGrid(scan.pose().x(), scan.pose().y());
        int gx0 = robot.gx();
        int gy0 = robot.gy();
        int width = grid.spec.width();
        int height = grid.spec.height();
        for (int i = 0; i < z.length; i++) {
            if (Double.isNaN(z[i])) {
                continue;
            }
            Cell end = grid.worldToGrid(ends.ex()[i], ends.ey()[i]);
            int gx1 = end.gx();
            int gy1 = end.gy();
            Steps inside = Ray.clipRay(gx0, gy0, gx1, gy1, width, height);
            int last = inside.last();
            boolean hit = z[i] < zMax;
            if (hit) {
                int a = Math.max(Math.abs(gx1 - gx0), Math.abs(gy1 - gy0));
                last = Math.min(last, a - 1);
            }
            grid.updateLine(gx0, gy0, gx1, gy1, inside.first(), last,
                    grid.lFree);
            if (hit) {
                grid.updateCell(gx1, gy1, grid.lOcc);
            }
        }
    }
    // [/snippet]

    /**
     * Appends the beams of a scan, in order, without those that say nothing.
     *
     * @param beams the list to append to
     * @param grid where the cells lie
     * @param scan the scan
     * @param zMax the sensor's maximum range, metres
     * @param noReturn what a beam without return means
     */
    public static void appendBeams(Beams beams, OccupancyGrid grid,
            Scan scan, double zMax, NoReturn noReturn) {
        double[] z = readRanges(scan.ranges(), zMax, noReturn);
        Endpoints ends = beamEndpoints(scan.pose(), scan.angles(), z);
        Cell robot = grid.worldToGrid(scan.pose().x(), scan.pose().y());
        for (int i = 0; i < z.length; i++) {
            if (!Double.isNaN(z[i])) {
                Cell end = grid.worldToGrid(ends.ex()[i], ends.ey()[i]);
                beams.add(new Beam(robot.gx(), robot.gy(), end.gx(), end.gy(),
                        z[i] < zMax));
            }
        }
    }

    /**
     * updateGridFromScan for beams of any number of scans, in order, but only
     * for some rows of the grid.
     *
     * @param grid the grid, changed in place
     * @param beams the beams
     * @param rows the rows
     */
    public static void updateRowsFromBeams(OccupancyGrid grid,
            Beams beams, Rows rows) {
        int width = grid.spec.width();
        int height = rows.last() - rows.first() + 1;
        for (int i = 0; i < beams.size(); i++) {
            Beam beam = beams.get(i);
            int gx0 = beam.gx0();
            int gy0 = beam.gy0();
            int gx1 = beam.gx1();
            int gy1 = beam.gy1();
            if (Math.max(gy0, gy1) < rows.first()
                    || rows.last() < Math.min(gy0, gy1)) {
                continue;
            }
            // the rows as a grid of their own
            Steps inside = Ray.clipRay(gx0, gy0 - rows.first(), gx1,
                    gy1 - rows.first(), width, height);
            int last = inside.last();
            if (beam.hit()) {
                int a = Math.max(Math.abs(gx1 - gx0), Math.abs(gy1 - gy0));
                last = Math.min(last, a - 1);
            }
            grid.updateLine(gx0, gy0, gx1, gy1, inside.first(), last,
                    grid.lFree);
            if (beam.hit() && rows.first() <= gy1 && gy1 <= rows.last()) {
                grid.updateCell(gx1, gy1, grid.lOcc);
            }
        }
    }
}
