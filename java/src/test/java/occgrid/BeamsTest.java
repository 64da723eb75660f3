package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import occgrid.Fast.Steps;
import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BeamsTest {
    private static OccupancyGrid grid(int width, int height) {
        GridSpec spec = new GridSpec(width, height, 0.5, -1.0, 2.0);
        return new OccupancyGrid(spec, 0.5, 0.75, 0.30, -8.0, 8.0);
    }

    /** A line that is walked twice in each way, from a grid like others. */
    private static void checkLine(int width, int height, int gx0, int gy0,
            int gx1, int gy1, boolean occupied) {
        OccupancyGrid plain = grid(width, height);
        OccupancyGrid fast = grid(width, height);
        double lUpdate = occupied ? plain.lOcc() : plain.lFree();
        Steps steps = Fast.clipRay(gx0, gy0, gx1, gy1, width, height);
        for (int i = 0; i < 2; i++) {
            for (Cell cell : Ray.bresenham(gx0, gy0, gx1, gy1)) {
                plain.updateCell(cell.gx(), cell.gy(), lUpdate);
            }
            Beams.updateLine(fast, gx0, gy0, gx1, gy1, steps.first(),
                    steps.last(), lUpdate);
        }
        Bits.assertSame(plain, fast,
                List.of(gx0, gy0, gx1, gy1).toString());
    }

    @Test
    void linesAreUpdatedCellByCell() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            checkLine(1 + random.nextInt(40), 1 + random.nextInt(40),
                    random.nextInt(90) - 25, random.nextInt(90) - 25,
                    random.nextInt(90) - 25, random.nextInt(90) - 25,
                    i % 4 == 0);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 349_525, 524_287, 1_048_575, 1_048_576})
    void theLongestLinesAreExact(int b) {
        int a = Ray.MAX_STEPS;
        // windows where the fixed-point number has gone far
        for (int back : new int[]{10, 100_000, a / 2, a - 10}) {
            int gx = a - back;
            int gy = (int) ((2L * gx * b + a - 1) / (2L * a));
            checkLine(60, 60, -gx, -gy + 30, a - gx, b - gy + 30, false);
            checkLine(60, 60, gy - 30, gx, gy - 30 - b, gx - a, true);
        }
    }

    /** The steps where rounding up comes closest to the next cell. */
    @Test
    void theFixedPointIsExact() {
        int a = Ray.MAX_STEPS;
        for (int b = 0; b <= 2; b++) {
            checkLine(a + 1, 3, 0, 0, a, b, false);
            checkLine(a + 1, 3, a - 1, b, 0, 0, true);
        }
    }

    /** More than there is room for at first, twice. */
    @Test
    void beamsComeBackAsTheyWere() {
        Beams beams = new Beams();
        for (int round = 0; round < 2; round++) {
            beams.clear();
            for (int i = 0; i < 5000; i++) {
                beams.add(i, -i, 7 * i, round, i % 3 == 0);
            }
            assertEquals(5000, beams.size());
            for (int i = 0; i < 5000; i++) {
                assertEquals(List.of(i, -i, 7 * i, round),
                        List.of(beams.gx0(i), beams.gy0(i), beams.gx1(i),
                                beams.gy1(i)));
            }
        }
    }
}
