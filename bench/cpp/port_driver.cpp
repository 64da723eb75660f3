// The C++ port at the benchmark's work.
//
// usage: cpp_port WORK [THREADS]
//
// Without THREADS: update_grid_from_scan, scan after scan. With it the
// port's mapping loop, map_scenario or map_scenario_in_bands, on a scenario in
// memory.
#include <memory>
#include <optional>

#include "driver.hpp"
#include "map_writer.hpp"
#include "mapper.hpp"
#include "sensor.hpp"

int main(int argc, char** argv) {
  const Work work = read_work(argv[1]);
  const int threads = argc > 2 ? std::stoi(argv[2]) : 0;

  occgrid::Settings settings;
  settings.width = work.width;
  settings.height = work.height;
  settings.resolution = work.resolution;
  settings.origin_x = work.origin_x;
  settings.origin_y = work.origin_y;
  settings.max_range = work.max_range;
  const auto array = [](const std::vector<double>& values) {
    return Eigen::ArrayXd(Eigen::Map<const Eigen::ArrayXd>(
        values.data(), static_cast<Eigen::Index>(values.size())));
  };
  std::vector<occgrid::Scan> scans;
  for (const WorkScan& scan : work.scans) {
    scans.push_back({{scan.x, scan.y, scan.theta},
                     array(work.angles),
                     array(scan.ranges)});
  }

  std::optional<occgrid::OccupancyGrid> grid;
  const auto map_scans = [&] {
    grid.reset();
    grid.emplace(settings.new_grid());
    for (const occgrid::Scan& scan : scans) {
      occgrid::update_grid_from_scan(*grid, scan, settings.max_range,
                                     settings.no_return);
    }
  };
  const auto map_scenario = [&] {
    const auto next_scan = [&, i = std::size_t{0}]() mutable
        -> std::optional<occgrid::ScenarioScan> {
      if (i == scans.size()) return std::nullopt;
      return scans[i++];
    };
    const occgrid::Scenario scenario{"", settings, {}, next_scan};
    grid.reset();
    grid.emplace(threads == 1 ? occgrid::map_scenario(scenario, std::nullopt)
                              : occgrid::map_scenario_in_bands(
                                    scenario, std::nullopt, threads));
  };
  const auto write = [&](std::ostream& out) {
    occgrid::map_log_odds(*grid, out);
  };
  if (threads > 0) {
    answer_requests(map_scenario, write);
  } else {
    answer_requests(map_scans, write);
  }
}
