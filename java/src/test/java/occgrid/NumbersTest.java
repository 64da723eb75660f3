package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumbersTest {
    private static double parse(String token) {
        // other fields around it
        byte[] text = ("9" + token + "9")
                .getBytes(StandardCharsets.ISO_8859_1);
        return Numbers.parse(text, 1, text.length - 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "+1", "-1", "1.", ".5", "1.5", "-.5e3",
            "1e5", "1E+05", "1.e-5", "00012", "1e999999999999", "nan", "-NaN",
            "+inf", "INF", "Infinity", "-iNFINITY"})
    void numbers(String token) {
        parse(token);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ".", "+", "-", "e5", ".e5", "1e", "1e+",
            "1e5.", "1.2.3", "--1", "+-inf", "1d", "1f", "1.0D", "0x10",
            "0x1p3", "1_0", "1,5", "in", "infinit", "nano", "1e5f", " 1",
            "infinityy", "naN(1)", "1-", "#1", "\u0661"})
    void notNumbers(String token) {
        assertThrows(NumberFormatException.class, () -> parse(token));
    }

    @ParameterizedTest
    @CsvSource({"1e300, Infinity", "-1e300, -Infinity", "1e9999, Infinity",
            "9.999999999999999e299, 9.999999999999999E299",
            "1e-300, 1.0E-300", "9.999999999999999e-301, 0.0",
            "-1e-301, 0.0", "-0, 0.0", "-0.0e5, 0.0", "-inf, -Infinity",
            "+INFINITY, Infinity", "-nan, NaN", "0.1, 0.1",
            "0e999999999999, 0.0", "1e-999999999999, 0.0"})
    void valuesOfNumbers(String token, String value) {
        assertEquals(value, Double.toString(parse(token)));
    }

    @Test
    void manyDigitsAreRoundedOnce() {
        // half way between 1 and the next double: to even, but for one digit
        String half = new BigDecimal(1.0).add(new BigDecimal(0x1p-53))
                .toPlainString();
        String zeros = "0".repeat(2000);
        assertEquals(1.0, parse(half + zeros));
        assertEquals(Math.nextUp(1.0), parse(half + zeros + "1"));
        assertEquals(1.0, parse("0." + zeros + "1e2001"));
        assertEquals(1.0, parse("1" + zeros + "e-2000"));
    }

    /** Short ones are divided by a power of ten, long ones are not. */
    @Test
    void decimalsAreRoundedAsJavaRounds() {
        Random random = new Random(7);
        for (int i = 0; i < 300_000; i++) {
            int digits = 1 + random.nextInt(20);
            StringBuilder token = new StringBuilder();
            for (int k = 0; k < digits; k++) {
                token.append((char) ('0' + random.nextInt(10)));
            }
            token.insert(random.nextInt(digits + 1), '.');
            if (i % 3 == 0) {
                token.insert(token.indexOf(".") + 1,
                        "0".repeat(random.nextInt(30)));
            }
            if (i % 5 == 0) {
                token.append("e").append(random.nextInt(60) - 30);
            }
            String text = token.toString();
            assertEquals(Double.parseDouble(text), parse(text), text);
            assertEquals(0.0 - Double.parseDouble(text), parse("-" + text),
                    text);
        }
        for (long whole : new long[]{(1L << 53) - 1, 1L << 53,
                (1L << 53) + 1, Long.MAX_VALUE}) {
            assertEquals((double) whole, parse("" + whole));
            assertEquals(Double.parseDouble(whole + "e-3"),
                    parse(whole / 1000 + "." + (1000 + whole % 1000 + "")
                            .substring(1)));
        }
    }
}
