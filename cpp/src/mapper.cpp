#include "mapper.hpp"

#include "noise.hpp"
#include "sensor.hpp"
#include "world.hpp"

namespace occgrid {

// [snippet: map-scenario]
OccupancyGrid map_scenario(const Scenario& scenario,
                           std::optional<std::uint32_t> seed) {
  const Settings& settings = scenario.settings;
  const double z_max = settings.max_range;
  const auto angles = beam_angles(settings.fov, settings.beams);
  OccupancyGrid grid = settings.new_grid();
  std::uint32_t number = 0;
  while (auto next = scenario.next_scan()) {
    if (const Pose* pose = std::get_if<Pose>(&*next)) {
      auto ranges = simulate_lidar_scan(*pose, scenario.walls, angles, z_max);
      if (seed) {
        add_range_noise(ranges, settings.noise_std, *seed, number, z_max);
      }
      next = Scan{*pose, angles, std::move(ranges)};
    }
    const Scan& scan = std::get<Scan>(*next);
    update_grid_from_scan(grid, scan, z_max, settings.no_return);
    ++number;
  }
  return grid;
}
// [/snippet]

}  // namespace occgrid
