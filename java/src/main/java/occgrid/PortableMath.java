package occgrid;

/**
 * sin, cos, exp and log with the same bits on every machine (SPEC.md section
 * 9).
 *
 * <p>
 * The contract's functions are the algorithms of fdlibm 5.3, which is exactly
 * what {@link StrictMath} is specified to be; so this port may call it where
 * the others carry the algorithm in their own code. {@code Math} may not be
 * used: its functions are replaced by the processor's own versions, which
 * differ in last bits. All four accept every double.
 */
public final class PortableMath {
    /** The double nearest to pi; the only one in this port. */
    public static final double PI = 3.141592653589793;

    private PortableMath() {
    }

    // [snippet: portable-sin]
    // fdlibm's sin and cos: StrictMath is specified to return their bits.
    /**
     * The sine.
     *
     * @param x an angle in radians, any double
     * @return sin(x); NaN for infinities and NaN
     */
    public static double sin(double x) {
        return StrictMath.sin(x);
    }

    /**
     * The cosine.
     *
     * @param x an angle in radians, any double
     * @return cos(x); NaN for infinities and NaN
     */
    public static double cos(double x) {
        return StrictMath.cos(x);
    }
    // [/snippet]

    // [snippet: portable-exp]
    // fdlibm's exp: StrictMath is specified to return its bits.
    /**
     * The exponential function.
     *
     * @param x any double
     * @return e to the power of x
     */
    public static double exp(double x) {
        return StrictMath.exp(x);
    }
    // [/snippet]

    // [snippet: portable-log]
    // fdlibm's log: StrictMath is specified to return its bits.
    /**
     * The natural logarithm.
     *
     * @param x any double
     * @return log(x); minus infinity for zeros, NaN below zero
     */
    public static double log(double x) {
        return StrictMath.log(x);
    }
    // [/snippet]
}
