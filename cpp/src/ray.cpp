#include "ray.hpp"

#include <algorithm>
#include <cstdlib>

namespace occgrid {

// [snippet: bresenham]
std::vector<Cell> bresenham(Cell from, Cell to) {
  const std::int64_t dx = std::abs(to.gx - from.gx);
  const std::int64_t dy = std::abs(to.gy - from.gy);
  const std::int64_t sx = from.gx < to.gx ? 1 : -1;
  const std::int64_t sy = from.gy < to.gy ? 1 : -1;
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(std::max(dx, dy)) + 1);
  std::int64_t err = dx - dy;
  for (Cell cell = from;;) {
    cells.push_back(cell);
    if (cell == to) return cells;
    const std::int64_t e2 = 2 * err;
    if (e2 > -dy) {
      err -= dy;
      cell.gx += sx;
    }
    if (e2 < dx) {
      err += dx;
      cell.gy += sy;
    }
  }
}
// [/snippet]

Line::Line(Cell from_, Cell to)
    : from(from_), sx(from.gx < to.gx ? 1 : -1), sy(from.gy < to.gy ? 1 : -1) {
  const std::int64_t dx = std::abs(to.gx - from.gx);
  const std::int64_t dy = std::abs(to.gy - from.gy);
  along_x = dx >= dy;
  a = along_x ? dx : dy;
  b = along_x ? dy : dx;
}

// [snippet: clip-ray]
namespace {

/// Fewest and most cells to go from g in direction s to be in 0 .. size-1.
Steps steps_inside(std::int64_t g, std::int64_t s, std::int64_t size) {
  return s > 0 ? Steps{-g, size - 1 - g} : Steps{g - (size - 1), g};
}

/// The first step that has gone m cells along the shorter axis: step k has
/// gone so far, or farther, exactly when 2 k b >= 2 a m - a + 1.
std::int64_t first_step(std::int64_t m, std::int64_t a, std::int64_t b) {
  if (m <= 0) return 0;
  if (m > b) return a + 1;  // never
  return (2 * a * m - a + 2 * b) / (2 * b);
}

}  // namespace

Steps clip_ray(const Line& line, std::int64_t width, std::int64_t height) {
  Steps major = steps_inside(line.from.gx, line.sx, width);
  Steps minor = steps_inside(line.from.gy, line.sy, height);
  if (!line.along_x) std::swap(major, minor);
  const std::int64_t enters = first_step(minor.first, line.a, line.b);
  const std::int64_t leaves = first_step(minor.last + 1, line.a, line.b);
  return {std::max({std::int64_t{0}, major.first, enters}),
          std::min({line.a, major.last, leaves - 1})};
}
// [/snippet]

}  // namespace occgrid
