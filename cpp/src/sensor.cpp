#include "sensor.hpp"

#include <algorithm>
#include <stdexcept>

#include "portable_math.hpp"
#include "ray.hpp"

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
  Endpoints ends{Eigen::ArrayXd(z.size()), Eigen::ArrayXd(z.size())};
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const SinCos beam = sin_cos(pose.theta + angles[i]);
    ends.x[i] = pose.x + z[i] * beam.cos;
    ends.y[i] = pose.y + z[i] * beam.sin;
  }
  return ends;
}
// [/snippet]

namespace {

constexpr int fraction_bits = 42;
constexpr std::int64_t max_steps = std::int64_t{1} << 20;

/// numerator / denominator in units of 2^-42: above the quotient, by little
/// more than one unit at most.
std::int64_t rounded_up(std::int64_t numerator, std::int64_t denominator) {
  const double scaled = static_cast<double>(numerator) * 0x1p42;
  return static_cast<std::int64_t>(scaled / static_cast<double>(denominator)) +
         1;
}

/// Replaces l by update(l) in some steps of a line, all in the grid.
///
/// This is the line in closed form (SPEC.md section 2.4), with minor(k) as the
/// upper bits of a number that grows by b / a with every step. bresenham's
/// error counter would make each step wait for the one before.
///
/// Both the number's start and its growth are rounded up, so that the k-th
/// step finds it too great by little more than k + 1 units of 2^-42. With at
/// most 2^20 steps this is less than 1 / (2 a), hence the number does not
/// reach the next multiple of 1 / (2 a), and its upper bits are exact.
template <typename Update>
void update_steps(GridArray& log_odds, const Line& line, Steps steps,
                  Update update) {
  if (steps.last < steps.first) return;
  if (line.a > max_steps) {
    throw std::length_error("a beam is longer than 2^20 cells");
  }
  const std::int64_t step_x = line.sx;
  const std::int64_t step_y = line.sy * log_odds.cols();
  const std::int64_t step_major = line.along_x ? step_x : step_y;
  const std::int64_t step_minor = line.along_x ? step_y : step_x;

  const std::int64_t twice_a = std::max<std::int64_t>(2 * line.a, 1);
  std::int64_t minor = 0;
  std::int64_t rest = std::max<std::int64_t>(line.a - 1, 0);
  if (steps.first > 0) {
    const std::int64_t start = 2 * steps.first * line.b + rest;
    minor = start / twice_a;
    rest = start % twice_a;
  }
  const std::int64_t slope = rounded_up(2 * line.b, twice_a);
  std::int64_t position = rounded_up(rest, twice_a);
  const std::int64_t cell = line.from.gy * log_odds.cols() + line.from.gx +
                            steps.first * step_major + minor * step_minor;
  // the line's cell without the steps along its shorter axis
  double* at = log_odds.data() + cell;
  for (std::int64_t left = steps.last - steps.first;; --left) {
    double& value = at[(position >> fraction_bits) * step_minor];
    value = update(value);
    if (left == 0) return;
    at += step_major;
    position += slope;
  }
}

/// Adds the evidence l_update - l0 to the cells of some steps of a line, all
/// in the grid. All of it has one sign and every cell lies within the bounds
/// before, so that only one bound can be crossed. Written in this order, each
/// comparison is one instruction of the processor (maxsd, minsd).
void update_line(OccupancyGrid& grid, const Line& line, Steps steps,
                 double l_update) {
  const double delta = l_update - grid.l0;
  const double l_min = grid.l_min, l_max = grid.l_max;
  if (delta < 0.0) {
    update_steps(grid.log_odds, line, steps, [=](double l) {
      return l + delta > l_min ? l + delta : l_min;
    });
  } else {
    update_steps(grid.log_odds, line, steps, [=](double l) {
      return l + delta < l_max ? l + delta : l_max;
    });
  }
}

}  // namespace

// [snippet: update-grid-from-scan]
void update_grid_from_scan(OccupancyGrid& grid, const Scan& scan, double z_max,
                           NoReturn no_return) {
  const Readings readings = read_ranges(scan.ranges, z_max, no_return);
  const Endpoints ends = beam_endpoints(scan.pose, scan.angles, readings.z);
  const Cell robot = grid.world_to_grid(scan.pose.x, scan.pose.y);
  const GridSpec& spec = grid.spec;
  for (Eigen::Index i = 0; i < ends.x.size(); ++i) {
    if (!readings.used[i]) continue;
    const Cell end = grid.world_to_grid(ends.x[i], ends.y[i]);
    const Line line(robot, end);
    Steps free = clip_ray(line, spec.width, spec.height);
    if (readings.hit[i]) free.last = std::min(free.last, line.a - 1);
    update_line(grid, line, free, grid.l_free);
    if (readings.hit[i]) grid.update_cell(end, grid.l_occ);
  }
}
// [/snippet]

void append_beams(std::vector<Beam>& beams, const OccupancyGrid& grid,
                  const Scan& scan, double z_max, NoReturn no_return) {
  const Readings readings = read_ranges(scan.ranges, z_max, no_return);
  const Endpoints ends = beam_endpoints(scan.pose, scan.angles, readings.z);
  const Cell robot = grid.world_to_grid(scan.pose.x, scan.pose.y);
  for (Eigen::Index i = 0; i < ends.x.size(); ++i) {
    if (!readings.used[i]) continue;
    const Cell end = grid.world_to_grid(ends.x[i], ends.y[i]);
    beams.push_back({robot, end, readings.hit[i]});
  }
}

void update_rows_from_beams(OccupancyGrid& grid,
                            const std::vector<Beam>& beams, Rows rows) {
  for (const Beam& beam : beams) {
    const auto [low, high] = std::minmax(beam.robot.gy, beam.end.gy);
    if (high < rows.first || rows.last < low) continue;
    const Line line(beam.robot, beam.end);
    // the rows as a grid of their own; a copy of the line would be slower
    const Line above({beam.robot.gx, beam.robot.gy - rows.first},
                     {beam.end.gx, beam.end.gy - rows.first});
    Steps free = clip_ray(above, grid.spec.width, rows.last - rows.first + 1);
    if (beam.hit) free.last = std::min(free.last, line.a - 1);
    update_line(grid, line, free, grid.l_free);
    const bool ends_here =
        rows.first <= beam.end.gy && beam.end.gy <= rows.last;
    if (beam.hit && ends_here) grid.update_cell(beam.end, grid.l_occ);
  }
}

}  // namespace occgrid
