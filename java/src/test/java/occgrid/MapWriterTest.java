package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.MapWriter.WriteException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MapWriterTest {
    @TempDir
    private Path folder;
    private final Locale locale = Locale.getDefault();

    /** No locale shows in the files. */
    @BeforeEach
    void foreignDigits() {
        Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
    }

    @AfterEach
    void home() {
        Locale.setDefault(locale);
    }

    private static OccupancyGrid grid(double resolution, double originX,
            double originY) {
        GridSpec spec = new GridSpec(3, 2, resolution, originX, originY);
        return new OccupancyGrid(spec, 0.5, 0.75, 0.30, -8.0, 8.0);
    }

    private interface Text {
        void writeTo(ByteArrayOutputStream out) throws IOException;
    }

    private static String text(Text text) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        text.writeTo(out);
        return out.toString("UTF-8");
    }

    @Test
    void pixels() {
        assertEquals(0, MapWriter.pixel(8.0));
        assertEquals(128, MapWriter.pixel(0.0));
        assertEquals(255, MapWriter.pixel(-8.0));
        assertEquals(64, MapWriter.pixel(Grid.logit(0.75)));
        assertEquals(0, MapWriter.pixel(1000.0));
        assertEquals(255, MapWriter.pixel(-1000.0));
    }

    @Test
    void pgm() throws IOException {
        OccupancyGrid grid = grid(0.1, 0.0, 0.0);
        grid.logOdds[0] = 8.0;
        grid.logOdds[5] = -8.0;
        assertEquals("P2\n3 2\n255\n128 128 255\n0 128 128\n",
                text(out -> MapWriter.mapPgm(grid, out)));
    }

    @Test
    void logOdds() throws IOException {
        OccupancyGrid grid = grid(0.1, 0.0, 0.0);
        grid.logOdds[0] = 8.0;
        grid.logOdds[5] = -0.1;
        assertEquals("# logodds 3 2\n8.0 0.0 0.0\n0.0 0.0 -0.1\n",
                text(out -> MapWriter.mapLogOdds(grid, out)));
    }

    @Test
    void logOddsReadBack() throws IOException {
        Random random = new Random(4);
        OccupancyGrid grid = grid(0.1, 0.0, 0.0);
        for (int i = 0; i < 1000; i++) {
            for (int cell = 0; cell < 6; cell++) {
                grid.logOdds[cell] = random.nextGaussian()
                        * (i % 2 == 0 ? 8.0 : 1e-9);
            }
            String[] fields = text(out -> MapWriter.mapLogOdds(grid, out))
                    .split("\\s+");
            for (int cell = 0; cell < 6; cell++) {
                String field = fields[4 + cell];
                assertEquals(grid.logOdds[cell], Double.parseDouble(field));
                String digits = field.replaceAll("E.*|[-.]", "")
                        .replaceAll("^0+", "");
                assertTrue(digits.length() <= 17, field);
            }
        }
    }

    private static String yaml(double resolution, double x, double y)
            throws IOException {
        return text(out -> MapWriter.mapYaml(grid(resolution, x, y),
                "a.pgm", out));
    }

    @Test
    void yaml() throws IOException {
        assertEquals("image: a.pgm\nmode: trinary\nresolution: 0.1\n"
                + "origin: [-11.0, -9.0, 0.0]\nnegate: 0\n"
                + "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                yaml(0.1, -11.0, -9.0));
        // 2^-10 has ten decimals, the last a 5: ties to even
        assertTrue(yaml(0x1p-10, -0x1p-10, 3 * 0x1p-10).contains(
                "resolution: 0.000976562\n"
                        + "origin: [-0.000976562, 0.002929688, 0.0]"));
        assertTrue(yaml(1000.0, -4e-10, 1e6).contains(
                "resolution: 1000.0\norigin: [0.0, 1000000.0, 0.0]"));
        assertTrue(yaml(0.05, 0.0, 123456.7890125).contains(
                "resolution: 0.05\norigin: [0.0, 123456.7890125, 0.0]"));
    }

    private List<String> names(Path where) throws IOException {
        try (Stream<Path> files = Files.list(where)) {
            return files.map(file -> file.getFileName().toString()).sorted()
                    .toList();
        }
    }

    @Test
    void threeFilesAreWritten() throws IOException {
        Path out = folder.resolve("a/b");
        MapWriter.writeMap(out, "room", grid(0.1, 0.0, 0.0));
        MapWriter.writeMap(out, "room", grid(0.2, 0.0, 0.0));
        assertEquals(List.of("room.logodds", "room.pgm", "room.yaml"),
                names(out));
        assertTrue(Files.readString(out.resolve("room.yaml"))
                .contains("image: room.pgm\nmode: trinary\nresolution: 0.2"));
    }

    @Test
    void aLinkToAFolderIsAFolder() throws IOException {
        Path real = Files.createDirectory(folder.resolve("real"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), real);
        MapWriter.writeMap(link, "room", grid(0.1, 0.0, 0.0));
        assertEquals(3, names(real).size());
    }

    @Test
    void nothingIsLeftWhereAFileCannotBeWritten() throws IOException {
        Path taken = Files.createDirectories(folder.resolve("x.yaml/full"));
        WriteException error = assertThrows(WriteException.class,
                () -> MapWriter.writeMap(folder, "x", grid(0.1, 0, 0)));
        assertEquals(folder.resolve("x.yaml") + ": cannot be written",
                error.getMessage());
        assertTrue(Files.exists(taken));
        assertEquals(List.of(), names(folder).stream()
                .filter(name -> name.endsWith(".part")).toList());
    }

    @Test
    void theFolderIsNamedWhereItCannotBeMade() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "");
        for (Path out : List.of(file, file.resolve("a/b"))) {
            WriteException error = assertThrows(WriteException.class,
                    () -> MapWriter.writeMap(out, "x", grid(0.1, 0, 0)));
            assertEquals(out + ": cannot be written", error.getMessage());
        }
    }
}
