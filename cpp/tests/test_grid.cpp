#include <gtest/gtest.h>

#include <cmath>

#include <limits>
#include <stdexcept>

#include "occgrid/grid.hpp"

namespace {

using occgrid::Cell;
using occgrid::GridSpec;
using occgrid::OccupancyGrid;

const GridSpec lesson_spec{220, 180, 0.1, -11.0, -9.0};

TEST(Grid, LogitAndSigmoid) {
  EXPECT_EQ(occgrid::logit(0.5), 0.0);
  EXPECT_NEAR(occgrid::logit(0.75), std::log(3.0), 1e-15);
  EXPECT_EQ(occgrid::logit(0.0), occgrid::logit(1e-9));
  EXPECT_EQ(occgrid::logit(1.0), occgrid::logit(1.0 - 1e-9));
  EXPECT_EQ(occgrid::sigmoid(0.0), 0.5);
  EXPECT_EQ(occgrid::sigmoid(1000.0), 1.0);
  EXPECT_EQ(occgrid::sigmoid(-1000.0), 0.0);
  EXPECT_NEAR(occgrid::sigmoid(occgrid::logit(0.3)), 0.3, 1e-15);
}

TEST(Grid, WorldToGrid) {
  const OccupancyGrid grid(lesson_spec);
  EXPECT_EQ(grid.world_to_grid(-11.0, -9.0), (Cell{0, 0}));
  EXPECT_EQ(grid.world_to_grid(-10.95, -8.85), (Cell{0, 1}));
  EXPECT_EQ(grid.world_to_grid(10.95, 8.95), (Cell{219, 179}));
  // outside too, towards minus infinity
  EXPECT_EQ(grid.world_to_grid(-11.05, -9.25), (Cell{-1, -3}));
  EXPECT_EQ(grid.world_to_grid(11.05, 9.05), (Cell{220, 180}));
  // one subtraction and one division, as they round: (0.7 - 0) / 0.1 is below
  // 7
  const OccupancyGrid tenths({10, 10, 0.1, 0.0, 0.0});
  EXPECT_EQ(tenths.world_to_grid(0.7, 0.3), (Cell{6, 2}));
}

TEST(Grid, CentersLieInTheirCells) {
  const OccupancyGrid grid(lesson_spec);
  for (std::int64_t gy = 0; gy < 180; gy += 7) {
    for (std::int64_t gx = 0; gx < 220; gx += 3) {
      const occgrid::Point center = grid.grid_to_world_center(gx, gy);
      EXPECT_EQ(grid.world_to_grid(center.x, center.y), (Cell{gx, gy}));
    }
  }
}

TEST(Grid, InBounds) {
  const OccupancyGrid grid(lesson_spec);
  EXPECT_TRUE(grid.in_bounds(0, 0));
  EXPECT_TRUE(grid.in_bounds(219, 179));
  EXPECT_FALSE(grid.in_bounds(-1, 0));
  EXPECT_FALSE(grid.in_bounds(0, -1));
  EXPECT_FALSE(grid.in_bounds(220, 0));
  EXPECT_FALSE(grid.in_bounds(0, 180));
}

TEST(Grid, UpdateCellAddsAndClamps) {
  OccupancyGrid grid({3, 2, 1.0, 0.0, 0.0}, 0.5, 0.75, 0.3, -2.0, 2.0);
  grid.update_cell(1, 0, grid.l_occ());
  EXPECT_EQ(grid.log_odds()(0, 1), grid.l_occ());
  grid.update_cell(1, 0, grid.l_occ());
  EXPECT_EQ(grid.log_odds()(0, 1), 2.0);
  grid.update_cell(1, 0, grid.l_free());
  EXPECT_EQ(grid.log_odds()(0, 1), 2.0 + grid.l_free());
  for (int i = 0; i < 10; ++i) grid.update_cell(2, 1, grid.l_free());
  EXPECT_EQ(grid.log_odds()(1, 2), -2.0);
  const occgrid::GridArray before = grid.log_odds();
  for (const Cell outside :
       {Cell{-1, 0}, Cell{3, 0}, Cell{0, -1}, Cell{0, 2}}) {
    grid.update_cell(outside.gx, outside.gy, grid.l_occ());
  }
  EXPECT_TRUE((grid.log_odds() == before).all());
}

TEST(Grid, StartsAtThePrior) {
  const OccupancyGrid grid({4, 3, 1.0, 0.0, 0.0}, 0.2);
  EXPECT_TRUE((grid.log_odds() == occgrid::logit(0.2)).all());
  const occgrid::GridArray p = grid.probability_grid();
  EXPECT_EQ(p.rows(), 3);
  EXPECT_EQ(p.cols(), 4);
  EXPECT_NEAR(p(2, 3), 0.2, 1e-15);
}

// A grid is a value: two of them have nothing in common.
TEST(Grid, OwnsItsCells) {
  OccupancyGrid one({3, 2, 1.0, 0.0, 0.0});
  OccupancyGrid other = one;
  other.update_cell(1, 1, other.l_occ());
  EXPECT_EQ(one.log_odds()(1, 1), 0.0);
  EXPECT_EQ(other.log_odds()(1, 1), other.l_occ());
  const occgrid::GridArray difference = other.log_odds() - one.log_odds();
  EXPECT_EQ((difference != 0.0).count(), 1);
  one = OccupancyGrid({5, 4, 2.0, 0.0, 0.0}, 0.3);
  EXPECT_EQ(one.spec().width, 5);
  EXPECT_EQ(one.log_odds().rows(), 4);
  EXPECT_EQ(other.log_odds().rows(), 2);
}

TEST(Grid, BadArguments) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const GridSpec& spec :
       {GridSpec{0, 1, 1, 0, 0}, GridSpec{1, -1, 1, 0, 0},
        GridSpec{1, 1, 0, 0, 0}, GridSpec{1, 1, -1, 0, 0},
        GridSpec{1, 1, nan, 0, 0}, GridSpec{1, 1, 1, infinity, 0},
        GridSpec{1, 1, 1, 0, nan},
        GridSpec{std::int64_t{1} << 40, std::int64_t{1} << 40, 1, 0, 0}}) {
    EXPECT_THROW(OccupancyGrid{spec}, std::invalid_argument);
  }
  const GridSpec cell{1, 1, 1.0, 0.0, 0.0};
  EXPECT_THROW(OccupancyGrid(cell, nan), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.5, 1.5), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.5, 0.7, -0.1), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.5, 0.7, 0.3, 1.0, 2.0),
               std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.9, 0.7, 0.3, -2.0, 2.0),
               std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.5, 0.7, 0.3, 0.0, 0.0),
               std::invalid_argument);
  EXPECT_THROW(OccupancyGrid(cell, 0.5, 0.7, 0.3, nan, 2.0),
               std::invalid_argument);
}

