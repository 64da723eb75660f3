#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "ray.hpp"

namespace occgrid {
// for messages
void PrintTo(const Cell& cell, std::ostream* out) {
  *out << cell.gx << ',' << cell.gy;
}
}  // namespace occgrid

namespace {

using occgrid::bresenham;
using occgrid::Cell;
using Cells = std::vector<Cell>;

TEST(Ray, OneCell) {
  EXPECT_EQ(bresenham({3, -4}, {3, -4}), (Cells{{3, -4}}));
}

TEST(Ray, AxesAndDiagonals) {
  EXPECT_EQ(bresenham({0, 0}, {3, 0}),
            (Cells{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  EXPECT_EQ(bresenham({0, 0}, {0, -2}), (Cells{{0, 0}, {0, -1}, {0, -2}}));
  EXPECT_EQ(bresenham({2, 2}, {0, 0}), (Cells{{2, 2}, {1, 1}, {0, 0}}));
  EXPECT_EQ(bresenham({0, 0}, {-2, 2}), (Cells{{0, 0}, {-1, 1}, {-2, 2}}));
}

// . . 4 5     a = 5, b = 2: steps up after 2 and after 4; one line in each
// octant 1 2 3 .     (drawn without its first cell)
TEST(Ray, Octants) {
  EXPECT_EQ(bresenham({0, 0}, {5, 2}),
            (Cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}}));
  EXPECT_EQ(bresenham({0, 0}, {2, 5}),
            (Cells{{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 5}}));
  EXPECT_EQ(bresenham({0, 0}, {-2, 5}),
            (Cells{{0, 0}, {0, 1}, {-1, 2}, {-1, 3}, {-2, 4}, {-2, 5}}));
  EXPECT_EQ(bresenham({0, 0}, {-5, 2}),
            (Cells{{0, 0}, {-1, 0}, {-2, 1}, {-3, 1}, {-4, 2}, {-5, 2}}));
  EXPECT_EQ(bresenham({0, 0}, {-5, -2}),
            (Cells{{0, 0}, {-1, 0}, {-2, -1}, {-3, -1}, {-4, -2}, {-5, -2}}));
  EXPECT_EQ(bresenham({0, 0}, {-2, -5}),
            (Cells{{0, 0}, {0, -1}, {-1, -2}, {-1, -3}, {-2, -4}, {-2, -5}}));
  EXPECT_EQ(bresenham({0, 0}, {2, -5}),
            (Cells{{0, 0}, {0, -1}, {1, -2}, {1, -3}, {2, -4}, {2, -5}}));
  EXPECT_EQ(bresenham({0, 0}, {5, -2}),
            (Cells{{0, 0}, {1, 0}, {2, -1}, {3, -1}, {4, -2}, {5, -2}}));
}

// Half a cell is not enough for a step aside, so that the way back is another
// one.
TEST(Ray, Ties) {
  EXPECT_EQ(bresenham({0, 0}, {2, 1}), (Cells{{0, 0}, {1, 0}, {2, 1}}));
  EXPECT_EQ(bresenham({2, 1}, {0, 0}), (Cells{{2, 1}, {1, 1}, {0, 0}}));
  EXPECT_EQ(bresenham({0, 0}, {1, 2}), (Cells{{0, 0}, {0, 1}, {1, 2}}));
  EXPECT_EQ(bresenham({0, 0}, {-4, -2}),
            (Cells{{0, 0}, {-1, 0}, {-2, -1}, {-3, -1}, {-4, -2}}));
}

TEST(Ray, ClosedForm) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> anywhere(-60, 60);
  for (int i = 0; i < 20000; ++i) {
    const Cell from{anywhere(random), anywhere(random)};
    const Cell to{anywhere(random), anywhere(random)};
    const Cells cells = bresenham(from, to);
    const occgrid::Line line(from, to);
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(line.a + 1));
    for (std::int64_t k = 0; k <= line.a; ++k) {
      const std::int64_t minor =
          line.a == 0 ? 0 : (2 * k * line.b + line.a - 1) / (2 * line.a);
      const Cell cell =
          line.along_x
              ? Cell{from.gx + line.sx * k, from.gy + line.sy * minor}
              : Cell{from.gx + line.sx * minor, from.gy + line.sy * k};
      ASSERT_EQ(cells[static_cast<std::size_t>(k)], cell);
    }
  }
}

TEST(Ray, ClipRayFindsTheStepsInside) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> anywhere(-30, 50);
  std::uniform_int_distribution<std::int64_t> size(1, 25);
  int missed = 0;
  for (int i = 0; i < 50000; ++i) {
    const Cell from{anywhere(random), anywhere(random)};
    const Cell to{anywhere(random), anywhere(random)};
    const std::int64_t width = size(random), height = size(random);
    const Cells cells = bresenham(from, to);
    const auto inside = [&](Cell c) {
      return c.gx >= 0 && c.gx < width && c.gy >= 0 && c.gy < height;
    };
    const auto steps =
        occgrid::clip_ray(occgrid::Line(from, to), width, height);
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

// As far out as the contract allows: 2e9 cells from the grid.
TEST(Ray, ClipRayFarOut) {
  const auto far =
      occgrid::Line({2000000000, 2000000000}, {2001000000, 1999500000});
  const auto missed = occgrid::clip_ray(far, 5000, 5000);
  EXPECT_LT(missed.last, missed.first);
  const auto across = occgrid::Line({-400000, -100000}, {600000, 150001});
  const auto steps = occgrid::clip_ray(across, 5000, 5000);
  EXPECT_EQ(steps.first, 400000);
  EXPECT_EQ(steps.last, 404999);
}

}  // namespace
