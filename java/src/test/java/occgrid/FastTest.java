package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.Random;
import java.util.stream.IntStream;
import occgrid.Fast.Steps;
import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

/** The fast map is the plain map, bit for bit. */
class FastTest {
    // --- clipRay ---

    /** Steps inside by looking at every cell. */
    private static Steps steps(List<Cell> cells, int width, int height) {
        int[] inside = IntStream.range(0, cells.size()).filter(k -> {
            Cell cell = cells.get(k);
            return 0 <= cell.gx() && cell.gx() < width && 0 <= cell.gy()
                    && cell.gy() < height;
        }).toArray();
        int n = inside.length;
        return n == 0 ? new Steps(0, -1) : new Steps(inside[0], inside[n - 1]);
    }

    private static void checkClip(int... ends) {
        List<Cell> cells = Ray.bresenham(ends[0], ends[1], ends[2], ends[3]);
        for (int width = 1; width < 8; width++) {
            for (int height = 1; height < 8; height++) {
                assertEquals(steps(cells, width, height),
                        Fast.clipRay(ends[0], ends[1], ends[2], ends[3],
                                width, height));
            }
        }
    }

    @Test
    void clippingIsExact() {
        Random random = new Random(2);
        for (int i = 0; i < 4_000; i++) {
            int reach = i % 2 == 0 ? 12 : 60;
            checkClip(random.ints(4, -reach, reach).toArray());
        }
    }

    @Test
    void clippingIsExactFarAway() {
        long far = 20_000_000_000L;
        int a = 1 << 20;
        Steps none = new Steps(0, -1);
        assertEquals(new Steps(0, 3), Fast.clipRay(0, 0, 3, 3, 4, 4));
        for (long[] ends : new long[][]{{far, far, far - a, far - 3},
                {-far, far, -far + a, far - a}, {1L << 32, 3, 1L << 32, 5},
                {-a + 9, 5, 2, 900_000}, {3, -far, 3, -far + a}}) {
            assertEquals(none, Fast.clipRay(ends[0], ends[1], ends[2],
                    ends[3], 9, 9));
        }
        checkClip(-9_000, -9_001, 4, 2);
        assertThrows(IllegalArgumentException.class,
                () -> Fast.clipRay(0, 0, 3, -a - 1, 9, 9));
    }

    // --- updateGridFromScans ---

    private record Work(GridSpec spec, double[] p, double[] bounds,
            double zMax, NoReturn noReturn) {
        OccupancyGrid newGrid() {
            return new OccupancyGrid(spec, p[0], p[1], p[2], bounds[0],
                    bounds[1]);
        }
    }

    private static void check(Work work, List<Scan> scans) {
        OccupancyGrid plain = work.newGrid();
        for (Scan scan : scans) {
            Sensor.updateGridFromScan(plain, scan, work.zMax,
                    work.noReturn);
        }
        OccupancyGrid fast = work.newGrid();
        Fast.updateGridFromScans(fast, scans, work.zMax, work.noReturn);
        Bits.assertSame(plain, fast, work.toString());
    }

    private static Work randomWork(Random random, double x, double y) {
        double resolution = random.nextInt(3) == 0
                ? 0.25
                : 0.1 + random.nextDouble();
        GridSpec spec = new GridSpec(1 + random.nextInt(60),
                1 + random.nextInt(60), resolution, x - 9.0, y - 7.0);
        double p0 = 0.3 + 0.4 * random.nextDouble();
        // signs reversed at times: passed cells more occupied, hits less
        double pOcc = random.nextDouble(0.05, 0.95);
        double pFree = random.nextDouble(0.05, 0.95);
        double l0 = Grid.logit(p0);
        boolean tight = random.nextInt(4) == 0;
        double[] bounds = tight
                ? new double[]{l0, l0 + 1.0}
                : new double[]{-3.0, 2.5};
        return new Work(spec, new double[]{p0, pOcc, pFree}, bounds, 20.0,
                NoReturn.values()[random.nextInt(2)]);
    }

