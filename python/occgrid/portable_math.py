"""sin, cos, exp and log with the same bits on every machine and in every language.

The algorithms are those of fdlibm 5.3 (Sun Microsystems, 1993-1995), which Java's StrictMath is specified to be;
SPEC.md section 9 writes them down. NumPy's own functions may take vector instructions with other last bits.

All four functions take a float or an array of any shape, accept every double, and return an array of that shape.
``pi`` is the double nearest to the number.
"""

from __future__ import annotations

from math import ldexp

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Words = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]

pi = 3.141592653589793


def _doubles(bits: str) -> list[float]:
    """The doubles with these bits, 16 hexadecimal digits each."""
    return [
        float(np.uint64(int(word, 16)).view(np.float64))
        for word in bits.split()
    ]


def _high_word(x: Array) -> Words:
    """Upper 32 bits of each double, as a signed number."""
    return x.view(np.int64) >> 32


def _exponent(x: Array) -> Words:
    """Exponent field of each double."""
    return x.view(np.int64) >> 52 & 0x7FF


def _add_to_exponent(x: Array, k: Words) -> Array:
    """x * 2**k for results that stay normal."""
    return (x.view(np.int64) + (k << 52)).view(np.float64)


def _flat(x: npt.ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """A vector of doubles to work on, and the shape that the result takes."""
    array = np.asarray(x, dtype=np.float64)
    return np.ascontiguousarray(array).reshape(-1), array.shape


# --- Reduction to [-pi/4, pi/4] ---

(INV_PIO2,) = _doubles("3FE45F306DC9C883")
PIO2_1, PIO2_1T = _doubles("3FF921FB54400000 3DD0B4611A626331")
PIO2_2, PIO2_2T = _doubles("3DD0B4611A600000 3BA3198A2E037073")
PIO2_3, PIO2_3T = _doubles("3BA3198A2E000000 397B839A252049C1")
PIO2_SPLIT = _doubles(
    "3FF921FB40000000 3E74442D00000000 3CF8469880000000 3B78CC5160000000 39F01B8380000000"
)

# upper words of n*pi/2: near them the first subtraction cancels and more of pi/2 is needed
NPIO2_HIGH: Words = _high_word(np.arange(33.0) * 1.5707963267948966)

TWO_OVER_PI_DIGITS = [
    int(digit, 16)
    for digit in """
    A2F983 6E4E44 1529FC 2757D1 F534DD C0DB62 95993C 439041 FE5163 ABDEBB C561B7
    246E3A 424DD2 E00649 2EEA09 D1921C FE1DEB 1CB129 A73EE8 8235F5 2EBB44 84E99C
    7026B4 5F7E41 3991D6 398353 39F49C 845F8B BDF928 3B1FF8 97FFDE 05980F EF2F11
    8B5A0A 6D1F6D 367ECF 27CB09 B74F46 3F669E 5FEA2D 7527BA C7EBE5 F17B3D 0739F7
    8A5292 EA6BFB 5FB11F 8D5D08 560330 46FC7B 6BABF0 CFBC20 9AF436 1DA9E3 91615E
    E61B08 659985 5F14A0 68408D FFD880 4D7327 310606 1556CA 73A8C9 60E27B C08C6B
    """.split()
]


def _is_reduced(x: Array) -> Mask:
    """Where x is larger than pi/4, so that the kernels work on what a reduction left."""
    return (_high_word(x) & 0x7FFFFFFF) > 0x3FE921FB


def _reduce_huge(x: float) -> tuple[int, float, float]:
    """n, y0, y1 with x = n*pi/2 + y0 + y1, for |x| above 2^20*pi/2 (Payne and Hanek's method)."""
    bits = int(np.float64(abs(x)).view(np.uint64))
    e0 = (bits >> 52) - 1046
    mantissa = bits & ((1 << 52) - 1) | 1 << 52
    tx = [mantissa >> 29, mantissa >> 5 & 0xFFFFFF, (mantissa & 31) << 19]
    while tx[-1] == 0:
        tx.pop()
    jk = 4
    jv = max(0, (e0 - 3) // 24)
    q0 = e0 - 24 * (jv + 1)

    def column(i: int) -> int:
        """Column i of x times the digits of 2/pi: below 2^53, so integers and doubles agree."""
        return sum(
            t * TWO_OVER_PI_DIGITS[jv + i - j]
            for j, t in enumerate(tx)
            if jv + i >= j
        )

    q = [column(i) for i in range(jk + 1)]
    while True:
        jz = len(q) - 1
        digits = [0] * (jz + 1)  # the least first
        z = q[jz]
        for i in range(jz):
            digits[i] = z & 0xFFFFFF
            z = q[jz - 1 - i] + (z >> 24)
        fraction = ldexp(z, q0)
        fraction -= 8.0 * (fraction * 0.125 // 1.0)
        n = int(fraction)
        fraction -= n
        ih = 0
        if q0 > 0:
            top = digits[jz - 1] >> (24 - q0)
            n += top
            digits[jz - 1] -= top << (24 - q0)
            ih = digits[jz - 1] >> (23 - q0)
        elif q0 == 0:
            ih = digits[jz - 1] >> 23
        elif fraction >= 0.5:
            ih = 2
        if (
            ih > 0
        ):  # more than half a quadrant: take the next one and what is missing to it
            n += 1
            value = -sum(d << (24 * i) for i, d in enumerate(digits[:jz]))
            digits[:jz] = [value >> (24 * i) & 0xFFFFFF for i in range(jz)]
            if q0 > 0:
                digits[jz - 1] &= 0xFFFFFF >> q0
            if ih == 2:
                fraction = 1.0 - fraction
                if value != 0:
                    fraction -= ldexp(1.0, q0)
        if fraction != 0.0 or any(digits[jk:jz]):
            break
        # all that is left are zeros: bring in more digits of 2/pi
        k = 1
        while digits[jk - k] == 0:
            k += 1
        q += [column(i) for i in range(jz + 1, jz + k + 1)]
    if fraction == 0.0:
        jz, q0 = jz - 1, q0 - 24
        while digits[jz] == 0:
            jz, q0 = jz - 1, q0 - 24
    else:
        z = int(ldexp(fraction, -q0))
        digits[jz] = z & 0xFFFFFF
        if z >> 24:
            jz, q0 = jz + 1, q0 + 24
            digits.append(z >> 24)
    scaled = [ldexp(digits[i], q0 - 24 * (jz - i)) for i in range(jz + 1)]
    fq = [0.0] * (jz + 1)
    for i in range(jz, -1, -1):
        for k in range(min(jk, jz - i) + 1):
            fq[jz - i] += PIO2_SPLIT[k] * scaled[i + k]
    y0 = 0.0
    for i in range(jz, -1, -1):
        y0 += fq[i]
    y1 = fq[0] - y0
    for i in range(1, jz + 1):
        y1 += fq[i]
    if ih != 0:
        y0, y1 = -y0, -y1
    return (n, y0, y1) if x > 0 else (-n, -y0, -y1)


def _rem_pio2(x: Array) -> tuple[Words, Array, Array]:
    """n, y0, y1 with x = n*pi/2 + y0 + y1 and |y0 + y1| <= pi/4; n = 0 and y0 = x where x is so small itself."""
    high = _high_word(x) & 0x7FFFFFFF
    magnitude = np.abs(x)
    small = ~_is_reduced(x)
    huge = (high > 0x413921FB) & (high < 0x7FF00000)
    below_3pi4 = high < 0x4002D97C
    n = np.where(below_3pi4, 1.0, np.floor(magnitude * INV_PIO2 + 0.5))
    n[small | (high > 0x413921FB)] = 0.0
    whole = n.astype(np.int64)

    r = magnitude - n * PIO2_1
    w = n * PIO2_1T
    y0 = r - w
    # close to a multiple of pi/2 the subtraction cancels: go on with the second part of pi/2, and the third
    close = (whole >= 32) | (NPIO2_HIGH[np.minimum(whole, 32)] == high)
    cancelled = below_3pi4 | ((high >> 20) - _exponent(y0) > 16)
    second = np.flatnonzero(close & cancelled & ~small)
    if second.size:
        r[second], w[second], y0[second] = _subtract_part(
            r[second], n[second], PIO2_2, PIO2_2T
        )
        deep = ~below_3pi4[second] & (
            (high[second] >> 20) - _exponent(y0[second]) > 49
        )
        third = second[deep]
        r[third], w[third], y0[third] = _subtract_part(
            r[third], n[third], PIO2_3, PIO2_3T
        )
    y1 = (r - y0) - w

    negative = x < 0.0
    whole = np.where(negative, -whole, whole)
    y0 = np.where(small, x, np.where(negative, -y0, y0))
    y1 = np.where(small, 0.0, np.where(negative, -y1, y1))
    for i in np.flatnonzero(huge):
        whole[i], y0[i], y1[i] = _reduce_huge(float(x[i]))
    return whole, y0, y1


def _subtract_part(
    r: Array, n: Array, part: float, tail: float
) -> tuple[Array, Array, Array]:
    """r less n parts of pi/2: what is left, the tail still to subtract, and their difference."""
    w = n * part
    rest = r - w
    w = n * tail - ((r - rest) - w)
    return rest, w, rest - w


# --- sin and cos ---


# [snippet: portable-sin]
S1, S2, S3, S4, S5, S6 = _doubles("""
    BFC5555555555549 3F8111111110F8A6 BF2A01A019C161D5
    3EC71DE357B1FE7D BE5AE5E68A2B9CEB 3DE5D93A5ACFD57C
""")
C1, C2, C3, C4, C5, C6 = _doubles("""
    3FA555555555554C BF56C16C16C15177 3EFA01A019CB1590
    BE927E4F809C52AD 3E21EE9EBDB4B1C4 BDA8FAE9BE8838D4
""")


def _kernel_sin(x: Array, y: Array, reduced: Mask) -> Array:
    """sin(x + y) for |x| <= pi/4; y is the tail of a reduced x."""
    z = x * x
    v = z * x
    r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))
    result = np.where(
        reduced,
        x - ((z * (0.5 * y - v * r) - y) - v * S1),
        x + v * (S1 + z * r),
    )
    return np.where(np.abs(x) < 2.0**-27, x, result)


def _kernel_cos(x: Array, y: Array) -> Array:
    """cos(x + y) for |x| <= pi/4; y is the tail of x."""
    high = _high_word(x) & 0x7FFFFFFF
    z = x * x
    r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))))
    # about x/4, so that 1 - qx is exact and little is lost in hz
    qx = ((high - 0x00200000) << 32).view(np.float64)
    qx = np.where(high > 0x3FE90000, 0.28125, qx)
    qx = np.where(high < 0x3FD33333, 0.0, qx)
    hz = 0.5 * z - qx
    result = (1.0 - qx) - (hz - (z * r - x * y))
    return np.where(np.abs(x) < 2.0**-27, 1.0, result)


