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

/// Log-odds of a probability, which is kept within [1e-9, 1 - 1e-9] (lesson
/// section 3).
double logit(double p);

/// Probability of log-odds; no overflow at either end.
double sigmoid(double log_odds);

/// Log-odds of every cell, and the evidence that an update adds (lesson
/// section 3). A value: a copy has cells of its own.
///
/// Every cell starts at l0 = logit(p0). l_min and l_max bound each cell after
/// each update.
class OccupancyGrid {
 public:
  /// Throws std::invalid_argument where a size is below 1, the resolution is
  /// not positive, a number is NaN or infinite, a probability is not from 0
  /// to 1, or l_min <= l0 <= l_max and l_min < l_max do not hold; and
  /// std::runtime_error where the library's arithmetic is not IEEE's
  /// (exact_arithmetic.hpp).
  explicit OccupancyGrid(const GridSpec& spec, double p0 = 0.5,
                         double p_occ = 0.75, double p_free = 0.30,
                         double l_min = -8.0, double l_max = 8.0);

  /// The cell of a point in metres; it may lie outside. Coordinates must be
  /// finite, and less than 2^62 cells from the origin.
  Cell world_to_grid(double x, double y) const;

  /// Centre of a cell in metres.
  Point grid_to_world_center(std::int64_t gx, std::int64_t gy) const;

  /// Whether a cell lies in the grid.
  bool in_bounds(std::int64_t gx, std::int64_t gy) const;

  /// Adds the evidence l_update - l0 to one cell and clamps it. A cell outside
  /// the grid is skipped.
  void update_cell(std::int64_t gx, std::int64_t gy, double l_update);

  /// P(occupied) of every cell, (height, width).
  GridArray probability_grid() const;

  const GridSpec& spec() const { return spec_; }
  double l0() const { return l0_; }          ///< log-odds of the prior
  double l_occ() const { return l_occ_; }    ///< logit(p_occ)
  double l_free() const { return l_free_; }  ///< logit(p_free)
  double l_min() const { return l_min_; }
  double l_max() const { return l_max_; }

  /// Log-odds of every cell, (height, width). They change by updates alone:
  /// the fast path relies on their bounds.
  const GridArray& log_odds() const { return log_odds_; }

 private:
  friend class LineUpdate;  // of fast.cpp: many cells, checked beforehand

  GridSpec spec_;
  double l0_, l_occ_, l_free_;
  double l_min_, l_max_;
  GridArray log_odds_;
};

}  // namespace occgrid
