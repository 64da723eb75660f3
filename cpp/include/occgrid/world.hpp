// The simulated world: walls, ray casting, range scans (lesson section 6).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace occgrid {

/// Where the robot (or its laser) stands: metres and radians.
struct Pose {
  double x;
  double y;
  double theta;
};

/// A wall from (x0, y0) to (x1, y1), metres.
struct Segment {
  double x0;
  double y0;
  double x1;
  double y1;
};

/// The four walls of a rectangle (metres), counterclockwise from the lower
/// one.
std::vector<Segment> build_box_world(double xmin, double ymin, double xmax,
                                     double ymax);

/// A wall along y.
Segment add_vertical_wall(double x, double y0, double y1);

/// A wall along x.
Segment add_horizontal_wall(double y, double x0, double x1);

/// Distance (metres) at which the ray from (rx, ry) in the direction (rdx,
/// rdy), of length 1, meets a wall; infinity where it is parallel or misses.
double ray_segment_intersection(double rx, double ry, double rdx, double rdy,
                                const Segment& wall);

/// Ranges (n, metres) along bearings `angles` (n, radians) from a pose. A beam
/// that meets no wall within z_max reads z_max.
Eigen::ArrayXd simulate_lidar_scan(const Pose& pose,
                                   const std::vector<Segment>& walls,
                                   const Eigen::ArrayXd& angles, double z_max);

}  // namespace occgrid
