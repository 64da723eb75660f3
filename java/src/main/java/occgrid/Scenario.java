package occgrid;

import java.util.List;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import occgrid.World.Segment;

/**
 * Settings, walls and scans, the scans read one by one as they are asked for:
 * a CARMEN log with PARAM, WALL and POSE lines (SPEC.md sections 5 and 8).
 *
 * @param name the name of the files that are written
 * @param settings what the PARAM lines set
 * @param walls the simulated world
 * @param scans what the robot sees, in order, from the first scan each time
 *        they are gone through. Those of a file throw a ScenarioException
 *        for a line that breaks a rule, and an IllegalStateException when
 *        the file is closed or, a pipe, cannot be gone through again; going
 *        through them anew ends an earlier way
 */
public record Scenario(String name, Settings settings, List<Segment> walls,
        Iterable<? extends Observation> scans) implements AutoCloseable {
    /** A scan, simulated or recorded. */
    public sealed interface Observation permits Simulated, Recorded {
    }

    /**
     * A bare pose: its scan is simulated.
     *
     * @param pose the sensor's pose
     */
    public record Simulated(Pose pose) implements Observation {
    }

    /**
     * A scan that was recorded.
     *
     * @param scan the scan; ranges below the least range are NaN
     */
    public record Recorded(Scan scan) implements Observation {
    }

    /**
     * What the PARAM lines set; the table of SPEC.md section 5.2.
     *
     * @param width cells
     * @param height cells
     * @param resolution metres
     * @param originX metres
     * @param originY metres
     * @param maxRange metres
     * @param minRange metres: recorded ranges below it are ignored
     * @param p0 prior probability of occupancy
     * @param pOcc probability that the inverse model gives to a hit cell
     * @param pFree probability that the inverse model gives to a passed cell
     * @param lMin lower bound of a cell's log-odds
     * @param lMax upper bound of a cell's log-odds
     * @param noReturn what a beam without return means
     * @param fov field of view of simulated scans, radians
     * @param beams number of beams of simulated scans
     * @param noiseStd standard deviation of simulated ranges, metres
     */
    public record Settings(int width, int height, double resolution,
            double originX, double originY, double maxRange, double minRange,
            double p0, double pOcc, double pFree, double lMin, double lMax,
            NoReturn noReturn, double fov, int beams, double noiseStd) {
        /**
         * An empty map.
         *
         * @return the grid
         */
        public OccupancyGrid newGrid() {
            GridSpec spec = new GridSpec(width, height, resolution, originX,
                    originY);
            return new OccupancyGrid(spec, p0, pOcc, pFree, lMin, lMax);
        }

        /**
         * These settings with other cells; the origin stays.
         *
         * @param width cells
         * @param height cells
         * @param resolution metres
         * @return the settings
         */
        public Settings withCells(int width, int height, double resolution) {
            return new Settings(width, height, resolution, originX, originY,
                    maxRange, minRange, p0, pOcc, pFree, lMin, lMax,
                    noReturn, fov, beams, noiseStd);
        }
    }

    /** A scenario that breaks a rule; its text is FILE:LINE: REASON. */
    public static final class ScenarioException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        /** The number of the line, from 1; 0 when no line was read. */
        public final int line;
        /** What is wrong: a text of SPEC.md section 8. */
        public final String reason;

        ScenarioException(String file, int line, String reason) {
            super(file + ":" + line + ": " + reason);
            this.line = line;
            this.reason = reason;
        }
    }

    /**
     * Opens a scenario and reads it up to its first scan. The file stays
     * open while scans are read: use it in a try statement.
     *
     * @param path the file's path
     * @return the scenario
     * @throws ScenarioException for what is wrong before the first scan;
     *         later errors come while going through the scans
     */
    public static Scenario readScenario(String path) {
        ScenarioReader reader = new ScenarioReader(path);
        try {
            return reader.read();
        } catch (RuntimeException error) {
            reader.close();
            throw error;
        }
    }

    /**
     * A scenario's name: its file name without the part from its last dot on.
     *
     * @param path the file's path; slashes at its end are dropped
     * @return the name
     */
    public static String scenarioName(String path) {
        String file = FileNames.withoutSlashes(path);
        String fileName = file.substring(file.lastIndexOf('/') + 1);
        int dot = fileName.lastIndexOf('.');
        return dot > 0 ? fileName.substring(0, dot) : fileName;
    }

    /** Closes the file, if there is one. */
    @Override
    public void close() {
        if (scans instanceof ScenarioReader reader) {
            reader.close();
        }
    }
}
