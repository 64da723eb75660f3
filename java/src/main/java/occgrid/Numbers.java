package occgrid;

import java.nio.charset.StandardCharsets;

/**
 * Numbers of a scenario (SPEC.md section 5.1). Double.parseDouble takes more:
 * hexadecimal digits, the suffixes d and f, spaces.
 */
final class Numbers {
    /** The powers of ten that a double holds exactly. */
    private static final double[] POWERS = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5,
            1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
            1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    /** Up to it a whole number and ten times it with a digit fit a long. */
    private static final long MANY = 100_000_000_000_000_000L;

    private Numbers() {
    }

    /**
     * The double of a number, rounded once.
     *
     * @param text ASCII
     * @param from where the number begins
     * @param to where it ends
     * @return the double: infinite from 1e300 on, 0 below 1e-300
     * @throws NumberFormatException if it is no number
     */
    static double parse(byte[] text, int from, int to) {
        int at = from;
        boolean minus = at < to && text[at] == '-';
        if (minus || at < to && text[at] == '+') {
            at++;
        }
        long digits = 0;
        boolean isLong = false;
        int start = at;
        while (at < to && isDigit(text[at])) {
            isLong |= digits >= MANY;
            digits = 10 * digits + (text[at++] - '0');
        }
        int count = at - start;
        int decimals = 0;
        if (at < to && text[at] == '.') {
            start = ++at;
            while (at < to && isDigit(text[at])) {
                isLong |= digits >= MANY;
                digits = 10 * digits + (text[at++] - '0');
            }
            decimals = at - start;
            count += decimals;
        }
        if (count == 0) {
            return word(text, from, to);
        }
        if (at == to && !isLong && digits < 1L << 53
                && decimals < POWERS.length) {
            // both are exact, so the quotient is rounded once
            double value = digits / POWERS[decimals];
            return minus && digits != 0 ? -value : value;
        }
        return decimal(text, from, at, to);
    }

    /** A decimal of many digits, or with an exponent at {@code at}. */
    private static double decimal(byte[] text, int from, int at, int to) {
        if (at < to) {
            boolean isExponent = (text[at] | 0x20) == 'e';
            int digit = at + 1;
            if (digit < to && (text[digit] == '+' || text[digit] == '-')) {
                digit++;
            }
            int end = digit;
            while (end < to && isDigit(text[end])) {
                end++;
            }
            if (!isExponent || end == digit || end < to) {
                throw new NumberFormatException();
            }
        }
        double value = Double.parseDouble(string(text, from, to));
        if (Math.abs(value) >= 1e300) {
            return Math.copySign(Double.POSITIVE_INFINITY, value);
        }
        return Math.abs(value) < 1e-300 ? 0.0 : value;
    }

    /** nan, inf or infinity. */
    private static double word(byte[] text, int from, int to) {
        String word = string(text, from, to);
        boolean minus = word.startsWith("-");
        if (minus || word.startsWith("+")) {
            word = word.substring(1);
        }
        if (word.equalsIgnoreCase("nan")) {
            return Double.NaN;
        }
        if (word.equalsIgnoreCase("inf")
                || word.equalsIgnoreCase("infinity")) {
            return minus
                    ? Double.NEGATIVE_INFINITY
                    : Double.POSITIVE_INFINITY;
        }
        throw new NumberFormatException();
    }

    static boolean isDigit(int c) {
        return '0' <= c && c <= '9';
    }

    private static String string(byte[] text, int from, int to) {
        return new String(text, from, to - from, StandardCharsets.ISO_8859_1);
    }
}
