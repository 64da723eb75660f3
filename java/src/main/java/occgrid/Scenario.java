package occgrid;

import java.io.Closeable;
import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Sensor.NoReturn;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import occgrid.World.Segment;

/**
 * Settings, walls and scans, the scans read one by one as they are asked for:
 * a CARMEN log with PARAM, WALL and POSE lines (SPEC.md sections 5 and 8).
 * One file, one room: scenario.
 *
 * @param name the name of the files that are written
 * @param settings what the PARAM lines set
 * @param walls the simulated world
 * @param scans what the robot sees, in order; it can be gone through once,
 *        and throws ScenarioException for a line that breaks a rule
 */
public record Scenario(String name, Settings settings, List<Segment> walls,
        Iterator<? extends Observation> scans) implements AutoCloseable {
    private static final int MAX_CELLS = 25_000_000;
    private static final int MAX_RANGE_CELLS = 1_000_000;
    private static final String MAX_BEAMS = "100000";

    /** A bare Pose is a scan to be simulated; a Scan was recorded. */
    public sealed interface Observation permits Pose, Scan {
    }

    /**
     * What the PARAM lines set; the table of SPEC.md section 5.2.
     *
     * @param width cells
     * @param height cells
     * @param resolution metres
     * @param originX metres
     * @param originY metres
     * @param maxRange metres
     * @param p0 prior probability of occupancy
     * @param pOcc probability that the inverse model gives to a hit cell
     * @param pFree probability that the inverse model gives to a passed cell
     * @param lMin lower bound of a cell's log-odds
     * @param lMax upper bound of a cell's log-odds
     * @param noReturn what a beam without return means
     * @param fov field of view of simulated scans, radians
     * @param beams number of beams of simulated scans
     * @param noiseStd standard deviation of simulated ranges, metres
     */
    public record Settings(int width, int height, double resolution,
            double originX, double originY, double maxRange, double p0,
            double pOcc, double pFree, double lMin, double lMax,
            NoReturn noReturn, double fov, int beams, double noiseStd) {
        /**
         * An empty map.
         *
         * @return the grid
         */
        public OccupancyGrid newGrid() {
            GridSpec spec = new GridSpec(width, height, resolution, originX,
                    originY);
            return new OccupancyGrid(spec, p0, pOcc, pFree, lMin, lMax);
        }
    }

    /** A scenario that breaks a rule; its text is FILE:LINE: REASON. */
    public static final class ScenarioException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        /** The number of the line, from 1; 0 when no line was read. */
        public final int line;
        /** What is wrong: a text of SPEC.md section 8. */
        public final String reason;

        ScenarioException(String file, int line, String reason) {
            super(file + ":" + line + ": " + reason);
            this.line = line;
            this.reason = reason;
        }
    }

    /** Closes the file, if there is one. */
    @Override
    public void close() {
        if (scans instanceof ScanReader reader) {
            reader.close();
        }
    }

    /**
     * Opens a scenario and reads it up to its first scan. The file stays
     * open while scans are read: use it in a try statement.
     *
     * @param file the file's name
     * @return the scenario
     * @throws ScenarioException for what is wrong before the first scan;
     *         later errors come while going through the scans
     */
    public static Scenario readScenario(String file) {
        ScanReader reader = new ScanReader(file);
        try {
            return reader.read();
        } catch (RuntimeException error) {
            reader.close();
            throw error;
        }
    }

    /**
     * A scenario's name: its file name without the part from its last dot on.
     *
     * @param file the file's name
     * @return the name
     */
    public static String scenarioName(String file) {
        // not a Path: it refuses names that the locale cannot say
        String fileName = new File(file).getName();
        int dot = fileName.lastIndexOf('.');
        return dot > 0 ? fileName.substring(0, dot) : fileName;
    }

    private enum Kind {
        WHOLE, REAL, PROBABILITY, NO_RETURN
    }

    /** A row of the table of parameters, limits as they are printed. */
    private record Parameter(String name, Kind kind, String low,
            String high) {
        Parameter(String name, Kind kind) {
            this(name, kind, "", "");
        }
    }

    private static final String LOWEST = "-1000000";
    private static final String HIGHEST = "1000000";

    private static final Map<String, Parameter> PARAMETERS = Stream.of(
            new Parameter("occgrid_width", Kind.WHOLE, "1", "25000000"),
            new Parameter("occgrid_height", Kind.WHOLE, "1", "25000000"),
            new Parameter("occgrid_resolution", Kind.REAL, "0.001", "1000"),
            new Parameter("occgrid_origin_x", Kind.REAL, LOWEST, HIGHEST),
            new Parameter("occgrid_origin_y", Kind.REAL, LOWEST, HIGHEST),
            new Parameter("occgrid_max_range", Kind.REAL, "0.001", "10000"),
            new Parameter("occgrid_p0", Kind.PROBABILITY),
            new Parameter("occgrid_p_occ", Kind.PROBABILITY),
            new Parameter("occgrid_p_free", Kind.PROBABILITY),
            new Parameter("occgrid_l_min", Kind.REAL, "-1000", "1000"),
            new Parameter("occgrid_l_max", Kind.REAL, "-1000", "1000"),
            new Parameter("occgrid_no_return", Kind.NO_RETURN),
            new Parameter("occgrid_fov", Kind.REAL, "0", "6.283185307179586"),
            new Parameter("occgrid_beams", Kind.WHOLE, "1", MAX_BEAMS),
            new Parameter("occgrid_noise_std", Kind.REAL, "0", "1000"))
            .collect(Collectors.toMap(Parameter::name, Function.identity()));

    private static final List<String> REQUIRED = List.of("occgrid_width",
            "occgrid_height", "occgrid_resolution", "occgrid_origin_x",
            "occgrid_origin_y", "occgrid_max_range");

    /** Goes through a file line by line; line is the last one's number. */
    private static final class ScanReader
            implements
                Iterator<Observation>,
                Closeable {
        private final String file;
        private final Reader input;
        private final char[] buffer = new char[1 << 16];
        private int from;
        private int to;
        private int line;
        private final Map<String, Double> values = new HashMap<>();
        private final Map<String, Integer> lines = new HashMap<>();
        private NoReturn noReturn = NoReturn.FREE;
        private final List<Segment> walls = new ArrayList<>();
        /** Whether the first scan was met. */
        private boolean isMapping;
        /** A scan line; null at the end of the file. */
        private List<String> scanLine;
        /** Whether next() has yet to read scanLine. */
        private boolean isAhead;

        ScanReader(String file) {
            this.file = file;
            try {
                // Latin-1 keeps bytes as they are, so ASCII can be checked
                input = new InputStreamReader(new FileInputStream(file),
                        StandardCharsets.ISO_8859_1);
            } catch (IOException error) {
                throw fail("cannot be read");
            }
        }

        @Override
        public void close() {
            try {
                input.close();
            } catch (IOException error) {
                // it was only read: nothing is lost
            }
        }

        ScenarioException fail(String reason) {
            return fail(reason, line);
        }

        ScenarioException fail(String reason, int where) {
            return new ScenarioException(file, where, reason);
        }

        // --- Lines ---

        /** A line without its LF; null at the end of the file. */
        private String readLine() throws IOException {
            // not BufferedReader's: it ends lines at a lone CR too
            StringBuilder text = new StringBuilder();
            while (true) {
                int start = from;
                while (from < to && buffer[from] != '\n') {
                    from++;
                }
                text.append(buffer, start, from - start);
                if (from < to) {
                    from++;
                    return text.toString();
                }
                from = 0;
                to = Math.max(input.read(buffer), 0);
                if (to == 0) {
                    return text.length() == 0 ? null : text.toString();
                }
            }
        }

        /** Fields of the next line that is not skipped; null at the end. */
        private List<String> fields() {
            while (true) {
                String text;
                try {
                    text = readLine();
                } catch (IOException error) {
                    throw fail("cannot be read");
                }
                if (text == null) {
                    return null;
                }
                line++;
                if (text.endsWith("\r")) {
                    text = text.substring(0, text.length() - 1);
                }
                List<String> fields = split(text);
                if (fields.isEmpty() || fields.get(0).startsWith("#")) {
                    continue;
                }
                if (!isPlain(text)) {
                    throw fail("not plain ASCII text");
                }
                if (!isKeyword(fields.get(0))) {
                    throw fail("'" + fields.get(0) + "' is not a keyword");
                }
                return fields;
            }
        }

        /** Reads on to the next scan line. */
        private void advance() {
            isAhead = true;
            while ((scanLine = fields()) != null) {
                List<String> given = withoutKeyword(scanLine);
                switch (scanLine.get(0)) {
                    case "POSE", "FLASER", "ROBOTLASER1" -> {
                        return;
                    }
                    case "WALL" -> wall(given);
                    case "PARAM" -> {
                        if (!given.isEmpty()
                                && given.get(0).startsWith("occgrid_")) {
                            parameter(given);
                        }
                    }
                    default -> {
                        // it belongs to another program
                    }
                }
            }
        }

        /** The settings and walls, up to the first scan. */
        Scenario read() {
            advance();
            if (scanLine == null) {
                throw fail("no scan");
            }
            Settings settings = settings();
            isMapping = true;
            return new Scenario(scenarioName(file), settings, walls, this);
        }

        @Override
        public boolean hasNext() {
            if (!isAhead) {
                advance();
            }
            return scanLine != null;
        }

        @Override
        public Observation next() {
            if (!hasNext()) {
                throw new NoSuchElementException();
            }
            isAhead = false;
            List<String> given = withoutKeyword(scanLine);
            return switch (scanLine.get(0)) {
                case "POSE" -> pose(
                        expect("POSE", 3, withoutComment(given)));
                case "FLASER" -> flaser(given);
                default -> robotlaser1(given);
            };
        }

        // --- PARAM and WALL ---

        private void parameter(List<String> given) {
            expectBeforeScans("PARAM");
            List<String> pair = expect("PARAM", 2, withoutComment(given));
            String name = pair.get(0);
            String token = pair.get(1);
            Parameter row = PARAMETERS.get(name);
            if (row == null) {
                throw fail("unknown parameter " + name);
            }
            if (lines.put(name, line) != null) {
                throw fail(name + " is given twice");
            }
            switch (row.kind()) {
                case WHOLE -> values.put(name,
                        (double) whole(name, token, row.low(), row.high()));
                case REAL -> values.put(name,
                        real(name, token, row.low(), row.high()));
                case PROBABILITY -> values.put(name,
                        probability(name, token));
                case NO_RETURN -> noReturn = noReturn(name, token);
            }
        }

        private void wall(List<String> given) {
            expectBeforeScans("WALL");
            List<String> ends = expect("WALL", 4, withoutComment(given));
            walls.add(new Segment(coordinate("x0", ends.get(0)),
                    coordinate("y0", ends.get(1)),
                    coordinate("x1", ends.get(2)),
                    coordinate("y1", ends.get(3))));
        }

        private void expectBeforeScans(String keyword) {
            if (isMapping) {
                throw fail(keyword + " must stand before the first scan");
            }
        }

        /** The parameters as a whole, checked together. */
        private Settings settings() {
            for (String name : REQUIRED) {
                if (!values.containsKey(name)) {
                    throw fail(name + " is missing");
                }
            }
            Settings settings = new Settings(
                    values.get("occgrid_width").intValue(),
                    values.get("occgrid_height").intValue(),
                    values.get("occgrid_resolution"),
                    values.get("occgrid_origin_x"),
                    values.get("occgrid_origin_y"),
                    values.get("occgrid_max_range"),
                    values.getOrDefault("occgrid_p0", 0.5),
                    values.getOrDefault("occgrid_p_occ", 0.75),
                    values.getOrDefault("occgrid_p_free", 0.30),
                    values.getOrDefault("occgrid_l_min", -8.0),
                    values.getOrDefault("occgrid_l_max", 8.0),
                    noReturn,
                    values.getOrDefault("occgrid_fov", Sensor.PI),
                    values.getOrDefault("occgrid_beams", 181.0).intValue(),
                    values.getOrDefault("occgrid_noise_std", 0.02));
            long cells = (long) settings.width() * settings.height();
            double rangeCells = settings.maxRange() / settings.resolution();
            double l0 = Grid.logit(settings.p0());
            if (cells > MAX_CELLS) {
                throw fail("the grid has more than " + MAX_CELLS + " cells",
                        latest("occgrid_width", "occgrid_height"));
            }
            if (rangeCells > MAX_RANGE_CELLS) {
                throw fail("occgrid_max_range is more than " + MAX_RANGE_CELLS
                        + " cells",
                        latest("occgrid_max_range", "occgrid_resolution"));
            }
            if (settings.lMin() >= settings.lMax()) {
                throw fail("occgrid_l_min is not below occgrid_l_max",
                        latest("occgrid_l_min", "occgrid_l_max"));
            }
            if (l0 < settings.lMin() || l0 > settings.lMax()) {
                throw fail("logit(occgrid_p0) is not from occgrid_l_min to"
                        + " occgrid_l_max",
                        latest("occgrid_p0", "occgrid_l_min",
                                "occgrid_l_max"));
            }
            return settings;
        }

        /** The latest of the lines of these parameters. */
        private int latest(String... names) {
            return Stream.of(names)
                    .mapToInt(name -> lines.getOrDefault(name, 0)).max()
                    .getAsInt();
        }

        // --- Scans ---

        /** FLASER n r1 .. rn x y theta and six fields not looked at. */
        private Scan flaser(List<String> given) {
            if (given.isEmpty()) {
                throw fail("FLASER has no beam count");
            }
            int n = whole("beam count", given.get(0), "1", MAX_BEAMS);
            int found = given.size();
            if (found != n + 10) {
                throw fail("FLASER with " + n + " beams takes " + (n + 10)
                        + " values, found " + found);
            }
            double[] ranges = ranges(given.subList(1, n + 1));
            Pose pose = pose(given.subList(n + 1, n + 4));
            return new Scan(pose, Sensor.flaserAngles(n), ranges);
        }

        /**
         * ROBOTLASER1 type start fov step max accuracy mode n r1 .. rn m e1
         * .. em x y theta and eleven fields not looked at.
         */
        private Scan robotlaser1(List<String> given) {
            int found = given.size();
            if (found < 8) {
                throw fail("ROBOTLASER1 has no beam count");
            }
            int n = whole("beam count", given.get(7), "1", MAX_BEAMS);
            if (found < n + 23) {
                throw fail("ROBOTLASER1 with " + n + " beams takes at least "
                        + (n + 23) + " values, found " + found);
            }
            int m = whole("remission count", given.get(n + 8), "0",
                    MAX_BEAMS);
            if (found != n + m + 23) {
                throw fail("ROBOTLASER1 with " + n + " beams and " + m
                        + " remissions takes " + (n + m + 23)
                        + " values, found " + found);
            }
            double start = coordinate("start", given.get(1));
            double step = coordinate("step", given.get(3));
            double[] ranges = ranges(given.subList(8, n + 8));
            Pose pose = pose(given.subList(n + m + 9, n + m + 12));
            double[] angles = new double[n];
            for (int i = 0; i < n; i++) {
                angles[i] = start + i * step;
            }
            return new Scan(pose, angles, ranges);
        }

        private Pose pose(List<String> tokens) {
            return new Pose(coordinate("x", tokens.get(0)),
                    coordinate("y", tokens.get(1)),
                    coordinate("theta", tokens.get(2)));
        }

        /** Ranges in metres, NaN and infinity among them. */
        private double[] ranges(List<String> tokens) {
            double[] ranges = new double[tokens.size()];
            for (int i = 0; i < ranges.length; i++) {
                String token = tokens.get(i);
                if (!isNumber(token)) {
                    throw fail("range " + i + " '" + token
                            + "' is not a number");
                }
                ranges[i] = toDouble(token);
                if (ranges[i] < 0.0) {
                    throw fail("range " + i + " '" + token + "' is negative");
                }
            }
            return ranges;
        }

        // --- Values ---

        private List<String> expect(String keyword, int count,
                List<String> given) {
            if (given.size() != count) {
                throw fail(keyword + " takes " + count + " values, found "
                        + given.size());
            }
            return given;
        }

        private double number(String field, String token) {
            if (!isNumber(token)) {
                throw fail(field + " '" + token + "' is not a number");
            }
            return toDouble(token);
        }

        private double real(String field, String token, String low,
                String high) {
            double value = number(field, token);
            if (!(toDouble(low) <= value && value <= toDouble(high))) {
                throw fail(field + " '" + token + "' is not from " + low
                        + " to " + high);
            }
            return value;
        }

        private int whole(String field, String token, String low,
                String high) {
            if (!token.chars().allMatch(c -> '0' <= c && c <= '9')) {
                throw fail(field + " '" + token + "' is not a whole number");
            }
            return (int) real(field, token, low, high);
        }

        private double probability(String field, String token) {
            double value = number(field, token);
            if (!(0.0 < value && value < 1.0)) {
                throw fail(field + " '" + token + "' is not between 0 and 1");
            }
            return value;
        }

        private NoReturn noReturn(String field, String token) {
            return switch (token) {
                case "free" -> NoReturn.FREE;
                case "ignore" -> NoReturn.IGNORE;
                default -> throw fail(field + " '" + token
                        + "' is not free or ignore");
            };
        }

        /** A coordinate in metres, or an angle in radians. */
        private double coordinate(String field, String token) {
            return real(field, token, LOWEST, HIGHEST);
        }
    }

    // --- Text ---

    /** Fields between spaces and tabs. */
    private static List<String> split(String text) {
        List<String> fields = new ArrayList<>();
        int end = 0;
        while (true) {
            int start = end;
            while (start < text.length() && isSpace(text.charAt(start))) {
                start++;
            }
            if (start == text.length()) {
                return fields;
            }
            end = start;
            while (end < text.length() && !isSpace(text.charAt(end))) {
                end++;
            }
            fields.add(text.substring(start, end));
        }
    }

    private static boolean isSpace(char c) {
        return c == ' ' || c == '\t';
    }

    private static boolean isPlain(String text) {
        return text.chars().allMatch(c -> ' ' <= c && c <= '~' || c == '\t');
    }

    private static boolean isKeyword(String field) {
        return field.chars()
                .allMatch(c -> 'A' <= c && c <= 'Z' || 'a' <= c && c <= 'z'
                        || isDigit(c) || c == '_')
                && !isDigit(field.charAt(0));
    }

    private static boolean isDigit(int c) {
        return '0' <= c && c <= '9';
    }

    private static List<String> withoutKeyword(List<String> fields) {
        return fields.subList(1, fields.size());
    }

    /** The fields before one that begins with #. */
    private static List<String> withoutComment(List<String> fields) {
        return fields.stream().takeWhile(field -> !field.startsWith("#"))
                .toList();
    }

    /**
     * Whether a field is a number of SPEC.md section 5.1. Double.parseDouble
     * takes more: hexadecimal digits, the suffixes d and f, spaces.
     */
    static boolean isNumber(String token) {
        int length = token.length();
        int i = skipSign(token, 0);
        if (i < length && Character.isLetter(token.charAt(i))) {
            return isWord(token.substring(i));
        }
        int afterWhole = skipDigits(token, i);
        int digits = afterWhole - i;
        i = afterWhole;
        if (i < length && token.charAt(i) == '.') {
            int afterFraction = skipDigits(token, i + 1);
            digits += afterFraction - (i + 1);
            i = afterFraction;
        }
        if (digits == 0) {
            return false;
        }
        if (i < length && (token.charAt(i) | 0x20) == 'e') {
            int exponent = skipSign(token, i + 1);
            i = skipDigits(token, exponent);
            return i > exponent && i == length;
        }
        return i == length;
    }

    private static boolean isWord(String word) {
        return word.equalsIgnoreCase("nan") || word.equalsIgnoreCase("inf")
                || word.equalsIgnoreCase("infinity");
    }

    private static int skipSign(String token, int i) {
        return i < token.length()
                && (token.charAt(i) == '+' || token.charAt(i) == '-')
                        ? i + 1
                        : i;
    }

    private static int skipDigits(String token, int i) {
        while (i < token.length() && isDigit(token.charAt(i))) {
            i++;
        }
        return i;
    }

    /** The double of a field that is a number. */
    static double toDouble(String token) {
        double value;
        char last = token.charAt(token.length() - 1);
        if (Character.isLetter(last)) {
            boolean isNan = last == 'n' || last == 'N';
            value = isNan
                    ? Double.NaN
                    : token.startsWith("-")
                            ? Double.NEGATIVE_INFINITY
                            : Double.POSITIVE_INFINITY;
        } else {
            value = Double.parseDouble(token);
        }
        if (Math.abs(value) >= 1e300) {
            return value < 0.0
                    ? Double.NEGATIVE_INFINITY
                    : Double.POSITIVE_INFINITY;
        }
        return Math.abs(value) < 1e-300 ? 0.0 : value;
    }
}
