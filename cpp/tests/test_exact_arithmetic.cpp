#include "occgrid/exact_arithmetic.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace {

// That it fails where it should is shown by test_flags.py.
TEST(ExactArithmetic, HoldsHere) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NO_THROW(occgrid::require_exact_arithmetic());
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 0.001);
}

}  // namespace
