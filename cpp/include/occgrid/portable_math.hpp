// sin, cos, exp and log with the same bits on every machine and in every
// language.
//
// The algorithms are those of fdlibm 5.3 (Sun Microsystems, 1993-1995), which
// Java's StrictMath is specified to be; SPEC.md section 9 writes them down.
// std::sin and its like differ from platform to platform in the last bit, and
// Eigen's array functions are polynomials of their own.
//
// Everything but the reduction of huge arguments stands in this header, so
// that it can be inlined. It is static: a program that includes it keeps the
// copies that its own flags make to itself, and the library its own.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__FAST_MATH__)
#error "the map's bits need IEEE arithmetic: build without -ffast-math"
#endif

namespace occgrid {

static_assert(std::numeric_limits<double>::is_iec559,
              "double must be IEEE-754 binary64");
static_assert(FLT_EVAL_METHOD == 0,
              "no extended precision (on 32-bit x86: -msse2 -mfpmath=sse)");

/// The double nearest to pi.
constexpr double pi = 3.141592653589793;

namespace detail {

static inline std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

static inline double double_of(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Upper 32 bits of x, as a signed number.
static inline std::int32_t high_word(double x) {
  return static_cast<std::int32_t>(bits_of(x) >> 32);
}

/// Upper 32 bits of |x|: they order magnitudes.
static inline std::int32_t abs_high_word(double x) {
  return high_word(x) & 0x7fffffff;
}

/// x * 2^k for results that stay normal.
static inline double add_to_exponent(double x, std::int64_t k) {
  return double_of(bits_of(x) + (static_cast<std::uint64_t>(k) << 52));
}

// --- Reduction to [-pi/4, pi/4] ---

/// x = n * pi/2 + (y0 + y1) with |y0 + y1| <= pi/4; y1 is the tail of y0. Only
/// n mod 4 counts.
struct Reduced {
  int n;
  double y0, y1;
};

constexpr double inv_pio2 = 0x1.45f306dc9c883p-1;
// pi/2 in three parts of 33 bits, each with the tail that is left after it
constexpr double pio2_1 = 0x1.921fb544p+0, pio2_1t = 0x1.0b4611a626331p-34;
constexpr double pio2_2 = 0x1.0b4611a6p-34, pio2_2t = 0x1.3198a2e037073p-69;
constexpr double pio2_3 = 0x1.3198a2ep-69, pio2_3t = 0x1.b839a252049c1p-104;

/// Upper words of n * pi/2, n = 1 .. 32: near them the first subtraction
/// cancels, and more of pi/2 is needed.
constexpr std::int32_t npio2_high[32] = {
    0x3ff921fb, 0x400921fb, 0x4012d97c, 0x401921fb, 0x401f6a7a, 0x4022d97c,
    0x4025fdbb, 0x402921fb, 0x402c463a, 0x402f6a7a, 0x4031475c, 0x4032d97c,
    0x40346b9c, 0x4035fdbb, 0x40378fdb, 0x403921fb, 0x403ab41b, 0x403c463a,
    0x403dd85a, 0x403f6a7a, 0x40407e4c, 0x4041475c, 0x4042106c, 0x4042d97c,
    0x4043a28c, 0x40446b9c, 0x404534ac, 0x4045fdbb, 0x4046c6cb, 0x40478fdb,
    0x404858eb, 0x404921fb};

/// Reduction of any finite |x| above 2^20 * pi/2 (the method of Payne and
/// Hanek).
Reduced rem_pio2_huge(double x);

/// Reduction of |x| from pi/4 to 3pi/4: n is 1 or -1.
static inline Reduced rem_pio2_near(double x) {
  const double magnitude = std::fabs(x);
  double z = magnitude - pio2_1;
  double tail = pio2_1t;
  if (abs_high_word(x) == 0x3ff921fb) {  // within 2^-20 or so of pi/2
    z = z - pio2_2;
    tail = pio2_2t;
  }
  const double y0 = z - tail;
  const double y1 = (z - y0) - tail;
  return x < 0.0 ? Reduced{-1, -y0, -y1} : Reduced{1, y0, y1};
}

/// Reduction of |x| up to 2^20 * pi/2, n being |x| / (pi/2) rounded to the
/// nearest.
static inline Reduced rem_pio2_medium(double x) {
  const std::int32_t ix = abs_high_word(x);
  const double magnitude = std::fabs(x);
  const int n = static_cast<int>(magnitude * inv_pio2 + 0.5);
  const double fn = n;
  double r = magnitude - fn * pio2_1;
  double w = fn * pio2_1t;
  double y0 = r - w;
  if (n >= 32 || ix == npio2_high[n - 1]) {
    // bits lost to cancellation: those of x's exponent above y0's
    const auto lost = [ix](double y) {
      return (ix >> 20) - (abs_high_word(y) >> 20);
    };
    if (lost(y0) > 16) {
      double t = r;
      w = fn * pio2_2;
      r = t - w;
      w = fn * pio2_2t - ((t - r) - w);
      y0 = r - w;
      if (lost(y0) > 49) {
        t = r;
        w = fn * pio2_3;
        r = t - w;
        w = fn * pio2_3t - ((t - r) - w);
        y0 = r - w;
      }
    }
  }
  const double y1 = (r - y0) - w;
  return x < 0.0 ? Reduced{-n, -y0, -y1} : Reduced{n, y0, y1};
}

/// True where rem_pio2 has nothing to do: |x| is at most about pi/4.
static inline bool is_reduced(double x) {
  return abs_high_word(x) <= 0x3fe921fb;
}

/// Reduction of any x that is not reduced yet; NaN for an infinity or NaN.
static inline Reduced rem_pio2(double x) {
  const std::int32_t ix = abs_high_word(x);
  if (ix < 0x4002d97c) return rem_pio2_near(x);
  if (ix <= 0x413921fb) return rem_pio2_medium(x);
  if (ix >= 0x7ff00000) return {0, x - x, x - x};
  return rem_pio2_huge(x);
}

constexpr double C1 = 0x1.555555555554cp-5, C2 = -0x1.6c16c16c15177p-10;
constexpr double C3 = 0x1.a01a019cb159p-16, C4 = -0x1.27e4f809c52adp-22;
constexpr double C5 = 0x1.1ee9ebdb4b1c4p-29, C6 = -0x1.8fae9be8838d4p-37;

/// cos(x + y) for |x| <= pi/4, where y is the tail of x.
static inline double kernel_cos(double x, double y) {
  const std::int32_t ix = abs_high_word(x);
  if (ix < 0x3e400000) return 1.0;  // |x| < 2^-27
  const double z = x * x;
  const double r =
      z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
  if (ix < 0x3fd33333) return 1.0 - (0.5 * z - (z * r - x * y));  // |x| < 0.3
  // qx is about x/4 with few bits, so that 1 - qx is exact
  const double qx =
      ix > 0x3fe90000
          ? 0.28125
          : double_of(static_cast<std::uint64_t>(ix - 0x00200000) << 32);
  const double hz = 0.5 * z - qx;
  const double a = 1.0 - qx;
  return a - (hz - (z * r - x * y));
}

// [snippet: portable-sin]
constexpr double S1 = -0x1.5555555555549p-3, S2 = 0x1.111111110f8a6p-7;
constexpr double S3 = -0x1.a01a019c161d5p-13, S4 = 0x1.71de357b1fe7dp-19;
constexpr double S5 = -0x1.ae5e68a2b9cebp-26, S6 = 0x1.5d93a5acfd57cp-33;

/// sin(x + y) for |x| <= pi/4, where y is the tail of x. reduced is false
/// where x is no remainder and y is 0: that has a formula of its own.
static inline double kernel_sin(double x, double y, bool reduced) {
  if (abs_high_word(x) < 0x3e400000) return x;  // |x| < 2^-27
  const double z = x * x;
  const double v = z * x;
  const double r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  if (!reduced) return x + v * (S1 + z * r);
  return x - ((z * (0.5 * y - v * r) - y) - v * S1);
}

}  // namespace detail

/// Sine of x (radians), any double; NaN where x is infinite or NaN.
static inline double sin(double x) {
  if (detail::is_reduced(x)) return detail::kernel_sin(x, 0.0, false);
  const auto [n, y0, y1] = detail::rem_pio2(x);
  switch (n & 3) {
    case 0:
      return detail::kernel_sin(y0, y1, true);
    case 1:
      return detail::kernel_cos(y0, y1);
    case 2:
      return -detail::kernel_sin(y0, y1, true);
    default:
      return -detail::kernel_cos(y0, y1);
  }
}
// [/snippet]

/// Cosine of x (radians), any double; NaN where x is infinite or NaN.
static inline double cos(double x) {
  if (detail::is_reduced(x)) return detail::kernel_cos(x, 0.0);
  const auto [n, y0, y1] = detail::rem_pio2(x);
  switch (n & 3) {
    case 0:
      return detail::kernel_cos(y0, y1);
    case 1:
      return -detail::kernel_sin(y0, y1, true);
    case 2:
      return -detail::kernel_cos(y0, y1);
    default:
      return detail::kernel_sin(y0, y1, true);
  }
}

/// Sine and cosine of one angle.
struct SinCos {
  double sin, cos;
};

/// {sin(x), cos(x)}, where x is reduced once for both.
static inline SinCos sin_cos(double x) {
  using namespace detail;
  if (is_reduced(x)) return {kernel_sin(x, 0.0, false), kernel_cos(x, 0.0)};
  const auto [n, y0, y1] = rem_pio2(x);
  const double s = kernel_sin(y0, y1, true);
  const double c = kernel_cos(y0, y1);
  switch (n & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

namespace detail {

// ln 2 in two parts
constexpr double ln2_hi = 0x1.62e42feep-1, ln2_lo = 0x1.a39ef35793c76p-33;
constexpr double inv_ln2 = 0x1.71547652b82fep+0;
// above the first, exp overflows; below the second, it is less than half of
// the least subnormal
constexpr double exp_max = 0x1.62e42fefa39efp+9,
                 exp_min = -0x1.74910d52d3051p+9;

constexpr double P1 = 0x1.555555555553ep-3, P2 = -0x1.6c16c16bebd93p-9;
constexpr double P3 = 0x1.1566aaf25de2cp-14, P4 = -0x1.bbd41c5d26bf1p-20;
constexpr double P5 = 0x1.6376972bea4dp-25;

}  // namespace detail

// [snippet: portable-exp]
/// e to the power of x, any double; 0 and infinity where it leaves the range.
static inline double exp(double x) {
  using namespace detail;
  if (std::isnan(x)) return x;
  if (x > exp_max) return std::numeric_limits<double>::infinity();
  if (x < exp_min) return 0.0;

  // x = k ln 2 + (hi - lo), the difference within half of ln 2
  const std::int32_t ix = abs_high_word(x);
  double hi = 0.0;
  double lo = 0.0;
  int k = 0;
  if (ix > 0x3fd62e42) {    // |x| > 0.5 ln 2
    if (ix < 0x3ff0a2b2) {  // |x| < 1.5 ln 2
      k = x < 0.0 ? -1 : 1;
    } else {
      k = static_cast<int>(inv_ln2 * x + (x < 0.0 ? -0.5 : 0.5));
    }
    hi = x - k * ln2_hi;
    lo = k * ln2_lo;
    x = hi - lo;
  } else if (ix < 0x3e300000) {  // |x| < 2^-28
    return 1.0 + x;
  }

  const double t = x * x;
  const double c = x - t * (P1 + t * (P2 + t * (P3 + t * (P4 + t * P5))));
  if (k == 0) return 1.0 - ((x * c) / (c - 2.0) - x);
  const double y = 1.0 - ((lo - (x * c) / (2.0 - c)) - hi);
  if (k >= -1021) return add_to_exponent(y, k);
  return add_to_exponent(y, k + 1000) * 0x1p-1000;  // subnormal: rounds once
}
// [/snippet]

namespace detail {

constexpr double Lg1 = 0x1.5555555555593p-1, Lg2 = 0x1.999999997fa04p-2;
constexpr double Lg3 = 0x1.2492494229359p-2, Lg4 = 0x1.c71c51d8e78afp-3;
constexpr double Lg5 = 0x1.7466496cb03dep-3, Lg6 = 0x1.39a09d078c69fp-3;
constexpr double Lg7 = 0x1.2f112df3e5244p-3;
constexpr double third = 0x1.5555555555555p-2;

}  // namespace detail

// [snippet: portable-log]
/// Natural logarithm of x, any double; -infinity at 0, NaN below it.
static inline double log(double x) {
  using namespace detail;
  if (x == 0.0) return -std::numeric_limits<double>::infinity();
  if (x < 0.0) return std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(x)) return x;

  // x = 2^k (1 + f) with sqrt(2)/2 < 1 + f < sqrt(2)
  int k = 0;
  if (x < 0x1p-1022) {  // subnormal
    x = x * 0x1p54;
    k = -54;
  }
  k += (high_word(x) >> 20) - 1023;
  const std::int32_t hx = high_word(x) & 0xfffff;
  const std::int32_t i = (hx + 0x95f64) & 0x100000;
  k += i >> 20;
  const auto high = static_cast<std::uint64_t>(hx | (i ^ 0x3ff00000));
  const double f = double_of(high << 32 | (bits_of(x) & 0xffffffff)) - 1.0;
  const double dk = k;

  if ((0xfffff & (2 + hx)) < 3) {  // |f| < 2^-20
    if (f == 0.0) return k == 0 ? 0.0 : dk * ln2_hi + dk * ln2_lo;
    const double R = f * f * (0.5 - third * f);
    if (k == 0) return f - R;
    return dk * ln2_hi - ((R - dk * ln2_lo) - f);
  }
  const double s = f / (2.0 + f);
  const double z = s * s;
  const double w = z * z;
  const double t1 = w * (Lg2 + w * (Lg4 + w * Lg6));
  const double t2 = z * (Lg1 + w * (Lg3 + w * (Lg5 + w * Lg7)));
  const double R = t2 + t1;
  if (hx >= 0x6147a && hx <= 0x6b851) {  // 1 + f near sqrt(2), or half of it
    const double hfsq = 0.5 * f * f;
    if (k == 0) return f - (hfsq - s * (hfsq + R));
    return dk * ln2_hi - ((hfsq - (s * (hfsq + R) + dk * ln2_lo)) - f);
  }
  if (k == 0) return f - s * (f - R);
  return dk * ln2_hi - ((s * (f - R) - dk * ln2_lo) - f);
}
// [/snippet]

}  // namespace occgrid
