#include "mapper.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <utility>

#include "crew.hpp"
#include "noise.hpp"
#include "world.hpp"

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

std::function<std::optional<Scan>()> simulated_scans(
    const Scenario& scenario, std::optional<std::uint32_t> seed) {
  const Settings& settings = scenario.settings;
  const double z_max = settings.max_range;
  const auto angles = beam_angles(settings.fov, settings.beams);
  std::uint32_t number = 0;
  return [=, &scenario, &settings]() mutable -> std::optional<Scan> {
    auto next = scenario.next_scan();
    if (!next) return std::nullopt;
    if (const Pose* pose = std::get_if<Pose>(&*next)) {
      auto ranges = simulate_lidar_scan(*pose, scenario.walls, angles, z_max);
      if (seed) {
        add_range_noise(ranges, settings.noise_std, *seed, number, z_max);
      }
      next = Scan{*pose, angles, std::move(ranges)};
    }
    ++number;
    return std::get<Scan>(std::move(*next));
  };
}
// [/snippet]

OccupancyGrid map_scenario_in_bands(const Scenario& scenario,
                                    std::optional<std::uint32_t> seed,
                                    int threads) {
  constexpr Eigen::Index batch_beams = 1 << 17;
  const Settings& settings = scenario.settings;
  OccupancyGrid grid = settings.new_grid();
  const auto next_scan = simulated_scans(scenario, seed);
  const auto read_batch = [&] {
    std::vector<Scan> scans;
    for (Eigen::Index beams = 0; beams < batch_beams;) {
      auto scan = next_scan();
      if (!scan) break;
      beams += scan->ranges.size();
      scans.push_back(std::move(*scan));
    }
    return scans;
  };
  const auto share = static_cast<std::size_t>(threads);
  // kept from batch to batch, as new memory is slow at first
  std::vector<std::vector<Beam>> beams(share);
  std::vector<Rows> bands;
  Crew crew(threads);  // the last: it ends before what it works on
  for (auto scans = read_batch(); !scans.empty();) {
    // first the beams, each thread those of some scans
    crew.start([&](int thread) {
      const auto t = static_cast<std::size_t>(thread);
      const std::size_t end = scans.size() * (t + 1) / share;
      beams[t].clear();
      for (std::size_t s = scans.size() * t / share; s < end; ++s) {
        append_beams(beams[t], grid, scans[s], settings.max_range,
                     settings.no_return);
      }
    });
    crew.wait();
    // then the updates, while this thread reads on
    bands = cut_bands(beams, settings.height, threads);
    crew.start([&](int thread) {
      const Rows rows = bands[static_cast<std::size_t>(thread)];
      for (const auto& some : beams) update_rows_from_beams(grid, some, rows);
    });
    scans = read_batch();
    crew.wait();
  }
  return grid;
}

std::vector<Rows> cut_bands(const std::vector<std::vector<Beam>>& beams,
                            std::int64_t height, int bands) {
  // how many more cells a row has of the beams than the row before
  std::vector<double> rise(static_cast<std::size_t>(height) + 1, 0.0);
  double all = 0.0;
  for (const std::vector<Beam>& some : beams) {
    // a thousand of them say enough
    const std::size_t step = 1 + some.size() / 1024;
    for (std::size_t i = 0; i < some.size(); i += step) {
      const Beam& beam = some[i];
      const auto [low, high] = std::minmax(beam.robot.gy, beam.end.gy);
      const std::int64_t first = std::max<std::int64_t>(low, 0);
      const std::int64_t last = std::min(high, height - 1);
      if (last < first) continue;
      const std::int64_t columns = std::abs(beam.end.gx - beam.robot.gx);
      const std::int64_t rows = high - low + 1;
      const double in_a_row = std::max(
          1.0, static_cast<double>(columns) / static_cast<double>(rows));
      rise[static_cast<std::size_t>(first)] += in_a_row;
      rise[static_cast<std::size_t>(last + 1)] -= in_a_row;
      all += in_a_row * static_cast<double>(last - first + 1);
    }
  }
  std::vector<Rows> cut;
  std::int64_t row = 0;
  double cells = 0.0, before = 0.0;
  for (int band = 1; band <= bands; ++band) {
    const std::int64_t first = row;
    while (row < height && (band == bands || before < all * band / bands)) {
      cells += rise[static_cast<std::size_t>(row)];
      before += cells;
      ++row;
    }
    cut.push_back({first, row - 1});
  }
  return cut;
}

}  // namespace occgrid
