// Which cells a beam crosses: Bresenham's line (lesson section 4, line
// traversal).
#pragma once

#include <cstdint>
#include <vector>

#include "occgrid/grid.hpp"

namespace occgrid {

/// The most steps of a line, from each cell to the next.
constexpr std::int64_t max_steps = std::int64_t{1} << 20;

/// Cells of the line from (gx0, gy0) to (gx1, gy1), both included, in order:
/// Bresenham's integer line (1965). Numbers of cells are below 2^61. Throws
/// std::length_error where the line has more than 2^20 steps.
std::vector<Cell> bresenham(std::int64_t gx0, std::int64_t gy0,
                            std::int64_t gx1, std::int64_t gy1);

}  // namespace occgrid
