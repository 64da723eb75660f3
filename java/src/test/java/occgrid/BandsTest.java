package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import java.util.Random;
import java.util.stream.Stream;
import occgrid.Bands.Rows;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.Settings;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

/** Several threads draw the map that one draws, bit for bit. */
class BandsTest {
    private static final int[] THREADS = {1, 2, 3, 7};

    /** Scans in and around a grid of this height. */
    private static Scenario randomLog(int height, int scans) {
        Settings settings = new Settings(97, height, 0.1, -4.0, -2.0, 9.0,
                0.0, 0.5, 0.75, 0.3, -1.5, 2.0, NoReturn.FREE, 3.0, 181,
                0.02);
        Random random = new Random(5);
        List<Recorded> log = Stream.generate(() -> randomScan(random))
                .limit(scans).map(Recorded::new).toList();
        return new Scenario("random", settings, List.of(), log);
    }

    private static Scan randomScan(Random random) {
        Pose pose = new Pose(random.nextDouble(-6.0, 8.0),
                random.nextDouble(-4.0, 6.0), random.nextDouble(-9.0, 9.0));
        double[] ranges = random.doubles(300, 0.0, 12.0).toArray();
        ranges[7] = Double.NaN;
        return new Scan(pose, Sensor.beamAngles(6.0, 300), ranges);
    }

    /** Beams for several batches; grids of fewer rows than threads. */
    @Test
    void randomLogsInBands() {
        OptionalLong noSeed = OptionalLong.empty();
        for (int height : new int[]{60, 5, 1}) {
            Scenario log = randomLog(height, 500);
            OccupancyGrid plain = Mapper.mapScenario(log, noSeed);
            assertTrue(Arrays.stream(plain.logOdds())
                    .anyMatch(l -> l == -1.5));
            for (int threads : THREADS) {
                Bits.assertSame(plain,
                        Fast.mapScenarioFast(log, noSeed, threads),
                        threads + " threads");
            }
        }
    }

    /** An error comes out while the bands are at work on a batch. */
    @Test
    void errorsOfTheLogComeThrough() {
        for (int after : new int[]{0, 500}) {
            Scenario log = randomLog(60, 600);
            Iterable<Observation> failing = () -> {
                Iterator<? extends Observation> good = log.scans().iterator();
                return new Iterator<>() {
                    private int left = after;

                    @Override
                    public boolean hasNext() {
                        return true;
                    }

                    @Override
                    public Observation next() {
                        if (left-- == 0) {
                            throw new UnsupportedOperationException("bad");
                        }
                        return good.next();
                    }
                };
            };
            Scenario bad = new Scenario("bad", log.settings(), List.of(),
                    failing);
            assertThrows(UnsupportedOperationException.class, () -> Fast
                    .mapScenarioFast(bad, OptionalLong.empty(), 3));
        }
    }

    /** A beam that is too long fails on a worker, as on the main thread. */
    @Test
    void errorsOfAWorkerComeThrough() {
        Settings fine = new Settings(5, 5, 0.001, 0.0, 0.0, 5000.0, 0.0,
                0.5, 0.75, 0.3, -1.5, 2.0, NoReturn.FREE, 3.0, 181, 0.02);
        Scan scan = new Scan(new Pose(0.0, 0.0, 0.0), new double[1],
                new double[]{4000.0});
        Scenario bad = new Scenario("bad", fine, List.of(),
                List.of(new Recorded(scan)));
        assertThrows(IllegalArgumentException.class,
                () -> Fast.mapScenarioFast(bad, OptionalLong.empty(), 2));
    }

    @Test
    void bandsCoverEveryRowOnce() {
        Beams beams = new Beams();
        beams.add(0, -5, 10, 300, true);
        beams.add(0, 3, 50, 3, false);
        beams.add(0, -9, 0, -1, true);
        for (int height : new int[]{1, 2, 7, 400}) {
            for (int count : THREADS) {
                int row = 0;
                for (Rows rows : Bands.cutBands(List.of(beams), height,
                        count)) {
                    assertEquals(row, rows.first());
                    assertTrue(rows.last() >= rows.first() - 1);
                    row = rows.last() + 1;
                }
                assertEquals(height, row);
            }
        }
    }

    @Test
    void bandsShareTheWork() {
        // a fan of 40 beams in rows 10 to 13, then 1000 cells of row 90
        Beams beams = new Beams();
        for (int i = 0; i < 40; i++) {
            beams.add(0, 10, 3, 13, true);
        }
        assertEquals(11,
                Bands.cutBands(List.of(beams), 100, 2).get(0).last());
        beams.add(0, 90, 1000, 90, true);
        assertEquals(90,
                Bands.cutBands(List.of(beams), 100, 2).get(0).last());
    }
}
