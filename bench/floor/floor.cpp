// What no mapping of this kind can do without, as a floor to measure against.
//
// usage: floor WORK list|ends
//
// list: the updates of the whole work are known beforehand, as a list of
// cells and a list of increments; read, add, clamp, store.
// ends: where the beams end: sin, cos, and the cells by floor. Its cells are
// added up, lest the compiler drop them.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "driver.hpp"
#include "occgrid/grid.hpp"
#include "occgrid/portable_math.hpp"
#include "occgrid/ray.hpp"

namespace {

using occgrid::Cell;
using occgrid::OccupancyGrid;

struct Updates {
  std::vector<std::uint32_t> cells;
  std::vector<double> increments;
};

OccupancyGrid new_grid(const Work& work) {
  return OccupancyGrid({work.width, work.height, work.resolution,
                        work.origin_x, work.origin_y});
}

Cell end_of(const OccupancyGrid& grid, const WorkScan& scan, double angle,
            double z) {
  const double a = scan.theta + angle;
  return grid.world_to_grid(scan.x + z * occgrid::cos(a),
                            scan.y + z * occgrid::sin(a));
}

Updates all_updates(const Work& work) {
  const OccupancyGrid grid = new_grid(work);
  Updates updates;
  for (const WorkScan& scan : work.scans) {
    const Cell robot = grid.world_to_grid(scan.x, scan.y);
    for (std::size_t i = 0; i < work.angles.size(); ++i) {
      const bool hit = scan.ranges[i] < work.max_range - 1e-12;
      const double z = hit ? scan.ranges[i] : work.max_range;
      const Cell end = end_of(grid, scan, work.angles[i], z);
      const auto cells =
          occgrid::bresenham(robot.gx, robot.gy, end.gx, end.gy);
      for (std::size_t k = 0; k < cells.size(); ++k) {
        if (!grid.in_bounds(cells[k].gx, cells[k].gy)) continue;
        const bool occupied = hit && k + 1 == cells.size();
        updates.cells.push_back(static_cast<std::uint32_t>(
            cells[k].gy * work.width + cells[k].gx));
        updates.increments.push_back(
            (occupied ? grid.l_occ() : grid.l_free()) - grid.l0());
      }
    }
  }
  return updates;
}

/// The cells after all updates.
occgrid::GridArray apply(const OccupancyGrid& grid, const Updates& updates) {
  occgrid::GridArray cells = grid.log_odds();
  double* const l = cells.data();
  const double low = grid.l_min(), high = grid.l_max();
  for (std::size_t i = 0; i < updates.cells.size(); ++i) {
    double& value = l[updates.cells[i]];
    value = std::clamp(value + updates.increments[i], low, high);
  }
  return cells;
}

std::int64_t sum_of_ends(const OccupancyGrid& grid, const Work& work) {
  std::int64_t sum = 0;
  for (const WorkScan& scan : work.scans) {
    for (std::size_t i = 0; i < work.angles.size(); ++i) {
      const Cell end = end_of(grid, scan, work.angles[i], scan.ranges[i]);
      sum += end.gx + end.gy;
    }
  }
  return sum;
}

}  // namespace

int main(int, char** argv) {
  const Work work = read_work(argv[1]);
  const OccupancyGrid grid = new_grid(work);
  std::optional<occgrid::GridArray> cells = grid.log_odds();
  const auto write = [&](std::ostream& out) {
    write_log_odds(out, cells->data(), work.width, work.height);
  };
  if (std::string(argv[2]) == "list") {
    const Updates updates = all_updates(work);
    answer_requests(
        [&] {
          cells.reset();
          cells.emplace(apply(grid, updates));
        },
        write);
  } else {
    volatile std::int64_t sum = 0;
    answer_requests([&] { sum = sum_of_ends(grid, work); }, write);
  }
}
