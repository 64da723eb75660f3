package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The vectors that all ports share, in scenarios/vectors: a file for each
 * function of the probe, a line for each call.
 */
class VectorsTest {
    private static final Path SHARED = Path.of(
            System.getProperty("occgrid.basedir"), "../scenarios/vectors");

    /** Calls the function for each line; the number of lines. */
    private static int check(String name, int inputs, Path file)
            throws IOException {
        Function<String[], String> function = Probe.function(name);
        List<String> lines = Files.readAllLines(file);
        int columns = lines.get(0).split(",").length;
        for (String line : lines.subList(1, lines.size())) {
            String[] words = line.split(",");
            assertEquals(columns, words.length, name + ": " + line);
            String[] given = Arrays.copyOf(words, inputs);
            String expected = String.join(" ",
                    Arrays.asList(words).subList(inputs, columns));
            assertEquals(expected, function.apply(given),
                    name + ": " + line);
        }
        return lines.size() - 1;
    }

    @ParameterizedTest
    @CsvSource({"sin, 1", "cos, 1", "exp, 1", "log, 1", "logit, 1",
            "sigmoid, 1", "world_to_grid, 5", "bresenham, 4", "clip_ray, 6",
            "flaser_angles, 2", "read_ranges, 3", "beam_endpoints, 5",
            "update_cell, 6", "pixel, 1", "philox, 6", "normal_deviate, 3"})
    void sharedVectors(String name, int inputs) throws IOException {
        assertTrue(Files.isDirectory(SHARED), SHARED + " is missing");
        assertTrue(check(name, inputs, SHARED.resolve(name + ".csv")) > 0);
    }

    private static String bits(double value) {
        String digits = Long.toHexString(Double.doubleToLongBits(value));
        return "0".repeat(16 - digits.length()) + digits;
    }

    /** One line of each function, worked out by hand. */
    @Test
    void oneVectorOfEachFunction(@TempDir Path folder) throws IOException {
        String one = bits(1.0);
        String half = bits(0.5);
        String zero = bits(0.0);
        String ten = bits(10.0);
        String eight = bits(8.0);
        String below = bits(-8.0);
        String[][] vectors = {{"sin", "1", zero, zero},
                {"cos", "1", zero, one}, {"exp", "1", zero, one},
                {"log", "1", one, zero}, {"logit", "1", half, zero},
                {"sigmoid", "1", zero, half},
                {"world_to_grid", "5", half, one, zero, zero, bits(1.25),
                        "-2,2"},
                {"bresenham", "4", "0,0,2,1,0:0 1:0 2:1"},
                {"clip_ray", "6", "-3,0,5,4,4,3,3,5"},
                {"clip_ray", "6", "-3,0,5,4,4,1,0,-1"},
                {"flaser_angles", "2", "181,0", bits(-1.5707963267948966)},
                {"read_ranges", "3", one, ten, "free", one, "1,1"},
                {"read_ranges", "3", "7ff8000000000000", ten, "free", ten,
                        "0,0"},
                {"read_ranges", "3", ten, ten, "ignore", ten, "0,0"},
                {"beam_endpoints", "5", one, half, zero, zero, ten,
                        bits(11.0), half},
                {"update_cell", "6", half, bits(0.75), bits(0.3), below,
                        eight, "oooooooooo", eight},
                {"update_cell", "6", half, bits(0.75), bits(0.25), below,
                        eight, "ooffffffffffffff", below},
                {"pixel", "1", zero, "128"},
                {"philox", "6", "00000000,00000000,00000000,00000000,"
                        + "00000000,00000000,"
                        + "6627e8d5,e169c58d,bc57ac4c,9b00dbd8"},
                {"normal_deviate", "3", "0,0,0",
                        bits(Noise.normalDeviate(0, 0, 0))}};
        for (String[] vector : vectors) {
            String line = String.join(",",
                    Arrays.copyOfRange(vector, 2, vector.length));
            String head = "x" + ",x".repeat(line.split(",").length - 1);
            Path file = folder.resolve(vector[0] + ".csv");
            Files.writeString(file, head + "\n" + line + "\n");
            assertEquals(1,
                    check(vector[0], Integer.parseInt(vector[1]), file));
        }
    }
}
