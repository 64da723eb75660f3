import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;

/**
 * sin, cos, exp and log as Java's Math has them, or with "strict" its StrictMath: FOLDER/sin.txt to FOLDER/sin.out, and
 * so on.
 */
final class PlatformMath {
    private static final Map<String, DoubleUnaryOperator> MATH =
            Map.of("sin", Math::sin, "cos", Math::cos, "exp", Math::exp, "log", Math::log);
    private static final Map<String, DoubleUnaryOperator> STRICT = Map.of(
            "sin", StrictMath::sin, "cos", StrictMath::cos, "exp", StrictMath::exp, "log", StrictMath::log);

    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        boolean strict = arguments.length > 1 && arguments[1].equals("strict");
        for (Map.Entry<String, DoubleUnaryOperator> function : (strict ? STRICT : MATH).entrySet()) {
            List<String> lines = Files.readAllLines(folder.resolve(function.getKey() + ".txt"));
            List<String> results = lines.stream()
                    .map(line -> Double.toString(function.getValue().applyAsDouble(Double.parseDouble(line))))
                    .toList();
            Files.write(folder.resolve(function.getKey() + ".out"), results);
        }
    }
}
