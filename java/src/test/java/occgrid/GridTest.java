package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Grid.Point;
import occgrid.Ray.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GridTest {
    private static OccupancyGrid grid(int width, int height) {
        GridSpec spec = new GridSpec(width, height, 0.5, -1.0, 2.0);
        return new OccupancyGrid(spec, 0.5, 0.75, 0.30, -8.0, 8.0);
    }

    @Test
    void problem1() {
        int width = (int) Math.floor(30.0 / 0.05);
        int height = (int) Math.floor(20.0 / 0.05);
        assertEquals(600, width);
        assertEquals(400, height);
        assertEquals(240_000, grid(width, height).logOdds.length);
        assertEquals(1_920_000, 240_000 * Double.BYTES);
    }

    @Test
    void logitAndSigmoid() {
        assertEquals(0.0, Grid.logit(0.5));
        assertEquals(StrictMath.log(3.0), Grid.logit(0.75));
        assertEquals(Grid.logit(1e-9), Grid.logit(0.0));
        assertEquals(Grid.logit(1.0 - 1e-9), Grid.logit(1.0));
        assertEquals(0.5, Grid.sigmoid(0.0));
        assertEquals(0.75, Grid.sigmoid(Grid.logit(0.75)), 1e-15);
        assertEquals(0.0, Grid.sigmoid(-1000.0));
        assertEquals(1.0, Grid.sigmoid(1000.0));
    }

    @Test
    void pointsAndCells() {
        OccupancyGrid grid = grid(4, 3);
        assertEquals(new Cell(0, 0), grid.worldToGrid(-1.0, 2.0));
        assertEquals(new Cell(-1, -1), grid.worldToGrid(-1.0001, 1.9999));
        assertEquals(new Cell(1, 0), grid.worldToGrid(-0.5, 2.4999));
        assertEquals(new Cell(3, 2), grid.worldToGrid(0.9999, 3.4999));
        assertEquals(new Cell(4, 3), grid.worldToGrid(1.0, 3.5));
        assertEquals(new Point(-0.75, 2.25), grid.gridToWorldCenter(0, 0));
        assertEquals(new Point(0.75, 3.25), grid.gridToWorldCenter(3, 2));
        assertTrue(grid.inBounds(0, 0));
        assertTrue(grid.inBounds(3, 2));
        assertFalse(grid.inBounds(-1, 0));
        assertFalse(grid.inBounds(0, -1));
        assertFalse(grid.inBounds(4, 0));
        assertFalse(grid.inBounds(0, 3));
    }

    @Test
    void theFarthestCellsFit() {
        GridSpec spec = new GridSpec(9, 9, 0.001, -1e6, -1e6);
        OccupancyGrid grid = new OccupancyGrid(spec, 0.5, 0.75, 0.3, -8, 8);
        assertEquals(new Cell(2_001_000_000, 2_001_000_000),
                grid.worldToGrid(1001e3, 1001e3));
    }

    @Test
    void aCellIsClampedAtOnce() {
        OccupancyGrid grid = grid(4, 3);
        double lOcc = StrictMath.log(3.0);
        grid.updateCell(1, 2, grid.lOcc);
        assertEquals(lOcc, grid.logOdds[9]);
        for (int i = 0; i < 20; i++) {
            grid.updateCell(1, 2, grid.lOcc);
            grid.updateCell(2, 1, grid.lFree);
        }
        assertEquals(8.0, grid.logOdds[9]);
        assertEquals(-8.0, grid.logOdds[6]);
        grid.updateCell(1, 2, grid.lFree);
        assertEquals(8.0 + grid.lFree, grid.logOdds[9]);
    }

    @Test
    void cellsOutsideAreSkipped() {
        OccupancyGrid grid = grid(4, 3);
        grid.updateCell(-1, 1, grid.lOcc);
        grid.updateCell(4, 1, grid.lOcc);
        grid.updateCell(1, -1, grid.lOcc);
        grid.updateCell(1, 3, grid.lOcc);
        assertArrayEquals(new double[12], grid.logOdds);
    }

    @Test
    void problem4() {
        GridSpec spec = new GridSpec(1, 1, 1.0, 0.0, 0.0);
        double p0 = 0.4;
        double pInv = 0.3;
        OccupancyGrid grid = new OccupancyGrid(spec, p0, 0.75, pInv, -50, 50);
        double odds0 = p0 / (1.0 - p0);
        double oddsInv = pInv / (1.0 - pInv);
        double odds = odds0;
        for (int t = 1; t <= 30; t++) {
            grid.updateCell(0, 0, grid.lFree);
            odds *= oddsInv / odds0;
            double p = odds / (1.0 + odds);
            assertEquals(p, grid.probabilityGrid()[0], 1e-14);
        }
    }

    @Test
    void theBoundsHoldThePrior() {
        GridSpec spec = new GridSpec(1, 1, 1.0, 0.0, 0.0);
        assertThrows(IllegalArgumentException.class,
                () -> new OccupancyGrid(spec, 0.5, 0.75, 0.3, 1.0, 2.0));
    }

    /** updateLine is bresenham, clipRay and updateCell in one. */
    private static void checkLine(OccupancyGrid grid, int gx0, int gy0,
            int gx1, int gy1, double lUpdate) {
        double[] before = grid.logOdds.clone();
        for (Cell cell : Ray.bresenham(gx0, gy0, gx1, gy1)) {
            grid.updateCell(cell.gx(), cell.gy(), lUpdate);
        }
        double[] expected = grid.logOdds.clone();
        System.arraycopy(before, 0, grid.logOdds, 0, before.length);
        Steps steps = Ray.clipRay(gx0, gy0, gx1, gy1, grid.spec.width(),
                grid.spec.height());
        grid.updateLine(gx0, gy0, gx1, gy1, steps.first(), steps.last(),
                lUpdate);
        if (!Arrays.equals(expected, grid.logOdds)) {
            assertArrayEquals(expected, grid.logOdds, List
                    .of(gx0, gy0, gx1, gy1).toString());
        }
    }

    @Test
    void linesAreUpdatedCellByCell() {
        Random random = new Random(1);
        for (int i = 0; i < 200; i++) {
            OccupancyGrid grid = grid(1 + random.nextInt(40),
                    1 + random.nextInt(40));
            for (int line = 0; line < 100; line++) {
                checkLine(grid, random.nextInt(90) - 25,
                        random.nextInt(90) - 25, random.nextInt(90) - 25,
                        random.nextInt(90) - 25,
                        random.nextInt(4) == 0 ? grid.lOcc : grid.lFree);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 466_667, 699_999, 1_399_999, 1_400_000})
    void theLongestLinesAreExact(int b) {
        int a = OccupancyGrid.LONGEST_LINE;
        // windows where the fixed-point number has gone far
        for (int back : new int[]{10, 100_000, a / 2, a - 10}) {
            int gx = a - back;
            int gy = (int) ((2L * gx * b + a - 1) / (2L * a));
            OccupancyGrid grid = grid(60, 60);
            checkLine(grid, -gx, -gy + 30, a - gx, b - gy + 30, grid.lFree);
            checkLine(grid, gy - 30, gx, gy - 30 - b, gx - a, grid.lOcc);
        }
        assertThrows(IllegalArgumentException.class, () -> grid(9, 9)
                .updateLine(0, 0, a + 1, b, 0, 5, 1.0));
    }

    /** The steps where rounding up comes closest to the next cell. */
    @Test
    void theFixedPointIsExact() {
        OccupancyGrid grid = grid(OccupancyGrid.LONGEST_LINE + 1, 3);
        int a = OccupancyGrid.LONGEST_LINE;
        for (int b = 0; b <= 2; b++) {
            checkLine(grid, 0, 0, a, b, grid.lFree);
            checkLine(grid, a - 1, b, 0, 0, grid.lOcc);
        }
    }
}
