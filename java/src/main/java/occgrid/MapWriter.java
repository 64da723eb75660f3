package occgrid;

import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.List;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.OutputFiles.Output;

/**
 * Writing a map: the picture (PGM), what a navigation stack needs beside it
 * (YAML), the log-odds (SPEC.md section 7).
 *
 * <p>
 * Differs from the other ports: each text goes to a stream row by row, since
 * a grid may have 25 million cells.
 */
public final class MapWriter {
    private MapWriter() {
    }

    /** A folder or file that cannot be written: PATH: cannot be written. */
    public static final class WriteException extends IOException {
        private static final long serialVersionUID = 1L;

        WriteException(String path, Throwable cause) {
            super(path + ": cannot be written", cause);
        }
    }

    // [snippet: pixel]
    /**
     * Grey value of a cell: 0 is occupied, 255 is free.
     *
     * @param logOdds the cell's log-odds
     * @return 0 to 255
     */
    public static int pixel(double logOdds) {
        double free = 1.0 - Grid.sigmoid(logOdds);
        return (int) Math.floor(free * 255.0 + 0.5);
    }
    // [/snippet]

    // [snippet: map-pgm]
    /**
     * The map as an ASCII PGM (P2), the row with the largest y first.
     *
     * @param grid the map
     * @param out the text goes here
     * @throws IOException if it cannot be written
     */
    public static void mapPgm(OccupancyGrid grid, OutputStream out)
            throws IOException {
        int width = grid.spec().width();
        int height = grid.spec().height();
        write(out, "P2\n" + width + " " + height + "\n255\n");
        for (int gy = height - 1; gy >= 0; gy--) {
            StringBuilder row = new StringBuilder();
            for (int gx = 0; gx < width; gx++) {
                row.append(gx == 0 ? "" : " ");
                row.append(pixel(grid.logOdds(gx, gy)));
            }
            write(out, row.append('\n'));
        }
    }
    // [/snippet]

    /**
     * The description that map_server and Nav2 read beside the picture. Its
     * thresholds follow the prior: a cell that nothing touched is unknown.
     *
     * @param grid the map
     * @param image the picture's file name
     * @param out the text goes here
     * @throws IOException if it cannot be written
     */
    public static void mapYaml(OccupancyGrid grid, String image,
            OutputStream out) throws IOException {
        GridSpec spec = grid.spec();
        double l0 = grid.l0();
        double grey = 255 - pixel(l0); // how readers see the prior, of 255
        double occupied = Math.max(Grid.sigmoid(l0 + Grid.logit(0.65)),
                (grey + 0.5) / 255.0);
        double free = Math.min(Grid.sigmoid(l0 + Grid.logit(0.196)),
                (grey - 0.5) / 255.0);
        write(out, "image: ");
        // the name's own bytes, whatever the locale
        out.write(quoted(image).getBytes(FileNames.CHARSET));
        write(out, "\nmode: trinary\n"
                + "resolution: " + fixed(spec.resolution()) + "\n"
                + "origin: [" + fixed(spec.originX()) + ", "
                + fixed(spec.originY()) + ", 0.0]\n"
                + "negate: 0\n"
                + "occupied_thresh: " + fixed(Math.min(occupied, 1.0)) + "\n"
                + "free_thresh: " + fixed(Math.max(free, 0.0)) + "\n");
    }

    /**
     * The log-odds as text that reads back to the same doubles, the row with
     * the smallest y first.
     *
     * @param grid the map
     * @param out the text goes here
     * @throws IOException if it cannot be written
     */
    public static void mapLogOdds(OccupancyGrid grid, OutputStream out)
            throws IOException {
        int width = grid.spec().width();
        int height = grid.spec().height();
        write(out, "# logodds " + width + " " + height + "\n");
        for (int gy = 0; gy < height; gy++) {
            StringBuilder row = new StringBuilder();
            for (int gx = 0; gx < width; gx++) {
                row.append(gx == 0 ? "" : " ");
                row.append(grid.logOdds(gx, gy));
            }
            write(out, row.append('\n'));
        }
    }

    /**
     * Writes NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is
     * made where it is missing: all three files or none.
     *
     * <p>
     * They are written under temporary names and renamed when all are whole.
     * Temporary files that a killed run left in the folder are removed when
     * they are more than 24 hours old.
     *
     * @param folder the folder
     * @param name the files' name
     * @param grid the map
     * @throws WriteException if the folder or a file cannot be written
     */
    public static void writeMap(String folder, String name,
            OccupancyGrid grid) throws WriteException {
        OutputFiles.write(folder, List.of(
                new Output(name + ".pgm", out -> mapPgm(grid, out)),
                new Output(name + ".yaml",
                        out -> mapYaml(grid, name + ".pgm", out)),
                new Output(name + ".logodds",
                        out -> mapLogOdds(grid, out))));
    }

    private static void write(OutputStream out, CharSequence text)
            throws IOException {
        out.write(text.toString().getBytes(StandardCharsets.US_ASCII));
    }

    /** A name for YAML, in double quotes where it needs them. */
    private static String quoted(String name) {
        if (name.matches("[A-Za-z0-9_][A-Za-z0-9_.-]*")) {
            return name;
        }
        StringBuilder text = new StringBuilder("\"");
        for (char c : name.toCharArray()) {
            if (c < ' ' || c == 0x7f) {
                String digits = "0123456789ABCDEF";
                text.append("\\x").append(digits.charAt(c / 16))
                        .append(digits.charAt(c % 16));
            } else {
                text.append(c == '"' || c == '\\' ? "\\" : "").append(c);
            }
        }
        return text.append('"').toString();
    }

    /** The exact value rounded to nine decimals, one of them kept. */
    private static String fixed(double value) {
        BigDecimal rounded = new BigDecimal(value)
                .setScale(9, RoundingMode.HALF_EVEN).stripTrailingZeros();
        return rounded.setScale(Math.max(rounded.scale(), 1)).toPlainString();
    }
}
