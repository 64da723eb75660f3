package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import java.util.Random;
import java.util.stream.Stream;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Settings;
import occgrid.Sensor.Beam;
import occgrid.Sensor.Beams;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Rows;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

/** Several threads draw the map that one draws, bit for bit. */
class MapperTest {
    private static final int[] THREADS = {1, 2, 3, 7};

    /** Doubles as bits: assertArrayEquals forgives the sign of zero. */
    private static long[] bits(double[] values) {
        return Arrays.stream(values).mapToLong(Double::doubleToRawLongBits)
                .toArray();
    }

    /** Scans in and around a grid of this height. */
    private static Scenario randomLog(int height, int scans) {
        Settings settings = new Settings(97, height, 0.1, -4.0, -2.0, 9.0,
                0.5, 0.75, 0.3, -1.5, 2.0, NoReturn.FREE, 3.0, 181, 0.02);
        Random random = new Random(5);
        Iterator<Observation> log = Stream
                .generate(() -> (Observation) randomScan(random)).limit(scans)
                .iterator();
        return new Scenario("random", settings, List.of(), log);
    }

    private static Scan randomScan(Random random) {
        Pose pose = new Pose(random.nextDouble(-6.0, 8.0),
                random.nextDouble(-4.0, 6.0), random.nextDouble(-9.0, 9.0));
        double[] ranges = random.doubles(300, 0.0, 12.0).toArray();
        ranges[7] = Double.NaN;
        return new Scan(pose, Sensor.beamAngles(6.0, 300), ranges);
    }

    @Test
    void theLessonInBands() {
        for (OptionalLong seed : List.of(OptionalLong.empty(),
                OptionalLong.of(3))) {
            long[] plain = bits(Mapper
                    .mapScenario(Lesson.lessonScenario(), seed).logOdds);
            for (int threads : THREADS) {
                assertArrayEquals(plain,
                        bits(Mapper.mapScenarioInBands(
                                Lesson.lessonScenario(), seed,
                                threads).logOdds));
            }
        }
    }

    /** Beams for several batches; grids of fewer rows than threads. */
    @Test
    void randomLogsInBands() {
        OptionalLong noSeed = OptionalLong.empty();
        for (int height : new int[]{60, 5, 1}) {
            double[] plain = Mapper.mapScenario(randomLog(height, 500),
                    noSeed).logOdds;
            assertTrue(Arrays.stream(plain).anyMatch(l -> l == -1.5));
            for (int threads : THREADS) {
                assertArrayEquals(bits(plain),
                        bits(Mapper.mapScenarioInBands(
                                randomLog(height, 500), noSeed,
                                threads).logOdds));
            }
        }
    }

    /** An error comes out while the bands are at work on a batch. */
    @Test
    void errorsOfTheLogComeThrough() {
        for (int after : new int[]{0, 500}) {
            Scenario log = randomLog(60, 600);
            Iterator<Observation> failing = new Iterator<>() {
                private int left = after;

                @Override
                public boolean hasNext() {
                    return true;
                }

                @Override
                public Observation next() {
                    if (left-- == 0) {
                        throw new IllegalArgumentException("bad");
                    }
                    return log.scans().next();
                }
            };
            Scenario bad = new Scenario("bad", log.settings(), List.of(),
                    failing);
            assertThrows(IllegalArgumentException.class, () -> Mapper
                    .mapScenarioInBands(bad, OptionalLong.empty(), 3));
        }
    }

    @Test
    void bandsCoverEveryRowOnce() {
        Beams beams = new Beams();
        beams.add(new Beam(0, -5, 10, 300, true));
        beams.add(new Beam(0, 3, 50, 3, false));
        beams.add(new Beam(0, -9, 0, -1, true));
        for (int height : new int[]{1, 2, 7, 400}) {
            for (int count : THREADS) {
                int row = 0;
                for (Rows rows : Mapper.cutBands(List.of(beams), height,
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
        Beam fan = new Beam(0, 10, 3, 13, true);
        Beams beams = new Beams();
        for (int i = 0; i < 40; i++) {
            beams.add(fan);
        }
        assertEquals(11,
                Mapper.cutBands(List.of(beams), 100, 2).get(0).last());
        beams.add(new Beam(0, 90, 1000, 90, true));
        assertEquals(90,
                Mapper.cutBands(List.of(beams), 100, 2).get(0).last());
    }

    /** More than there is room for at first, twice. */
    @Test
    void beamsComeBackAsTheyWere() {
        Beams beams = new Beams();
        for (int round = 0; round < 2; round++) {
            beams.clear();
            for (int i = 0; i < 5000; i++) {
                beams.add(new Beam(i, -i, 7 * i, round, i % 3 == 0));
            }
            assertEquals(5000, beams.size());
            for (int i = 0; i < 5000; i++) {
                assertEquals(new Beam(i, -i, 7 * i, round, i % 3 == 0),
                        beams.get(i));
            }
        }
    }
}
