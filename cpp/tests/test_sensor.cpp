#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "occgrid/portable_math.hpp"
#include "occgrid/sensor.hpp"

namespace {

using occgrid::NoReturn;
using occgrid::OccupancyGrid;
using occgrid::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Sensor, BeamAngles) {
  const auto angles = occgrid::beam_angles(pi, 181);
  EXPECT_EQ(angles[0], -pi / 2.0);
  EXPECT_EQ(angles[90], 0.0);
  EXPECT_EQ(angles[1], -(pi / 2.0) + pi / 180.0);
  EXPECT_EQ(angles[7], -(pi / 2.0) + (pi * 7.0) / 180.0);
  EXPECT_EQ(occgrid::beam_angles(pi, 1)[0], 0.0);
}

TEST(Sensor, FlaserAngles) {
  const auto expect_step = [](Eigen::Index n, double step) {
    const Eigen::ArrayXd angles = occgrid::flaser_angles(n);
    ASSERT_EQ(angles.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_EQ(angles[i], -(pi / 2.0) + static_cast<double>(i) * step);
    }
  };
  expect_step(180, pi / 180.0);
  expect_step(181, pi / 180.0);
  expect_step(360, pi / 360.0);
  expect_step(361, pi / 360.0);
  expect_step(400, pi / 720.0);
  expect_step(401, pi / 720.0);
  expect_step(5, pi / 4.0);
  expect_step(182, pi / 181.0);
  expect_step(1, 0.0);
}

TEST(Sensor, ReadRanges) {
  Eigen::ArrayXd ranges(7);
  ranges << 0.0, 9.5, std::nextafter(10.0 - 1e-12, 0.0), 10.0 - 1e-12, 10.0,
      infinity, nan;
  const auto free = occgrid::read_ranges(ranges, 10.0, NoReturn::free);
  const auto ignore = occgrid::read_ranges(ranges, 10.0, NoReturn::ignore);
  for (int i = 0; i < 7; ++i) {
    const bool hit = i < 3;
    EXPECT_EQ(free.hit[i], hit);
    EXPECT_EQ(free.used[i], i != 6);
    EXPECT_EQ(free.z[i], hit ? ranges[i] : 10.0);
    EXPECT_EQ(ignore.hit[i], hit);
    EXPECT_EQ(ignore.used[i], hit);
  }
}

TEST(Sensor, BeamEndpoints) {
  Eigen::ArrayXd angles(2), z(2);
  angles << 0.25, -3.0;
  z << 2.0, 0.0;
  const auto [ex, ey] = occgrid::beam_endpoints({1.0, -2.0, 0.5}, angles, z);
  EXPECT_EQ(ex[0], 1.0 + 2.0 * occgrid::cos(0.75));
  EXPECT_EQ(ey[0], -2.0 + 2.0 * occgrid::sin(0.75));
  EXPECT_EQ(ex[1], 1.0);
  EXPECT_EQ(ey[1], -2.0);
}

/// One beam along x from the middle of cell (1, 1).
OccupancyGrid one_beam(double range, NoReturn no_return = NoReturn::free) {
  OccupancyGrid grid({6, 3, 1.0, 0.0, 0.0});
  const Eigen::ArrayXd angle = Eigen::ArrayXd::Zero(1);
  const Eigen::ArrayXd ranges = Eigen::ArrayXd::Constant(1, range);
  occgrid::update_grid_from_scan(grid, {{1.5, 1.5, 0.0}, angle, ranges}, 3.0,
                                 no_return);
  return grid;
}

TEST(Sensor, HitIsFreeThenOccupied) {
  const OccupancyGrid grid = one_beam(2.0);
  Eigen::ArrayXd row(6);
  row << 0.0, grid.l_free(), grid.l_free(), grid.l_occ(), 0.0, 0.0;
  EXPECT_TRUE((grid.log_odds().row(1).transpose() == row).all());
  EXPECT_TRUE((grid.log_odds().row(0) == 0.0).all());
  EXPECT_TRUE((grid.log_odds().row(2) == 0.0).all());
}

// Lesson section 7, Problem 3.
TEST(Sensor, NoReturnIsFreeAllAlong) {
  for (const double range : {3.0, 7.0, infinity}) {
    const OccupancyGrid grid = one_beam(range);
    Eigen::ArrayXd row(6);
    row << 0.0, grid.l_free(), grid.l_free(), grid.l_free(), grid.l_free(),
        0.0;
    EXPECT_TRUE((grid.log_odds().row(1).transpose() == row).all());
    EXPECT_TRUE((one_beam(range, NoReturn::ignore).log_odds() == 0.0).all());
  }
  EXPECT_TRUE((one_beam(nan).log_odds() == 0.0).all());
}

TEST(Sensor, BeamOfOneCell) {
  const OccupancyGrid grid = one_beam(0.2);
  EXPECT_EQ(grid.log_odds()(1, 1), grid.l_occ());
  EXPECT_EQ((grid.log_odds() != 0.0).count(), 1);
}

// A robot outside the grid marks what its beams cross of it.
TEST(Sensor, RobotOutsideTheGrid) {
  OccupancyGrid grid({3, 1, 1.0, 0.0, 0.0});
  occgrid::update_grid_from_scan(grid,
                                 {{-1.5, 0.5, 0.0},
                                  Eigen::ArrayXd::Zero(1),
                                  Eigen::ArrayXd::Constant(1, 3.0)},
                                 9.0);
  EXPECT_EQ(grid.log_odds()(0, 0), grid.l_free());
  EXPECT_EQ(grid.log_odds()(0, 1), grid.l_occ());
  EXPECT_EQ(grid.log_odds()(0, 2), 0.0);
}

TEST(Sensor, BadArguments) {
  OccupancyGrid grid({10, 10, 0.001, 0.0, 0.0});
  const Eigen::ArrayXd one = Eigen::ArrayXd::Zero(1);
  const occgrid::Scan too_long{
      {0.0, 0.0, 0.0}, one, Eigen::ArrayXd::Constant(1, 2000.0)};
  EXPECT_THROW(occgrid::update_grid_from_scan(grid, too_long, 5000.0),
               std::length_error);
  const occgrid::Scan uneven{{0.0, 0.0, 0.0}, one, Eigen::ArrayXd::Zero(2)};
  EXPECT_THROW(occgrid::update_grid_from_scan(grid, uneven, 5.0),
               std::invalid_argument);
}

}  // namespace