def sin(x: npt.ArrayLike) -> Array:
    """Sine of x (radians); NaN where x is infinite or NaN."""
    x, shape = _flat(x)
    with np.errstate(all="ignore"):
        n, y0, y1 = _rem_pio2(x)
        s = _kernel_sin(y0, y1, _is_reduced(x))
        c = _kernel_cos(y0, y1)
    result = np.choose(n & 3, [s, c, -s, -c])
    result[~np.isfinite(x)] = np.nan
    return result.reshape(shape)


def cos(x: npt.ArrayLike) -> Array:
    """Cosine of x (radians); NaN where x is infinite or NaN."""
    x, shape = _flat(x)
    with np.errstate(all="ignore"):
        n, y0, y1 = _rem_pio2(x)
        s = _kernel_sin(y0, y1, _is_reduced(x))
        c = _kernel_cos(y0, y1)
    result = np.choose(n & 3, [c, -s, -c, s])
    result[~np.isfinite(x)] = np.nan
    return result.reshape(shape)


# [/snippet]


# --- exp and log ---

LN2_HI, LN2_LO, INV_LN2 = _doubles(
    "3FE62E42FEE00000 3DEA39EF35793C76 3FF71547652B82FE"
)


# [snippet: portable-exp]
P1, P2, P3, P4, P5 = _doubles("""
    3FC555555555553E BF66C16C16BEBD93 3F11566AAF25DE2C
    BEBBBD41C5D26BF1 3E66376972BEA4D0
""")
EXP_OVERFLOW, EXP_UNDERFLOW = _doubles("40862E42FEFA39EF C0874910D52D3051")


