package occgrid;

/**
 * Range noise that depends on nothing but the seed, the scan and the beam
 * (SPEC.md section 3.3; lesson section 6.3).
 */
public final class Noise {
    private Noise() {
    }

    // [snippet: philox]
    private static final long PHILOX_M0 = 0xD2511F53L;
    private static final long PHILOX_M1 = 0xCD9E8D57L;
    private static final int PHILOX_W0 = 0x9E3779B9;
    private static final int PHILOX_W1 = 0xBB67AE85;

    /**
     * Philox4x32-10 (Salmon et al. 2011): four random words per counter.
     * Java has no unsigned words; an int holds the same 32 bits.
     *
     * @param counter four words
     * @param key two words
     * @return four words
     */
    public static int[] philox4x32(int[] counter, int[] key) {
        int c0 = counter[0];
        int c1 = counter[1];
        int c2 = counter[2];
        int c3 = counter[3];
        int k0 = key[0];
        int k1 = key[1];
        for (int round = 0; round < 10; round++) {
            long product0 = PHILOX_M0 * Integer.toUnsignedLong(c0);
            long product1 = PHILOX_M1 * Integer.toUnsignedLong(c2);
            c0 = (int) (product1 >>> 32) ^ c1 ^ k0;
            c1 = (int) product1;
            c2 = (int) (product0 >>> 32) ^ c3 ^ k1;
            c3 = (int) product0;
            k0 += PHILOX_W0;
            k1 += PHILOX_W1;
        }
        return new int[]{c0, c1, c2, c3};
    }
    // [/snippet]

    // [snippet: normal-deviate]
    /**
     * A standard normal deviate (Box and Muller 1958).
     *
     * @param seed from 0 to 2^32 - 1
     * @param scan the scan's number, from 0
     * @param beam the beam's number in its scan, from 0
     * @return the deviate of this beam
     */
    public static double normalDeviate(long seed, int scan, int beam) {
        int[] counter = {scan, beam, 0, 0};
        int[] words = philox4x32(counter, new int[]{(int) seed, 0});
        double w0 = Integer.toUnsignedLong(words[0]);
        double w1 = Integer.toUnsignedLong(words[1]);
        double u1 = (w0 + 0.5) / 4294967296.0;
        double u2 = (w1 + 0.5) / 4294967296.0;
        double radius = Math.sqrt(-2.0 * PortableMath.log(u1));
        return radius * PortableMath.cos(2.0 * PortableMath.PI * u2);
    }
    // [/snippet]

    // [snippet: range-noise]
    /**
     * The ranges of a simulated scan with noise, kept within [0, zMax]. A
     * beam that met no wall gets noise too, as in the lesson.
     *
     * @param ranges (n) metres
     * @param noiseStd standard deviation, metres
     * @param seed from 0 to 2^32 - 1
     * @param scan the scan's number, from 0
     * @param zMax the sensor's maximum range, metres
     * @return (n) metres
     */
    public static double[] addRangeNoise(double[] ranges, double noiseStd,
            long seed, int scan, double zMax) {
        double[] noisy = new double[ranges.length];
        for (int beam = 0; beam < ranges.length; beam++) {
            double deviate = normalDeviate(seed, scan, beam);
            double range = ranges[beam] + noiseStd * deviate;
            noisy[beam] = range < 0.0 ? 0.0 : range > zMax ? zMax : range;
        }
        return noisy;
    }
    // [/snippet]
}
