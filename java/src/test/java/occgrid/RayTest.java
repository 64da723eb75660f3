package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.IntStream;
import occgrid.Grid.Cell;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RayTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "3 4 3 4 | 3:4",
            "0 0 3 0 | 0:0 1:0 2:0 3:0",
            "0 0 -3 0 | 0:0 -1:0 -2:0 -3:0",
            "0 0 0 3 | 0:0 0:1 0:2 0:3",
            "0 0 0 -3 | 0:0 0:-1 0:-2 0:-3",
            "0 0 2 2 | 0:0 1:1 2:2",
            "0 0 -2 2 | 0:0 -1:1 -2:2",
            "0 0 2 -2 | 0:0 1:-1 2:-2",
            "0 0 -2 -2 | 0:0 -1:-1 -2:-2",
            // ties: half a cell to the side after one step
            "0 0 2 1 | 0:0 1:0 2:1",
            "0 0 -2 1 | 0:0 -1:0 -2:1",
            "0 0 2 -1 | 0:0 1:0 2:-1",
            "0 0 -2 -1 | 0:0 -1:0 -2:-1",
            "0 0 1 2 | 0:0 0:1 1:2",
            "0 0 -1 2 | 0:0 0:1 -1:2",
            "0 0 1 -2 | 0:0 0:-1 1:-2",
            "0 0 -1 -2 | 0:0 0:-1 -1:-2",
            "2 1 0 0 | 2:1 1:1 0:0",
            // the eight octants
            "1 1 6 3 | 1:1 2:1 3:2 4:2 5:3 6:3",
            "1 1 3 6 | 1:1 1:2 2:3 2:4 3:5 3:6",
            "1 1 -1 6 | 1:1 1:2 0:3 0:4 -1:5 -1:6",
            "1 1 -4 3 | 1:1 0:1 -1:2 -2:2 -3:3 -4:3",
            "1 1 -4 -1 | 1:1 0:1 -1:0 -2:0 -3:-1 -4:-1",
            "1 1 -1 -4 | 1:1 1:0 0:-1 0:-2 -1:-3 -1:-4",
            "1 1 3 -4 | 1:1 1:0 2:-1 2:-2 3:-3 3:-4",
            "1 1 6 -1 | 1:1 2:1 3:0 4:0 5:-1 6:-1"})
    void exactCells(String ends, String cells) {
        assertEquals(cells, Probe.function("bresenham")
                .apply(ends.split(" ")));
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

    @Test
    void theLongestLine() {
        long far = 20_000_000_000L;
        int a = 1 << 20;
        List<Cell> cells = Ray.bresenham(far, -far, far - a, -far + 3);
        assertEquals(a + 1, cells.size());
        assertEquals(new Cell(far - a, -far + 3), cells.get(a));
        assertThrows(IllegalArgumentException.class,
                () -> Ray.bresenham(far, far, far + 3, far - a - 1));
        assertThrows(IllegalArgumentException.class,
                () -> Ray.bresenham(0, 0, a + 1, 0));
        assertThrows(ArithmeticException.class,
                () -> Ray.bresenham(Long.MIN_VALUE, 0, Long.MAX_VALUE, 0));
    }
}
