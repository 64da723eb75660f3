#include "occgrid/ray.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace occgrid {

// [snippet: bresenham]
std::vector<Cell> bresenham(std::int64_t gx0, std::int64_t gy0,
                            std::int64_t gx1, std::int64_t gy1) {
  const std::int64_t dx = std::abs(gx1 - gx0), dy = std::abs(gy1 - gy0);
  const std::int64_t sx = gx0 < gx1 ? 1 : -1, sy = gy0 < gy1 ? 1 : -1;
  const std::int64_t steps = std::max(dx, dy);
  if (steps > max_steps) throw std::length_error("a line of over 2^20 steps");
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(steps) + 1);
  std::int64_t err = dx - dy;
  std::int64_t gx = gx0, gy = gy0;
  while (true) {
    cells.push_back({gx, gy});
    if (gx == gx1 && gy == gy1) return cells;
    const std::int64_t e2 = 2 * err;
    if (e2 > -dy) {
      err -= dy;
      gx += sx;
    }
    if (e2 < dx) {
      err += dx;
      gy += sy;
    }
  }
}
// [/snippet]

}  // namespace occgrid
