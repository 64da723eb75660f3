#include <gtest/gtest.h>

#include <cmath>

#include "occgrid/noise.hpp"
#include "occgrid/portable_math.hpp"

namespace {

using Words = std::array<std::uint32_t, 4>;

// The three known answers that its authors publish.
TEST(Noise, PhiloxKnownAnswers) {
  EXPECT_EQ(occgrid::philox4x32({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      occgrid::philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
                          {0xffffffff, 0xffffffff}),
      (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      occgrid::philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
                          {0xa4093822, 0x299f31d0}),
      (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Noise, DeviateIsBoxAndMullersOfTheFirstTwoWords) {
  const double u1 = (0x6627e8d5 + 0.5) / 4294967296.0;
  const double u2 = (0xe169c58d + 0.5) / 4294967296.0;
  EXPECT_EQ(occgrid::normal_deviate(0, 0, 0),
            std::sqrt(-2.0 * occgrid::log(u1)) *
                occgrid::cos(6.283185307179586 * u2));
}

TEST(Noise, DeviatesAreNormal) {
  const int n = 100000;
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double deviate = occgrid::normal_deviate(5, i / 181, i % 181);
    sum += deviate;
    squares += deviate * deviate;
  }
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
}

TEST(Noise, RangesGetTheirOwnDeviateAndAreClamped) {
  const Eigen::ArrayXd ranges = Eigen::ArrayXd::Constant(200, 5.0);
  const auto noisy = occgrid::add_range_noise(ranges, 0.02, 9, 3, 10.0);
  for (std::uint32_t i = 0; i < 200; ++i) {
    EXPECT_EQ(noisy[i], 5.0 + 0.02 * occgrid::normal_deviate(9, 3, i));
  }
  EXPECT_TRUE((ranges == 5.0).all());
  const auto far = occgrid::add_range_noise(ranges, 1000.0, 9, 3, 10.0);
  EXPECT_EQ(far.minCoeff(), 0.0);
  EXPECT_EQ(far.maxCoeff(), 10.0);
}

}  // namespace
