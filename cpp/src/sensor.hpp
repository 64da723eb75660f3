// The range sensor: bearings, what a range means, and the update of the grid
// (lesson section 4).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "grid.hpp"
#include "world.hpp"

namespace occgrid {

/// What a range without return says: the beam is free all along, or nothing.
enum class NoReturn { free, ignore };

/// One scan: the sensor's pose, bearings (n) in radians from its heading,
/// ranges (n) in metres.
struct Scan {
  Pose pose;
  Eigen::ArrayXd angles;
  Eigen::ArrayXd ranges;
};

/// What the ranges of a scan mean, beam by beam: each (n).
struct Readings {
  Eigen::ArrayXd z;  ///< length of the beam, metres
  Eigen::Array<bool, Eigen::Dynamic, 1>
      hit;  ///< whether something stands at its end
  Eigen::Array<bool, Eigen::Dynamic, 1> used;  ///< whether it says anything
};

/// World points where the beams of a scan end: each (n), metres.
struct Endpoints {
  Eigen::ArrayXd x;
  Eigen::ArrayXd y;
};

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

/// Bearings (n_beams, radians) of a simulated scan over `fov` radians.
Eigen::ArrayXd beam_angles(double fov, Eigen::Index n_beams);

/// Bearings (n_beams, radians) of a FLASER scan: its step is known by its
/// count.
Eigen::ArrayXd flaser_angles(Eigen::Index n_beams);

/// What ranges (n, metres) mean. NaN is ignored. At z_max or beyond nothing
/// was hit (lesson section 7, Problem 3): the beam is free up to z_max, or
/// ignored.
Readings read_ranges(const Eigen::ArrayXd& ranges, double z_max,
                     NoReturn no_return);

/// Where beams of length z (n, metres) along bearings `angles` (n, radians)
/// from a pose end.
Endpoints beam_endpoints(const Pose& pose, const Eigen::ArrayXd& angles,
                         const Eigen::ArrayXd& z);

/// The inverse sensor model: free along each beam, occupied at its hit. What
/// lies outside the grid is skipped. A beam may cross 2^20 cells of the grid;
/// a longer one throws std::length_error.
void update_grid_from_scan(OccupancyGrid& grid, const Scan& scan, double z_max,
                           NoReturn no_return = NoReturn::free);

/// Appends the beams of a scan, in order, without those that say nothing.
void append_beams(std::vector<Beam>& beams, const OccupancyGrid& grid,
                  const Scan& scan, double z_max, NoReturn no_return);

/// update_grid_from_scan for beams of any number of scans, in order, but only
/// for some rows of the grid.
void update_rows_from_beams(OccupancyGrid& grid,
                            const std::vector<Beam>& beams, Rows rows);

}  // namespace occgrid
