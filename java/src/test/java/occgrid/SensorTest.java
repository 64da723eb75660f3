package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Readings;
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

    private static void checkReadings(NoReturn noReturn, double range,
            double z, boolean hit, boolean used) {
        double[] ranges = {range};
        Readings read = Sensor.readRanges(ranges, 10.0, noReturn);
        assertEquals(z, read.z()[0]);
        assertEquals(hit, read.hit()[0]);
        assertEquals(used, read.used()[0]);
        assertEquals(range, ranges[0], "the scan's own ranges stay");
    }

    @Test
    void whatRangesMean() {
        for (NoReturn noReturn : NoReturn.values()) {
            boolean free = noReturn == NoReturn.FREE;
            for (double hit : new double[]{0.0, 3.0, 10.0 - 2e-12,
                    Math.nextDown(10.0 - 1e-12)}) {
                checkReadings(noReturn, hit, hit, true, true);
            }
            for (double none : new double[]{10.0 - 1e-12, 10.0 - 5e-13,
                    Math.nextDown(10.0), 10.0, Math.nextUp(10.0), 11.0,
                    INF}) {
                checkReadings(noReturn, none, 10.0, false, free);
            }
            checkReadings(noReturn, NAN, 10.0, false, false);
        }
    }

    @Test
    void beamsEndWhereTheyPoint() {
        var ends = Sensor.beamEndpoints(new Pose(1.0, 2.0, PI / 2.0),
                new double[]{0.0, -PI / 2.0}, new double[]{3.0, 2.0});
        assertEquals(1.0 + 3.0 * StrictMath.cos(PI / 2.0), ends.ex()[0]);
        assertEquals(5.0, ends.ey()[0]);
        assertEquals(3.0, ends.ex()[1]);
        assertEquals(2.0, ends.ey()[1]);
    }

    private static double[] row(NoReturn noReturn, double x,
            double... ranges) {
        GridSpec spec = new GridSpec(6, 1, 1.0, 0.0, 0.0);
        OccupancyGrid grid = new OccupancyGrid(spec, 0.5, 0.75, 0.25, -8, 8);
        double[] angles = new double[ranges.length];
        Sensor.updateGridFromScan(grid,
                new Scan(new Pose(x, 0.5, 0.0), angles, ranges), 4.0,
                noReturn);
        double[] units = grid.logOdds();
        for (int i = 0; i < units.length; i++) {
            units[i] = Math.floor(units[i] / grid.lOcc() + 0.5);
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
}
