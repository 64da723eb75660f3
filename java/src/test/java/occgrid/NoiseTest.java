package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NoiseTest {
    @ParameterizedTest
    @CsvSource({
            "00000000 00000000 00000000 00000000 00000000 00000000,"
                    + "6627e8d5 e169c58d bc57ac4c 9b00dbd8",
            "ffffffff ffffffff ffffffff ffffffff ffffffff ffffffff,"
                    + "408f276d 41c83b0e a20bc7c6 6d5451fd",
            "243f6a88 85a308d3 13198a2e 03707344 a4093822 299f31d0,"
                    + "d16cfe09 94fdcceb 5001e420 24126ea1"})
    void knownAnswers(String words, String answer) {
        assertEquals(answer, Probe.function("philox").apply(words.split(" ")));
    }

    @Test
    void aDeviateIsBoxAndMuller() {
        // the first known answer's first two words
        double u1 = (0x6627e8d5L + 0.5) / 4294967296.0;
        double u2 = (0xe169c58dL + 0.5) / 4294967296.0;
        double expected = StrictMath.sqrt(-2.0 * StrictMath.log(u1))
                * StrictMath.cos(2.0 * StrictMath.PI * u2);
        assertEquals(expected, Noise.normalDeviate(0, 0, 0));
    }

    @Test
    void seedScanAndBeamAllCount() {
        double first = Noise.normalDeviate(0, 0, 0);
        assertNotEquals(first, Noise.normalDeviate(4294967295L, 0, 0));
        assertNotEquals(first, Noise.normalDeviate(0, 1, 0));
        assertNotEquals(first, Noise.normalDeviate(0, 0, 1));
    }

    @Test
    void deviatesAreStandard() {
        double[] n = IntStream.range(0, 20000)
                .mapToDouble(i -> Noise.normalDeviate(1, i / 200, i % 200))
                .toArray();
        double mean = IntStream.range(0, n.length).mapToDouble(i -> n[i])
                .average().getAsDouble();
        double variance = IntStream.range(0, n.length)
                .mapToDouble(i -> n[i] * n[i]).average().getAsDouble();
        assertEquals(0.0, mean, 0.03);
        assertEquals(1.0, variance, 0.05);
    }

    @Test
    void noiseStaysWithinTheRange() {
        double[] ranges = {0.0, 0.0, 5.0, 10.0, 10.0};
        double[] noisy = Noise.addRangeNoise(ranges, 100.0, 0, 0, 10.0);
        for (int beam = 0; beam < ranges.length; beam++) {
            double range = ranges[beam]
                    + 100.0 * Noise.normalDeviate(0, 0, beam);
            double clamped = range < 0.0 ? 0.0 : range > 10.0 ? 10.0 : range;
            assertEquals(clamped, noisy[beam]);
        }
        assertArrayEquals(new double[]{0.0, 0.0, 5.0, 10.0, 10.0}, ranges);
        assertArrayEquals(ranges,
                Noise.addRangeNoise(ranges, 0.0, 0, 0, 10.0));
    }
}
