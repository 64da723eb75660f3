#include "occgrid/grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "occgrid/exact_arithmetic.hpp"
#include "occgrid/portable_math.hpp"

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

namespace {

void require(bool holds, const std::string& rule) {
  if (!holds) throw std::invalid_argument("OccupancyGrid: " + rule);
}

/// NaN is none.
bool is_probability(double p) {
  return p >= 0.0 && p <= 1.0;
}

GridSpec checked(const GridSpec& spec) {
  require(spec.width >= 1 && spec.height >= 1,
          "width and height are at least 1");
  require(spec.width <= std::int64_t{PTRDIFF_MAX / 8} / spec.height,
          "so many cells do not fit into memory");
  require(std::isfinite(spec.resolution) && spec.resolution > 0.0,
          "the resolution is positive");
  require(std::isfinite(spec.origin_x) && std::isfinite(spec.origin_y),
          "the origin is finite");
  return spec;
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridSpec& spec, double p0, double p_occ,
                             double p_free, double l_min, double l_max)
    : spec_(checked(spec)),
      l0_(logit(p0)),
      l_occ_(logit(p_occ)),
      l_free_(logit(p_free)),
      l_min_(l_min),
      l_max_(l_max) {
  require_exact_arithmetic();
  require(
      is_probability(p0) && is_probability(p_occ) && is_probability(p_free),
      "p0, p_occ and p_free are from 0 to 1");
  require(std::isfinite(l_min) && std::isfinite(l_max) && l_min < l_max,
          "l_min is below l_max");
  require(l_min <= l0_ && l0_ <= l_max, "logit(p0) is from l_min to l_max");
  log_odds_ = GridArray::Constant(static_cast<Eigen::Index>(spec.height),
                                  static_cast<Eigen::Index>(spec.width), l0_);
}

// [snippet: world-to-grid]
Cell OccupancyGrid::world_to_grid(double x, double y) const {
  const double gx = std::floor((x - spec_.origin_x) / spec_.resolution);
  const double gy = std::floor((y - spec_.origin_y) / spec_.resolution);
  return {static_cast<std::int64_t>(gx), static_cast<std::int64_t>(gy)};
}
// [/snippet]

Point OccupancyGrid::grid_to_world_center(std::int64_t gx,
                                          std::int64_t gy) const {
  const double x = static_cast<double>(gx) + 0.5;
  const double y = static_cast<double>(gy) + 0.5;
  return {spec_.origin_x + x * spec_.resolution,
          spec_.origin_y + y * spec_.resolution};
}

// [snippet: update-cell]
bool OccupancyGrid::in_bounds(std::int64_t gx, std::int64_t gy) const {
  return 0 <= gx && gx < spec_.width && 0 <= gy && gy < spec_.height;
}

void OccupancyGrid::update_cell(std::int64_t gx, std::int64_t gy,
                                double l_update) {
  if (!in_bounds(gx, gy)) return;
  double& l =
      log_odds_(static_cast<Eigen::Index>(gy), static_cast<Eigen::Index>(gx));
  l = std::clamp(l + (l_update - l0_), l_min_, l_max_);
}
// [/snippet]

// [snippet: probability-grid]
GridArray OccupancyGrid::probability_grid() const {
  // not Eigen's exp(): that is a polynomial with other last bits
  return log_odds_.unaryExpr([](double l) { return sigmoid(l); });
}
// [/snippet]

}  // namespace occgrid
