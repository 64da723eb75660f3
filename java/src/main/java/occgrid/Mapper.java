package occgrid;

import java.util.Iterator;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.Settings;
import occgrid.Scenario.Simulated;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;

/**
 * The mapping loop: scan after scan into the grid (the lesson's first flow
 * chart). {@link Fast} draws the same map sooner.
 */
public final class Mapper {
    private Mapper() {
    }

    // [snippet: map-scenario]
    /**
     * Maps all scans of a scenario.
     *
     * @param scenario the scenario, which can be mapped again
     * @param seed the noise's seed, 0 to 2^32 - 1; empty: free of noise
     * @return the grid
     * @throws Scenario.ScenarioException if a scan breaks a rule
     */
    public static OccupancyGrid mapScenario(Scenario scenario,
            OptionalLong seed) {
        Settings settings = scenario.settings();
        OccupancyGrid grid = settings.newGrid();
        for (Scan scan : simulatedScans(scenario, seed)) {
            Sensor.updateGridFromScan(grid, scan, settings.maxRange(),
                    settings.noReturn());
        }
        return grid;
    }

    /**
     * The scans of a scenario, one by one. A recorded one stays as it is; a
     * bare pose is simulated, with noise.
     *
     * @param scenario the scenario
     * @param seed the noise's seed, 0 to 2^32 - 1; empty: free of noise
     * @return the scans, from the first one each time they are asked for
     */
    public static Iterable<Scan> simulatedScans(Scenario scenario,
            OptionalLong seed) {
        Settings settings = scenario.settings();
        double[] angles = Sensor.beamAngles(settings.fov(), settings.beams());
        return () -> new Iterator<>() {
            private final Iterator<? extends Observation> rest = scenario
                    .scans().iterator();
            private int number;

            @Override
            public boolean hasNext() {
                return rest.hasNext();
            }

            @Override
            public Scan next() {
                Observation next = rest.next();
                int n = number++;
                if (next instanceof Recorded recorded) {
                    return recorded.scan();
                }
                Pose pose = ((Simulated) next).pose();
                return simulatedScan(scenario, pose, angles, n, seed);
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
            ranges = Noise.addRangeNoise(ranges, noiseStd, seed.getAsLong(),
                    number, zMax);
        }
        return new Scan(pose, angles, ranges);
    }
    // [/snippet]
}
