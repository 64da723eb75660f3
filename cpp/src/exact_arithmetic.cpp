#include "occgrid/exact_arithmetic.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "occgrid/portable_math.hpp"

namespace occgrid {
namespace {

using detail::bits_of;

/// The same number, of which the compiler knows nothing.
double hidden(double x) {
  volatile double at_run_time = x;
  return at_run_time;
}

bool same(double x, std::uint64_t bits) {
  return bits_of(x) == bits;
}

/// Sums stay in their order: a compiler that reassociates finds that a - a
/// leaves b.
bool keeps_order() {
  const double a = hidden(1.0), b = hidden(0x1p-60), c = hidden(3.0);
  return same((a + b) - a, bits_of(0.0)) && same((b + a) - a, bits_of(0.0)) &&
         same(a - (a - b), bits_of(0.0)) &&
         same((b + a) + (b - a), bits_of(0.0)) &&
         // 3 * (1/3 as a double) is 1, and 3 * 0.1 is not 0.3
         same(c * (a / c), bits_of(1.0)) &&
         same((c * hidden(0.1)) / c, bits_of(0.10000000000000002)) &&
         same(hidden(0.1) * c - hidden(0.3), bits_of(0x1p-54));
}

/// A quotient is not a product with the reciprocal, not even where several
/// have one divisor: 5 * (1/49) and 5/49 differ.
bool divides() {
  const double d = hidden(49.0);
  const double q[6] = {hidden(1.0) / d, hidden(3.0) / d,  hidden(5.0) / d,
                       hidden(9.0) / d, hidden(11.0) / d, hidden(49.0) / d};
  return same(q[0], 0x3f94e5e0a72f0539) && same(q[1], 0x3faf58d0fac687d6) &&
         same(q[2], 0x3fba1f58d0fac688) && same(q[3], 0x3fc7829cbc14e5e1) &&
         same(q[4], 0x3fccbc14e5e0a72f) && same(q[5], bits_of(1.0)) &&
         same((hidden(0.7) - hidden(0.0)) / hidden(0.1), 0x401bffffffffffff) &&
         same(hidden(5.0) / 49.0, 0x3fba1f58d0fac688);
}

/// A product is rounded before it is added: fused, 2^-60 would be left.
bool rounds_products() {
  const double a = hidden(1.0 + 0x1p-30), b = hidden(1.0 + 0x1p-29);
  return same(a * a - b, bits_of(0.0)) && same(b - a * a, bits_of(0.0)) &&
         same(-b + a * a, bits_of(0.0));
}

/// No extended precision, which would round twice; and to nearest, ties to
/// even.
bool rounds_once() {
  const double one = hidden(1.0);
  const double above_half = hidden(0x1p-53) + hidden(0x1p-65);
  return same(one + above_half, bits_of(1.0 + 0x1p-52)) &&
         same(one + hidden(0x1p-53), bits_of(1.0)) &&
         same(-one - hidden(0x1.8p-53), bits_of(-1.0 - 0x1p-52)) &&
         std::isinf(hidden(1e308) * hidden(10.0) / hidden(10.0)) &&
         same(std::sqrt(hidden(2.0)), 0x3ff6a09e667f3bcd) &&
         same(hidden(0.1) + hidden(0.2), 0x3fd3333333333334);
}

/// Subnormals, signed zeros and NaN are what they are.
bool keeps_special_values() {
  const double least = hidden(0x1p-1022);
  const double zero = hidden(0.0), minus_zero = hidden(-0.0);
  const double nan = hidden(std::numeric_limits<double>::quiet_NaN());
  // as integers: a compiler that knows no NaN may drop the comparison
  volatile int equal = nan == nan, below = nan < zero, same_sum = zero == zero;
  return same(least * hidden(0.5), 0x0008000000000000) &&
         same(hidden(0x1p-1074) + zero, 1) &&
         same(minus_zero + zero, bits_of(0.0)) &&
         same(zero - zero, bits_of(0.0)) &&
         same(zero * hidden(-1.0), bits_of(-0.0)) && equal == 0 &&
         below == 0 && same_sum == 1;
}

/// The functions that everything is computed with, in each of their branches.
bool computes_the_functions() {
  return same(sin(hidden(0.5)), 0x3fdeaee8744b05f0) &&
         same(sin(hidden(-2.356194490192345)), 0xbfe6a09e667f3bcd) &&
         same(sin(hidden(100.0)), 0xbfe03425b78c4db8) &&
         same(sin(hidden(-1e22)), 0x3feb453ab76bf397) &&
         same(cos(hidden(0.2999)), 0x3fee925bcb3d5284) &&
         same(cos(hidden(0.5)), 0x3fec1528065b7d50) &&
         same(cos(hidden(1.5707963267948966)), 0x3c91a62633145c07) &&
         same(cos(hidden(1000000.0)), 0x3fedf9df9906d32c) &&
         same(exp(hidden(1.0)), 0x4005bf0a8b14576a) &&
         same(exp(hidden(-8.0)), 0x3f35fc21041027ad) &&
         same(exp(hidden(0.25)), 0x3ff48b5e3c3e8186) &&
         same(exp(hidden(-708.5)), 0x000e6cf6d08897ac) &&
         same(log(hidden(0.75)), 0xbfd269621134db92) &&
         same(log(hidden(10.0)), 0x40026bb1bbb55516) &&
         same(log(hidden(1.4142135623730951)), 0x3fd62e42fefa39f0);
}

}  // namespace

void require_exact_arithmetic() {
  static const bool exact = keeps_order() && divides() && rounds_products() &&
                            rounds_once() && keeps_special_values() &&
                            computes_the_functions();
  if (!exact) {
    throw std::runtime_error(
        "occgrid was compiled with flags that change the map's bits: build it "
        "without -ffast-math, -funsafe-math-optimizations, -Ofast and their "
        "like, with -ffp-contract=off, on 32-bit x86 with -msse2 "
        "-mfpmath=sse");
  }
}

}  // namespace occgrid
