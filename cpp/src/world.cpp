#include "occgrid/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "occgrid/portable_math.hpp"

namespace occgrid {

// [snippet: box-world]
std::vector<Segment> build_box_world(double xmin, double ymin, double xmax,
                                     double ymax) {
  return {
      {xmin, ymin, xmax, ymin},
      {xmax, ymin, xmax, ymax},
      {xmax, ymax, xmin, ymax},
      {xmin, ymax, xmin, ymin},
  };
}

Segment add_vertical_wall(double x, double y0, double y1) {
  return {x, y0, x, y1};
}

Segment add_horizontal_wall(double y, double x0, double x1) {
  return {x0, y, x1, y};
}
// [/snippet]

// [snippet: ray-segment-intersection]
double ray_segment_intersection(double rx, double ry, double rdx, double rdy,
                                const Segment& wall) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double sx = wall.x1 - wall.x0, sy = wall.y1 - wall.y0;
  const double rxs = rdx * sy - rdy * sx;
  if (std::fabs(rxs) < 1e-12) return none;  // parallel
  const double qpx = wall.x0 - rx, qpy = wall.y0 - ry;
  const double t = (qpx * sy - qpy * sx) / rxs;
  const double u = (qpx * rdy - qpy * rdx) / rxs;
  return t >= 0.0 && u >= 0.0 && u <= 1.0 ? t : none;
}
// [/snippet]

// [snippet: simulate-lidar-scan]
Eigen::ArrayXd simulate_lidar_scan(const Pose& pose,
                                   const std::vector<Segment>& walls,
                                   const Eigen::ArrayXd& angles,
                                   double z_max) {
  Eigen::ArrayXd ranges(angles.size());
  for (Eigen::Index i = 0; i < angles.size(); ++i) {
    const double beam = pose.theta + angles[i];
    const double rdx = cos(beam), rdy = sin(beam);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& wall : walls) {
      const double t =
          ray_segment_intersection(pose.x, pose.y, rdx, rdy, wall);
      nearest = std::min(nearest, t);
    }
    ranges[i] = nearest <= z_max ? nearest : z_max;
  }
  return ranges;
}
// [/snippet]

}  // namespace occgrid
