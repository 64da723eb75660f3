#include "grid.hpp"

#include <algorithm>
#include <cmath>

#include "portable_math.hpp"

namespace occgrid {

// [snippet: logit]
double logit(double p) {
  const double q = std::clamp(p, 1e-9, 1.0 - 1e-9);
  return log(q / (1.0 - q));
}
// [/snippet]

// [snippet: sigmoid]
double sigmoid(double log_odds) {
  const double z = exp(-std::fabs(log_odds));
  return (log_odds >= 0.0 ? 1.0 : z) / (1.0 + z);
}
// [/snippet]

OccupancyGrid::OccupancyGrid(const GridSpec& spec_, double p0, double p_occ,
                             double p_free, double l_min_, double l_max_)
    : spec(spec_),
      l0(logit(p0)),
      l_occ(logit(p_occ)),
      l_free(logit(p_free)),
      l_min(l_min_),
      l_max(l_max_),
      log_odds(GridArray::Constant(spec.height, spec.width, l0)) {}

// [snippet: world-to-grid]
Cell OccupancyGrid::world_to_grid(double x, double y) const {
  const double gx = std::floor((x - spec.origin_x) / spec.resolution);
  const double gy = std::floor((y - spec.origin_y) / spec.resolution);
  return {static_cast<std::int64_t>(gx), static_cast<std::int64_t>(gy)};
}

Point OccupancyGrid::grid_to_world_center(Cell cell) const {
  const auto gx = static_cast<double>(cell.gx);
  const auto gy = static_cast<double>(cell.gy);
  return {spec.origin_x + (gx + 0.5) * spec.resolution,
          spec.origin_y + (gy + 0.5) * spec.resolution};
}

bool OccupancyGrid::in_bounds(Cell cell) const {
  return 0 <= cell.gx && cell.gx < spec.width &&  //
         0 <= cell.gy && cell.gy < spec.height;
}
// [/snippet]

// [snippet: update-cell]
void OccupancyGrid::update_cell(Cell cell, double l_update) {
  if (!in_bounds(cell)) return;
  double& l = log_odds(cell.gy, cell.gx);
  l = std::clamp(l + (l_update - l0), l_min, l_max);
}
// [/snippet]

// [snippet: probability-grid]
GridArray OccupancyGrid::probability_grid() const {
  // not Eigen's exp(): that is a polynomial with other last bits
  return log_odds.unaryExpr([](double l) { return sigmoid(l); });
}
// [/snippet]

}  // namespace occgrid
