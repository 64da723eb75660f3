package occgrid;

import java.util.List;
import occgrid.Grid.Cell;
import occgrid.Grid.OccupancyGrid;
import occgrid.World.Pose;

/**
 * The range sensor: bearings, what a range means, and the update of the grid
 * (lesson section 4).
 */
public final class Sensor {
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
     * @param ranges (n) metres; NaN for a beam that is ignored
     */
    public record Scan(Pose pose, double[] angles, double[] ranges) {
    }

    // [snippet: beam-angles]
    /**
     * Bearings of a simulated scan.
     *
     * @param fov field of view, radians
     * @param nBeams number of beams
     * @return (nBeams) radians from the heading; 0 for one beam
     */
    public static double[] beamAngles(double fov, int nBeams) {
        double[] angles = new double[nBeams];
        for (int i = 0; i < nBeams && nBeams > 1; i++) {
            angles[i] = -(fov / 2.0) + (fov * i) / (nBeams - 1);
        }
        return angles;
    }
    // [/snippet]

    // [snippet: flaser-angles]
    /**
     * Bearings of a FLASER scan: its step is known by its count (SPEC.md
     * section 5.3).
     *
     * @param nBeams number of beams
     * @return (nBeams) radians from the heading
     */
    public static double[] flaserAngles(int nBeams) {
        double step = switch (nBeams) {
            case 180, 181 -> PortableMath.PI / 180.0;
            case 360, 361 -> PortableMath.PI / 360.0;
            case 400, 401 -> PortableMath.PI / 720.0;
            case 1 -> 0.0;
            default -> PortableMath.PI / (nBeams - 1);
        };
        double[] angles = new double[nBeams];
        for (int i = 0; i < nBeams; i++) {
            angles[i] = -(PortableMath.PI / 2.0) + i * step;
        }
        return angles;
    }
    // [/snippet]

    // [snippet: read-ranges]
    /**
     * What the ranges of a scan mean.
     *
     * @param z (n) lengths of the beams, metres
     * @param hit (n) whether the beam ended at something
     * @param used (n) whether the beam counts
     */
    public record Readings(double[] z, boolean[] hit, boolean[] used) {
    }

    /**
     * Reads ranges. At zMax or beyond nothing was hit (lesson Problem 3):
     * the beam is free up to zMax, or ignored. NaN is ignored.
     *
     * @param ranges (n) metres
     * @param zMax the sensor's maximum range, metres
     * @param noReturn what a beam without return means
     * @return (n) readings; z is zMax where nothing was hit
     */
    public static Readings readRanges(double[] ranges, double zMax,
            NoReturn noReturn) {
        int n = ranges.length;
        double[] z = new double[n];
        boolean[] hit = new boolean[n];
        boolean[] used = new boolean[n];
        for (int i = 0; i < n; i++) {
            hit[i] = ranges[i] < zMax - 1e-12; // false for NaN
            z[i] = hit[i] ? ranges[i] : zMax;
            used[i] = hit[i] || !Double.isNaN(ranges[i])
                    && noReturn == NoReturn.FREE;
        }
        return new Readings(z, hit, used);
    }
    // [/snippet]

    // [snippet: beam-endpoints]
    /**
     * Points of the world where the beams of a scan end.
     *
     * @param ex (n) metres
     * @param ey (n) metres
     */
    public record Endpoints(double[] ex, double[] ey) {
    }

    /**
     * Where the beams of a scan end.
     *
     * @param pose the sensor's pose
     * @param angles (n) bearings from the heading, radians
     * @param z (n) lengths of the beams, metres
     * @return (n) points, metres
     */
    public static Endpoints beamEndpoints(Pose pose, double[] angles,
            double[] z) {
        double[] ex = new double[z.length];
        double[] ey = new double[z.length];
        for (int i = 0; i < z.length; i++) {
            double beam = pose.theta() + angles[i];
            ex[i] = pose.x() + z[i] * PortableMath.cos(beam);
            ey[i] = pose.y() + z[i] * PortableMath.sin(beam);
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
     * @throws IllegalArgumentException if a beam has more than 2^20 steps
     */
    public static void updateGridFromScan(OccupancyGrid grid, Scan scan,
            double zMax, NoReturn noReturn) {
        Readings read = readRanges(scan.ranges(), zMax, noReturn);
        Endpoints ends = beamEndpoints(scan.pose(), scan.angles(), read.z());
        Cell robot = grid.worldToGrid(scan.pose().x(), scan.pose().y());
        for (int i = 0; i < read.z().length; i++) {
            if (!read.used()[i]) {
                continue;
            }
            Cell end = grid.worldToGrid(ends.ex()[i], ends.ey()[i]);
            List<Cell> cells = Ray.bresenham(robot.gx(), robot.gy(),
                    end.gx(), end.gy());
            boolean hit = read.hit()[i]; // the cells before it are free
            int nFree = hit ? cells.size() - 1 : cells.size();
            for (Cell cell : cells.subList(0, nFree)) {
                grid.updateCell(cell.gx(), cell.gy(), grid.lFree());
            }
            if (hit) {
                grid.updateCell(end.gx(), end.gy(), grid.lOcc());
            }
        }
    }
    // [/snippet]
}
