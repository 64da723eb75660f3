// Beams as lines of cells, for the fast path.
#pragma once

#include <cstdint>
#include <vector>

#include "occgrid/grid.hpp"
#include "occgrid/sensor.hpp"

namespace occgrid {

/// A beam that says something, in cells; both may lie outside the grid.
struct Beam {
  Cell robot;  ///< where it begins
  Cell end;    ///< where it ends
  bool hit;    ///< whether something stands there
};

/// Rows first .. last of a grid; none where last < first.
struct Rows {
  std::int64_t first;
  std::int64_t last;
};

/// Appends the beams of a scan, in order, without those that say nothing.
/// Throws as update_grid_from_scan does.
void append_beams(std::vector<Beam>& beams, const OccupancyGrid& grid,
                  const Scan& scan, double z_max, NoReturn no_return);

/// Updates some rows of the grid, none of the others, by beams in order.
void update_rows_from_beams(OccupancyGrid& grid,
                            const std::vector<Beam>& beams, Rows rows);

}  // namespace occgrid
