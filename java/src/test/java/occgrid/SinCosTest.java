package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class SinCosTest {
    private static void assertSinCosIsStrictMath(double x) {
        SinCos both = SinCos.of(x);
        assertEquals(Double.doubleToLongBits(StrictMath.sin(x)),
                Double.doubleToLongBits(both.sin()), () -> "sin " + x);
        assertEquals(Double.doubleToLongBits(StrictMath.cos(x)),
                Double.doubleToLongBits(both.cos()), () -> "cos " + x);
    }

    @Test
    void sinCosIsStrictMath() {
        Random random = new Random(6);
        for (int i = 0; i < 200_000; i++) {
            assertSinCosIsStrictMath(random.nextDouble(-20.0, 20.0));
            assertSinCosIsStrictMath(random.nextDouble(-1e6, 1e6));
            assertSinCosIsStrictMath(
                    Double.longBitsToDouble(random.nextLong()));
        }
        for (double x : new double[]{0.0, -0.0, 0x1p-27, 0x1p19, 823549.6,
                Double.MIN_VALUE, Double.MAX_VALUE, Double.NaN,
                Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            assertSinCosIsStrictMath(x);
            assertSinCosIsStrictMath(Math.nextDown(x));
        }
    }

    /** Where the reduction cancels, and where the formulas change. */
    @Test
    void sinCosIsStrictMathNearMultiplesOfAnEighthOfATurn() {
        for (int n = -400; n <= 400; n++) {
            double x = n * (StrictMath.PI / 4.0);
            for (int digits = 0; digits <= 53; digits++) {
                double off = x * StrictMath.scalb(1.0, -digits);
                assertSinCosIsStrictMath(x + off);
                assertSinCosIsStrictMath(x - off);
            }
        }
    }
}
