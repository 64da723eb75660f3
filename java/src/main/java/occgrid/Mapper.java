package occgrid;

import java.util.Iterator;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Settings;
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
        double[] angles = Sensor.beamAngles(settings.fov(), settings.beams());
        Iterator<? extends Observation> scans = scenario.scans();
        for (int number = 0; scans.hasNext(); number++) {
            Observation next = scans.next();
            Scan scan = next instanceof Pose pose
                    ? simulatedScan(scenario, pose, angles, number, seed)
                    : (Scan) next;
            Sensor.updateGridFromScan(grid, scan, settings.maxRange(),
                    settings.noReturn());
        }
        return grid;
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
}
