// The range sensor: bearings, what a range means, and the update of the grid
// (lesson section 4).
#pragma once

#include <Eigen/Core>

#include "occgrid/grid.hpp"
#include "occgrid/world.hpp"

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

/// A yes or no for each beam: (n).
using Flags = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// What the ranges of a scan mean, beam by beam: each (n).
struct Readings {
  Eigen::ArrayXd z;  ///< length of the beam, metres
  Flags hit;         ///< whether something stands at its end
  Flags used;        ///< whether it says anything
};

/// World points where the beams of a scan end: each (n), metres.
struct Endpoints {
  Eigen::ArrayXd ex;
  Eigen::ArrayXd ey;
};

/// Bearings (n_beams, radians) of a simulated scan over `fov` radians.
Eigen::ArrayXd beam_angles(double fov, Eigen::Index n_beams);

/// Bearings (n_beams, radians) of a FLASER scan: its step is known by its
/// count (SPEC.md section 5.3).
Eigen::ArrayXd flaser_angles(Eigen::Index n_beams);

/// What ranges (n, metres) mean. NaN is ignored. At z_max or beyond nothing
/// was hit (lesson section 7, Problem 3): the beam is free up to z_max, or
/// ignored.
Readings read_ranges(const Eigen::ArrayXd& ranges, double z_max,
                     NoReturn no_return);

/// Where beams of length z (n, metres) along bearings `angles` (n, radians)
/// from a pose end. Throws std::invalid_argument where the counts differ.
Endpoints beam_endpoints(const Pose& pose, const Eigen::ArrayXd& angles,
                         const Eigen::ArrayXd& z);

/// The inverse sensor model (lesson section 4): free along each beam, occupied
/// at its hit. What lies outside the grid is skipped. Throws
/// std::length_error at a beam of more than 2^20 steps, and
/// std::invalid_argument where there are not as many bearings as ranges.
void update_grid_from_scan(OccupancyGrid& grid, const Scan& scan, double z_max,
                           NoReturn no_return = NoReturn::free);

}  // namespace occgrid