    /** Ranges among them that are limits, their neighbours, nothing. */
    private static double[] randomRanges(Random random, double zMax, int n) {
        double[] edges = {0.0, zMax, Math.nextUp(zMax), Math.nextDown(zMax),
                zMax - 1e-12, Math.nextDown(zMax - 1e-12), Double.NaN,
                Double.POSITIVE_INFINITY, 1e-9, 0.25, 1.5};
        double[] ranges = new double[n];
        for (int i = 0; i < n; i++) {
            ranges[i] = random.nextInt(3) == 0
                    ? edges[random.nextInt(edges.length)]
                    : random.nextDouble() * 1.5 * zMax;
        }
        return ranges;
    }

    private static Scan randomScan(Random random, Work work, int n) {
        GridSpec spec = work.spec;
        double x = spec.originX() + 9.0 + random.nextGaussian() * 12.0;
        double y = spec.originY() + 7.0 + random.nextGaussian() * 12.0;
        double theta = random.nextGaussian() * 4.0;
        double[] angles = Sensor.beamAngles(6.0, n);
        if (random.nextInt(3) == 0) {
            // on the edges of cells, beams along the axes and between them
            x = spec.originX() + random.nextInt(80) * spec.resolution();
            y = spec.originY() + random.nextInt(80) * spec.resolution();
            theta = 0.0;
            for (int i = 0; i < n; i++) {
                angles[i] = (i - n / 2) * (PortableMath.PI / 4.0);
            }
        }
        return new Scan(new Pose(x, y, theta), angles,
                randomRanges(random, work.zMax, n));
    }

    @Test
    void anyScansGiveTheBitsOfThePlainLoop() {
        Random random = new Random(3);
        for (int i = 0; i < 400; i++) {
            double far = i % 5 == 0 ? 9_999_000.0 : 0.0;
            Work work = randomWork(random, far, -far);
            List<Scan> scans = new ArrayList<>();
            for (int scan = 0; scan < 4; scan++) {
                scans.add(randomScan(random, work, 50));
            }
            check(work, scans);
        }
    }

    /** Coordinates of 1e7 m in cells of 1 mm, where numbers pass 2^31. */
    @Test
    void cellsFarFromTheOriginAndFarFromTheGrid() {
        double[] angles = Sensor.beamAngles(6.0, 99);
        double[] ranges = new Random(8).doubles(99, 0.0, 0.1).toArray();
        Pose pose = new Pose(1e7, -1e7, 1.0);
        Scan scan = new Scan(pose, angles, ranges);
        for (double off : new double[]{0.0, 4_294_967.296, 2e7}) {
            GridSpec spec = new GridSpec(150, 150, 0.001,
                    1e7 - 0.07 - off, -1e7 - 0.07);
            check(new Work(spec, new double[]{0.5, 0.75, 0.3},
                    new double[]{-8.0, 8.0}, 0.2, NoReturn.FREE),
                    List.of(scan));
        }
    }

    @Test
    void longBeamsAreRefusedByBoth() {
        GridSpec spec = new GridSpec(5, 5, 0.001, 0.0, 0.0);
        OccupancyGrid grid = new OccupancyGrid(spec, 0.5, 0.75, 0.3, -8, 8);
        Scan scan = new Scan(new Pose(-9.0, 0.0, 2.0), new double[1],
                new double[]{2000.0});
        assertThrows(IllegalArgumentException.class,
                () -> Sensor.updateGridFromScan(grid, scan, 3000.0,
                        NoReturn.FREE));
        assertThrows(IllegalArgumentException.class,
                () -> Fast.updateGridFromScans(grid, List.of(scan), 3000.0,
                        NoReturn.FREE));
    }

    // --- mapScenarioFast ---

    @Test
    void theLesson() {
        for (OptionalLong seed : List.of(OptionalLong.empty(),
                OptionalLong.of(3))) {
            Scenario lesson = Lesson.lessonScenario();
            OccupancyGrid plain = Mapper.mapScenario(lesson, seed);
            for (int threads : new int[]{1, 2, 3, 7}) {
                Bits.assertSame(plain,
                        Fast.mapScenarioFast(lesson, seed, threads),
                        threads + " threads");
            }
        }
        assertThrows(IllegalArgumentException.class,
                () -> Fast.mapScenarioFast(Lesson.lessonScenario(),
                        OptionalLong.empty(), 0));
    }
}
