// The C++ port at the benchmark's work.
//
// usage: cpp_port WORK [plain | THREADS]
//
// Without more: update_grid_from_scans, all scans at once. plain:
// update_grid_from_scan, scan after scan. THREADS: the port's mapping loop,
// map_scenario_fast, on a scenario in memory.
#include <optional>

#include "driver.hpp"
#include "occgrid/fast.hpp"
#include "occgrid/map_writer.hpp"
#include "occgrid/sensor.hpp"

int main(int argc, char** argv) {
  const Work work = read_work(argv[1]);
  const std::string how = argc > 2 ? argv[2] : "";

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
  const auto map_plain = [&] {
    grid.reset();
    grid.emplace(settings.new_grid());
    for (const occgrid::Scan& scan : scans) {
      occgrid::update_grid_from_scan(*grid, scan, settings.max_range,
                                     settings.no_return);
    }
  };
  const auto map_fast = [&] {
    grid.reset();
    grid.emplace(settings.new_grid());
    occgrid::update_grid_from_scans(*grid, scans, settings.max_range,
                                    settings.no_return);
  };
  const auto map_on_threads = [&] {
    const auto source = [&]() -> occgrid::ScanSource {
      return [&, i = std::size_t{
                     0}]() mutable -> std::optional<occgrid::ScenarioScan> {
        if (i == scans.size()) return std::nullopt;
        return scans[i++];
      };
    };
    const occgrid::Scenario scenario{"", settings, {}, source};
    grid.reset();
    grid.emplace(
        occgrid::map_scenario_fast(scenario, std::nullopt, std::stoi(how)));
  };
  const auto write = [&](std::ostream& out) {
    occgrid::map_log_odds(*grid, out);
  };
  if (how.empty()) {
    answer_requests(map_fast, write);
  } else if (how == "plain") {
    answer_requests(map_plain, write);
  } else {
    answer_requests(map_on_threads, write);
  }
}
