package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import occgrid.Grid.Cell;
import occgrid.Ray.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RayTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "3 4 3 4 | 3,4",
            "0 0 3 0 | 0,0 1,0 2,0 3,0",
            "0 0 -3 0 | 0,0 -1,0 -2,0 -3,0",
            "0 0 0 3 | 0,0 0,1 0,2 0,3",
            "0 0 0 -3 | 0,0 0,-1 0,-2 0,-3",
            "0 0 2 2 | 0,0 1,1 2,2",
            "0 0 -2 2 | 0,0 -1,1 -2,2",
            "0 0 2 -2 | 0,0 1,-1 2,-2",
            "0 0 -2 -2 | 0,0 -1,-1 -2,-2",
            // ties: half a cell to the side after one step
            "0 0 2 1 | 0,0 1,0 2,1",
            "0 0 -2 1 | 0,0 -1,0 -2,1",
            "0 0 2 -1 | 0,0 1,0 2,-1",
            "0 0 -2 -1 | 0,0 -1,0 -2,-1",
            "0 0 1 2 | 0,0 0,1 1,2",
            "0 0 -1 2 | 0,0 0,1 -1,2",
            "0 0 1 -2 | 0,0 0,-1 1,-2",
            "0 0 -1 -2 | 0,0 0,-1 -1,-2",
            "2 1 0 0 | 2,1 1,1 0,0",
            // the eight octants
            "1 1 6 3 | 1,1 2,1 3,2 4,2 5,3 6,3",
            "1 1 3 6 | 1,1 1,2 2,3 2,4 3,5 3,6",
            "1 1 -1 6 | 1,1 1,2 0,3 0,4 -1,5 -1,6",
            "1 1 -4 3 | 1,1 0,1 -1,2 -2,2 -3,3 -4,3",
            "1 1 -4 -1 | 1,1 0,1 -1,0 -2,0 -3,-1 -4,-1",
            "1 1 -1 -4 | 1,1 1,0 0,-1 0,-2 -1,-3 -1,-4",
            "1 1 3 -4 | 1,1 1,0 2,-1 2,-2 3,-3 3,-4",
            "1 1 6 -1 | 1,1 2,1 3,0 4,0 5,-1 6,-1"})
    void exactCells(String ends, String cells) {
        assertEquals(cells, Probe.function("bresenham").apply(ends));
    }

    @Test
    void theClosedFormIsTheSameList() {
        for (int dx = -40; dx <= 40; dx++) {
            for (int dy = -40; dy <= 40; dy++) {
                int a = Math.max(Math.abs(dx), Math.abs(dy));
                int b = Math.min(Math.abs(dx), Math.abs(dy));
                boolean alongX = Math.abs(dx) >= Math.abs(dy);
                int sx = Integer.signum(dx);
                int sy = Integer.signum(dy);
                List<Cell> expected = IntStream.rangeClosed(0, a)
                        .mapToObj(k -> {
                            int m = a == 0
                                    ? 0
                                    : (2 * k * b + a - 1) / (2 * a);
                            return alongX
                                    ? new Cell(7 + sx * k, 9 + sy * m)
                                    : new Cell(7 + sx * m, 9 + sy * k);
                        }).toList();
                assertEquals(expected, Ray.bresenham(7, 9, 7 + dx, 9 + dy));
            }
        }
    }

    /** Steps inside by looking at every cell. */
    private static Steps steps(List<Cell> cells, int width, int height) {
        int[] inside = IntStream.range(0, cells.size()).filter(k -> {
            Cell cell = cells.get(k);
            return 0 <= cell.gx() && cell.gx() < width && 0 <= cell.gy()
                    && cell.gy() < height;
        }).toArray();
        int n = inside.length;
        return n == 0 ? null : new Steps(inside[0], inside[n - 1]);
    }

    private static void checkClip(int... ends) {
        List<Cell> cells = Ray.bresenham(ends[0], ends[1], ends[2], ends[3]);
        for (int width = 1; width < 8; width++) {
            for (int height = 1; height < 8; height++) {
                Steps expected = steps(cells, width, height);
                Steps found = Ray.clipRay(ends[0], ends[1], ends[2], ends[3],
                        width, height);
                boolean none = found.last() < found.first();
                assertEquals(expected, none ? null : found);
            }
        }
    }

    @Test
    void clippingIsExact() {
        Random random = new Random(2);
        for (int i = 0; i < 4_000; i++) {
            int reach = i % 2 == 0 ? 12 : 60;
            checkClip(random.ints(4, -reach, reach).toArray());
        }
    }

    @Test
    void clippingIsExactFarAway() {
        int far = 2_000_000_000;
        int long_ = 1_000_000;
        assertEquals(new Steps(0, 3), Ray.clipRay(0, 0, 3, 3, 4, 4));
        for (int[] ends : new int[][]{{far, far, far - long_, far - 3},
                {-far, far, -far + long_, far - long_},
                {-long_, 5, 2, 900_000}, {3, -far, 3, -far + long_}}) {
            Steps steps = Ray.clipRay(ends[0], ends[1], ends[2], ends[3], 9,
                    9);
            assertEquals(true, steps.last() < steps.first());
        }
        checkClip(-9_000, -9_001, 4, 2);
    }
}
