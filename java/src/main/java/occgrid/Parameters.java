package occgrid;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import occgrid.Scenario.Settings;
import occgrid.Sensor.NoReturn;

/**
 * The parameters of a scenario, one by one and as a whole (SPEC.md section
 * 5.2).
 */
final class Parameters {
    private static final int MAX_CELLS = 25_000_000;
    private static final int MAX_RANGE_CELLS = 1_000_000;

    private enum Kind {
        WHOLE, REAL, PROBABILITY, NO_RETURN
    }

    /** A row of the table, limits as they are printed. */
    private record Row(String name, Kind kind, String low, String high) {
        Row(String name, Kind kind) {
            this(name, kind, "", "");
        }
    }

    private static final Map<String, Row> TABLE = Stream.of(
            new Row("occgrid_width", Kind.WHOLE, "1", "25000000"),
            new Row("occgrid_height", Kind.WHOLE, "1", "25000000"),
            new Row("occgrid_resolution", Kind.REAL, "0.001", "1000"),
            new Row("occgrid_origin_x", Kind.REAL, "-10000000", "10000000"),
            new Row("occgrid_origin_y", Kind.REAL, "-10000000", "10000000"),
            new Row("occgrid_max_range", Kind.REAL, "0.001", "10000"),
            new Row("occgrid_min_range", Kind.REAL, "0", "10000"),
            new Row("occgrid_p0", Kind.PROBABILITY),
            new Row("occgrid_p_occ", Kind.PROBABILITY),
            new Row("occgrid_p_free", Kind.PROBABILITY),
            new Row("occgrid_l_min", Kind.REAL, "-1000", "1000"),
            new Row("occgrid_l_max", Kind.REAL, "-1000", "1000"),
            new Row("occgrid_no_return", Kind.NO_RETURN),
            new Row("occgrid_fov", Kind.REAL, "0", "6.283185307179586"),
            new Row("occgrid_beams", Kind.WHOLE, "1", "100000"),
            new Row("occgrid_noise_std", Kind.REAL, "0", "1000"))
            .collect(Collectors.toMap(Row::name, Function.identity()));

    private static final List<String> REQUIRED = List.of("occgrid_width",
            "occgrid_height", "occgrid_resolution", "occgrid_origin_x",
            "occgrid_origin_y", "occgrid_max_range");

    private final ScenarioReader reader;
    private final Map<String, Double> values = new HashMap<>();
    /** The number of the line that gave each parameter. */
    private final Map<String, Integer> lines = new HashMap<>();
    private NoReturn noReturn = NoReturn.FREE;

    Parameters(ScenarioReader reader) {
        this.reader = reader;
    }

    /** Takes the value of a parameter from a field of the line at hand. */
    void set(String name, int field) {
        Row row = TABLE.get(name);
        if (row == null) {
            throw reader.fail("unknown parameter " + name);
        }
        if (lines.put(name, reader.line()) != null) {
            throw reader.fail(name + " is given twice");
        }
        switch (row.kind()) {
            case WHOLE -> values.put(name, (double) reader.whole(name, field,
                    row.low(), row.high()));
            case REAL -> values.put(name,
                    reader.real(name, field, row.low(), row.high()));
            case PROBABILITY -> values.put(name, probability(name, field));
            case NO_RETURN -> noReturn = noReturn(name, field);
        }
    }

    private double probability(String name, int field) {
        double value = reader.number(name, field);
        if (!(0.0 < value && value < 1.0)) {
            throw reader.failAt(name, field, "is not between 0 and 1");
        }
        return value;
    }

    private NoReturn noReturn(String name, int field) {
        return switch (reader.text(field)) {
            case "free" -> NoReturn.FREE;
            case "ignore" -> NoReturn.IGNORE;
            default -> throw reader.failAt(name, field,
                    "is not free or ignore");
        };
    }

    /** The parameters as a whole, checked together. */
    Settings settings() {
        for (String name : REQUIRED) {
            if (!values.containsKey(name)) {
                throw reader.fail(name + " is missing");
            }
        }
        Settings settings = new Settings(
                values.get("occgrid_width").intValue(),
                values.get("occgrid_height").intValue(),
                values.get("occgrid_resolution"),
                values.get("occgrid_origin_x"),
                values.get("occgrid_origin_y"),
                values.get("occgrid_max_range"),
                values.getOrDefault("occgrid_min_range", 0.0),
                values.getOrDefault("occgrid_p0", 0.5),
                values.getOrDefault("occgrid_p_occ", 0.75),
                values.getOrDefault("occgrid_p_free", 0.30),
                values.getOrDefault("occgrid_l_min", -8.0),
                values.getOrDefault("occgrid_l_max", 8.0),
                noReturn,
                values.getOrDefault("occgrid_fov", PortableMath.PI),
                values.getOrDefault("occgrid_beams", 181.0).intValue(),
                values.getOrDefault("occgrid_noise_std", 0.02));
        long cells = (long) settings.width() * settings.height();
        double rangeCells = settings.maxRange() / settings.resolution();
        double l0 = Grid.logit(settings.p0());
        refuse(cells > MAX_CELLS,
                "the grid has more than " + MAX_CELLS + " cells",
                "occgrid_width", "occgrid_height");
        refuse(rangeCells > MAX_RANGE_CELLS,
                "occgrid_max_range is more than " + MAX_RANGE_CELLS
                        + " cells",
                "occgrid_max_range", "occgrid_resolution");
        refuse(settings.lMin() >= settings.lMax(),
                "occgrid_l_min is not below occgrid_l_max", "occgrid_l_min",
                "occgrid_l_max");
        refuse(l0 < settings.lMin() || l0 > settings.lMax(),
                "logit(occgrid_p0) is not from occgrid_l_min to"
                        + " occgrid_l_max",
                "occgrid_p0", "occgrid_l_min", "occgrid_l_max");
        refuse(settings.minRange() >= settings.maxRange(),
                "occgrid_min_range is not below occgrid_max_range",
                "occgrid_min_range", "occgrid_max_range");
        return settings;
    }

    /** An error at the latest of the lines of these parameters. */
    private void refuse(boolean isWrong, String reason, String... names) {
        if (isWrong) {
            int latest = Stream.of(names)
                    .mapToInt(name -> lines.getOrDefault(name, 0)).max()
                    .getAsInt();
            throw reader.fail(reason, latest);
        }
    }
}
