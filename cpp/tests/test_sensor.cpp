#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "portable_math.hpp"
#include "ray.hpp"
#include "sensor.hpp"

namespace {

using occgrid::Cell;
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
  const auto step = [](Eigen::Index n) {
    return occgrid::flaser_angles(n)[1] + pi / 2.0;
  };
  EXPECT_NEAR(step(180), pi / 180.0, 1e-15);
  EXPECT_NEAR(step(181), pi / 180.0, 1e-15);
  EXPECT_NEAR(step(360), pi / 360.0, 1e-15);
  EXPECT_NEAR(step(361), pi / 360.0, 1e-15);
  EXPECT_NEAR(step(400), pi / 720.0, 1e-15);
  EXPECT_NEAR(step(401), pi / 720.0, 1e-15);
  EXPECT_NEAR(step(5), pi / 4.0, 1e-15);
  EXPECT_EQ(occgrid::flaser_angles(180)[7], -(pi / 2.0) + 7.0 * (pi / 180.0));
  EXPECT_EQ(occgrid::flaser_angles(1)[0], -pi / 2.0);
  EXPECT_NEAR(occgrid::flaser_angles(180)[179], 89.0 * pi / 180.0, 1e-14);
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
  const auto ends = occgrid::beam_endpoints({1.0, -2.0, 0.5}, angles, z);
  EXPECT_EQ(ends.x[0], 1.0 + 2.0 * occgrid::cos(0.75));
  EXPECT_EQ(ends.y[0], -2.0 + 2.0 * occgrid::sin(0.75));
  EXPECT_EQ(ends.x[1], 1.0);
  EXPECT_EQ(ends.y[1], -2.0);
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
  row << 0.0, grid.l_free, grid.l_free, grid.l_occ, 0.0, 0.0;
  EXPECT_TRUE((grid.log_odds.row(1).transpose() == row).all());
  EXPECT_TRUE((grid.log_odds.row(0) == 0.0).all());
  EXPECT_TRUE((grid.log_odds.row(2) == 0.0).all());
}

// Lesson section 7, Problem 3.
TEST(Sensor, NoReturnIsFreeAllAlong) {
  for (const double range : {3.0, 7.0, infinity}) {
    const OccupancyGrid grid = one_beam(range);
    Eigen::ArrayXd row(6);
    row << 0.0, grid.l_free, grid.l_free, grid.l_free, grid.l_free, 0.0;
    EXPECT_TRUE((grid.log_odds.row(1).transpose() == row).all());
    EXPECT_TRUE((one_beam(range, NoReturn::ignore).log_odds == 0.0).all());
  }
  EXPECT_TRUE((one_beam(nan).log_odds == 0.0).all());
}

TEST(Sensor, BeamOfOneCell) {
  const OccupancyGrid grid = one_beam(0.2);
  EXPECT_EQ(grid.log_odds(1, 1), grid.l_occ);
  EXPECT_EQ((grid.log_odds != 0.0).count(), 1);
}

/// The contract as it stands: SPEC.md sections 2.4 and 2.5, cell by cell.
void update_cell_by_cell(OccupancyGrid& grid, const occgrid::Scan& scan,
                         double z_max, NoReturn no_return) {
  const Cell robot = grid.world_to_grid(scan.pose.x, scan.pose.y);
  for (Eigen::Index i = 0; i < scan.angles.size(); ++i) {
    if (std::isnan(scan.ranges[i])) continue;
    const bool hit = scan.ranges[i] < z_max - 1e-12;
    if (!hit && no_return == NoReturn::ignore) continue;
    const double z = hit ? scan.ranges[i] : z_max;
    const double a = scan.pose.theta + scan.angles[i];
    const double ex = scan.pose.x + z * occgrid::cos(a);
    const double ey = scan.pose.y + z * occgrid::sin(a);
    const auto cells = occgrid::bresenham(robot, grid.world_to_grid(ex, ey));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const bool last = k + 1 == cells.size();
      grid.update_cell(cells[k], hit && last ? grid.l_occ : grid.l_free);
    }
  }
}

