import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.DoubleUnaryOperator;

/**
 * What Java's StrictMath says, for the tests of portable_math.
 *
 * <p>Arguments: pairs of an input and an output file, each after the name of a function (sin, cos, exp,
 * log). Lines are doubles as 16 hexadecimal digits, NaN as 7ff8000000000000.
 */
final class StrictMathReference {
    private StrictMathReference() {
    }

    public static void main(String[] arguments) throws IOException {
        for (int i = 0; i + 2 < arguments.length; i += 3) {
            answer(function(arguments[i]), Path.of(arguments[i + 1]), Path.of(arguments[i + 2]));
        }
    }

    private static DoubleUnaryOperator function(String name) {
        return switch (name) {
            case "sin" -> StrictMath::sin;
            case "cos" -> StrictMath::cos;
            case "exp" -> StrictMath::exp;
            case "log" -> StrictMath::log;
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static void answer(DoubleUnaryOperator function, Path input, Path output) throws IOException {
        try (BufferedReader lines = Files.newBufferedReader(input, StandardCharsets.US_ASCII);
                PrintWriter answers = new PrintWriter(output.toFile(), StandardCharsets.US_ASCII)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                double argument = Double.longBitsToDouble(Long.parseUnsignedLong(line, 16));
                long bits = Double.doubleToLongBits(function.applyAsDouble(argument));
                answers.printf("%016x\n", bits);
            }
        }
    }
}
