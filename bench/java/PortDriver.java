import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.MapWriter;
import occgrid.Mapper;
import occgrid.Scenario;
import occgrid.Scenario.Settings;
import occgrid.Sensor;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;

/**
 * The Java port at the benchmark's work: PortDriver WORK [THREADS].
 *
 * <p>Without THREADS: updateGridFromScan, scan after scan. With it the port's
 * mapping loop, mapScenario or mapScenarioInBands, on a scenario in memory.
 */
final class PortDriver implements Driver.Mapping {
    private final Settings settings;
    private final List<Scan> scans;
    private final int threads;
    private OccupancyGrid grid;

    private PortDriver(Driver.Work work, int threads) {
        settings = new Settings(work.width(), work.height(),
                work.resolution(), work.originX(), work.originY(),
                work.maxRange(), 0.5, 0.75, 0.30, -8.0, 8.0, NoReturn.FREE,
                3.141592653589793, 181, 0.02);
        scans = Arrays.stream(work.scans())
                .map(scan -> new Scan(
                        new Pose(scan.x(), scan.y(), scan.theta()),
                        work.angles(), scan.ranges()))
                .toList();
        this.threads = threads;
    }

    @Override
    public void map() {
        if (threads == 0) {
            grid = settings.newGrid();
            for (Scan scan : scans) {
                Sensor.updateGridFromScan(grid, scan, settings.maxRange(),
                        settings.noReturn());
            }
            return;
        }
        Scenario scenario = new Scenario("", settings, List.of(),
                scans.iterator());
        grid = threads == 1
                ? Mapper.mapScenario(scenario, OptionalLong.empty())
                : Mapper.mapScenarioInBands(scenario, OptionalLong.empty(),
                        threads);
    }

    @Override
    public void write(OutputStream out) throws IOException {
        OutputStream buffered = new BufferedOutputStream(out);
        MapWriter.mapLogOdds(grid, buffered);
        buffered.flush();
    }

    public static void main(String[] arguments) throws IOException {
        int threads = arguments.length > 1
                ? Integer.parseInt(arguments[1])
                : 0;
        Driver.answerRequests(
                new PortDriver(Driver.readWork(arguments[0]), threads));
    }
}
