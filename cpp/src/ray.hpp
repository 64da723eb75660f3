// Which cells a beam crosses: Bresenham's line (lesson section 4, line
// traversal).
#pragma once

#include <cstdint>
#include <vector>

#include "grid.hpp"

namespace occgrid {

/// Cells of the line between two cells, both included, in order: Bresenham's
/// integer line (1965).
///
/// Step k goes k cells along the longer axis and floor((2 k b + a - 1) / (2
/// a)) along the shorter one, where a and b are the line's extents along the
/// two.
std::vector<Cell> bresenham(Cell from, Cell to);

/// A line of cells by its start, extents and directions.
struct Line {
  Line(Cell from, Cell to);

  Cell from;
  std::int64_t a;   ///< cells to go along the longer axis
  std::int64_t b;   ///< cells to go along the shorter axis
  std::int64_t sx;  ///< 1 or -1
  std::int64_t sy;  ///< 1 or -1
  bool along_x;  ///< whether x is the longer axis; it is where both are equal
};

/// Steps first .. last of a line; none where last < first.
struct Steps {
  std::int64_t first;
  std::int64_t last;
};

/// The steps of a line, 0 .. a, that lie in a grid of width x height cells; no
/// cell outside is visited.
Steps clip_ray(const Line& line, std::int64_t width, std::int64_t height);

}  // namespace occgrid
