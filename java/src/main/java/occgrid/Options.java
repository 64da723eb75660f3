package occgrid;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;

/** What the command line asks for, read from left to right. */
final class Options {
    static final String USAGE = """
            usage: occgrid [--noise-free | --seed N] [--plain | --threads N]
                           [--out DIR] [SCENARIO...]

            Map range scans into an occupancy grid.
            Without a scenario: the built-in lesson.

              --noise-free  simulate ranges without noise
              --seed N      seed of the noise, 0 to 4294967295 (default: 0)
              --plain       map beam by beam, as the handouts print it; the
                            map is the same
              --threads N   map on N threads, 1 to 256 (default: 1); the map
                            is the same
              --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds there
                            (without it: the picture on standard output)
              --version     the version
              --help        this text
            """;

    OptionalLong seed = OptionalLong.of(0);
    boolean isPlain;
    int threads = 1;
    /** The folder for the maps; null without. */
    Argument folder;
    final List<Argument> scenarios = new ArrayList<>();
    /** The answer to --help or --version; null without. */
    String text;

    private boolean isNoiseFree;
    private boolean isSeeded;
    private boolean isThreaded;

    private Options() {
    }

    /** The command line is wrong. */
    static final class UsageException extends Exception {
        private static final long serialVersionUID = 1L;

        UsageException(String reason) {
            super(reason);
        }
    }

    static Options parse(List<Argument> arguments) throws UsageException {
        Options options = new Options();
        Iterator<Argument> rest = arguments.iterator();
        while (rest.hasNext() && options.text == null) {
            options.take(rest.next(), rest);
        }
        if (options.text == null) {
            options.checkTogether();
        }
        return options;
    }

    /** Takes one argument, and its value from the rest. */
    private void take(Argument argument, Iterator<Argument> rest)
            throws UsageException {
        String option = argument.text();
        switch (option) {
            case "--help" -> text = USAGE;
            case "--version" -> text = "occgrid " + Main.VERSION + " (Java "
                    + System.getProperty("java.version") + ")\n";
            case "--noise-free" -> isNoiseFree = true;
            case "--plain" -> isPlain = true;
            case "--seed" -> {
                isSeeded = true;
                seed = OptionalLong
                        .of(whole(option, rest, 0, 4294967295L));
            }
            case "--threads" -> {
                isThreaded = true;
                threads = (int) whole(option, rest, 1, 256);
            }
            case "--out" -> folder = value(option, rest);
            default -> {
                if (option.startsWith("-")) {
                    throw new UsageException("unknown option " + option);
                }
                scenarios.add(argument);
            }
        }
    }

    private static Argument value(String option, Iterator<Argument> rest)
            throws UsageException {
        Argument value = rest.hasNext() ? rest.next() : null;
        if (value == null || value.text().isEmpty()
                || value.text().startsWith("--")) {
            throw new UsageException(option + " needs a value");
        }
        return value;
    }

    private static long whole(String option, Iterator<Argument> rest,
            long low, long high) throws UsageException {
        String text = value(option, rest).text();
        // whole numbers of up to 18 digits fit in a long
        if (text.matches("0*[0-9]{1,18}")) {
            long number = Long.parseLong(text);
            if (low <= number && number <= high) {
                return number;
            }
        }
        throw new UsageException(option + " needs a whole number from " + low
                + " to " + high + ", not '" + text + "'");
    }

    private void checkTogether() throws UsageException {
        if (isNoiseFree && isSeeded) {
            throw new UsageException(
                    "--noise-free and --seed exclude each other");
        }
        if (isPlain && isThreaded) {
            throw new UsageException(
                    "--plain and --threads exclude each other");
        }
        if (isNoiseFree) {
            seed = OptionalLong.empty();
        }
        if (scenarios.size() > 1 && folder == null) {
            throw new UsageException("several scenarios need --out");
        }
        Set<String> names = new HashSet<>();
        for (Argument scenario : scenarios) {
            if (!names.add(Scenario.scenarioName(scenario.bytes()))) {
                throw new UsageException("two scenarios are named "
                        + Scenario.scenarioName(scenario.text()));
            }
        }
    }
}
