package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PortableMathTest {
    /** fdlibm's bits, some of them where another library rounds otherwise. */
    @ParameterizedTest
    @CsvSource({
            "sin, 3ff0000000000000, 3feaed548f090cee",
            "cos, 3ff0000000000000, 3fe14a280fb5068c",
            "exp, 3ff0000000000000, 4005bf0a8b14576a",
            "log, 4000000000000000, 3fe62e42fefa39ef",
            "sin, 8000000000000000, 8000000000000000",
            "sin, 7ff0000000000000, 7ff8000000000000",
            "cos, fff0000000000000, 7ff8000000000000",
            "exp, fff0000000000000, 0000000000000000",
            "exp, 40862e42fefa39f0, 7ff0000000000000",
            "exp, c0874910d52d3052, 0000000000000000",
            "log, 8000000000000000, fff0000000000000",
            "log, bff0000000000000, 7ff8000000000000",
            "log, 0000000000000001, c0874385446d71c3",
            "exp, fff8000000000001, 7ff8000000000000"})
    void knownBits(String function, String argument, String result) {
        assertEquals(result, Probe.function(function)
                .apply(new String[]{argument}));
    }

    @Test
    void sourcesUseNothingThatDiffersElsewhere() throws IOException {
        Pattern other = Pattern.compile("(?<!Strict)Math\\s*\\.\\s*(sin|cos|"
                + "tan|asin|acos|atan2?|sinh|cosh|tanh|exp|expm1|log|log10|"
                + "log1p|pow|cbrt|hypot|fma|round|rint|toRadians)\\b"
                + "|import static"
                // and nothing that knows a locale or a platform's line end
                + "|println|lineSeparator|%n|String\\.format|formatted\\(");
        Path main = Path.of(System.getProperty("occgrid.basedir"),
                "src/main/java/occgrid");
        try (Stream<Path> files = Files.list(main)) {
            List<Path> sources = files.toList();
            assertTrue(sources.size() >= 11);
            for (Path source : sources) {
                String text = Files.readString(source)
                        .replaceAll("PortableMath", "StrictMath");
                assertEquals(List.of(), other.matcher(text).results()
                        .map(match -> source + ": " + match.group())
                        .toList());
            }
        }
    }

    @Test
    void onlyPortableMathUsesStrictMath() throws IOException {
        Path main = Path.of(System.getProperty("occgrid.basedir"),
                "src/main/java/occgrid");
        try (Stream<Path> files = Files.list(main)) {
            for (Path source : files.toList()) {
                boolean here = source.endsWith("PortableMath.java");
                assertEquals(here, Files.readString(source)
                        .contains("StrictMath."), source.toString());
            }
        }
    }
}
