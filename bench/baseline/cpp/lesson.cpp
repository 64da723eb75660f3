// The lesson's mapping written down plainly: a list of cells for each beam,
// grown as it is walked, and a look at the borders for each update.
//
// usage: cpp_lesson WORK
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include "driver.hpp"

namespace {

double logit(double p) {
  return std::log(p / (1.0 - p));
}

struct Grid {
  explicit Grid(const Work& work)
      : width(work.width),
        height(work.height),
        resolution(work.resolution),
        origin_x(work.origin_x),
        origin_y(work.origin_y),
        log_odds(
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            l0) {}

  std::pair<int, int> world_to_grid(double x, double y) const {
    return {static_cast<int>(std::floor((x - origin_x) / resolution)),
            static_cast<int>(std::floor((y - origin_y) / resolution))};
  }

  void update_cell(int gx, int gy, double l) {
    if (gx < 0 || gx >= width || gy < 0 || gy >= height) return;
    double& cell = log_odds[static_cast<std::size_t>(gy * width + gx)];
    cell += l - l0;
    if (cell > l_max) cell = l_max;
    if (cell < l_min) cell = l_min;
  }

  int width, height;
  double resolution, origin_x, origin_y;
  double l0 = logit(0.5), l_occ = logit(0.75), l_free = logit(0.30);
  double l_min = -8.0, l_max = 8.0;
  std::vector<double> log_odds;
};

std::vector<std::pair<int, int>> bresenham(int x, int y, int x_end,
                                           int y_end) {
  std::vector<std::pair<int, int>> cells;
  const int dx = std::abs(x_end - x), dy = std::abs(y_end - y);
  const int x_step = x < x_end ? 1 : -1, y_step = y < y_end ? 1 : -1;
  int error = dx - dy;
  while (true) {
    cells.push_back({x, y});  // as the lesson has it; emplace_back is quicker
    if (x == x_end && y == y_end) return cells;
    const int twice = 2 * error;
    if (twice > -dy) {
      error -= dy;
      x += x_step;
    }
    if (twice < dx) {
      error += dx;
      y += y_step;
    }
  }
}

void update_from_scan(Grid& grid, const WorkScan& scan,
                      const std::vector<double>& angles, double max_range) {
  const auto robot = grid.world_to_grid(scan.x, scan.y);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double heading = scan.theta + angles[i];
    const double range = std::min(scan.ranges[i], max_range);
    const auto end = grid.world_to_grid(scan.x + range * std::cos(heading),
                                        scan.y + range * std::sin(heading));
    const auto cells =
        bresenham(robot.first, robot.second, end.first, end.second);
    const bool hit = range < max_range - 1e-12;
    const std::size_t free = cells.size() - (hit ? 1 : 0);
    for (std::size_t k = 0; k < free; ++k) {
      grid.update_cell(cells[k].first, cells[k].second, grid.l_free);
    }
    if (hit) {
      grid.update_cell(cells.back().first, cells.back().second, grid.l_occ);
    }
  }
}

}  // namespace

int main(int, char** argv) {
  const Work work = read_work(argv[1]);
  std::unique_ptr<Grid> grid;
  answer_requests(
      [&] {
        grid.reset();
        grid = std::make_unique<Grid>(work);
        for (const WorkScan& scan : work.scans) {
          update_from_scan(*grid, scan, work.angles, work.max_range);
        }
      },
      [&](std::ostream& out) {
        write_log_odds(out, grid->log_odds.data(), grid->width, grid->height);
      });
}
