package occgrid;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import occgrid.Fast.Steps;
import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.Endpoints;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Readings;
import occgrid.World.Pose;

/**
 * The port's probe: Probe FUNCTION INPUT OUTPUT lays open the functions of
 * the contract to the suite's tests (see CONTRIBUTING.md). A line of the
 * input holds a function's arguments, a line of the output its results,
 * separated by spaces. Doubles are their bits, 16 hexadecimal digits.
 */
final class Probe {
    private Probe() {
    }

    public static void main(String[] arguments) throws IOException {
        Function<String[], String> function = function(arguments[0]);
        Path input = Path.of(arguments[1]);
        Path output = Path.of(arguments[2]);
        try (Stream<String> lines = Files.lines(input,
                StandardCharsets.US_ASCII)) {
            Files.writeString(output,
                    lines.map(line -> function.apply(line.split(" ")))
                            .map(line -> line + "\n")
                            .collect(Collectors.joining()));
        }
    }

    /** A function of the words of a line. */
    static Function<String[], String> function(String name) {
        return switch (name) {
            case "sin" -> real(PortableMath::sin);
            case "cos" -> real(PortableMath::cos);
            case "exp" -> real(PortableMath::exp);
            case "log" -> real(PortableMath::log);
            case "logit" -> real(Grid::logit);
            case "sigmoid" -> real(Grid::sigmoid);
            case "world_to_grid" -> Probe::worldToGrid;
            case "bresenham" -> Probe::bresenham;
            case "clip_ray" -> Probe::clipRay;
            case "flaser_angles" -> words -> hex(Sensor.flaserAngles(
                    Integer.parseInt(words[0]))[Integer.parseInt(words[1])]);
            case "read_ranges" -> Probe::readRanges;
            case "beam_endpoints" -> Probe::beamEndpoints;
            case "update_cell" -> Probe::updateCell;
            case "pixel" -> words -> String
                    .valueOf(MapWriter.pixel(toDouble(words[0])));
            case "philox" -> Probe::philox;
            case "normal_deviate" -> words -> hex(
                    Noise.normalDeviate(Long.parseLong(words[0]),
                            Integer.parseUnsignedInt(words[1]),
                            Integer.parseUnsignedInt(words[2])));
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static double toDouble(String word) {
        return Double.longBitsToDouble(HexFormat.fromHexDigitsToLong(word));
    }

    private static String hex(double value) {
        // doubleToLongBits knows one NaN only: 7ff8000000000000
        return HexFormat.of().toHexDigits(Double.doubleToLongBits(value));
    }

    private static double[] doubles(String[] words) {
        return Stream.of(words).mapToDouble(Probe::toDouble).toArray();
    }

    private static long[] longs(String[] words) {
        return Stream.of(words).mapToLong(Long::parseLong).toArray();
    }

    private static Function<String[], String> real(
            DoubleUnaryOperator function) {
        return words -> hex(function.applyAsDouble(toDouble(words[0])));
    }

    private static String worldToGrid(String[] words) {
        double[] x = doubles(words);
        GridSpec spec = new GridSpec(1, 1, x[0], x[1], x[2]);
        Cell cell = new OccupancyGrid(spec, 0.5, 0.75, 0.3, -8.0, 8.0)
                .worldToGrid(x[3], x[4]);
        return cell.gx() + " " + cell.gy();
    }

    private static String bresenham(String[] words) {
        long[] ends = longs(words);
        return Ray.bresenham(ends[0], ends[1], ends[2], ends[3]).stream()
                .map(cell -> cell.gx() + ":" + cell.gy())
                .collect(Collectors.joining(" "));
    }

    private static String clipRay(String[] words) {
        long[] x = longs(words);
        Steps steps = Fast.clipRay(x[0], x[1], x[2], x[3], (int) x[4],
                (int) x[5]);
        return steps.first() + " " + steps.last();
    }

    private static String readRanges(String[] words) {
        Readings read = Sensor.readRanges(new double[]{toDouble(words[0])},
                toDouble(words[1]),
                words[2].equals("free") ? NoReturn.FREE : NoReturn.IGNORE);
        return hex(read.z()[0]) + (read.hit()[0] ? " 1" : " 0")
                + (read.used()[0] ? " 1" : " 0");
    }

    private static String beamEndpoints(String[] words) {
        double[] x = doubles(words);
        Endpoints ends = Sensor.beamEndpoints(new Pose(x[0], x[1], x[2]),
                new double[]{x[3]}, new double[]{x[4]});
        return hex(ends.ex()[0]) + " " + hex(ends.ey()[0]);
    }

    private static String updateCell(String[] words) {
        double[] x = doubles(Arrays.copyOf(words, 5));
        OccupancyGrid grid = new OccupancyGrid(
                new GridSpec(1, 1, 1.0, 0.0, 0.0), x[0], x[1], x[2], x[3],
                x[4]);
        for (char update : words[5].toCharArray()) {
            grid.updateCell(0, 0, update == 'o' ? grid.lOcc() : grid.lFree());
        }
        return hex(grid.logOdds(0, 0));
    }

    private static String philox(String[] words) {
        int[] x = Stream.of(words).mapToInt(HexFormat::fromHexDigits)
                .toArray();
        return IntStream
                .of(Noise.philox4x32(Arrays.copyOfRange(x, 0, 4),
                        Arrays.copyOfRange(x, 4, 6)))
                .mapToObj(HexFormat.of()::toHexDigits)
                .collect(Collectors.joining(" "));
    }
}
