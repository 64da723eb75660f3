#include "occgrid/sensor.hpp"

#include <stdexcept>
#include <vector>

#include "occgrid/portable_math.hpp"
#include "occgrid/ray.hpp"

namespace occgrid {

// Bearings are written out: Eigen's LinSpaced has a formula of its own.

// [snippet: beam-angles]
Eigen::ArrayXd beam_angles(double fov, Eigen::Index n_beams) {
  if (n_beams == 1) return Eigen::ArrayXd::Zero(1);
  const auto last = static_cast<double>(n_beams - 1);
  return Eigen::ArrayXd::NullaryExpr(n_beams, [=](Eigen::Index i) {
    return -(fov / 2.0) + (fov * static_cast<double>(i)) / last;
  });
}
// [/snippet]

// [snippet: flaser-angles]
Eigen::ArrayXd flaser_angles(Eigen::Index n_beams) {
  double step = 0.0;
  if (n_beams == 180 || n_beams == 181) {
    step = pi / 180.0;
  } else if (n_beams == 360 || n_beams == 361) {
    step = pi / 360.0;
  } else if (n_beams == 400 || n_beams == 401) {
    step = pi / 720.0;
  } else if (n_beams > 1) {
    step = pi / static_cast<double>(n_beams - 1);
  }
  return Eigen::ArrayXd::NullaryExpr(n_beams, [=](Eigen::Index i) {
    return -(pi / 2.0) + static_cast<double>(i) * step;
  });
}
// [/snippet]

// [snippet: read-ranges]
Readings read_ranges(const Eigen::ArrayXd& ranges, double z_max,
                     NoReturn no_return) {
  Readings readings;
  readings.hit = ranges < z_max - 1e-12;
  readings.z = readings.hit.select(ranges, z_max);
  if (no_return == NoReturn::ignore) {
    readings.used = readings.hit;
  } else {
    readings.used = ranges == ranges;  // not NaN
  }
  return readings;
}
// [/snippet]

// [snippet: beam-endpoints]
Endpoints beam_endpoints(const Pose& pose, const Eigen::ArrayXd& angles,
                         const Eigen::ArrayXd& z) {
  const Eigen::Index n = z.size();
  if (angles.size() != n)
    throw std::invalid_argument("angles and ranges differ in number");
  Endpoints ends{Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const double a = pose.theta + angles[i];
    ends.ex[i] = pose.x + z[i] * cos(a);
    ends.ey[i] = pose.y + z[i] * sin(a);
  }
  return ends;
}
// [/snippet]

// [snippet: update-grid-from-scan]
void update_grid_from_scan(OccupancyGrid& grid, const Scan& scan, double z_max,
                           NoReturn no_return) {
  const auto [z, hit, used] = read_ranges(scan.ranges, z_max, no_return);
  const auto [ex, ey] = beam_endpoints(scan.pose, scan.angles, z);
  const auto [gx0, gy0] = grid.world_to_grid(scan.pose.x, scan.pose.y);
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    if (!used[i]) continue;
    const auto [gx1, gy1] = grid.world_to_grid(ex[i], ey[i]);
    const std::vector<Cell> cells = bresenham(gx0, gy0, gx1, gy1);
    // the cells before the hit
    const std::size_t n_free = hit[i] ? cells.size() - 1 : cells.size();
    for (std::size_t k = 0; k < n_free; ++k) {
      grid.update_cell(cells[k].gx, cells[k].gy, grid.l_free());
    }
    if (hit[i]) grid.update_cell(gx1, gy1, grid.l_occ());
  }
}
// [/snippet]

}  // namespace occgrid
