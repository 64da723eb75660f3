package occgrid;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The port's probe: lays open portable_math, Philox and Bresenham to the
 * suite's tests (see CONTRIBUTING.md). Its sin, cos, exp and log are
 * StrictMath's, which the other ports are measured by.
 */
final class Probe {
    private Probe() {
    }

    public static void main(String[] arguments) throws IOException {
        UnaryOperator<String> function = function(arguments[0]);
        Path input = Path.of(arguments[1]);
        Path output = Path.of(arguments[2]);
        try (Stream<String> lines = Files.lines(input)) {
            Files.writeString(output, lines.map(function)
                    .map(line -> line + "\n").collect(Collectors.joining()));
        }
    }

    static UnaryOperator<String> function(String name) {
        return switch (name) {
            case "sin" -> line -> real(line, PortableMath::sin);
            case "cos" -> line -> real(line, PortableMath::cos);
            case "exp" -> line -> real(line, PortableMath::exp);
            case "log" -> line -> real(line, PortableMath::log);
            case "philox" -> Probe::philox;
            case "bresenham" -> Probe::bresenham;
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static String real(String line, DoubleUnaryOperator function) {
        long bits = HexFormat.fromHexDigitsToLong(line);
        double result = function.applyAsDouble(Double.longBitsToDouble(bits));
        // doubleToLongBits knows one NaN only: 7ff8000000000000
        return HexFormat.of().toHexDigits(Double.doubleToLongBits(result));
    }

    private static String philox(String line) {
        int[] words = Arrays.stream(line.strip().split("\\s+"))
                .mapToInt(HexFormat::fromHexDigits).toArray();
        int[] counter = Arrays.copyOfRange(words, 0, 4);
        int[] key = Arrays.copyOfRange(words, 4, 6);
        return IntStream.of(Noise.philox4x32(counter, key))
                .mapToObj(HexFormat.of()::toHexDigits)
                .collect(Collectors.joining(" "));
    }

    private static String bresenham(String line) {
        int[] ends = Arrays.stream(line.strip().split("\\s+"))
                .mapToInt(Integer::parseInt).toArray();
        return Ray.bresenham(ends[0], ends[1], ends[2], ends[3]).stream()
                .map(cell -> cell.gx() + "," + cell.gy())
                .collect(Collectors.joining(" "));
    }
}
