#include "occgrid/fast.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "beams.hpp"
#include "occgrid/mapper.hpp"
#include "occgrid/portable_math.hpp"
#include "occgrid/ray.hpp"
#include "scan_pipeline.hpp"

namespace occgrid {

// What makes it fast: a line is cut to the grid beforehand, so that no cell
// outside is visited and no update asks whether its cell is inside; and a line
// is not listed but walked, with one addition for its shorter axis.

namespace {

/// A line of cells by its start, extents and directions.
struct Line {
  Line(Cell from_, Cell to)
      : from(from_),
        sx(from.gx < to.gx ? 1 : -1),
        sy(from.gy < to.gy ? 1 : -1) {
    const std::int64_t dx = std::abs(to.gx - from.gx);
    const std::int64_t dy = std::abs(to.gy - from.gy);
    along_x = dx >= dy;
    a = along_x ? dx : dy;
    b = along_x ? dy : dx;
    if (a > max_steps) throw std::length_error("a line of over 2^20 steps");
  }

  Cell from;
  std::int64_t a;   ///< cells to go along the longer axis
  std::int64_t b;   ///< cells to go along the shorter axis
  std::int64_t sx;  ///< 1 or -1
  std::int64_t sy;  ///< 1 or -1
  bool along_x;  ///< whether x is the longer axis; it is where both are equal
};

}  // namespace

// [snippet: clip-ray]
namespace {

/// Fewest and most cells to go from g in direction s to be in 0 .. size-1.
/// From g = -2 upwards into 5 cells: 2 to 6 of them.
Steps steps_inside(std::int64_t g, std::int64_t s, std::int64_t size) {
  return s > 0 ? Steps{-g, size - 1 - g} : Steps{g - (size - 1), g};
}

/// The first step that has gone m cells along the shorter axis. Step k has
/// gone floor((2 k b + a - 1) / (2 a)) of them (SPEC.md section 2.4), which is
/// m or more exactly when 2 k b >= 2 a m - a + 1. With a = 5, b = 2 it has
/// gone 0 0 1 1 2 2: m = 1 asks for 4 k >= 6, and that is k = 2.
std::int64_t first_step(std::int64_t m, std::int64_t a, std::int64_t b) {
  if (m <= 0) return 0;
  if (m > b) return a + 1;  // never
  return (2 * a * m - a + 2 * b) / (2 * b);
}

Steps clip_line(const Line& line, std::int64_t width, std::int64_t height) {
  Steps major = steps_inside(line.from.gx, line.sx, width);
  Steps minor = steps_inside(line.from.gy, line.sy, height);
  if (!line.along_x) std::swap(major, minor);
  const std::int64_t enters = first_step(minor.first, line.a, line.b);
  const std::int64_t leaves = first_step(minor.last + 1, line.a, line.b);
  return {std::max({std::int64_t{0}, major.first, enters}),
          std::min({line.a, major.last, leaves - 1})};
}

}  // namespace

Steps clip_ray(std::int64_t gx0, std::int64_t gy0, std::int64_t gx1,
               std::int64_t gy1, std::int64_t width, std::int64_t height) {
  return clip_line(Line({gx0, gy0}, {gx1, gy1}), width, height);
}
// [/snippet]

namespace {

constexpr int fraction_bits = 42;

/// numerator / denominator in units of 2^-42: above the quotient, by little
/// more than one unit at most.
std::int64_t rounded_up(std::int64_t numerator, std::int64_t denominator) {
  const double scaled = static_cast<double>(numerator) * 0x1p42;
  return static_cast<std::int64_t>(scaled / static_cast<double>(denominator)) +
         1;
}

}  // namespace

/// Adds evidence to the cells of some steps of a line, all of them in the
/// grid.
///
/// The shorter axis is a fixed-point number that grows by b / a with every
/// step, and whose upper bits are the cells gone so far. With a = 5, b = 2 it
/// starts at (a - 1) / (2 a) = 0.4 and goes 0.4 0.8 1.2 1.6 2.0 2.4: cells 0 0
/// 1 1 2 2, as bresenham lists them. bresenham's error counter would make each
/// step wait for the comparison of the one before; here it waits for an
/// addition, and the lesson takes a third of the time.
///
/// Why the bits are the same: exact values are multiples of 1 / (2 a). The
/// start and the growth are rounded up, so that the k-th step finds the number
/// too great by little more than k + 1 units of 2^-42. With at most 2^20 steps
/// this is less than 1 / (2 a): never enough to reach the next multiple.
class LineUpdate {
 public:
  LineUpdate(OccupancyGrid& grid, double l_update)
      : log_odds_(grid.log_odds_),
        delta_(l_update - grid.l0_),
        l_min_(grid.l_min_),
        l_max_(grid.l_max_) {}

