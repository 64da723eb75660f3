package occgrid;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Settings;
import occgrid.Sensor.Beam;
import occgrid.Sensor.Beams;
import occgrid.Sensor.Rows;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;

/**
 * The mapping loop: scan after scan into the grid (the lesson's first flow
 * chart). One file, one room: mapper.
 */
public final class Mapper {
    private Mapper() {
    }

    // [snippet: map-scenario]
    /**
     * Maps all scans of a scenario. A bare pose is simulated, with noise.
     *
     * @param scenario the scenario; its scans are used up
     * @param seed the noise's seed, 0 to 2^32 - 1; without, free of noise
     * @return the grid
     * @throws Scenario.ScenarioException if a scan breaks a rule
     */
    public static OccupancyGrid mapScenario(Scenario scenario,
            OptionalLong seed) {
        Settings settings = scenario.settings();
        OccupancyGrid grid = settings.newGrid();
        Iterator<Scan> scans = simulatedScans(scenario, seed);
        while (scans.hasNext()) {
            Sensor.updateGridFromScan(grid, scans.next(),
                    settings.maxRange(), settings.noReturn());
        }
        return grid;
    }

    private static Iterator<Scan> simulatedScans(Scenario scenario,
            OptionalLong seed) {
        Settings settings = scenario.settings();
        double[] angles = Sensor.beamAngles(settings.fov(), settings.beams());
        Iterator<? extends Observation> scans = scenario.scans();
        return new Iterator<>() {
            private int number;

            @Override
            public boolean hasNext() {
                return scans.hasNext();
            }

            @Override
            public Scan next() {
                Observation next = scans.next();
                int n = number++;
                return next instanceof Pose pose
                        ? simulatedScan(scenario, pose, angles, n, seed)
                        : (Scan) next;
            }
        };
    }

    private static Scan simulatedScan(Scenario scenario, Pose pose,
            double[] angles, int number, OptionalLong seed) {
        double zMax = scenario.settings().maxRange();
        double[] ranges = World.simulateLidarScan(pose, scenario.walls(),
                angles, zMax);
        if (seed.isPresent()) {
            double noiseStd = scenario.settings().noiseStd();
            Noise.addRangeNoise(ranges, noiseStd, seed.getAsLong(), number,
                    zMax);
        }
        return new Scan(pose, angles, ranges);
    }
    // [/snippet]

    /** Beams that are updated together: bounds the memory. */
    private static final int BATCH_BEAMS = 1 << 17;

    /**
     * mapScenario on several threads, with the same bits for any number of
     * them: each owns a band of rows and takes the updates in order, while
     * this one reads on. Memory grows with the grid and not with the log.
     *
     * @param scenario the scenario; its scans are used up
     * @param seed the noise's seed, 0 to 2^32 - 1; without, free of noise
     * @param threads how many bands, each with a thread of its own
     * @return the grid
     * @throws Scenario.ScenarioException if a scan breaks a rule
     */
    public static OccupancyGrid mapScenarioInBands(Scenario scenario,
            OptionalLong seed, int threads) {
        Settings settings = scenario.settings();
        OccupancyGrid grid = settings.newGrid();
        Iterator<Scan> scans = simulatedScans(scenario, seed);
        ExecutorService workers = Executors.newFixedThreadPool(threads);
        List<Beams> beams = Stream.generate(Beams::new).limit(threads)
                .toList();
        try {
            List<Scan> batch = nextBatch(scans);
            while (!batch.isEmpty()) {
                // first the beams, each thread those of some scans
                List<Future<?>> pieces = new ArrayList<>();
                for (int t = 0; t < threads; t++) {
                    List<Scan> some = batch.subList(
                            batch.size() * t / threads,
                            batch.size() * (t + 1) / threads);
                    Beams found = beams.get(t);
                    pieces.add(workers.submit(
                            () -> findBeams(found, some, grid, settings)));
                }
                await(pieces);
                // then the updates, while this thread reads on
                for (Rows rows : cutBands(beams, settings.height(), threads)) {
                    pieces.add(
                            workers.submit(() -> beams.forEach(some -> Sensor
                                    .updateRowsFromBeams(grid, some, rows))));
                }
                batch = nextBatch(scans);
                await(pieces);
            }
            return grid;
        } catch (InterruptedException error) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(error);
        } catch (ExecutionException error) {
            throw new IllegalStateException(error);
        } finally {
            workers.shutdownNow();
        }
    }

    private static List<Scan> nextBatch(Iterator<Scan> scans) {
        List<Scan> batch = new ArrayList<>();
        for (int beams = 0; beams < BATCH_BEAMS && scans.hasNext();) {
            Scan scan = scans.next();
            batch.add(scan);
            beams += scan.ranges().length;
        }
        return batch;
    }

    private static void findBeams(Beams beams, List<Scan> scans,
            OccupancyGrid grid, Settings settings) {
        beams.clear();
        for (Scan scan : scans) {
            Sensor.appendBeams(beams, grid, scan, settings.maxRange(),
                    settings.noReturn());
        }
    }

    /** Waits for pieces of work and forgets them. */
    private static void await(List<Future<?>> pieces)
            throws InterruptedException, ExecutionException {
        for (Future<?> piece : pieces) {
            piece.get();
        }
        pieces.clear();
    }

    /**
     * Cuts the rows 0 .. height - 1 into bands, in order, that take about as
     * many updates by these beams each. Some may be empty.
     *
     * @param beams the beams
     * @param height number of rows
     * @param count number of bands
     * @return the bands
     */
    static List<Rows> cutBands(List<Beams> beams, int height, int count) {
        // how many more cells a row has of the beams than the row before
        double[] rise = new double[height + 1];
        double all = 0.0;
        for (Beams some : beams) {
            // a thousand of them say enough
            int step = 1 + some.size() / 1024;
            for (int i = 0; i < some.size(); i += step) {
                Beam beam = some.get(i);
                int low = Math.min(beam.gy0(), beam.gy1());
                int high = Math.max(beam.gy0(), beam.gy1());
                int first = Math.max(low, 0);
                int last = Math.min(high, height - 1);
                if (first > last) {
                    continue;
                }
                double columns = Math.abs(beam.gx1() - beam.gx0());
                double inRow = Math.max(1.0, columns / (high - low + 1.0));
                rise[first] += inRow;
                rise[last + 1] -= inRow;
                all += inRow * (last - first + 1);
            }
        }
        List<Rows> bands = new ArrayList<>();
        int row = 0;
        double inRow = 0.0;
        double before = 0.0;
        for (int band = 1; band <= count; band++) {
            int first = row;
            while (row < height
                    && (band == count || before < all * band / count)) {
                inRow += rise[row];
                before += inRow;
                row++;
            }
            bands.add(new Rows(first, row - 1));
        }
        return bands;
    }
}
