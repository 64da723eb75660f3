import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalLong;
import occgrid.Fast;
import occgrid.Grid.OccupancyGrid;
import occgrid.MapWriter;
import occgrid.Scenario;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.Settings;
import occgrid.Sensor;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;

/**
 * The Java port at the benchmark's work: PortDriver WORK [THREADS | plain].
 *
 * <p>Without THREADS: updateGridFromScans; with plain updateGridFromScan, scan
 * after scan. With THREADS the port's mapping loop, mapScenarioFast, on a
 * scenario in memory.
 */
final class PortDriver implements Driver.Mapping {
    private final Settings settings;
    private final List<Scan> scans;
    private final String how;
    private OccupancyGrid grid;

    private PortDriver(Driver.Work work, String how) {
        settings = new Settings(work.width(), work.height(),
                work.resolution(), work.originX(), work.originY(),
                work.maxRange(), 0.0, 0.5, 0.75, 0.30, -8.0, 8.0, NoReturn.FREE,
                3.141592653589793, 181, 0.02);
        scans = Arrays.stream(work.scans())
                .map(scan -> new Scan(
                        new Pose(scan.x(), scan.y(), scan.theta()),
                        work.angles(), scan.ranges()))
                .toList();
        this.how = how;
    }

    @Override
    public void map() {
        if (how.isEmpty()) {
            grid = settings.newGrid();
            Fast.updateGridFromScans(grid, scans, settings.maxRange(),
                    settings.noReturn());
        } else if (how.equals("plain")) {
            grid = settings.newGrid();
            for (Scan scan : scans) {
                Sensor.updateGridFromScan(grid, scan, settings.maxRange(),
                        settings.noReturn());
            }
        } else {
            Scenario scenario = new Scenario("", settings, List.of(),
                    scans.stream().map(Recorded::new).toList());
            grid = Fast.mapScenarioFast(scenario, OptionalLong.empty(),
                    Integer.parseInt(how));
        }
    }

    @Override
    public void write(OutputStream out) throws IOException {
        OutputStream buffered = new BufferedOutputStream(out);
        MapWriter.mapLogOdds(grid, buffered);
        buffered.flush();
    }

    public static void main(String[] arguments) throws IOException {
        String how = arguments.length > 1 ? arguments[1] : "";
        Driver.answerRequests(
                new PortDriver(Driver.readWork(arguments[0]), how));
    }
}
