package occgrid;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import occgrid.Scenario.Observation;
import occgrid.Scenario.Recorded;
import occgrid.Scenario.ScenarioException;
import occgrid.Scenario.Simulated;
import occgrid.Sensor.Scan;
import occgrid.World.Pose;
import occgrid.World.Segment;

/**
 * Reads a scenario line by line: its parameters and walls at once, its scans
 * as they are asked for (SPEC.md sections 5 and 8).
 */
final class ScenarioReader implements Iterable<Observation>, Closeable {
    private static final String FAR = "10000000";
    private static final String WIDE = "1000000";
    private static final String MAX_BEAMS = "100000";

    private final String path;
    private final Lines lines;
    /** The number of the line at hand; of the first scan's; its place. */
    private int line;
    private int firstLine;
    private long firstPosition;
    private double minRange;
    private boolean isClosed;
    /** Who goes through the scans at present. */
    private Scans scans;
    /** Bearings of the FLASER line before: most logs have one kind. */
    private double[] flaserAngles = {};

    /** Opens a file. */
    ScenarioReader(String path) {
        this.path = path;
        try {
            lines = new Lines(path);
        } catch (IOException error) {
            throw fail("cannot be read");
        }
    }

    @Override
    public void close() {
        isClosed = true;
        try {
            lines.close();
        } catch (IOException error) {
            // it was only read: nothing is lost
        }
    }

    /** Reads what stands before the first scan. */
    Scenario read() {
        Parameters parameters = new Parameters(this);
        List<Segment> walls = new ArrayList<>();
        while (true) {
            if (!advance()) {
                throw fail("no scan");
            }
            String keyword = lines.text(0);
            if (isScan(keyword)) {
                break;
            }
            if (keyword.equals("WALL")) {
                walls.add(wall());
            } else if (isOurParameter(keyword)) {
                expect(keyword, 2, withoutComment());
                parameters.set(lines.text(1), 2);
            }
        }
        Scenario.Settings settings = parameters.settings();
        minRange = settings.minRange();
        firstLine = line;
        firstPosition = lines.position();
        return new Scenario(Scenario.scenarioName(path), settings, walls,
                this);
    }

    // --- Scans ---

    /** Goes through the scans from the first one. */
    @Override
    public Iterator<Observation> iterator() {
        checkOpen();
        if (scans != null) {
            try {
                lines.seek(firstPosition);
            } catch (IOException error) {
                throw new IllegalStateException(
                        path + " cannot be read a second time", error);
            }
            line = firstLine - 1;
        }
        scans = new Scans(scans == null);
        return scans;
    }

    private void checkOpen() {
        if (isClosed) {
            throw new IllegalStateException(path + " is closed");
        }
    }

    /** One way through the scans. */
    private final class Scans implements Iterator<Observation> {
        /** Whether the line at hand is a scan that is not yet read. */
        private boolean isAhead;
        private boolean isAtEnd;

        Scans(boolean isAhead) {
            this.isAhead = isAhead;
        }

        @Override
        public boolean hasNext() {
            if (scans != this) {
                throw new ConcurrentModificationException(
                        path + " is read from its first scan again");
            }
            checkOpen();
            if (!isAhead && !isAtEnd) {
                isAhead = advanceToScan();
                isAtEnd = !isAhead;
            }
            return isAhead;
        }

        @Override
        public Observation next() {
            if (!hasNext()) {
                throw new NoSuchElementException();
            }
            isAhead = false;
            return switch (lines.text(0)) {
                case "POSE" -> {
                    expect("POSE", 3, withoutComment());
                    yield new Simulated(pose(1));
                }
                case "FLASER" -> new Recorded(flaser());
                default -> new Recorded(robotlaser1());
            };
        }
    }

    /** Goes on to the next scan line; false at the end of the file. */
    private boolean advanceToScan() {
        while (advance()) {
            String keyword = lines.text(0);
            if (isScan(keyword)) {
                return true;
            }
            if (keyword.equals("WALL") || isOurParameter(keyword)) {
                throw fail(keyword + " must stand before the first scan");
            }
        }
        return false;
    }

    /** FLASER n r1 .. rn x y theta and six fields not looked at. */
    private Scan flaser() {
        int found = lines.size() - 1;
        if (found == 0) {
            throw fail("FLASER has no beam count");
        }
        int n = whole("beam count", 1, "1", MAX_BEAMS);
        if (found != n + 10) {
            throw fail("FLASER with " + n + " beams takes " + (n + 10)
                    + " values, found " + found);
        }
        double[] ranges = ranges(2, n);
        Pose pose = pose(n + 2);
        if (flaserAngles.length != n) {
            flaserAngles = Sensor.flaserAngles(n);
        }
        return new Scan(pose, flaserAngles.clone(), ranges);
    }

