package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MainTest {
    private static final String SMALL = """
            PARAM occgrid_width 4
            PARAM occgrid_height 3
            PARAM occgrid_resolution 1
            PARAM occgrid_origin_x 0
            PARAM occgrid_origin_y 0
            PARAM occgrid_max_range 8
            PARAM occgrid_beams 1
            WALL 3.5 0 3.5 3
            POSE 0.5 1.5 0
            """;
    private static final String SMALL_PGM = """
            P2
            4 3
            255
            128 128 128 128
            179 179 179 64
            128 128 128 128
            """;

    @TempDir
    private Path folder;
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... arguments) {
        out.reset();
        err.reset();
        return Main.run(Stream.of(arguments).map(Argument::of).toList(), out,
                err);
    }

    private String small(String name) throws IOException {
        return Files.writeString(folder.resolve(name), SMALL).toString();
    }

    @Test
    void aPictureOnStandardOutput() throws IOException {
        assertEquals(0, run("--noise-free", small("a.log")));
        assertEquals(SMALL_PGM, out.toString());
        assertEquals("", err.toString());
    }

    @Test
    void theLessonIsBuiltIn() {
        assertEquals(0, run());
        String first = out.toString();
        assertTrue(first.startsWith("P2\n220 180\n255\n"));
        assertEquals(0, run("--seed", "0"));
        assertEquals(first, out.toString());
        assertEquals(0, run("--seed", "0", "--seed", "4294967295"));
        assertFalse(first.equals(out.toString()));
        assertEquals(0, run("--noise-free"));
        assertFalse(first.equals(out.toString()));
    }

    @Test
    void filesOfSeveralScenarios() throws IOException {
        Path maps = folder.resolve("x/maps");
        assertEquals(0, run(small("a.log"), "--out", "elsewhere",
                small("b.c.log"), "--out", maps.toString(), "--noise-free"));
        assertEquals("", out.toString());
        assertEquals(SMALL_PGM, Files.readString(maps.resolve("a.pgm")));
        assertEquals(SMALL_PGM, Files.readString(maps.resolve("b.c.pgm")));
        assertTrue(Files.readString(maps.resolve("b.c.logodds"))
                .startsWith("# logodds 4 3\n"));
        assertTrue(Files.exists(maps.resolve("a.yaml")));
        assertFalse(Files.exists(Path.of("elsewhere")));
    }

    @Test
    void theFirstErrorEndsTheRun() throws IOException {
        String bad = Files.writeString(folder.resolve("bad.log"),
                SMALL + "POSE 1 2\n").toString();
        Path maps = folder.resolve("maps");
        assertEquals(1, run("--out", maps.toString(), small("a.log"), bad,
                small("c.log")));
        assertEquals(bad + ":10: POSE takes 3 values, found 2\n",
                err.toString());
        assertTrue(Files.exists(maps.resolve("a.logodds")));
        assertFalse(Files.exists(maps.resolve("bad.pgm")));
        assertFalse(Files.exists(maps.resolve("c.pgm")));
        assertEquals(1, run(bad));
        assertEquals("", out.toString());
    }

    @Test
    void everyWayDrawsTheSameMap() throws IOException {
        assertEquals(0, run());
        String one = out.toString();
        assertEquals(0, run("--threads", "2"));
        assertEquals(one, out.toString());
        assertEquals(0, run("--plain"));
        assertEquals(one, out.toString());
        String bad = Files.writeString(folder.resolve("bad.log"),
                SMALL + "POSE 1 2\n").toString();
        Path maps = folder.resolve("maps");
        assertEquals(1,
                run("--out", maps.toString(), "--threads", "3", bad));
        assertEquals(bad + ":10: POSE takes 3 values, found 2\n",
                err.toString());
        assertFalse(Files.exists(maps.resolve("bad.pgm")));
    }

    @Test
    void aFullDisk() {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("full");
            }
        };
        for (String[] arguments : new String[][]{{}, {"--version"}}) {
            err.reset();
            assertEquals(1, Main.run(
                    Stream.of(arguments).map(Argument::of).toList(), full,
                    err));
            assertEquals("standard output: cannot be written\n",
                    err.toString());
        }
    }

    @Test
    void versionAndHelp() {
        assertEquals(0, run("--version"));
        assertEquals("occgrid " + System.getProperty("occgrid.version")
                + " (Java " + System.getProperty("java.version") + ")\n",
                out.toString());
        assertEquals(0, run("x.log", "--help"));
        assertTrue(out.toString().startsWith("usage: occgrid [--noise-free |"
                + " --seed N] [--plain | --threads N]\n"));
        // they act where they are read
        assertEquals(0, run("--help", "--bogus"));
        assertEquals(2, run("--bogus", "--help"));
        assertEquals(2, run("--seed", "x", "--version"));
        assertEquals(0, run("--seed", "1", "--noise-free", "--version"));
        assertEquals(2, run("--out", "--help"));
    }

    @ParameterizedTest
    @CsvSource({"--plot, unknown option --plot", "-x, unknown option -x",
            "-, unknown option -", "--, unknown option --",
            "-5, unknown option -5", "--seed=7, unknown option --seed=7",
            "--seed, --seed needs a value", "--out, --out needs a value",
            "--seed --out, --seed needs a value",
            "--out --noise-free a.log, --out needs a value",
            "--seed 1.5, 'needs a whole number from 0 to 4294967295'",
            "--seed 4294967296, 'not ''4294967296'''",
            "--seed 99999999999999999999, not",
            "--seed +1, 'not ''+1'''", "--seed -1, 'not ''-1'''",
            "--threads, --threads needs a value",
            "--threads 0, 'from 1 to 256, not ''0'''",
            "--threads 257, 'not ''257'''", "--threads x, 'not ''x'''",
            "--threads -1, 'not ''-1'''",
            "--plain --threads 1, exclude each other",
            "--seed 1 --noise-free, exclude each other",
            "a.log b.log, several scenarios need --out",
            "--out o x/a.log y/a.txt, two scenarios are named a",
            "--out o a.log a.log/, two scenarios are named a"})
    void badUsage(String arguments, String reason) {
        assertEquals(2, run(arguments.split(" ")));
        assertTrue(err.toString().contains(reason), err.toString());
        assertTrue(err.toString().contains("usage: occgrid"));
        assertEquals("", out.toString());
    }

    @Test
    void anEmptyValueIsMissing() {
        assertEquals(2, run("--out", ""));
        assertTrue(err.toString()
                .startsWith("occgrid: --out needs a value\nusage:"));
        assertEquals(2, run("--seed", ""));
        assertEquals(1, run(""));
        assertEquals(":0: cannot be read\n", err.toString());
    }

    @Test
    void seedsInDigits() {
        assertEquals(0, run("--seed", "7"));
        String seven = out.toString();
        assertEquals(0, run("--seed", "00000000000000000007"));
        assertEquals(seven, out.toString());
    }

    @Test
    void foldersCannotBeRead() throws IOException {
        String file = small("a.log") + "/";
        for (String path : List.of(file, folder + "/", folder + "")) {
            assertEquals(1, run("--out", folder + "/o", path));
            assertEquals(path + ":0: cannot be read\n", err.toString());
        }
        assertFalse(Files.exists(folder.resolve("o")));
    }

    @Test
    void messagesAreOneLine() {
        assertEquals(1, run("a\n\tb\u007f.log"));
        assertEquals("a??b?.log:0: cannot be read\n", err.toString());
        assertEquals(2, run("--a\nb"));
        assertTrue(err.toString()
                .startsWith("occgrid: unknown option --a?b\nusage:"));
    }
}
