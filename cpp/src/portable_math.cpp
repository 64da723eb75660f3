#include "occgrid/portable_math.hpp"

#include <algorithm>

namespace occgrid::detail {
namespace {

/// 2/pi in digits of 24 bits.
constexpr std::int32_t two_over_pi[66] = {
    0xa2f983, 0x6e4e44, 0x1529fc, 0x2757d1, 0xf534dd, 0xc0db62, 0x95993c,
    0x439041, 0xfe5163, 0xabdebb, 0xc561b7, 0x246e3a, 0x424dd2, 0xe00649,
    0x2eea09, 0xd1921c, 0xfe1deb, 0x1cb129, 0xa73ee8, 0x8235f5, 0x2ebb44,
    0x84e99c, 0x7026b4, 0x5f7e41, 0x3991d6, 0x398353, 0x39f49c, 0x845f8b,
    0xbdf928, 0x3b1ff8, 0x97ffde, 0x05980f, 0xef2f11, 0x8b5a0a, 0x6d1f6d,
    0x367ecf, 0x27cb09, 0xb74f46, 0x3f669e, 0x5fea2d, 0x7527ba, 0xc7ebe5,
    0xf17b3d, 0x0739f7, 0x8a5292, 0xea6bfb, 0x5fb11f, 0x8d5d08, 0x560330,
    0x46fc7b, 0x6babf0, 0xcfbc20, 0x9af436, 0x1da9e3, 0x91615e, 0xe61b08,
    0x659985, 0x5f14a0, 0x68408d, 0xffd880, 0x4d7327, 0x310606, 0x1556ca,
    0x73a8c9, 0x60e27b, 0xc08c6b};

/// pi/2 in parts of 24 bits.
constexpr double pio2_split[5] = {0x1.921fb4p+0, 0x1.4442dp-24, 0x1.846988p-48,
                                  0x1.8cc516p-72, 0x1.01b838p-96};

constexpr int first_digits =
    4;  // of the quotient, beyond the first: enough unless they cancel
constexpr std::int32_t all_ones = 0xffffff;

double power_of_two(int k) {
  return double_of(static_cast<std::uint64_t>(1023 + k) << 52);
}

/// The quotient |x| / (pi/2) around its binary point, as columns of products
/// of 24-bit digits.
class Quotient {
 public:
  explicit Quotient(double magnitude) {
    const int e0 = (high_word(magnitude) >> 20) - 1046;
    double z = add_to_exponent(magnitude, -e0);  // 2^23 <= z < 2^24
    for (int i = 0; i < 2; ++i) {
      digits_[i] = std::trunc(z);
      z = (z - digits_[i]) * 0x1p24;
    }
    digits_[2] = z;
    while (digits_[last_digit_] == 0.0) --last_digit_;
    // digits of 2/pi before this one only make multiples of 8
    first_of_two_over_pi_ = std::max(0, (e0 - 3) / 24);
    exponent_ = e0 - 24 * (first_of_two_over_pi_ + 1);
  }

  /// Exponent of column 0.
  int exponent() const { return exponent_; }

  /// Column i, exact: a sum of at most three products of 24-bit digits.
  double column(int i) const {
    double sum = 0.0;
    for (int j = 0; j <= last_digit_; ++j) {
      const int k = first_of_two_over_pi_ + i - j;
      sum += digits_[j] * (k < 0 ? 0.0 : two_over_pi[k]);
    }
    return sum;
  }