def exp(x: npt.ArrayLike) -> Array:
    """e to the power x; infinity above 709.78, 0 below -745.13."""
    x, shape = _flat(x)
    with np.errstate(all="ignore"):
        inside = (x <= EXP_OVERFLOW) & (x >= EXP_UNDERFLOW)
        arg = np.where(inside, x, 0.0)
        high = _high_word(arg) & 0x7FFFFFFF
        sign = np.where(arg < 0.0, -1.0, 1.0)
        # arg = k ln 2 + (hi - lo)
        k = np.trunc(INV_LN2 * arg + 0.5 * sign)
        k = np.where(high < 0x3FF0A2B2, sign, k)
        k = np.where(high <= 0x3FD62E42, 0.0, k)
        hi = arg - k * LN2_HI
        lo = k * LN2_LO
        r = hi - lo
        t = r * r
        c = r - t * (P1 + t * (P2 + t * (P3 + t * (P4 + t * P5))))
        near = 1.0 - ((r * c) / (c - 2.0) - r)
        y = 1.0 - ((lo - (r * c) / (2.0 - c)) - hi)
        power = k.astype(np.int64)
        deep = power < -1021  # the result may be subnormal
        y = _add_to_exponent(y, np.where(deep, power + 1000, power))
        y = np.where(deep, y * 2.0**-1000, y)
        result = np.where(power == 0, near, y)
        result = np.where(high < 0x3E300000, 1.0 + arg, result)
    result[x > EXP_OVERFLOW] = np.inf
    result[x < EXP_UNDERFLOW] = 0.0
    result[np.isnan(x)] = np.nan
    return result.reshape(shape)


