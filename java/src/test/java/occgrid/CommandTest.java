package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What only a process of its own shows: names, signals, pipes, disks. */
class CommandTest {
    private static final String SCENARIO = """
            PARAM occgrid_width 4
            PARAM occgrid_height 3
            PARAM occgrid_resolution 1
            PARAM occgrid_origin_x 0
            PARAM occgrid_origin_y 0
            PARAM occgrid_max_range 8
            POSE 0.5 1.5 0
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void aScenario() throws IOException {
        Files.writeString(folder.resolve("a.log"), SCENARIO);
    }

    /** A shell's command in the folder; occgrid is the program. */
    private ProcessBuilder shell(String command) {
        String java = Path.of(System.getProperty("java.home"), "bin/java")
                .toString();
        String classes = Path.of(System.getProperty("occgrid.basedir"),
                "target/classes").toString();
        ProcessBuilder builder = new ProcessBuilder("sh", "-c",
                "java=$0; classes=$1\n" + command.replace("occgrid ",
                        "\"$java\" -cp \"$classes\" occgrid.Main "),
                java, classes).directory(folder.toFile());
        builder.redirectError(folder.resolve("err").toFile());
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        return builder;
    }

    private int run(String command)
            throws IOException, InterruptedException {
        Process process = shell(command)
                .redirectOutput(folder.resolve("out").toFile()).start();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        return process.exitValue();
    }

    /** What went to standard error, its bytes as Latin-1. */
    private String errors() throws IOException {
        return Files.readString(folder.resolve("err"),
                StandardCharsets.ISO_8859_1);
    }

    private List<String> temporary(Path where) throws IOException {
        if (!Files.exists(where)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(where)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.startsWith(".occgrid-")).toList();
        }
    }

    /** Bytes that the locale has no text for; the file exists. */
    @ParameterizedTest
    @CsvSource({"C, '\\303\\274.log'", "C.UTF-8, '\\377.log'",
            "C, '\\377?.log'"})
    void aScenarioThatJavaCannotName(String locale, String name)
            throws IOException, InterruptedException {
        assertEquals(1, run("name=$(printf '" + name + "'); cp a.log $name;"
                + "cp a.log '?.log'; cp a.log '??.log';"
                + "LC_ALL=" + locale + " occgrid --out o \"$name\""));
        assertTrue(errors().matches("[\\u00fc\\u00c3\\u00bc\\u00ff?]+\\.log"
                + ":0: cannot be read\n"), errors());
        assertFalse(Files.exists(folder.resolve("o")));
    }

    @ParameterizedTest
    @CsvSource({"C, '\\303\\244'", "C.UTF-8, '\\377'"})
    void aFolderThatJavaCannotName(String locale, String name)
            throws IOException, InterruptedException {
        assertEquals(1, run("LC_ALL=" + locale + " occgrid --out \"$(printf '"
                + name + "')/\" a.log"));
        assertTrue(errors().matches("[\\u00c3\\u00a4\\u00ff]+"
                + ": cannot be written\n"), errors());
        assertFalse(Files.exists(folder.resolve("?")));
    }

    /** They are two, though Java sees ? in place of both. */
    @Test
    void twoScenariosThatJavaCannotName()
            throws IOException, InterruptedException {
        assertEquals(1, run("LC_ALL=C occgrid --out o"
                + " \"$(printf '\\374.log')\" \"$(printf '\\344.log')\""));
        assertEquals("\u00fc.log:0: cannot be read\n", errors());
    }

    @Test
    void namesThatJavaCanSay() throws IOException, InterruptedException {
        assertEquals(0, run("cp a.log '?.log'; cp a.log '\\~*.log';"
                + "LC_ALL=C occgrid --out '??' '?.log' '\\~*.log'"));
        assertEquals(0, run("n=$(printf '\\303\\274 b'); cp a.log \"$n.log\";"
                + "LC_ALL=C.UTF-8 occgrid --out \"$n/$n\" \"$n.log\";"
                + "s=$?; cp \"$n/$n/$n.yaml\" yaml; ls '??' > list; exit $s"));
        assertTrue(Files.readString(folder.resolve("yaml"))
                .startsWith("image: \"\u00fc b.pgm\"\n"));
        assertEquals("?.logodds\n?.pgm\n?.yaml\n\\~*.logodds\n\\~*.pgm\n"
                + "\\~*.yaml\n", Files.readString(folder.resolve("list")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.log", "--help", "--version", ""})
    void aFullDisk(String arguments)
            throws IOException, InterruptedException {
        assertEquals(1, run("occgrid " + arguments + " > /dev/full"));
        assertEquals("standard output: cannot be written\n", errors());
    }

    /** Nobody reads: an error like any other, not the end by a signal. */
    @ParameterizedTest
    @ValueSource(strings = {"", "--version"})
    void aClosedPipe(String arguments)
            throws IOException, InterruptedException {
        assertEquals(0, run("{ occgrid " + arguments
                + "; echo $? > status; } | { exec 0<&-; }"
                + "; while [ ! -s status ]; do sleep 0.05; done"));
        String status = Files.readString(folder.resolve("status")).strip();
        assertEquals("1", status);
        assertEquals("standard output: cannot be written\n", errors());
    }

    /** Temporary files go when a signal comes while they are written. */
    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143"})
    void signalsLeaveNoTemporaryFile(String signal, int status)
            throws IOException, InterruptedException {
        Files.writeString(folder.resolve("big.log"),
                SCENARIO.replace("width 4", "width 5000")
                        .replace("height 3", "height 5000"));
        Path out = folder.resolve("o");
        // a background has SIGINT ignored, and its children with it
        Process run = shell("exec env --default-signal=INT,TERM "
                + "occgrid --out o big.log")
                .redirectOutput(folder.resolve("out").toFile()).start();
        long end = System.nanoTime() + 60_000_000_000L;
        while (temporary(out).isEmpty() && System.nanoTime() < end) {
            Thread.sleep(5);
        }
        assertFalse(temporary(out).isEmpty(), "it writes");
        assertEquals(0, new ProcessBuilder("kill", "-" + signal,
                "" + run.pid()).start().waitFor());
        assertTrue(run.waitFor(60, TimeUnit.SECONDS));
        assertEquals(status, run.exitValue());
        assertEquals("", errors());
        try (Stream<Path> left = Files.list(out)) {
            assertEquals(List.of(), left.toList());
        }
    }
}
