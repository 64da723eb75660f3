// The grid of log-odds (lesson sections 1 and 3).
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace occgrid {

// [snippet: grid-spec]
/// Where the cells lie in the world (lesson section 1).
struct GridSpec {
  std::int64_t width;   ///< number of columns
  std::int64_t height;  ///< number of rows
  double resolution;    ///< side of a cell, metres
  double origin_x;      ///< world x of the lower left corner, metres
  double origin_y;      ///< world y of the lower left corner, metres
};
// [/snippet]

/// Column and row of a cell; it may lie outside the grid.
struct Cell {
  std::int64_t gx;
  std::int64_t gy;
};

inline bool operator==(Cell a, Cell b) {
  return a.gx == b.gx && a.gy == b.gy;
}

/// A point of the world, metres.
struct Point {
  double x;
  double y;
};

/// One number for each cell, (height, width), row 0 with the smallest y.
using GridArray =
    Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Log-odds of a probability, which is kept within [1e-9, 1 - 1e-9].
double logit(double p);

/// Probability of log-odds; no overflow at either end.
double sigmoid(double log_odds);

/// Log-odds of every cell, and the evidence that an update adds (lesson
/// section 3).
///
/// Every cell starts at l0 = logit(p0). l_min and l_max bound each cell after
/// each update; l0 lies between them.
class OccupancyGrid {
 public:
  explicit OccupancyGrid(const GridSpec& spec, double p0 = 0.5,
                         double p_occ = 0.75, double p_free = 0.30,
                         double l_min = -8.0, double l_max = 8.0);

  /// The cell of a point in metres; it may lie outside. Coordinates must be
  /// finite, and less than 2^62 cells from the origin.
  Cell world_to_grid(double x, double y) const;

  /// Centre of a cell in metres.
  Point grid_to_world_center(Cell cell) const;

  /// Whether a cell lies in the grid.
  bool in_bounds(Cell cell) const;

  /// Adds the evidence l_update - l0 to one cell and clamps it. A cell outside
  /// the grid is skipped.
  void update_cell(Cell cell, double l_update);

  /// P(occupied) of every cell, (height, width).
  GridArray probability_grid() const;

  const GridSpec spec;
  const double l0, l_occ, l_free;
  const double l_min, l_max;
  GridArray log_odds;
};

}  // namespace occgrid
