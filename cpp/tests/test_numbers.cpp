#include "numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

using occgrid::parse_number;
using occgrid::parse_whole;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string repeat(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

TEST(Numbers, Forms) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("+1.50"), 1.5);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  EXPECT_EQ(parse_number("1.E+02"), 100.0);
  EXPECT_EQ(parse_number("-12.5e-1"), -1.25);
  EXPECT_EQ(parse_number("inf"), infinity);
  EXPECT_EQ(parse_number("-INFINITY"), -infinity);
  EXPECT_EQ(parse_number("+Inf"), infinity);
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
  EXPECT_TRUE(std::isnan(parse_number("-NaN").value()));
  for (const char* not_one :
       {"",       "+",       "-",   ".",     "e5",   ".e5",     "1e",
        "1e+",    "1.2.3",   "--1", "+-1",   "0x10", "1_0",     "1,5",
        "nan(1)", "infinit", "1f",  "1e5.0", "1 ",   "\xd9\xa1"}) {
    EXPECT_FALSE(parse_number(not_one)) << not_one;
  }
}

TEST(Numbers, AreRoundedCorrectly) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("1.0050000000000001"), 1.0050000000000001);
  EXPECT_EQ(parse_number("3.141592653589793"), 3.141592653589793);
  EXPECT_EQ(parse_number("9007199254740993"),
            9007199254740992.0);  // half way: to even
  EXPECT_EQ(parse_number("9007199254740993." + repeat("0", 800) + "1"),
            9007199254740994.0);
  EXPECT_EQ(parse_number("8.5e22"), 8.5e22);
  EXPECT_EQ(parse_number("1" + repeat("0", 400) + "e-400"), 1.0);
  EXPECT_EQ(parse_number("0." + repeat("0", 400) + "1e401"), 1.0);
  EXPECT_EQ(parse_number("1.7976931348623157e299"), 1.7976931348623157e299);
  EXPECT_EQ(parse_number("179769313486231570000e-20"), 1.7976931348623157);
}

TEST(Numbers, OutOfRange) {
  EXPECT_EQ(parse_number("1e300"), infinity);
  EXPECT_EQ(parse_number("9.999999999999999e299"), 9.999999999999999e299);
  EXPECT_EQ(parse_number("-1e400"), -infinity);
  EXPECT_EQ(parse_number("1e99999999999999999999"), infinity);
  EXPECT_EQ(parse_number("0e99999999999999999999"), 0.0);
  EXPECT_EQ(parse_number("0." + repeat("0", 500) + "1e900"), infinity);
  EXPECT_EQ(parse_number(repeat("9", 500) + "e-900"), 0.0);
  EXPECT_EQ(parse_number("00" + repeat("9", 500)), infinity);
  EXPECT_EQ(parse_number("0." + repeat("0", 500) + "1"), 0.0);
  EXPECT_EQ(parse_number("1e-300"), 1e-300);
  EXPECT_EQ(parse_number("9.999e-301"), 0.0);
  EXPECT_EQ(parse_number("1e-99999999999999999999"), 0.0);
  for (const char* zero : {"-0", "-0.0", "-1e-301", "-1e-999"}) {
    EXPECT_EQ(parse_number(zero), 0.0);
    EXPECT_FALSE(std::signbit(parse_number(zero).value())) << zero;
  }
}

TEST(Numbers, Whole) {
  EXPECT_EQ(parse_whole("0"), 0);
  EXPECT_EQ(parse_whole("007"), 7);
  EXPECT_EQ(parse_whole("25000000"), 25000000);
  EXPECT_EQ(parse_whole(repeat("9", 500)), std::int64_t{1} << 62);
  for (const char* not_one : {"", "+1", "-1", "1.0", "1e3", "x"})
    EXPECT_FALSE(parse_whole(not_one));
}

}  // namespace
