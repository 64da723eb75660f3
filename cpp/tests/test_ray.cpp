#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <vector>

#include "occgrid/ray.hpp"

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
  EXPECT_EQ(bresenham(3, -4, 3, -4), (Cells{{3, -4}}));
}

TEST(Ray, AxesAndDiagonals) {
  EXPECT_EQ(bresenham(0, 0, 3, 0), (Cells{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  EXPECT_EQ(bresenham(0, 0, 0, -2), (Cells{{0, 0}, {0, -1}, {0, -2}}));
  EXPECT_EQ(bresenham(2, 2, 0, 0), (Cells{{2, 2}, {1, 1}, {0, 0}}));
  EXPECT_EQ(bresenham(0, 0, -2, 2), (Cells{{0, 0}, {-1, 1}, {-2, 2}}));
}

// . . 4 5     a = 5, b = 2: steps up after 2 and after 4; one line in each
// octant 1 2 3 .     (drawn without its first cell)
TEST(Ray, Octants) {
  EXPECT_EQ(bresenham(0, 0, 5, 2),
            (Cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}}));
  EXPECT_EQ(bresenham(0, 0, 2, 5),
            (Cells{{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 5}}));
  EXPECT_EQ(bresenham(0, 0, -2, 5),
            (Cells{{0, 0}, {0, 1}, {-1, 2}, {-1, 3}, {-2, 4}, {-2, 5}}));
  EXPECT_EQ(bresenham(0, 0, -5, 2),
            (Cells{{0, 0}, {-1, 0}, {-2, 1}, {-3, 1}, {-4, 2}, {-5, 2}}));
  EXPECT_EQ(bresenham(0, 0, -5, -2),
            (Cells{{0, 0}, {-1, 0}, {-2, -1}, {-3, -1}, {-4, -2}, {-5, -2}}));
  EXPECT_EQ(bresenham(0, 0, -2, -5),
            (Cells{{0, 0}, {0, -1}, {-1, -2}, {-1, -3}, {-2, -4}, {-2, -5}}));
  EXPECT_EQ(bresenham(0, 0, 2, -5),
            (Cells{{0, 0}, {0, -1}, {1, -2}, {1, -3}, {2, -4}, {2, -5}}));
  EXPECT_EQ(bresenham(0, 0, 5, -2),
            (Cells{{0, 0}, {1, 0}, {2, -1}, {3, -1}, {4, -2}, {5, -2}}));
}

// Half a cell is not enough for a step aside, so that the way back is another
// one.
TEST(Ray, Ties) {
  EXPECT_EQ(bresenham(0, 0, 2, 1), (Cells{{0, 0}, {1, 0}, {2, 1}}));
  EXPECT_EQ(bresenham(2, 1, 0, 0), (Cells{{2, 1}, {1, 1}, {0, 0}}));
  EXPECT_EQ(bresenham(0, 0, 1, 2), (Cells{{0, 0}, {0, 1}, {1, 2}}));
  EXPECT_EQ(bresenham(0, 0, -4, -2),
            (Cells{{0, 0}, {-1, 0}, {-2, -1}, {-3, -1}, {-4, -2}}));
}

TEST(Ray, ClosedForm) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> anywhere(-60, 60);
  for (int i = 0; i < 20000; ++i) {
    const Cell from{anywhere(random), anywhere(random)};
    const Cell to{anywhere(random), anywhere(random)};
    const Cells cells = bresenham(from.gx, from.gy, to.gx, to.gy);
    const std::int64_t dx = std::abs(to.gx - from.gx);
    const std::int64_t dy = std::abs(to.gy - from.gy);
    const std::int64_t a = std::max(dx, dy), b = std::min(dx, dy);
    const std::int64_t sx = from.gx < to.gx ? 1 : -1;
    const std::int64_t sy = from.gy < to.gy ? 1 : -1;
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(a + 1));
    for (std::int64_t k = 0; k <= a; ++k) {
      const std::int64_t minor = a == 0 ? 0 : (2 * k * b + a - 1) / (2 * a);
      const Cell cell = dx >= dy
                            ? Cell{from.gx + sx * k, from.gy + sy * minor}
                            : Cell{from.gx + sx * minor, from.gy + sy * k};
      ASSERT_EQ(cells[static_cast<std::size_t>(k)], cell);
    }
  }
}

TEST(Ray, LongestLine) {
  EXPECT_EQ(bresenham(-7, 5, -7 + (1 << 20), 6).size(), (1u << 20) + 1);
  EXPECT_THROW(bresenham(-7, 5, -7, 6 + (1 << 20)), std::length_error);
  EXPECT_THROW(bresenham(-20000000000, 0, 20000000000, 1), std::length_error);
}

}  // namespace
