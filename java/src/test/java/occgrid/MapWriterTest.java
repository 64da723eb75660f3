package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Locale;
import java.util.Random;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MapWriterTest {
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
        for (int i = 0; i < 20; i++) {
            grid.updateCell(0, 0, grid.lOcc());
            grid.updateCell(2, 1, grid.lFree());
        }
        assertEquals("P2\n3 2\n255\n128 128 255\n0 128 128\n",
                text(out -> MapWriter.mapPgm(grid, out)));
    }

    @Test
    void logOdds() throws IOException {
        OccupancyGrid grid = grid(0.1, 0.0, 0.0);
        for (int i = 0; i < 20; i++) {
            grid.updateCell(0, 0, grid.lOcc());
        }
        grid.updateCell(2, 1, grid.lFree());
        assertEquals("# logodds 3 2\n8.0 0.0 0.0\n0.0 0.0 "
                + grid.lFree() + "\n",
                text(out -> MapWriter.mapLogOdds(grid, out)));
    }

    @Test
    void logOddsReadBack() throws IOException {
        Random random = new Random(4);
        for (int i = 0; i < 1000; i++) {
            OccupancyGrid grid = new OccupancyGrid(
                    new GridSpec(3, 2, 0.1, 0.0, 0.0), 0.5, 0.75, 0.30,
                    -30.0, 30.0);
            for (int cell = 0; cell < 6; cell++) {
                grid.updateCell(cell % 3, cell / 3, random.nextGaussian()
                        * (i % 2 == 0 ? 8.0 : 1e-9));
            }
            String[] fields = text(out -> MapWriter.mapLogOdds(grid, out))
                    .split("\\s+");
            for (int cell = 0; cell < 6; cell++) {
                String field = fields[4 + cell];
                assertEquals(grid.logOdds(cell % 3, cell / 3),
                        Double.parseDouble(field));
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

    private static String[] thresholds(double p0) throws IOException {
        GridSpec spec = new GridSpec(1, 1, 1.0, 0.0, 0.0);
        OccupancyGrid grid = new OccupancyGrid(spec, p0, 0.75, 0.3, -30, 30);
        String[] lines = text(out -> MapWriter.mapYaml(grid, "a", out))
                .split("\n");
        return new String[]{lines[5].replace("occupied_thresh: ", ""),
                lines[6].replace("free_thresh: ", "")};
    }

    /** Whatever the prior is, a cell that nothing touched is unknown. */
    @Test
    void thresholdsFollowThePrior() throws IOException {
        assertArrayEquals(new String[]{"0.65", "0.196"}, thresholds(0.5));
        // odds 7/3 and 13/7: 91/21 of 112/21; 49/201: 343/603 of 946/603
        assertArrayEquals(new String[]{"0.8125", "0.362579281"},
                thresholds(0.7));
        assertArrayEquals(new String[]{"1.0", "0.998039216"},
                thresholds(1.0 - 1e-9));
        assertArrayEquals(new String[]{"0.001960784", "0.0"},
                thresholds(1e-9));
        for (int i = 1; i < 1000; i++) {
            double p0 = i / 1000.0;
            double seen = (255 - MapWriter.pixel(Grid.logit(p0))) / 255.0;
            String[] found = thresholds(p0);
            // readers: occupied above the one, free below the other
            assertFalse(seen > Double.parseDouble(found[0]), "p0 " + p0);
            assertFalse(seen < Double.parseDouble(found[1]), "p0 " + p0);
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "run-2_b.log.pgm | run-2_b.log.pgm", "1.pgm | 1.pgm",
            "run #2.pgm | \"run #2.pgm\"", "lab: x.pgm | \"lab: x.pgm\"",
            "[x].pgm | \"[x].pgm\"", "@x.pgm | \"@x.pgm\"",
            "'q'.pgm | \"'q'.pgm\"", "%x.pgm | \"%x.pgm\"",
            "- x.pgm | \"- x.pgm\"", "-x.pgm | \"-x.pgm\"",
            ".x.pgm | \".x.pgm\"", "a\"b\\c.pgm | \"a\\\"b\\\\c.pgm\""})
    void namesAreQuotedWhereYamlNeedsIt(String name, String written)
            throws IOException {
        assertEquals("image: " + written, text(out -> MapWriter
                .mapYaml(grid(1, 0, 0), name, out)).split("\n")[0]);
    }

    @Test
    void controlCharactersAreEscaped() throws IOException {
        assertEquals("image: \"a\\x01\\x7F\\x0A\\x1F.pgm\"",
                text(out -> MapWriter.mapYaml(grid(1, 0, 0),
                        "a\u0001\u007f\n\u001f.pgm", out))
                        .split("\n")[0]);
    }
}
