package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import occgrid.Grid.OccupancyGrid;

/** Maps compared as bits: assertArrayEquals forgives the sign of zero. */
final class Bits {
    private Bits() {
    }

    static long[] of(OccupancyGrid grid) {
        return Arrays.stream(grid.logOdds())
                .mapToLong(Double::doubleToRawLongBits).toArray();
    }

    static void assertSame(OccupancyGrid expected, OccupancyGrid grid,
            String what) {
        long[] bits = of(expected);
        if (!Arrays.equals(bits, of(grid))) {
            assertArrayEquals(bits, of(grid), what);
        }
    }
}
