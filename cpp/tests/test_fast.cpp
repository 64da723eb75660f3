// The fast path gives the bits of the plain one.
#include "occgrid/fast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "occgrid/lesson.hpp"
#include "occgrid/mapper.hpp"
#include "occgrid/ray.hpp"
#include "random_worlds.hpp"
#include "same_bits.hpp"

namespace {

using occgrid::Cell;
using occgrid::clip_ray;
using occgrid::OccupancyGrid;
using occgrid::pi;

TEST(Fast, ClipRayFindsTheStepsInside) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> anywhere(-30, 50);
  std::uniform_int_distribution<std::int64_t> size(1, 25);
  int missed = 0;
  for (int i = 0; i < 50000; ++i) {
    const Cell from{anywhere(random), anywhere(random)};
    const Cell to{anywhere(random), anywhere(random)};
    const std::int64_t width = size(random), height = size(random);
    const auto cells = occgrid::bresenham(from.gx, from.gy, to.gx, to.gy);
    const auto inside = [&](Cell c) {
      return c.gx >= 0 && c.gx < width && c.gy >= 0 && c.gy < height;
    };
    const auto steps = clip_ray(from.gx, from.gy, to.gx, to.gy, width, height);
    const auto count = std::count_if(cells.begin(), cells.end(), inside);
    if (count == 0) {
      ++missed;
      ASSERT_LT(steps.last, steps.first);
    } else {
      const auto first =
          std::find_if(cells.begin(), cells.end(), inside) - cells.begin();
      ASSERT_EQ(steps.first, first);
      ASSERT_EQ(steps.last, first + count - 1);
    }
  }
  EXPECT_GT(missed, 1000);
}

// As far out as the contract allows: 2e10 cells from the grid.
TEST(Fast, ClipRayFarOut) {
  const auto missed =
      clip_ray(20000000000, 20000000000, 20001000000, 19999500000, 5000, 5000);
  EXPECT_LT(missed.last, missed.first);
  const auto steps = clip_ray(-400000, -100000, 600000, 150001, 5000, 5000);
  EXPECT_EQ(steps.first, 400000);
  EXPECT_EQ(steps.last, 404999);
  EXPECT_THROW(clip_ray(0, 0, 1 + (1 << 20), 0, 5, 5), std::length_error);
}

TEST(Fast, LessonSameAsPlain) {
  const auto lesson = occgrid::lesson_scenario();
  for (const std::optional<std::uint32_t> seed :
       {std::optional<std::uint32_t>{}, std::optional<std::uint32_t>{3}}) {
    EXPECT_TRUE(same_bits(occgrid::map_scenario(lesson, seed),
                          occgrid::map_scenario_fast(lesson, seed)));
  }
}

TEST(Fast, RandomWorldsSameAsPlain) {
  RandomWorld random(11);
  int touched = 0;
  for (int i = 0; i < 400; ++i) {
    const auto scenario = random.scenario(30);
    const OccupancyGrid plain = occgrid::map_scenario(scenario, 3);
    ASSERT_TRUE(same_bits(plain, occgrid::map_scenario_fast(scenario, 3)))
        << i;
    touched += (plain.log_odds() != plain.l0()).any() ? 1 : 0;
  }
  EXPECT_GT(touched, 200);
}

TEST(Fast, TwoGridsAtOnce) {
  RandomWorld random(12);
  const auto one = random.scenario(20), other = random.scenario(20);
  OccupancyGrid a = one.settings.new_grid(), b = other.settings.new_grid();
  const auto scans_a = occgrid::simulated_scans(one, 1);
  const auto scans_b = occgrid::simulated_scans(other, 1);
  for (int i = 0; i < 20; ++i) {
    occgrid::update_grid_from_scans(a, {scans_a().value()},
                                    one.settings.max_range,
                                    one.settings.no_return);
    occgrid::update_grid_from_scans(b, {scans_b().value()},
                                    other.settings.max_range,
                                    other.settings.no_return);
  }
  EXPECT_TRUE(same_bits(a, occgrid::map_scenario(one, 1)));
  EXPECT_TRUE(same_bits(b, occgrid::map_scenario(other, 1)));
}

