package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import occgrid.Grid.Cell;
import occgrid.Grid.GridSpec;
import occgrid.Grid.OccupancyGrid;
import occgrid.Grid.Point;
import org.junit.jupiter.api.Test;

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
        assertEquals(240_000, grid(width, height).logOdds().length);
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

    /** Beyond 2^31, and still exact. */
    @Test
    void theFarthestCells() {
        GridSpec spec = new GridSpec(9, 9, 0.001, -1e7, -1e7);
        OccupancyGrid grid = new OccupancyGrid(spec, 0.5, 0.75, 0.3, -8, 8);
        assertEquals(new Cell(20_000_000_000L, -1),
                grid.worldToGrid(1e7, -1e7 - 0.0005));
        assertFalse(grid.inBounds(1L << 32, 0));
        assertFalse(grid.inBounds(0, 1L << 32));
        grid.updateCell(1L << 32, 0, grid.lOcc());
        grid.updateCell(0, (1L << 32) + 1, grid.lOcc());
        assertArrayEquals(new double[81], grid.logOdds());
        Point centre = grid.gridToWorldCenter(20_000_000_000L, 8);
        assertEquals(-1e7 + 20_000_000_000.5 * 0.001, centre.x());
        assertEquals(-1e7 + 8.5 * 0.001, centre.y());
    }

    /** What is read of a grid is a copy; other grids do not matter. */
    @Test
    void aGridOwnsItsCells() {
        OccupancyGrid grid = grid(4, 3);
        grid.updateCell(1, 2, grid.lOcc());
        double[] copy = grid.logOdds();
        copy[0] = 99.0;
        OccupancyGrid other = grid(7, 8);
        other.updateCell(0, 0, other.lFree());
        assertEquals(0.0, grid.logOdds(0, 0));
        assertEquals(grid.lOcc(), grid.logOdds(1, 2));
        assertEquals(12, grid.logOdds().length);
        for (long[] outside : new long[][]{{-1, 0}, {0, -1}, {4, 0}, {0, 3},
                {1L << 32, 0}}) {
            assertThrows(IndexOutOfBoundsException.class,
                    () -> grid.logOdds(outside[0], outside[1]));
        }
    }

    @Test
    void aCellIsClampedAtOnce() {
        OccupancyGrid grid = grid(4, 3);
        double lOcc = StrictMath.log(3.0);
        grid.updateCell(1, 2, grid.lOcc());
        assertEquals(lOcc, grid.logOdds(1, 2));
        for (int i = 0; i < 20; i++) {
            grid.updateCell(1, 2, grid.lOcc());
            grid.updateCell(2, 1, grid.lFree());
        }
        assertEquals(8.0, grid.logOdds(1, 2));
        assertEquals(-8.0, grid.logOdds(2, 1));
        grid.updateCell(1, 2, grid.lFree());
        assertEquals(8.0 + grid.lFree(), grid.logOdds(1, 2));
    }

    @Test
    void cellsOutsideAreSkipped() {
        OccupancyGrid grid = grid(4, 3);
        grid.updateCell(-1, 1, grid.lOcc());
        grid.updateCell(4, 1, grid.lOcc());
        grid.updateCell(1, -1, grid.lOcc());
        grid.updateCell(1, 3, grid.lOcc());
        assertArrayEquals(new double[12], grid.logOdds());
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
            grid.updateCell(0, 0, grid.lFree());
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

    @Test
    void aGridHasCells() {
        for (int[] size : new int[][]{{0, 1}, {1, 0}, {-5, 5},
                {1 << 16, 1 << 15}}) {
            assertThrows(IllegalArgumentException.class,
                    () -> grid(size[0], size[1]));
        }
    }
}
