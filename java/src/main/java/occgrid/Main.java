package occgrid;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.MapWriter.WriteException;
import occgrid.Scenario.ScenarioException;

/** The command line (SPEC.md section 6). One file, one room: main. */
public final class Main {
    /** The version of this port. */
    public static final String VERSION = "1.0.0";

    private static final String USAGE = """
            usage: occgrid [--noise-free | --seed N] [--out DIR]
                           [--threads N] [SCENARIO...]

            Map range scans into an occupancy grid.
            Without a scenario: the built-in lesson.

              --noise-free  simulate ranges without noise
              --seed N      seed of the noise, 0 to 4294967295 (default: 0)
              --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds there
                            (without it: the picture on standard output)
              --threads N   map on N threads, 1 to 256 (default: 1); the map
                            is the same
              --version     the version
              --help        this text
            """;

    private Main() {
    }

    /**
     * The program.
     *
     * @param arguments the command line
     */
    public static void main(String[] arguments) {
        // not System.out: it hides that a write failed
        OutputStream out = new FileOutputStream(FileDescriptor.out);
        System.exit(run(arguments, out, System.err));
    }

    /**
     * Runs the command.
     *
     * @param arguments the command line
     * @param out standard output
     * @param err standard error
     * @return the exit status: 0, 1 for bad input or output, 2 for bad usage
     */
    public static int run(String[] arguments, OutputStream out,
            PrintStream err) {
        Options options;
        try {
            options = Options.parse(arguments);
        } catch (UsageException error) {
            err.print("occgrid: " + error.getMessage() + "\n" + USAGE);
            return 2;
        }
        try {
            if (options.text != null) {
                print(options.text, out);
                return 0;
            }
            if (options.scenarios.isEmpty()) {
                mapOne(Lesson.lessonScenario(), options, out);
            }
            for (String file : options.scenarios) {
                mapOne(Scenario.readScenario(file), options, out);
            }
        } catch (ScenarioException | WriteException error) {
            err.print(error.getMessage() + "\n");
            return 1;
        }
        return 0;
    }

    /** Maps one scenario and writes what was asked for. */
    private static void mapOne(Scenario scenario, Options options,
            OutputStream out) throws WriteException {
        OccupancyGrid grid;
        try (scenario) {
            grid = options.threads == 1
                    ? Mapper.mapScenario(scenario, options.seed)
                    : Mapper.mapScenarioInBands(scenario, options.seed,
                            options.threads);
        }
        if (options.folder != null) {
            MapWriter.writeMap(options.folder, scenario.name(), grid);
            return;
        }
        try {
            OutputStream buffered = new BufferedOutputStream(out);
            MapWriter.mapPgm(grid, buffered);
            buffered.flush();
        } catch (IOException error) {
            throw new WriteException(STANDARD_OUTPUT, error);
        }
    }

    private static final Path STANDARD_OUTPUT = Path.of("standard output");

    private static void print(String text, OutputStream out)
            throws WriteException {
        try {
            out.write(text.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException error) {
            throw new WriteException(STANDARD_OUTPUT, error);
        }
    }

    /** What the command line says. */
    private static final class Options {
        OptionalLong seed = OptionalLong.of(0);
        Path folder;
        int threads = 1;
        List<String> scenarios = new ArrayList<>();
        /** The answer to --help or --version; null without. */
        String text;

        static Options parse(String[] arguments) throws UsageException {
            Options options = new Options();
            boolean noiseFree = false;
            boolean seeded = false;
            Iterator<String> rest = Arrays.asList(arguments).iterator();
            while (rest.hasNext()) {
                String argument = rest.next();
                switch (argument) {
                    case "--help" -> {
                        options.text = USAGE;
                        return options;
                    }
                    case "--version" -> {
                        options.text = "occgrid " + VERSION + " (Java "
                                + System.getProperty("java.version") + ")\n";
                        return options;
                    }
                    case "--noise-free" -> noiseFree = true;
                    case "--seed" -> {
                        seeded = true;
                        options.seed = seed(value(argument, rest));
                    }
                    case "--out" -> options.folder = Path
                            .of(value(argument, rest));
                    case "--threads" -> options.threads = threads(
                            value(argument, rest));
                    default -> {
                        if (isOption(argument)) {
                            throw new UsageException(
                                    "unknown option " + argument);
                        }
                        options.scenarios.add(argument);
                    }
                }
            }
            if (noiseFree && seeded) {
                throw new UsageException(
                        "--noise-free and --seed exclude each other");
            }
            if (noiseFree) {
                options.seed = OptionalLong.empty();
            }
            options.checkScenarios();
            return options;
        }

        private void checkScenarios() throws UsageException {
            if (scenarios.size() > 1 && folder == null) {
                throw new UsageException("several scenarios need --out");
            }
            List<String> names = scenarios.stream()
                    .map(Scenario::scenarioName).toList();
            for (String name : names) {
                if (Collections.frequency(names, name) > 1) {
                    throw new UsageException(
                            "two scenarios are named " + name);
                }
            }
        }

        private static boolean isOption(String argument) {
            return argument.length() > 1 && argument.startsWith("-");
        }

        private static String value(String option, Iterator<String> rest)
                throws UsageException {
            String value = rest.hasNext() ? rest.next() : option;
            if (isOption(value)) {
                throw new UsageException(option + " needs a value");
            }
            return value;
        }

        private static OptionalLong seed(String text) throws UsageException {
            // whole numbers of up to 18 digits fit in a long
            if (text.matches("0*[0-9]{1,18}")
                    && Long.parseLong(text) <= 0xFFFFFFFFL) {
                return OptionalLong.of(Long.parseLong(text));
            }
            throw new UsageException("--seed needs a whole number from 0 to"
                    + " 4294967295, not '" + text + "'");
        }

        private static int threads(String text) throws UsageException {
            if (text.matches("0*[0-9]{1,3}")) {
                int threads = Integer.parseInt(text);
                if (1 <= threads && threads <= 256) {
                    return threads;
                }
            }
            throw new UsageException("--threads needs a whole number from 1"
                    + " to 256, not '" + text + "'");
        }
    }

    /** The command line is wrong. */
    private static final class UsageException extends Exception {
        private static final long serialVersionUID = 1L;

        UsageException(String reason) {
            super(reason);
        }
    }
}
