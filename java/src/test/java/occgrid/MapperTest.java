package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.Settings;
import occgrid.Scenario.Simulated;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

class MapperTest {
    /** A recorded scan between two that are simulated. */
    private static Scenario mixed() {
        Scan scan = new Scan(new Pose(-6.0, 0.0, 0.0), new double[]{0.1},
                new double[]{3.0});
        return new Scenario("mixed", Lesson.lessonSettings(),
                Lesson.lessonWorld(),
                List.of(new Simulated(new Pose(1.0, 2.0, 3.0)),
                        new Recorded(scan),
                        new Simulated(new Pose(1.0, 2.0, 3.0))));
    }

    @Test
    void scansAreSimulatedWithTheirNumbers() {
        Scenario scenario = mixed();
        Settings settings = scenario.settings();
        double[] angles = Sensor.beamAngles(settings.fov(), 181);
        double[] ranges = World.simulateLidarScan(new Pose(1.0, 2.0, 3.0),
                scenario.walls(), angles, 10.0);
        for (OptionalLong seed : List.of(OptionalLong.empty(),
                OptionalLong.of(9))) {
            List<Scan> scans = new ArrayList<>();
            Mapper.simulatedScans(scenario, seed).forEach(scans::add);
            assertEquals(3, scans.size());
            assertEquals(3.0, scans.get(1).ranges()[0]);
            for (int number : new int[]{0, 2}) {
                double[] expected = seed.isEmpty()
                        ? ranges
                        : Noise.addRangeNoise(ranges, 0.02, 9, number, 10.0);
                assertArrayEquals(expected, scans.get(number).ranges());
                assertArrayEquals(angles, scans.get(number).angles());
            }
        }
    }

    /** Noise-free, then with a seed: what anyone compares first. */
    @Test
    void aScenarioIsMappedAgain() {
        for (Scenario scenario : List.of(mixed(), Lesson.lessonScenario())) {
            OccupancyGrid first = Mapper.mapScenario(scenario,
                    OptionalLong.empty());
            Mapper.mapScenario(scenario, OptionalLong.of(7));
            Bits.assertSame(first,
                    Mapper.mapScenario(scenario, OptionalLong.empty()),
                    scenario.name());
        }
    }
}