 private:
  double digits_[3];
  int last_digit_ = 2;
  int first_of_two_over_pi_;
  int exponent_;
};

/// The digits become 2^24-complement, the least digit first. Returns whether
/// one was not zero.
bool complement(std::int32_t* digits, int count) {
  bool carry = false;
  for (int i = 0; i < count; ++i) {
    if (carry) {
      digits[i] = all_ones - digits[i];
    } else if (digits[i] != 0) {
      carry = true;
      digits[i] = all_ones + 1 - digits[i];
    }
  }
  return carry;
}

}  // namespace

Reduced rem_pio2_huge(double x) {
  const Quotient quotient(std::fabs(x));
  int q0 = quotient.exponent();
  double q[20] = {};            // columns, the greatest first
  std::int32_t digit[20] = {};  // digits of the fraction, the least first
  int last = first_digits;      // last column in use
  for (int i = 0; i <= last; ++i) q[i] = quotient.column(i);

  int n;
  int above_half;  // not 0 where the fraction is at least 1/2
  double z;        // the fraction's part above the digits
  for (;;) {
    // carry the columns over into digits
    z = q[last];
    for (int i = 0; i < last; ++i) {
      const double carry = std::trunc(z * 0x1p-24);
      digit[i] = static_cast<std::int32_t>(z - carry * 0x1p24);
      z = q[last - 1 - i] + carry;
    }

    // n is the whole part mod 8, z what is left of the first digit
    z = z * power_of_two(q0);
    z = z - 8.0 * std::floor(z / 8.0);
    n = static_cast<int>(z);
    z = z - n;
    above_half = 0;
    if (q0 > 0) {  // some bits of the next digit are whole too
      const std::int32_t whole = digit[last - 1] >> (24 - q0);
      n += whole;
      digit[last - 1] -= whole << (24 - q0);
      above_half = digit[last - 1] >> (23 - q0);
    } else if (q0 == 0) {
      above_half = digit[last - 1] >> 23;
    } else if (z >= 0.5) {
      above_half = 2;
    }

    if (above_half > 0) {  // the next multiple is nearer: take 1 - fraction
      n += 1;
      const bool carry = complement(digit, last);
      if (q0 > 0) digit[last - 1] &= all_ones >> q0;
      if (above_half == 2) {
        z = 1.0 - z;
        if (carry) z = z - power_of_two(q0);
      }
    }

    const auto lost = [&](int i) { return digit[i] == 0; };
    bool all_lost = z == 0.0;
    for (int i = last - 1; i >= first_digits && all_lost; --i)
      all_lost = lost(i);
    if (!all_lost) break;
    // cancellation left too few digits: take more of 2/pi
    int more = 1;
    while (lost(first_digits - more)) ++more;
    for (int i = last + 1; i <= last + more; ++i) q[i] = quotient.column(i);
    last += more;
  }

  // the fraction as digits alone, none of the leading ones zero
  if (z == 0.0) {
    do {
      last -= 1;
      q0 -= 24;
    } while (digit[last] == 0);
  } else {
    z = z * power_of_two(-q0);
    if (z >= 0x1p24) {
      const double carry = std::trunc(z * 0x1p-24);
      digit[last] = static_cast<std::int32_t>(z - carry * 0x1p24);
      last += 1;
      q0 += 24;
      digit[last] = static_cast<std::int32_t>(carry);
    } else {
      digit[last] = static_cast<std::int32_t>(z);
    }
  }

  // times pi/2, column by column; the sums run from the least
  for (int i = last; i >= 0; --i)
    q[i] = digit[i] * power_of_two(q0 - 24 * (last - i));
  double fq[20] = {};
  for (int i = last; i >= 0; --i) {
    double sum = 0.0;
    for (int k = 0; k <= std::min(first_digits, last - i); ++k)
      sum += pio2_split[k] * q[i + k];
    fq[last - i] = sum;
  }
  double y0 = 0.0;
  for (int i = last; i >= 0; --i) y0 += fq[i];
  double y1 = fq[0] - y0;
  for (int i = 1; i <= last; ++i) y1 += fq[i];
  if (above_half > 0) {
    y0 = -y0;
    y1 = -y1;
  }
  return x < 0.0 ? Reduced{-n, -y0, -y1} : Reduced{n, y0, y1};
}

}  // namespace occgrid::detail
