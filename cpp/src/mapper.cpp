#include "occgrid/mapper.hpp"

#include <utility>
#include <variant>

#include "occgrid/noise.hpp"
#include "occgrid/world.hpp"

namespace occgrid {

// [snippet: map-scenario]
OccupancyGrid map_scenario(const Scenario& scenario,
                           std::optional<std::uint32_t> seed) {
  const Settings& settings = scenario.settings;
  OccupancyGrid grid = settings.new_grid();
  const auto next_scan = simulated_scans(scenario, seed);
  while (const auto scan = next_scan()) {
    update_grid_from_scan(grid, *scan, settings.max_range, settings.no_return);
  }
  return grid;
}

Scan simulated_scan(const Scenario& scenario, const Pose& pose,
                    std::uint32_t number, std::optional<std::uint32_t> seed) {
  const Settings& settings = scenario.settings;
  const double z_max = settings.max_range;
  const auto n_beams = static_cast<Eigen::Index>(settings.beams);
  const Eigen::ArrayXd angles = beam_angles(settings.fov, n_beams);
  Eigen::ArrayXd ranges =
      simulate_lidar_scan(pose, scenario.walls, angles, z_max);
  if (seed) {
    ranges = add_range_noise(ranges, settings.noise_std, *seed, number, z_max);
  }
  return {pose, angles, ranges};
}

std::function<std::optional<Scan>()> simulated_scans(
    const Scenario& scenario, std::optional<std::uint32_t> seed) {
  return [&scenario, seed, next_scan = scenario.scans(),
          number = std::uint32_t{0}]() mutable -> std::optional<Scan> {
    std::optional<ScenarioScan> next = next_scan();
    if (!next) return std::nullopt;
    const std::uint32_t n = number++;
    const Pose* pose = std::get_if<Pose>(&*next);
    if (pose) return simulated_scan(scenario, *pose, n, seed);
    return std::get<Scan>(std::move(*next));
  };
}
// [/snippet]

}  // namespace occgrid
