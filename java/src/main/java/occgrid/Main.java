package occgrid;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import occgrid.Grid.OccupancyGrid;
import occgrid.MapWriter.WriteException;
import occgrid.Options.UsageException;
import occgrid.Scenario.ScenarioException;

/** The command line (SPEC.md section 6). */
public final class Main {
    /** The version of this port. */
    public static final String VERSION = "1.0.0";

    private Main() {
    }

    /**
     * The program.
     *
     * @param arguments the command line
     */
    public static void main(String[] arguments) {
        // SIGINT and SIGTERM end the program this way
        Runtime.getRuntime()
                .addShutdownHook(new Thread(OutputFiles::abandon));
        // not System.out: it hides that a write failed
        OutputStream out = new FileOutputStream(FileDescriptor.out);
        OutputStream err = new FileOutputStream(FileDescriptor.err);
        System.exit(run(Argument.ofCommandLine(arguments), out, err));
    }

    /**
     * Runs the command.
     *
     * @param arguments the command line
     * @param out standard output
     * @param err standard error
     * @return the exit status: 0, 1 for bad input or output, 2 for bad usage
     */
    static int run(List<Argument> arguments, OutputStream out,
            OutputStream err) {
        try {
            run(Options.parse(arguments), out);
            return 0;
        } catch (UsageException error) {
            report(err, FileNames.bytes("occgrid: " + error.getMessage()),
                    Options.USAGE);
            return 2;
        } catch (ScenarioException | WriteException error) {
            report(err, FileNames.bytes(error.getMessage()), "");
        } catch (InexactName error) {
            report(err, FileNames.onOneLine(error.getMessage())
                    .getBytes(StandardCharsets.ISO_8859_1), "");
        } catch (IOException error) {
            report(err, FileNames.bytes("standard output: cannot be written"),
                    "");
        }
        return 1;
    }

    private static void run(Options options, OutputStream out)
            throws IOException {
        if (options.text != null) {
            out.write(options.text.getBytes(StandardCharsets.US_ASCII));
            return;
        }
        if (options.scenarios.isEmpty()) {
            mapOne(Lesson.lessonScenario(), options, out);
        }
        for (Argument file : options.scenarios) {
            if (!file.isExact()) {
                throw new InexactName(file.bytes() + ":0: cannot be read");
            }
            mapOne(Scenario.readScenario(file.text()), options, out);
        }
    }

    /** Maps one scenario and writes what was asked for. */
    private static void mapOne(Scenario scenario, Options options,
            OutputStream out) throws IOException {
        OccupancyGrid grid;
        try (scenario) {
            grid = options.isPlain
                    ? Mapper.mapScenario(scenario, options.seed)
                    : Fast.mapScenarioFast(scenario, options.seed,
                            options.threads);
        }
        if (options.folder == null) {
            OutputStream buffered = new BufferedOutputStream(out);
            MapWriter.mapPgm(grid, buffered);
            buffered.flush();
            return;
        }
        if (!options.folder.isExact()) {
            String folder = FileNames.withoutSlashes(options.folder.bytes());
            throw new InexactName(folder + ": cannot be written");
        }
        MapWriter.writeMap(options.folder.text(), scenario.name(), grid);
    }

    /** Writes a line and what follows it to standard error. */
    private static void report(OutputStream err, byte[] line, String rest) {
        try {
            err.write(line);
            err.write(("\n" + rest).getBytes(StandardCharsets.US_ASCII));
        } catch (IOException error) {
            // there is no other place to report to; the status says it
        }
    }

    /** A name that Java cannot express; the text is Latin-1 for bytes. */
    private static final class InexactName extends RuntimeException {
        private static final long serialVersionUID = 1L;

        InexactName(String text) {
            super(text);
        }
    }
}