    /**
     * ROBOTLASER1 type start fov step max accuracy mode n r1 .. rn m e1 .. em
     * x y theta and eleven fields not looked at.
     */
    private Scan robotlaser1() {
        int found = lines.size() - 1;
        if (found < 8) {
            throw fail("ROBOTLASER1 has no beam count");
        }
        int n = whole("beam count", 8, "1", MAX_BEAMS);
        if (found < n + 23) {
            throw fail("ROBOTLASER1 with " + n + " beams takes at least "
                    + (n + 23) + " values, found " + found);
        }
        int m = whole("remission count", n + 9, "0", MAX_BEAMS);
        if (found != n + m + 23) {
            throw fail("ROBOTLASER1 with " + n + " beams and " + m
                    + " remissions takes " + (n + m + 23) + " values, found "
                    + found);
        }
        double start = within("start", 2, WIDE);
        double step = within("step", 4, WIDE);
        double[] ranges = ranges(9, n);
        Pose pose = pose(n + m + 10);
        double[] angles = new double[n];
        for (int i = 0; i < n; i++) {
            angles[i] = start + i * step;
        }
        return new Scan(pose, angles, ranges);
    }

    private Pose pose(int field) {
        return new Pose(within("x", field, FAR), within("y", field + 1, FAR),
                within("theta", field + 2, WIDE));
    }

    /** n ranges in metres; NaN, too, for those below the least. */
    private double[] ranges(int field, int n) {
        double[] ranges = new double[n];
        for (int i = 0; i < n; i++) {
            double range;
            try {
                range = lines.number(field + i);
            } catch (NumberFormatException error) {
                throw failAt("range " + i, field + i, "is not a number");
            }
            if (range < 0.0) {
                throw failAt("range " + i, field + i, "is negative");
            }
            ranges[i] = range < minRange ? Double.NaN : range;
        }
        return ranges;
    }

    // --- Lines ---

    /** Goes on to the next line that is not skipped; false at the end. */
    private boolean advance() {
        while (true) {
            try {
                if (!lines.advance()) {
                    return false;
                }
            } catch (IOException error) {
                throw fail("cannot be read");
            }
            line++;
            if (lines.size() == 0 || lines.first(0) == '#') {
                continue;
            }
            if (!lines.isPlain()) {
                throw fail("not plain ASCII text");
            }
            if (!isKeyword(lines.text(0))) {
                throw failAt("", 0, "is not a keyword");
            }
            return true;
        }
    }

    private static boolean isKeyword(String field) {
        return field.chars()
                .allMatch(c -> 'A' <= c && c <= 'Z' || 'a' <= c && c <= 'z'
                        || Numbers.isDigit(c) || c == '_')
                && !Numbers.isDigit(field.charAt(0));
    }

    private static boolean isScan(String keyword) {
        return switch (keyword) {
            case "POSE", "FLASER", "ROBOTLASER1" -> true;
            default -> false;
        };
    }

    private boolean isOurParameter(String keyword) {
        return keyword.equals("PARAM") && lines.size() > 1
                && lines.text(1).startsWith("occgrid_");
    }

    private Segment wall() {
        expect("WALL", 4, withoutComment());
        return new Segment(within("x0", 1, FAR), within("y0", 2, FAR),
                within("x1", 3, FAR), within("y1", 4, FAR));
    }

    // --- Values of the line at hand ---

    /** The number of values before a field that begins with #. */
    private int withoutComment() {
        int count = 1;
        while (count < lines.size() && lines.first(count) != '#') {
            count++;
        }
        return count - 1;
    }

    private void expect(String keyword, int count, int found) {
        if (found != count) {
            throw fail(keyword + " takes " + count + " values, found "
                    + found);
        }
    }

    /** A field as it is in the file. */
    String text(int field) {
        return lines.text(field);
    }

    double number(String name, int field) {
        try {
            return lines.number(field);
        } catch (NumberFormatException error) {
            throw failAt(name, field, "is not a number");
        }
    }

    double real(String name, int field, String low, String high) {
        double value = number(name, field);
        if (!(Double.parseDouble(low) <= value
                && value <= Double.parseDouble(high))) {
            throw failAt(name, field, "is not from " + low + " to " + high);
        }
        return value;
    }

    int whole(String name, int field, String low, String high) {
        if (!lines.text(field).chars().allMatch(Numbers::isDigit)) {
            throw failAt(name, field, "is not a whole number");
        }
        return (int) real(name, field, low, high);
    }

    /** A coordinate in metres or an angle in radians, either sign. */
    private double within(String name, int field, String limit) {
        return real(name, field, "-" + limit, limit);
    }

    // --- Errors ---

    /** The number of the line at hand. */
    int line() {
        return line;
    }

    ScenarioException failAt(String name, int field, String problem) {
        String before = name.isEmpty() ? "'" : name + " '";
        return fail(before + lines.text(field) + "' " + problem);
    }

    ScenarioException fail(String reason) {
        return fail(reason, line);
    }

    ScenarioException fail(String reason, int where) {
        return new ScenarioException(path, where, reason);
    }
}