// As far out as a scenario may be: 1e7 m, cells of 0.001 m.
TEST(Grid, FarFromTheOrigin) {
  const OccupancyGrid grid({10, 10, 0.001, 1e7, -1e7});
  EXPECT_EQ(grid.world_to_grid(-1e7, 1e7), (Cell{-20000000000, 20000000000}));
  EXPECT_EQ(grid.world_to_grid(1e7 + 0.0045, -1e7 + 0.0005), (Cell{4, 0}));
}

// Lesson section 7, Problem 1: 30 m x 20 m at 0.05 m.
TEST(Grid, ProblemOne) {
  const OccupancyGrid grid({600, 400, 0.05, 0.0, 0.0});
  EXPECT_EQ(grid.world_to_grid(30.0, 20.0), (Cell{600, 400}));
  EXPECT_EQ(grid.log_odds().size(), 240000);
  EXPECT_EQ(static_cast<std::size_t>(grid.log_odds().size()) * sizeof(double),
            1920000u);
}

// Problem 4: after t updates with the same evidence, p = O / (1 + O) with O =
// O0 (Oinv / O0)^t.
TEST(Grid, ProblemFour) {
  for (const double p0 : {0.5, 0.35}) {
    OccupancyGrid grid({1, 1, 1.0, 0.0, 0.0}, p0, 0.75, 0.3, -50.0, 50.0);
    const double odds0 = p0 / (1.0 - p0);
    const double odds_inv = 0.3 / 0.7;
    for (int t = 1; t <= 20; ++t) {
      grid.update_cell(0, 0, grid.l_free());
      const double odds = odds0 * std::pow(odds_inv / odds0, t);
      EXPECT_NEAR(grid.probability_grid()(0, 0), odds / (1.0 + odds), 1e-14);
    }
  }
}

}  // namespace
