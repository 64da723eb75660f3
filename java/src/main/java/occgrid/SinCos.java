package occgrid;

/**
 * Sine and cosine of one angle, the bits of {@link PortableMath} sooner.
 *
 * <p>
 * Before Java 21 every call of StrictMath's sine leaves the virtual machine,
 * which costs more than the sine. So what beams need is written out here:
 * fdlibm's reduction, done once for both, and its polynomials (SPEC.md
 * sections 9.1 and 9.2). For example 2 = 1 * pi/2 + 0.43, so n = 1, sin(2) =
 * cos(0.43) and cos(2) = -sin(0.43). The rest is left to PortableMath: angles
 * that are huge, tiny or so close to a multiple of pi/2 that more of its bits
 * are needed. It buys a sixth of the time that mapping takes.
 *
 * @param sin the sine
 * @param cos the cosine
 */
record SinCos(double sin, double cos) {
    private static final double INV_PIO2 = 0x1.45f306dc9c883p-1;
    // pi/2: its first 33 bits, and what is left
    private static final double PIO2_1 = 0x1.921fb544p+0;
    private static final double PIO2_1T = 0x1.0b4611a626331p-34;

    private static final double S1 = -0x1.5555555555549p-3;
    private static final double S2 = 0x1.111111110f8a6p-7;
    private static final double S3 = -0x1.a01a019c161d5p-13;
    private static final double S4 = 0x1.71de357b1fe7dp-19;
    private static final double S5 = -0x1.ae5e68a2b9cebp-26;
    private static final double S6 = 0x1.5d93a5acfd57cp-33;
    private static final double C1 = 0x1.555555555554cp-5;
    private static final double C2 = -0x1.6c16c16c15177p-10;
    private static final double C3 = 0x1.a01a019cb159p-16;
    private static final double C4 = -0x1.27e4f809c52adp-22;
    private static final double C5 = 0x1.1ee9ebdb4b1c4p-29;
    private static final double C6 = -0x1.8fae9be8838d4p-37;

    /**
     * Sine and cosine.
     *
     * @param x an angle in radians, any double
     * @return both; NaN for infinities and NaN
     */
    static SinCos of(double x) {
        double magnitude = Math.abs(x);
        boolean reduced = highWord(magnitude) > 0x3fe921fb; // about pi/4
        int n = reduced ? (int) (magnitude * INV_PIO2 + 0.5) : 0;
        double r = magnitude - n * PIO2_1;
        double w = n * PIO2_1T;
        double y0 = r - w;
        double y1 = (r - y0) - w;
        boolean here = magnitude < 0x1p+19 && magnitude >= 0x1p-27
                && Math.abs(y0) >= magnitude * 0x1p-16;
        double sin;
        double cos;
        if (here) {
            double s = kernelSin(y0, y1, reduced);
            double c = kernelCos(y0, y1);
            boolean odd = (n & 1) != 0;
            double sine = odd ? c : s;
            sin = (n & 2) != 0 ? -sine : sine;
            sin = x < 0.0 ? -sin : sin;
            double cosine = odd ? s : c;
            cos = (n + 1 & 2) != 0 ? -cosine : cosine;
        } else {
            sin = PortableMath.sin(x);
            cos = PortableMath.cos(x);
        }
        return new SinCos(sin, cos);
    }

    /** Upper 32 bits of a double. */
    private static int highWord(double x) {
        return (int) (Double.doubleToRawLongBits(x) >> 32);
    }

    /** sin(x + y) for |x| up to pi/4; y is 0 where x is not reduced. */
    private static double kernelSin(double x, double y, boolean reduced) {
        double z = x * x;
        double v = z * x;
        double r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
        return reduced
                ? x - ((z * (0.5 * y - v * r) - y) - v * S1)
                : x + v * (S1 + z * r);
    }

    /** cos(x + y) for |x| up to pi/4. */
    private static double kernelCos(double x, double y) {
        double z = x * x;
        double r = z
                * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
        int high = highWord(x) & 0x7fffffff;
        if (high < 0x3fd33333) { // |x| < 0.3
            return 1.0 - (0.5 * z - (z * r - x * y));
        }
        // about x/4 with few bits, so that 1 - qx is exact
        double qx = high > 0x3fe90000
                ? 0.28125
                : Double.longBitsToDouble((high - 0x00200000L) << 32);
        double hz = 0.5 * z - qx;
        double a = 1.0 - qx;
        return a - (hz - (z * r - x * y));
    }
}