TEST(Sensor, SameAsCellByCell) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  struct Model {
    double p0, p_occ, p_free, l_min, l_max;
  };
  // the last one is upside down: "free" evidence is for occupied
  for (const Model m :
       {Model{0.5, 0.75, 0.3, -8, 8}, Model{0.2, 0.9, 0.05, -1.5, 1.0},
        Model{0.5, 0.5, 0.5, -1, 1}, Model{0.4, 0.2, 0.7, -2, 3}}) {
    const occgrid::GridSpec spec{73, 41, 0.13, -4.0, -3.0};
    OccupancyGrid fast(spec, m.p0, m.p_occ, m.p_free, m.l_min, m.l_max);
    OccupancyGrid slow = fast;
    for (int s = 0; s < 200; ++s) {
      occgrid::Scan scan;
      scan.pose = {uniform(-9.0, 10.0), uniform(-7.0, 7.0),
                   uniform(-10.0, 10.0)};
      scan.angles = occgrid::beam_angles(uniform(0.1, 6.2), 61);
      scan.ranges = Eigen::ArrayXd::NullaryExpr(61, [&](Eigen::Index i) {
        return i % 17 == 5 ? nan : i % 7 == 3 ? infinity : uniform(0.0, 14.0);
      });
      const auto no_return = s % 3 == 0 ? NoReturn::ignore : NoReturn::free;
      occgrid::update_grid_from_scan(fast, scan, 12.0, no_return);
      update_cell_by_cell(slow, scan, 12.0, no_return);
    }
    EXPECT_TRUE((fast.log_odds == slow.log_odds).all());
    EXPECT_EQ((fast.log_odds != fast.l0).any(), m.p_occ != m.p0);
  }
}

// Lines as long as the contract allows, most of them clipped at both ends.
TEST(Sensor, LongBeamsSameAsCellByCell) {
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  OccupancyGrid fast({1000, 1000, 0.001, -0.5, -0.5});
  OccupancyGrid slow = fast;
  for (int s = 0; s < 60; ++s) {
    const double heading = uniform(0.0, 2.0 * pi);
    const double away = uniform(0.0, 1000.0);
    occgrid::Scan scan;
    scan.pose = {-away * std::cos(heading) + uniform(-0.5, 0.5),
                 -away * std::sin(heading) + uniform(-0.5, 0.5), heading};
    scan.angles = Eigen::ArrayXd::Zero(1);
    scan.ranges = Eigen::ArrayXd::Constant(1, s % 2 == 0 ? infinity : away);
    occgrid::update_grid_from_scan(fast, scan, 1000.0);
    update_cell_by_cell(slow, scan, 1000.0, NoReturn::free);
  }
  EXPECT_TRUE((fast.log_odds == slow.log_odds).all());
  EXPECT_GT((fast.log_odds != 0.0).count(), 10000);
}

// Many steps in a row inside the grid: what each one adds to the closed form
// must not add up to a cell.
TEST(Sensor, ManyStepsSameAsCellByCell) {
  OccupancyGrid fast({400000, 8, 0.001, 0.0, 0.0});
  OccupancyGrid slow = fast;
  occgrid::Scan scan;
  scan.pose = {0.0005, 0.0005, 0.0};
  scan.angles = Eigen::ArrayXd::NullaryExpr(
      9, [](Eigen::Index i) { return 2.1e-6 * static_cast<double>(i); });
  scan.ranges = Eigen::ArrayXd::Constant(9, 399.9);
  occgrid::update_grid_from_scan(fast, scan, 1000.0);
  update_cell_by_cell(slow, scan, 1000.0, NoReturn::free);
  EXPECT_TRUE((fast.log_odds == slow.log_odds).all());
  EXPECT_GT((fast.log_odds == fast.l_occ).count(), 5);
}

TEST(Sensor, TooLongABeamIsRefused) {
  OccupancyGrid grid({10, 10, 0.001, 0.0, 0.0});
  const occgrid::Scan scan{{0.0, 0.0, 0.0},
                           Eigen::ArrayXd::Zero(1),
                           Eigen::ArrayXd::Constant(1, 2000.0)};
  EXPECT_THROW(occgrid::update_grid_from_scan(grid, scan, 5000.0),
               std::length_error);
}

}  // namespace
