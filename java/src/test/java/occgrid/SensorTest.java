package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

class SensorTest {
    private static final double INF = Double.POSITIVE_INFINITY;
    private static final double NAN = Double.NaN;
    private static final double PI = 3.141592653589793;

    @Test
    void simulatedBearings() {
        double[] angles = Sensor.beamAngles(PI, 181);
        assertEquals(181, angles.length);
        assertEquals(-(PI / 2.0), angles[0]);
        assertEquals(-(PI / 2.0) + (PI * 7) / 180, angles[7]);
        assertEquals(PI / 2.0, angles[180]);
        assertArrayEquals(new double[]{0.0}, Sensor.beamAngles(PI, 1));
    }

    @Test
    void recordedBearings() {
        int[] counts = {180, 181, 360, 361, 400, 401, 3, 1};
        double[] steps = {PI / 180, PI / 180, PI / 360, PI / 360, PI / 720,
                PI / 720, PI / 2, 0.0};
        for (int i = 0; i < counts.length; i++) {
            double[] angles = Sensor.flaserAngles(counts[i]);
            int last = counts[i] - 1;
            assertEquals(counts[i], angles.length);
            assertEquals(-(PI / 2.0), angles[0]);
            assertEquals(-(PI / 2.0) + last * steps[i], angles[last]);
        }
    }

    @Test
    void whatRangesMean() {
        double below = 10.0 - 2e-12;
        double[] ranges = {3.0, 0.0, NAN, INF, 10.0, 11.0, 10.0 - 1e-12,
                10.0 - 5e-13, below};
        assertArrayEquals(
                new double[]{3.0, 0.0, NAN, 10.0, 10.0, 10.0, 10.0, 10.0,
                        below},
                Sensor.readRanges(ranges, 10.0, NoReturn.FREE));
        assertArrayEquals(
                new double[]{3.0, 0.0, NAN, NAN, NAN, NAN, NAN, NAN,
                        below},
                Sensor.readRanges(ranges, 10.0, NoReturn.IGNORE));
        assertEquals(INF, ranges[3], "the scan's own ranges stay");
    }

    @Test
    void beamsEndWhereTheyPoint() {
        var ends = Sensor.beamEndpoints(new Pose(1.0, 2.0, PI / 2.0),
                new double[]{0.0, -PI / 2.0}, new double[]{3.0, NAN});
        assertEquals(1.0 + 3.0 * StrictMath.cos(PI / 2.0), ends.ex()[0]);
        assertEquals(5.0, ends.ey()[0]);
        assertEquals(NAN, ends.ex()[1]);
    }

    private static double[] row(NoReturn noReturn, double x,
            double... ranges) {
        GridSpec spec = new GridSpec(6, 1, 1.0, 0.0, 0.0);
        OccupancyGrid grid = new OccupancyGrid(spec, 0.5, 0.75, 0.25, -8, 8);
        double[] angles = new double[ranges.length];
        Sensor.updateGridFromScan(grid,
                new Scan(new Pose(x, 0.5, 0.0), angles, ranges), 4.0,
                noReturn);
        double[] units = grid.logOdds.clone();
        for (int i = 0; i < units.length; i++) {
            units[i] = Math.floor(units[i] / grid.lOcc + 0.5);
        }
        return units;
    }

    @Test
    void theInverseSensorModel() {
        NoReturn free = NoReturn.FREE;
        NoReturn ignore = NoReturn.IGNORE;
        assertArrayEquals(new double[]{-1, -1, 1, 0, 0, 0},
                row(free, 0.5, 2.0));
        assertArrayEquals(new double[]{-1, -1, -1, -1, -1, 0},
                row(free, 0.5, INF));
        assertArrayEquals(new double[6], row(ignore, 0.5, INF, 4.0, NAN));
        assertArrayEquals(new double[6], row(free, 0.5, NAN));
        // a beam of one cell that is a hit
        assertArrayEquals(new double[]{0, 1, 0, 0, 0, 0},
                row(free, 1.5, 0.2));
        // the robot stands outside
        assertArrayEquals(new double[]{-1, 1, 0, 0, 0, 0},
                row(free, -1.5, 3.0));
        assertArrayEquals(new double[6], row(free, -1.5, 1.0));
        // the hit lies outside
        assertArrayEquals(new double[]{0, 0, 0, 0, -1, -1},
                row(free, 4.5, 3.5));
        assertArrayEquals(new double[]{-2, 0, 1, 0, 0, 0},
                row(free, 0.5, 1.0, 2.0));
    }

    /** The lesson's own way: every cell of every beam, one by one. */
    private static void plainly(OccupancyGrid grid, Scan scan, double zMax,
            NoReturn noReturn) {
        Pose pose = scan.pose();
        Cell robot = grid.worldToGrid(pose.x(), pose.y());
        for (int i = 0; i < scan.ranges().length; i++) {
            double range = scan.ranges()[i];
            boolean hit = range < zMax - 1e-12;
            if (Double.isNaN(range)
                    || !hit && noReturn == NoReturn.IGNORE) {
                continue;
            }
            double z = hit ? range : zMax;
            double beam = pose.theta() + scan.angles()[i];
            Cell end = grid.worldToGrid(
                    pose.x() + z * StrictMath.cos(beam),
                    pose.y() + z * StrictMath.sin(beam));
            for (Cell cell : Ray.bresenham(robot.gx(), robot.gy(), end.gx(),
                    end.gy())) {
                grid.updateCell(cell.gx(), cell.gy(),
                        hit && cell.equals(end) ? grid.lOcc : grid.lFree);
            }
        }
    }

    @Test
    void anyScanGivesTheBitsOfThePlainLoop() {
        Random random = new Random(3);
        for (int i = 0; i < 300; i++) {
            GridSpec spec = new GridSpec(1 + random.nextInt(60),
                    1 + random.nextInt(60), 0.1 + random.nextDouble(), -9.0,
                    -7.0);
            double p0 = 0.3 + 0.4 * random.nextDouble();
            double pOcc = random.nextDouble();
            double pFree = random.nextDouble();
            OccupancyGrid plain = new OccupancyGrid(spec, p0, pOcc, pFree,
                    -3.0, 2.5);
            OccupancyGrid grid = new OccupancyGrid(spec, p0, pOcc, pFree,
                    -3.0, 2.5);
            NoReturn noReturn = NoReturn.values()[i % 2];
            for (int scans = 0; scans < 4; scans++) {
                Pose pose = new Pose(random.nextGaussian() * 12.0,
                        random.nextGaussian() * 12.0,
                        random.nextGaussian() * 4.0);
                double[] ranges = random.doubles(50, -0.5, 30.0).toArray();
                for (int k = 0; k < 50; k++) {
                    ranges[k] = k % 9 == 0 ? NAN : Math.max(ranges[k], 0.0);
                }
                Scan scan = new Scan(pose, Sensor.beamAngles(6.0, 50),
                        ranges);
                plainly(plain, scan, 20.0, noReturn);
                Sensor.updateGridFromScan(grid, scan, 20.0, noReturn);
            }
            assertArrayEquals(plain.logOdds, grid.logOdds);
        }
    }
}