# [/snippet]


# [snippet: portable-log]
LG1, LG2, LG3, LG4, LG5, LG6, LG7 = _doubles("""
    3FE5555555555593 3FD999999997FA04 3FD2492494229359
    3FCC71C51D8E78AF 3FC7466496CB03DE 3FC39A09D078C69F
    3FC2F112DF3E5244
""")
THIRD = 0.33333333333333333


def log(x: npt.ArrayLike) -> Array:
    """Natural logarithm; -infinity at 0, NaN below it."""
    x, shape = _flat(x)
    with np.errstate(all="ignore"):
        inside = (x > 0.0) & (x < np.inf)
        arg = np.where(inside, x, 1.0)
        tiny = arg < 2.0**-1022
        arg = np.where(tiny, arg * 2.0**54, arg)
        # arg = 2**k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2)
        high = _high_word(arg)
        k = (high >> 20) - 1023 - np.where(tiny, 54, 0)
        high = high & 0xFFFFF
        i = (high + 0x95F64) & 0x100000
        low = arg.view(np.int64) & 0xFFFFFFFF
        words = ((high | (i ^ 0x3FF00000)) << 32) | low
        k = k + (i >> 20)
        f = words.view(np.float64) - 1.0
        dk = k.astype(np.float64)
        hi, lo = dk * LN2_HI, dk * LN2_LO

        s = f / (2.0 + f)
        z = s * s
        w = z * z
        t1 = w * (LG2 + w * (LG4 + w * LG6))
        t2 = z * (LG1 + w * (LG3 + w * (LG5 + w * LG7)))
        r = t2 + t1
        half = 0.5 * f * f
        middle = (0x6147A <= high) & (high <= 0x6B851)
        result = np.where(
            middle,
            np.where(
                k == 0,
                f - (half - s * (half + r)),
                hi - ((half - (s * (half + r) + lo)) - f),
            ),
            np.where(
                k == 0,
                f - s * (f - r),
                hi - ((s * (f - r) - lo) - f),
            ),
        )
        small = (0xFFFFF & (2 + high)) < 3  # |f| < 2**-20
        r = f * f * (0.5 - THIRD * f)
        close = np.where(k == 0, f - r, hi - ((r - lo) - f))
        close = np.where(f == 0.0, hi + lo, close)
        result = np.where(small, close, result)
    result[x == 0.0] = -np.inf
    result[x == np.inf] = np.inf
    result[(x < 0.0) | np.isnan(x)] = np.nan
    return result.reshape(shape)


# [/snippet]
