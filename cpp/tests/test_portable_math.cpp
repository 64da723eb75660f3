#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "occgrid/portable_math.hpp"

namespace {

using occgrid::detail::bits_of;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Known {
  double x;
  std::uint64_t bits;
};

void expect_known(double (*f)(double), const std::vector<Known>& table) {
  for (const Known& known : table) {
    EXPECT_EQ(bits_of(f(known.x)), known.bits) << "at " << known.x;
  }
}

// The results are those of Java's StrictMath.

TEST(PortableMath, Sin) {
  expect_known(occgrid::sin, {
                                 {0.0, 0x0000000000000000},
                                 {-0.0, 0x8000000000000000},
                                 {0.5, 0x3fdeaee8744b05f0},
                                 {-0.7853981633974483, 0xbfe6a09e667f3bcc},
                                 {0.7853981633974484, 0x3fe6a09e667f3bcd},
                                 {1.5707963267948966, 0x3ff0000000000000},
                                 {3.141592653589793, 0x3ca1a62633145c07},
                                 {-2.356194490192345, 0xbfe6a09e667f3bcd},
                                 {100.0, 0xbfe03425b78c4db8},
                                 {1000000.0, 0xbfd6664b2568d867},
                                 {-1e22, 0x3feb453ab76bf397},
                                 {5.319372648326541e255, 0x3ff0000000000000},
                                 {1.7976931348623157e308, 0x3f7452fc98b34e97},
                                 {4.9e-324, 0x0000000000000001},
                             });
}

TEST(PortableMath, Cos) {
  expect_known(occgrid::cos,
               {
                   {0.0, 0x3ff0000000000000},
                   {0.5, 0x3fec1528065b7d50},
                   {-0.7853981633974483, 0x3fe6a09e667f3bcd},
                   {0.2999, 0x3fee925bcb3d5284},
                   {1.5707963267948966, 0x3c91a62633145c07},
                   {3.141592653589793, 0xbff0000000000000},
                   {-2.356194490192345, 0xbfe6a09e667f3bcc},
                   {100.0, 0x3feb981dbf665fdf},
                   {1000000.0, 0x3fedf9df9906d32c},
                   {-1e22, 0x3fe0be2cef01c8f4},
                   // the double that lies nearest to a multiple of pi/2
                   {5.319372648326541e255, 0xbc214ae72e6ba22f},
                   {1.7976931348623157e308, 0xbfefffe62ecfab75},
                   {4.9e-324, 0x3ff0000000000000},
               });
}

TEST(PortableMath, SinCosIsSinAndCos) {
  std::mt19937_64 random(6);
  const auto expect_same = [](double x) {
    const occgrid::SinCos both = occgrid::sin_cos(x);
    EXPECT_EQ(bits_of(both.sin), bits_of(occgrid::sin(x))) << x;
    EXPECT_EQ(bits_of(both.cos), bits_of(occgrid::cos(x))) << x;
  };
  std::uniform_real_distribution<double> near(-20.0, 20.0);
  for (int i = 0; i < 100000; ++i) {
    expect_same(near(random));
    const double x = occgrid::detail::double_of(random());
    if (std::isfinite(x)) expect_same(x);
  }
  for (const double x : {0.0, -0.0, 4.9e-324, 0.7853981633974483}) {
    expect_same(x);
  }
  EXPECT_TRUE(std::isnan(occgrid::sin_cos(infinity).sin));
  EXPECT_TRUE(std::isnan(occgrid::sin_cos(nan).cos));
}

TEST(PortableMath, Exp) {
  expect_known(occgrid::exp, {
                                 {0.0, 0x3ff0000000000000},
                                 {-0.0, 0x3ff0000000000000},
                                 {1.0, 0x4005bf0a8b14576a},
                                 {-1.0, 0x3fd78b56362cef38},
                                 {0.25, 0x3ff48b5e3c3e8186},
                                 {8.0, 0x40a749ea7d470c6e},
                                 {-8.0, 0x3f35fc21041027ad},
                                 {709.782712893384, 0x7fefffffffffff2a},
                                 {-708.5, 0x000e6cf6d08897ac},
                                 {-745.1332191019411, 0x0000000000000001},
                                 {-745.1332191019412, 0x0000000000000000},
                                 {1e-9, 0x3ff000000044b830},
                                 {-0.4, 0x3fe57343067270ee},
                             });
}

TEST(PortableMath, Log) {
  expect_known(occgrid::log, {
                                 {1.0, 0x0000000000000000},
                                 {0.75, 0xbfd269621134db92},
                                 {0.4285714285714286, 0xbfeb1d10670aae99},
                                 {1.000000001e-9, 0xc034b927f327b435},
                                 {10.0, 0x40026bb1bbb55516},
                                 {1.0000001, 0x3e7ad7f2847b6492},
                                 {1.4142135623730951, 0x3fd62e42fefa39f0},
                                 {4.9e-324, 0xc0874385446d71c3},
                                 {1e-310, 0xc0864e69394d9508},
                                 {1.7976931348623157e308, 0x40862e42fefa39ef},
                                 {2.0, 0x3fe62e42fefa39ef},
                             });
}

TEST(PortableMath, Specials) {
  for (const double x : {nan, infinity, -infinity}) {
    EXPECT_TRUE(std::isnan(occgrid::sin(x)));
    EXPECT_TRUE(std::isnan(occgrid::cos(x)));
  }
  EXPECT_TRUE(std::isnan(occgrid::exp(nan)));
  EXPECT_EQ(occgrid::exp(infinity), infinity);
  EXPECT_EQ(occgrid::exp(-infinity), 0.0);
  EXPECT_EQ(occgrid::exp(709.7827128933841), infinity);
  EXPECT_TRUE(std::isnan(occgrid::log(nan)));
  EXPECT_TRUE(std::isnan(occgrid::log(-1.0)));
  EXPECT_TRUE(std::isnan(occgrid::log(-infinity)));
  EXPECT_EQ(occgrid::log(infinity), infinity);
  EXPECT_EQ(occgrid::log(0.0), -infinity);
  EXPECT_EQ(occgrid::log(-0.0), -infinity);
}

TEST(PortableMath, ConstantsHaveTheBitsOfTheContract) {
  using namespace occgrid::detail;
  EXPECT_EQ(bits_of(occgrid::pi), 0x400921fb54442d18u);
  EXPECT_EQ(bits_of(2.0 * occgrid::pi), bits_of(6.283185307179586));
  EXPECT_EQ(bits_of(pio2_1t), 0x3dd0b4611a626331u);
  EXPECT_EQ(bits_of(pio2_2t), 0x3ba3198a2e037073u);
  EXPECT_EQ(bits_of(pio2_3t), 0x397b839a252049c1u);
  EXPECT_EQ(bits_of(S6), 0x3de5d93a5acfd57cu);
  EXPECT_EQ(bits_of(C6), 0xbda8fae9be8838d4u);
  EXPECT_EQ(bits_of(P5), 0x3e66376972bea4d0u);
  EXPECT_EQ(bits_of(Lg7), 0x3fc2f112df3e5244u);
  for (int n = 1; n <= 32; ++n)
    EXPECT_EQ(npio2_high[n - 1], high_word(n * (occgrid::pi / 2.0)));
}

}  // namespace
