package occgrid;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.Map;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;

/**
 * Writing a map: the picture (PGM), what a navigation stack needs beside it
 * (YAML), the log-odds (SPEC.md section 7). One file, one room: map_writer.
 *
 * <p>Text goes to a stream row by row, for a grid may have 25 million cells.
 */
public final class MapWriter {
    private MapWriter() {
    }

    /** A folder or file that cannot be written. */
    public static final class WriteException extends IOException {
        private static final long serialVersionUID = 1L;

        WriteException(Path path, IOException cause) {
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
        int width = grid.spec.width();
        int height = grid.spec.height();
        write(out, "P2\n" + width + " " + height + "\n255\n");
        for (int gy = height - 1; gy >= 0; gy--) {
            StringBuilder row = new StringBuilder();
            for (int gx = 0; gx < width; gx++) {
                row.append(gx == 0 ? "" : " ");
                row.append(pixel(grid.logOdds[gy * width + gx]));
            }
            write(out, row.append('\n'));
        }
    }
    // [/snippet]

    /**
     * The description that map_server and Nav2 read beside the picture.
     *
     * @param grid the map
     * @param image the picture's file name
     * @param out the text goes here
     * @throws IOException if it cannot be written
     */
    public static void mapYaml(OccupancyGrid grid, String image,
            OutputStream out) throws IOException {
        GridSpec spec = grid.spec;
        write(out, "image: " + image + "\n"
                + "mode: trinary\n"
                + "resolution: " + fixed(spec.resolution()) + "\n"
                + "origin: [" + fixed(spec.originX()) + ", "
                + fixed(spec.originY()) + ", 0.0]\n"
                + "negate: 0\n"
                + "occupied_thresh: 0.65\n"
                + "free_thresh: 0.196\n");
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
        int width = grid.spec.width();
        int height = grid.spec.height();
        write(out, "# logodds " + width + " " + height + "\n");
        for (int gy = 0; gy < height; gy++) {
            StringBuilder row = new StringBuilder();
            for (int gx = 0; gx < width; gx++) {
                row.append(gx == 0 ? "" : " ");
                row.append(grid.logOdds[gy * width + gx]);
            }
            write(out, row.append('\n'));
        }
    }

    /**
     * Writes NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is
     * made where it is missing. Each file is renamed into place when all of
     * them are whole.
     *
     * @param folder the folder
     * @param name the files' name
     * @param grid the map
     * @throws WriteException if the folder or a file cannot be written
     */
    public static void writeMap(Path folder, String name, OccupancyGrid grid)
            throws WriteException {
        makeFolder(folder);
        Map<Path, Path> written = new LinkedHashMap<>();
        try {
            write(folder.resolve(name + ".pgm"), written,
                    out -> mapPgm(grid, out));
            write(folder.resolve(name + ".yaml"), written,
                    out -> mapYaml(grid, name + ".pgm", out));
            write(folder.resolve(name + ".logodds"), written,
                    out -> mapLogOdds(grid, out));
            for (Path path : written.keySet()) {
                rename(written.get(path), path);
            }
        } finally {
            // nothing is left of them where all went well
            written.values().forEach(MapWriter::remove);
        }
    }

    private interface Text {
        void writeTo(OutputStream out) throws IOException;
    }

    private static void makeFolder(Path folder) throws WriteException {
        try {
            // early releases of 17 refuse a link to a folder (JDK-8294193)
            if (!Files.isDirectory(folder)) {
                Files.createDirectories(folder);
            }
        } catch (IOException error) {
            throw new WriteException(folder, error);
        }
    }

    /** Writes the text of a file beside it, and notes where. */
    private static void write(Path path, Map<Path, Path> written, Text text)
            throws WriteException {
        // not a temporary file of Java's: others may not read those
        String name = "." + path.getFileName() + "."
                + ProcessHandle.current().pid() + ".part";
        Path beside = path.resolveSibling(name);
        written.put(path, beside);
        try (OutputStream out = new BufferedOutputStream(
                Files.newOutputStream(beside))) {
            text.writeTo(out);
        } catch (IOException error) {
            throw new WriteException(path, error);
        }
    }

    private static void rename(Path beside, Path path) throws WriteException {
        try {
            Files.move(beside, path, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException error) {
            throw new WriteException(path, error);
        }
    }

    private static void remove(Path beside) {
        try {
            Files.deleteIfExists(beside);
        } catch (IOException error) {
            // the error that brought us here matters more
        }
    }

    private static void write(OutputStream out, CharSequence text)
            throws IOException {
        out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** The exact value rounded to nine decimals, one of them kept. */
    private static String fixed(double value) {
        BigDecimal rounded = new BigDecimal(value)
                .setScale(9, RoundingMode.HALF_EVEN).stripTrailingZeros();
        return rounded.setScale(Math.max(rounded.scale(), 1)).toPlainString();
    }
}