/// Maps one scan both ways.
void update(OccupancyGrid& plain, OccupancyGrid& fast,
            const occgrid::Scan& scan, double z_max) {
  occgrid::update_grid_from_scan(plain, scan, z_max);
  occgrid::update_grid_from_scans(fast, {scan}, z_max);
}

// Lines as long as the contract allows, most of them clipped at both ends.
TEST(Fast, LongBeamsSameAsPlain) {
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  OccupancyGrid fast({1000, 1000, 0.001, -0.5, -0.5});
  OccupancyGrid plain = fast;
  for (int s = 0; s < 60; ++s) {
    const double heading = uniform(0.0, 2.0 * pi);
    const double away = uniform(0.0, 1000.0);
    const double range =
        s % 2 == 0 ? std::numeric_limits<double>::infinity() : away;
    update(plain, fast,
           {{-away * std::cos(heading) + uniform(-0.5, 0.5),
             -away * std::sin(heading) + uniform(-0.5, 0.5), heading},
            Eigen::ArrayXd::Zero(1),
            Eigen::ArrayXd::Constant(1, range)},
           1000.0);
  }
  EXPECT_TRUE(same_bits(fast, plain));
  EXPECT_GT((fast.log_odds() != 0.0).count(), 10000);
}

// Many steps in a row inside the grid: what each one adds to the closed form
// must not add up to a cell.
TEST(Fast, ManyStepsSameAsPlain) {
  OccupancyGrid fast({400000, 8, 0.001, 0.0, 0.0});
  OccupancyGrid plain = fast;
  update(
      plain, fast,
      {{0.0005, 0.0005, 0.0},
       Eigen::ArrayXd::NullaryExpr(
           9, [](Eigen::Index i) { return 2.1e-6 * static_cast<double>(i); }),
       Eigen::ArrayXd::Constant(9, 399.9)},
      1000.0);
  EXPECT_TRUE(same_bits(fast, plain));
  EXPECT_GT((fast.log_odds() == fast.l_occ()).count(), 5);
}

// The longest line that there is, and nearly level: 2^20 steps, 2^20 - 1
// others.
TEST(Fast, LongestLinesSameAsPlain) {
  for (const double rise : {0.0, 1.0, 3.0, 524288.0, 1048575.0, 1048576.0}) {
    const double length = std::hypot(1048576.0, rise);
    OccupancyGrid fast(
        {8192, 12, 1.0, 1048576.0 - 8190.0, rise < 8.0 ? -2.0 : rise - 10.0});
    OccupancyGrid plain = fast;
    update(plain, fast,
           {{0.5, 0.5, 0.0},
            Eigen::ArrayXd::Constant(1, std::atan2(rise, 1048576.0)),
            Eigen::ArrayXd::Constant(1, length)},
           length + 1.0);
    EXPECT_TRUE(same_bits(fast, plain)) << rise;
    EXPECT_TRUE((fast.log_odds() != 0.0).any()) << rise;
  }
}

TEST(Fast, RefusesWhatPlainRefuses) {
  OccupancyGrid grid({10, 10, 0.001, 0.0, 0.0});
  const Eigen::ArrayXd one = Eigen::ArrayXd::Zero(1);
  const auto update_with = [&](const Eigen::ArrayXd& ranges) {
    occgrid::update_grid_from_scans(grid, {{{0, 0, 0}, one, ranges}}, 5000.0);
  };
  EXPECT_THROW(update_with(Eigen::ArrayXd::Constant(1, 2000.0)),
               std::length_error);
  EXPECT_THROW(update_with(Eigen::ArrayXd::Zero(2)), std::invalid_argument);
  EXPECT_THROW(
      occgrid::map_scenario_fast(occgrid::lesson_scenario(), std::nullopt, 0),
      std::invalid_argument);
}

}  // namespace
