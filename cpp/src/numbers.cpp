#include "numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>

namespace occgrid {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  const auto same = [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
  };
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                    same);
}

/// The parts of an unsigned decimal: digits * 10^exponent, where `digits` is
/// right as long as there are at most 18 of them.
struct Decimal {
  std::uint64_t digits = 0;   ///< of both sides of the point
  std::int64_t count = 0;     ///< how many digits there are
  std::int64_t exponent = 0;  ///< that of the last digit
};

std::optional<Decimal> split_decimal(std::string_view text) {
  constexpr std::int64_t far_away = std::int64_t{1} << 50;
  Decimal decimal;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto take_digits = [&] {
    const char* const start = at;
    for (; at != end && is_digit(*at); ++at) {
      decimal.digits =
          10 * decimal.digits + static_cast<std::uint64_t>(*at - '0');
    }
    decimal.count += at - start;
    return at - start;
  };
  take_digits();
  if (at != end && *at == '.') {
    ++at;
    decimal.exponent = -take_digits();
  }
  if (decimal.count == 0) return std::nullopt;
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    if (at == end) return std::nullopt;
    std::int64_t exponent = 0;
    for (; at != end && is_digit(*at); ++at) {
      exponent = std::min(10 * exponent + (*at - '0'), far_away);
    }
    decimal.exponent += negative ? -exponent : exponent;
  }
  if (at != end) return std::nullopt;
  return decimal;
}

/// Whether the first digit that is not 0 stands for 1 or more.
bool is_at_least_one(std::string_view text, const Decimal& decimal) {
  std::int64_t zeros = 0;  // before that digit
  for (const char c : text) {
    if (is_digit(c) && c != '0') break;
    zeros += c == '0' ? 1 : 0;
  }
  return decimal.exponent + decimal.count - zeros > 0;
}

/// An unsigned decimal, correctly rounded, or none.
std::optional<double> parse_decimal(std::string_view text) {
  constexpr std::array<double, 23> powers_of_ten{
      1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const std::optional<Decimal> decimal = split_decimal(text);
  if (!decimal) return std::nullopt;
  // both exact as doubles: one operation, rounded once
  if (decimal->count <= 18 && decimal->digits <= std::uint64_t{1} << 53 &&
      std::abs(decimal->exponent) <= 22) {
    const double power =
        powers_of_ten[static_cast<std::size_t>(std::abs(decimal->exponent))];
    const auto number = static_cast<double>(decimal->digits);
    return decimal->exponent < 0 ? number / power : number * power;
  }
  double value = 0.0;
  const auto result =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc::result_out_of_range) return value;
  return is_at_least_one(text, *decimal) ? infinity : 0.0;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
  const bool negative = !token.empty() && token[0] == '-';
  if (negative || (!token.empty() && token[0] == '+')) token.remove_prefix(1);
  double magnitude = infinity;
  if (const auto decimal = parse_decimal(token)) {
    magnitude = *decimal;
  } else if (equals_ignoring_case(token, "nan")) {
    return std::numeric_limits<double>::quiet_NaN();
  } else if (!equals_ignoring_case(token, "inf") &&
             !equals_ignoring_case(token, "infinity")) {
    return std::nullopt;
  }
  // Near the ends of the range languages read differently; no measurement lies
  // there.
  if (magnitude >= 1e300) magnitude = infinity;
  if (magnitude < 1e-300) return 0.0;
  return negative ? -magnitude : magnitude;
}

std::optional<std::int64_t> parse_whole(std::string_view token) {
  constexpr std::int64_t max_whole = std::int64_t{1} << 62;
  if (token.empty() || !std::all_of(token.begin(), token.end(), is_digit))
    return std::nullopt;
  std::int64_t value = 0;
  for (const char c : token) {
    if (value > max_whole / 10) return max_whole;
    value = 10 * value + (c - '0');
  }
  return std::min(value, max_whole);
}

}  // namespace occgrid
