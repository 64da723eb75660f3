package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.OptionalLong;
import occgrid.Grid.OccupancyGrid;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.ScenarioException;
import occgrid.Scenario.Settings;
import occgrid.Scenario.Simulated;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import occgrid.World.Segment;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ScenarioTest {
    private static final String HEAD = """
            PARAM occgrid_width 20
            PARAM occgrid_height 10
            PARAM occgrid_resolution 0.5
            PARAM occgrid_origin_x -5
            PARAM occgrid_origin_y -2.5
            PARAM occgrid_max_range 8
            """;

    @TempDir
    private Path folder;

    private record Read(Scenario scenario, List<Observation> scans) {
    }

    private Path file(String text) {
        try {
            return Files.write(folder.resolve("a.log"),
                    text.getBytes(StandardCharsets.ISO_8859_1));
        } catch (IOException error) {
            throw new AssertionError(error);
        }
    }

    private Read read(String text) {
        List<Observation> scans = new ArrayList<>();
        try (Scenario scenario = Scenario
                .readScenario(file(text).toString())) {
            scenario.scans().forEach(scans::add);
            return new Read(scenario, scans);
        }
    }

    private static Scan scan(Read read, int number) {
        return ((Recorded) read.scans().get(number)).scan();
    }

    private void checkError(String text, int line, String reason) {
        ScenarioException error = assertThrows(ScenarioException.class,
                () -> read(text));
        assertEquals(reason, error.reason);
        assertEquals(line, error.line);
        assertEquals(folder.resolve("a.log") + ":" + line + ": " + reason,
                error.getMessage());
    }

    // --- What is read ---

    @Test
    void settingsAndDefaults() {
        Settings settings = read(HEAD + "POSE 1 2 3").scenario().settings();
        assertEquals(new Settings(20, 10, 0.5, -5, -2.5, 8, 0, 0.5, 0.75,
                0.30, -8, 8, NoReturn.FREE, PortableMath.PI, 181, 0.02),
                settings);
        settings = read(HEAD + """
                PARAM occgrid_min_range 0.25
                PARAM occgrid_p0 0.4
                PARAM occgrid_p_occ 0.9
                PARAM occgrid_p_free 0.2
                PARAM occgrid_l_min -3
                PARAM occgrid_l_max 4
                PARAM occgrid_no_return ignore
                PARAM occgrid_fov 6.283185307179586
                PARAM occgrid_beams 7
                PARAM occgrid_noise_std 0
                POSE 1 2 3
                """).scenario().settings();
        assertEquals(
                new Settings(20, 10, 0.5, -5, -2.5, 8, 0.25, 0.4, 0.9, 0.2,
                        -3, 4, NoReturn.IGNORE, 6.283185307179586, 7, 0),
                settings);
    }

    @Test
    void linesAndComments() {
        String text = "# a comment, \u00e4 too\n \t \n  #PARAM\n" + HEAD
                + "PARAM laser_front 1 2 3\nPARAM\nODOM 1 2 \t3\npose 1\n"
                + "\t WALL  1 2\t3 4 # and so on\nWALL 5 6 7 8 #9\n"
                + "POSE 1 2 3 #\n\nPARAM other 1\nPOSE -1e0 +2. .5";
        for (String end : List.of("\n", "\r\n")) {
            Read read = read(text.replace("\n", end));
            assertEquals(List.of(new Segment(1, 2, 3, 4),
                    new Segment(5, 6, 7, 8)), read.scenario().walls());
            assertEquals(List.of(new Simulated(new Pose(1, 2, 3)),
                    new Simulated(new Pose(-1, 2, 0.5))), read.scans());
            assertEquals("a", read.scenario().name());
        }
        // the last line may lack its end, whichever it has
        assertEquals(1, read(HEAD + "POSE 1 2 3\r").scans().size());
    }

    private static String values(String value, int count) {
        return String.join(" ", Collections.nCopies(count, value));
    }

    @Test
    void flaser() {
        Read read = read(HEAD + "FLASER 3 1.5 nan +Infinity 4 5 6 "
                + "9 9 9 1.0 host 2.0\nFLASER 180 " + values("2", 180)
                + " 1 2 3 x # y z u v");
        Scan scan = scan(read, 0);
        assertEquals(new Pose(4, 5, 6), scan.pose());
        assertArrayEquals(new double[]{1.5, Double.NaN,
                Double.POSITIVE_INFINITY}, scan.ranges());
        assertArrayEquals(Sensor.flaserAngles(3), scan.angles());
        scan = scan(read, 1);
        assertEquals(180, scan.ranges().length);
        assertEquals(new Pose(1, 2, 3), scan.pose());
    }

    @Test
    void robotlaser1() {
        String rest = " 7 8 9 0 0 0 0 0 x x x 1.0 host 2.0";
        Read read = read(HEAD + "ROBOTLASER1 0 -0.5 99 0.25 81 0.1 0 "
                + "3 1 2 3 2 x 0.5" + rest + "\nROBOTLASER1 a 0 b .1 c d e "
                + "1 4 0" + rest);
        Scan scan = scan(read, 0);
        assertEquals(new Pose(7, 8, 9), scan.pose());
        assertArrayEquals(new double[]{-0.5, -0.25, 0.0}, scan.angles());
        assertArrayEquals(new double[]{1, 2, 3}, scan.ranges());
        scan = scan(read, 1);
        assertEquals(new Pose(7, 8, 9), scan.pose());
        assertArrayEquals(new double[]{4}, scan.ranges());
    }

    @Test
    void scansAreReadOneByOne() {
        try (Scenario scenario = Scenario.readScenario(
                file(HEAD + "POSE 1 2 3\nPOSE 4 5 6\nPOSE x\n").toString())) {
            Iterator<? extends Observation> scans = scenario.scans()
                    .iterator();
            assertEquals(new Simulated(new Pose(1, 2, 3)), scans.next());
            assertEquals(new Simulated(new Pose(4, 5, 6)), scans.next());
            ScenarioException error = assertThrows(ScenarioException.class,
                    scans::next);
            assertEquals(9, error.line);
        }
    }

    @Test
    void scansStartFromTheFirstEachTime() {
        // more than the reader holds in memory
        String text = HEAD + "WALL 1 2 3 4\nPOSE 1 2 3\n"
                + ("# " + values("x", 50_000) + "\n").repeat(5)
                + "FLASER 1 2 0 0 0 0 0 0 0 h 0\nPOSE 7 8 9";
        try (Scenario scenario = Scenario
                .readScenario(file(text).toString())) {
            OccupancyGrid first = Mapper.mapScenario(scenario,
                    OptionalLong.empty());
            Iterator<? extends Observation> early = scenario.scans()
                    .iterator();
            assertEquals(new Simulated(new Pose(1, 2, 3)), early.next());
            Fast.mapScenarioFast(scenario, OptionalLong.of(7), 2);
            Bits.assertSame(first, Mapper.mapScenario(scenario,
                    OptionalLong.empty()), "the second time");
            assertThrows(ConcurrentModificationException.class,
                    early::hasNext);
        }
        // line numbers are right the second time, too
        try (Scenario scenario = Scenario.readScenario(
                file(HEAD + "\nPOSE 1 2 3\n\nPOSE 1\n").toString())) {
            for (int i = 0; i < 3; i++) {
                ScenarioException error = assertThrows(
                        ScenarioException.class, () -> Mapper
                                .mapScenario(scenario, OptionalLong.empty()));
                assertEquals(10, error.line);
            }
        }
    }

    @Test
    void aClosedScenarioHasNoScans() {
        Scenario scenario = Scenario
                .readScenario(file(HEAD + "POSE 1 2 3\n").toString());
        Iterator<? extends Observation> scans = scenario.scans().iterator();
        scenario.close();
        assertThrows(IllegalStateException.class, scans::hasNext);
        assertThrows(IllegalStateException.class,
                () -> scenario.scans().iterator());
    }

    /** A pipe is mapped once; a second time is an error, not an empty map. */
    @Test
    void aPipeIsReadOnce() throws IOException, InterruptedException {
        Path pipe = folder.resolve("pipe.log");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start()
                .waitFor());
        Path text = file(HEAD + "POSE 1 2 3\nPOSE 4 5 6\n");
        Process writer = new ProcessBuilder("sh", "-c", "cat \"$0\" > \"$1\"",
                text.toString(), pipe.toString()).start();
        try (Scenario scenario = Scenario.readScenario(pipe.toString());
                Scenario file = Scenario.readScenario(text.toString())) {
            Bits.assertSame(
                    Mapper.mapScenario(file, OptionalLong.empty()),
                    Mapper.mapScenario(scenario, OptionalLong.empty()),
                    "pipe");
            IllegalStateException error = assertThrows(
                    IllegalStateException.class, () -> Mapper
                            .mapScenario(scenario, OptionalLong.empty()));
            assertEquals(pipe + " cannot be read a second time",
                    error.getMessage());
        }
        assertEquals(0, writer.waitFor());
    }

    @Test
    void otherCellsForTheSameSettings() {
        Settings settings = read(HEAD + "POSE 1 2 3").scenario().settings();
        assertEquals(new Settings(40, 30, 0.25, -5, -2.5, 8, 0, 0.5, 0.75,
                0.30, -8, 8, NoReturn.FREE, PortableMath.PI, 181, 0.02),
                settings.withCells(40, 30, 0.25));
    }

    /** The least range is for recorded scans, and NaN is never below it. */
    @Test
    void rangesBelowTheLeastAreIgnored() {
        Read read = read(HEAD + "PARAM occgrid_min_range 0.5\n"
                + "FLASER 5 0 0.4999999999999999 0.5 nan inf 0 0 0 0 0 0 0 h"
                + " 0\nROBOTLASER1 0 0 0 0 0 0 0 2 0.1 0.6 0 "
                + values("0", 14) + "\nFLASER 1 0 0 0 0 0 0 0 0 h 0\n");
        double nan = Double.NaN;
        assertArrayEquals(new double[]{nan, nan, 0.5, nan,
                Double.POSITIVE_INFINITY}, scan(read, 0).ranges());
        assertArrayEquals(new double[]{nan, 0.6}, scan(read, 1).ranges());
        checkError(HEAD + "PARAM occgrid_min_range 0.5\n"
                + "FLASER 2 0.1 -0.1 0 0 0 0 0 0 0 h 0\n", 8,
                "range 1 '-0.1' is negative");
    }

    @Test
    void longLines() {
        String text = HEAD + "FLASER 100000 " + values("1.25", 100_000)
                + " 0 0 0 0 0 0 0 h 0\n";
        Scan scan = scan(read(text + "# " + values("x", 70_000) + "\n"
                + "POSE 1 2 3"), 0);
        assertEquals(100_000, scan.ranges().length);
        assertEquals(1.25, scan.ranges()[99_999]);
    }

    @ParameterizedTest
    @CsvSource({"a.log, a", "x/y/a.b.log, a.b", ".log, .log", "a, a",
            "x.y/a, a", "a., a", "..log, .", "'', ''", "a.log/, a",
            "x/a.b//, a",
            "/, ''"})
    void names(String file, String name) {
        assertEquals(name, Scenario.scenarioName(file));
    }

    // --- Errors: SPEC.md section 8 ---

    @Test
    void cannotBeRead() {
        String file = file(HEAD + "POSE 1 2 3\n").toString();
        for (String path : List.of(folder + "", folder + "/",
                folder.resolve("none.log") + "", file + "/", "",
                "/proc/self/mem", folder + "/a\0b")) {
            ScenarioException error = assertThrows(ScenarioException.class,
                    () -> Scenario.readScenario(path));
            assertEquals(path + ":0: cannot be read", error.getMessage());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"ODOM \u00e9", "\u00a0", "POSE 1 2\u0000 3",
            "POSE 1 2 3\f", "X\u007f", "POSE 1 2 3 # \u00e4", "POSE\r1 2 3",
            "1X \u00e9", "POSE 1 2 3\r\r"})
    void notPlainAscii(String line) {
        checkError(HEAD + line + "\n", 7, "not plain ASCII text");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1POSE", "PO-SE", "\"MESSAGE", "POSE#", "-"})
    void notAKeyword(String keyword) {
        checkError("\n" + keyword + " 1 2 3\n", 2,
                "'" + keyword + "' is not a keyword");
    }

    @Test
    void place() {
        checkError(HEAD + "POSE 1 2 3\nWALL x\n", 8,
                "WALL must stand before the first scan");
        checkError(HEAD + "POSE 1 2 3\n\nPARAM occgrid_x\n", 9,
                "PARAM must stand before the first scan");
    }

    @ParameterizedTest
    @CsvSource({"PARAM occgrid_width, 'PARAM takes 2 values, found 1'",
            "PARAM occgrid_x 1 2, 'PARAM takes 2 values, found 3'",
            "PARAM occgrid_x #1 2, 'PARAM takes 2 values, found 1'",
            "WALL, 'WALL takes 4 values, found 0'",
            "WALL 1 2 3 4 5, 'WALL takes 4 values, found 5'",
            "POSE 1 2 # 3, 'POSE takes 3 values, found 2'",
            "POSE 1 2 3 4, 'POSE takes 3 values, found 4'"})
    void numbersOfValues(String line, String reason) {
        checkError(HEAD + line, 7, reason);
    }

    @Test
    void parameters() {
        checkError("PARAM occgrid_depth x\n", 1,
                "unknown parameter occgrid_depth");
        checkError("PARAM occgrid_ 1\n", 1, "unknown parameter occgrid_");
        checkError("PARAM occgrid_Width 1\n", 1,
                "unknown parameter occgrid_Width");
        checkError(HEAD + "PARAM occgrid_height x\n", 7,
                "occgrid_height is given twice");
        checkError("PARAM occgrid_no_return free\n"
                + "PARAM occgrid_no_return free\n", 2,
                "occgrid_no_return is given twice");
    }

    @ParameterizedTest
    @CsvSource({"width, 0, is not from 1 to 25000000",
            "width, 25000001, is not from 1 to 25000000",
            "width, 99999999999999999999, is not from 1 to 25000000",
            "width, 1.0, is not a whole number",
            "width, +1, is not a whole number",
            "height, x, is not a whole number",
            "height, 0, is not from 1 to 25000000",
            "resolution, 0.0009, is not from 0.001 to 1000",
            "resolution, 1000.1, is not from 0.001 to 1000",
            "resolution, nan, is not from 0.001 to 1000",
            "resolution, 0x1, is not a number",
            "origin_x, -10000000.1, is not from -10000000 to 10000000",
            "origin_y, inf, is not from -10000000 to 10000000",
            "max_range, 10001, is not from 0.001 to 10000",
            "max_range, 1d, is not a number",
            "min_range, -0.1, is not from 0 to 10000",
            "min_range, nan, is not from 0 to 10000",
            "min_range, x, is not a number",
            "p0, 0, is not between 0 and 1", "p0, one, is not a number",
            "p_occ, 1, is not between 0 and 1",
            "p_occ, nan, is not between 0 and 1",
            "p_free, 1e-301, is not between 0 and 1",
            "l_min, -1001, is not from -1000 to 1000",
            "l_max, 1001, is not from -1000 to 1000",
            "no_return, Free, is not free or ignore",
            "fov, -1, is not from 0 to 6.283185307179586",
            "fov, 6.2831853071795871, is not from 0 to 6.283185307179586",
            "beams, 0, is not from 1 to 100000",
            "beams, 100001, is not from 1 to 100000",
            "noise_std, 1000.5, is not from 0 to 1000"})
    void values(String name, String token, String reason) {
        checkError("#\nPARAM occgrid_" + name + " " + token + "\n", 2,
                "occgrid_" + name + " '" + token + "' " + reason);
    }

    @Test
    void coordinates() {
        String limits = "' is not from -10000000 to 10000000";
        String[] fields = {"x0", "y0", "x1", "y1"};
        for (int i = 0; i < 4; i++) {
            String[] ends = {"1", "2", "3", "4"};
            ends[i] = "10000000.5";
            checkError("WALL " + String.join(" ", ends), 1,
                    fields[i] + " '10000000.5" + limits);
            ends[i] = "1f";
            checkError("WALL " + String.join(" ", ends), 1,
                    fields[i] + " '1f' is not a number");
        }
        checkError(HEAD + "POSE a 2 3", 7, "x 'a' is not a number");
        checkError(HEAD + "POSE 1 nan 3", 7, "y 'nan" + limits);
        checkError(HEAD + "POSE 1e7 2 -1e7", 7,
                "theta '-1e7' is not from -1000000 to 1000000");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "FLASER | FLASER has no beam count",
            "FLASER 0 | beam count '0' is not from 1 to 100000",
            "FLASER 100001 | beam count '100001' is not from 1 to 100000",
            "FLASER 1.5 | beam count '1.5' is not a whole number",
            "FLASER 1 | FLASER with 1 beams takes 11 values, found 1",
            "FLASER 1 x 0 0 0 0 0 0 0 0 0 0"
                    + "| FLASER with 1 beams takes 11 values, found 12",
            "FLASER 2 1 -1 0 0 0 0 0 0 0 0 0 | range 1 '-1' is negative",
            "FLASER 2 -inf x a 0 0 0 0 0 0 0 0 | range 0 '-inf' is negative",
            "FLASER 2 1 x 0 0 0 0 0 0 0 0 0 | range 1 'x' is not a number",
            "FLASER 1 1 0 b 0 0 0 0 0 0 0 | y 'b' is not a number"})
    void flaserErrors(String line, String reason) {
        checkError(HEAD + line, 7, reason);
    }

    @Test
    void robotlaser1Errors() {
        String tail = values("0", 14);
        String[][] rows = {
                {"0 0 0 0 0 0 0", "ROBOTLASER1 has no beam count"},
                {"0 0 0 0 0 0 0 -1",
                        "beam count '-1' is not a whole number"},
                {"0 0 0 0 0 0 0 2 1 1 x " + values("0", 13),
                        "ROBOTLASER1 with 2 beams takes at least 25 values,"
                                + " found 24"},
                {"0 0 0 0 0 0 0 2 1 1 100001 " + tail,
                        "remission count '100001' is not from 0 to 100000"},
                {"0 0 0 0 0 0 0 2 1 1 x " + tail,
                        "remission count 'x' is not a whole number"},
                {"0 a 0 0 0 0 0 2 1 1 1 " + tail,
                        "ROBOTLASER1 with 2 beams and 1 remissions takes 26"
                                + " values, found 25"},
                {"0 a 0 b 0 0 0 2 x 1 0 " + tail,
                        "start 'a' is not a number"},
                {"0 0 0 1e6 0 0 0 2 1 -2 0 x " + values("0", 13),
                        "range 1 '-2' is negative"},
                {"0 0 0 nan 0 0 0 2 x 1 0 " + tail,
                        "step 'nan' is not from -1000000 to 1000000"},
                {"0 0 0 0 0 0 0 2 1 1 0 0 0 z " + values("0", 11),
                        "theta 'z' is not a number"}};
        for (String[] row : rows) {
            checkError(HEAD + "ROBOTLASER1 " + row[0], 7, row[1]);
        }
    }

    @Test
    void parametersAsAWhole() {
        String[] required = {"width", "height", "resolution", "origin_x",
                "origin_y", "max_range"};
        for (String name : required) {
            checkError(HEAD.replaceAll("PARAM occgrid_" + name + ".*", "")
                    + "\nFLASER\n", 8, "occgrid_" + name + " is missing");
        }
        checkError("POSE x\n", 1, "occgrid_width is missing");
        checkError(HEAD.replace("width 20", "width 2500001") + "POSE x\n", 2,
                "the grid has more than 25000000 cells");
        checkError(HEAD.replace("max_range 8", "max_range 10000")
                .replace("resolution 0.5", "resolution 0.0099")
                + "POSE x\n", 6,
                "occgrid_max_range is more than 1000000 cells");
        checkError(HEAD + "PARAM occgrid_l_max -8\n\nPOSE x\n", 7,
                "occgrid_l_min is not below occgrid_l_max");
        checkError("PARAM occgrid_l_max 1\nPARAM occgrid_l_min 1\n" + HEAD
                + "POSE x\n", 2, "occgrid_l_min is not below occgrid_l_max");
        checkError("PARAM occgrid_p0 0.9\nPARAM occgrid_l_max 2\n" + HEAD
                + "POSE x\n", 2,
                "logit(occgrid_p0) is not from occgrid_l_min to"
                        + " occgrid_l_max");
        checkError(HEAD + "\nPARAM occgrid_min_range 8\nPOSE x\n", 8,
                "occgrid_min_range is not below occgrid_max_range");
        checkError("PARAM occgrid_min_range 9\n" + HEAD + "POSE x\n", 7,
                "occgrid_min_range is not below occgrid_max_range");
        checkError("PARAM occgrid_l_min 0.1\n" + HEAD + "POSE x\n", 1,
                "logit(occgrid_p0) is not from occgrid_l_min to"
                        + " occgrid_l_max");
    }

    @Test
    void noScan() {
        checkError("", 0, "no scan");
        checkError("\n", 1, "no scan");
        checkError(HEAD, 6, "no scan");
        checkError(HEAD + "\n# end", 8, "no scan");
        checkError("PARAM occgrid_width 5", 1, "no scan");
    }
}