  /// All evidence has one sign, and every cell lies within the bounds before,
  /// so that only one bound can be crossed. Written in this order, each
  /// comparison is one instruction of the processor (maxsd, minsd).
  void operator()(const Line& line, Steps steps) const {
    const double delta = delta_, l_min = l_min_, l_max = l_max_;
    if (delta < 0.0) {
      walk(line, steps,
           [=](double l) { return l + delta > l_min ? l + delta : l_min; });
    } else {
      walk(line, steps,
           [=](double l) { return l + delta < l_max ? l + delta : l_max; });
    }
  }

 private:
  /// Replaces l by update(l) in each cell.
  template <typename Update>
  void walk(const Line& line, Steps steps, Update update) const {
    if (steps.last < steps.first) return;
    const std::int64_t columns = log_odds_.cols();
    const std::int64_t step_x = line.sx, step_y = line.sy * columns;
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
    const std::int64_t cell = line.from.gy * columns + line.from.gx +
                              steps.first * step_major + minor * step_minor;
    // the line's cell without the steps along its shorter axis
    double* at = log_odds_.data() + cell;
    for (std::int64_t left = steps.last - steps.first;; --left) {
      double& value = at[(position >> fraction_bits) * step_minor];
      value = update(value);
      if (left == 0) return;
      at += step_major;
      position += slope;
    }
  }

  GridArray& log_odds_;
  double delta_, l_min_, l_max_;
};

namespace {

/// Calls visit(robot, end, hit) for each beam that says something, in order:
/// read_ranges and beam_endpoints without their lists, and with one reduction
/// of the angle for its sine and cosine.
template <typename Visit>
void for_each_beam(const OccupancyGrid& grid, const Scan& scan, double z_max,
                   NoReturn no_return, Visit visit) {
  if (scan.angles.size() != scan.ranges.size()) {
    throw std::invalid_argument("angles and ranges differ in number");
  }
  const Cell robot = grid.world_to_grid(scan.pose.x, scan.pose.y);
  for (Eigen::Index i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    const bool hit = range < z_max - 1e-12;
    const bool free = no_return == NoReturn::free && range == range;
    if (!hit && !free) continue;
    const double z = hit ? range : z_max;
    const SinCos a = sin_cos(scan.pose.theta + scan.angles[i]);
    const double ex = scan.pose.x + z * a.cos;
    const double ey = scan.pose.y + z * a.sin;
    visit(robot, grid.world_to_grid(ex, ey), hit);
  }
}

}  // namespace

// [snippet: update-grid-from-scans]
void update_grid_from_scans(OccupancyGrid& grid,
                            const std::vector<Scan>& scans, double z_max,
                            NoReturn no_return) {
  const GridSpec spec = grid.spec();
  const LineUpdate update_free(grid, grid.l_free());
  const auto update = [&](Cell robot, Cell end, bool hit) {
    const Line line(robot, end);
    Steps free = clip_line(line, spec.width, spec.height);
    if (hit) free.last = std::min(free.last, line.a - 1);
    update_free(line, free);
    if (hit) grid.update_cell(end.gx, end.gy, grid.l_occ());
  };
  for (const Scan& scan : scans) {
    for_each_beam(grid, scan, z_max, no_return, update);
  }
}
// [/snippet]

void append_beams(std::vector<Beam>& beams, const OccupancyGrid& grid,
                  const Scan& scan, double z_max, NoReturn no_return) {
  for_each_beam(grid, scan, z_max, no_return,
                [&](Cell robot, Cell end, bool hit) {
                  const Line refuses_what_is_too_long(robot, end);
                  beams.push_back({robot, end, hit});
                });
}

void update_rows_from_beams(OccupancyGrid& grid,
                            const std::vector<Beam>& beams, Rows rows) {
  const std::int64_t width = grid.spec().width;
  const LineUpdate update_free(grid, grid.l_free());
  for (const Beam& beam : beams) {
    const auto [low, high] = std::minmax(beam.robot.gy, beam.end.gy);
    if (high < rows.first || rows.last < low) continue;
    Line line(beam.robot, beam.end);
    // the rows as a grid of their own
    line.from.gy -= rows.first;
    Steps free = clip_line(line, width, rows.last - rows.first + 1);
    line.from.gy += rows.first;
    if (beam.hit) free.last = std::min(free.last, line.a - 1);
    update_free(line, free);
    const bool ends_here =
        rows.first <= beam.end.gy && beam.end.gy <= rows.last;
    if (beam.hit && ends_here) {
      grid.update_cell(beam.end.gx, beam.end.gy, grid.l_occ());
    }
  }
}

OccupancyGrid map_scenario_fast(const Scenario& scenario,
                                std::optional<std::uint32_t> seed,
                                int threads) {
  if (threads < 1) throw std::invalid_argument("threads are 1 or more");
  const Settings& settings = scenario.settings;
  OccupancyGrid grid = settings.new_grid();
  if (threads > 1) {
    map_on_threads(grid, scenario, seed, threads);
    return grid;
  }
  const auto next_scan = simulated_scans(scenario, seed);
  std::vector<Scan> one(1);
  while (auto scan = next_scan()) {
    one[0] = std::move(*scan);
    update_grid_from_scans(grid, one, settings.max_range, settings.no_return);
  }
  return grid;
}

}  // namespace occgrid
