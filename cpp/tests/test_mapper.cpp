// The plain mapping loop.
#include "occgrid/mapper.hpp"

#include <gtest/gtest.h>

#include "occgrid/lesson.hpp"
#include "occgrid/noise.hpp"
#include "occgrid/world.hpp"
#include "same_bits.hpp"
#include "temp_folder.hpp"

namespace {

using occgrid::map_scenario;
using occgrid::OccupancyGrid;

// The first comparison that anybody makes: without noise, then with it.
TEST(Mapper, AScenarioCanBeMappedAgain) {
  const TempFolder folder;
  const auto file = occgrid::read_scenario(folder.write(
      "a.log",
      "PARAM occgrid_width 9\nPARAM occgrid_height 9\nPARAM "
      "occgrid_resolution 1\nPARAM occgrid_origin_x 0\nPARAM occgrid_origin_y "
      "0\nPARAM occgrid_max_range 9\nWALL 7 0 7 9\nPOSE 1 5 0\nPOSE 2 4 1\n"));
  for (const auto& scenario : {occgrid::lesson_scenario(), file}) {
    const OccupancyGrid noise_free = map_scenario(scenario, std::nullopt);
    EXPECT_TRUE((noise_free.log_odds() != 0.0).any());
    const OccupancyGrid noisy = map_scenario(scenario, 7);
    EXPECT_TRUE((noisy.log_odds() != 0.0).any());
    EXPECT_TRUE(same_bits(map_scenario(scenario, std::nullopt), noise_free));
    EXPECT_TRUE(same_bits(map_scenario(scenario, 7), noisy));
  }
}

TEST(Mapper, SimulatedScans) {
  const auto scenario = occgrid::lesson_scenario();
  const auto poses = occgrid::lesson_poses();
  const auto noise_free = occgrid::simulated_scans(scenario, std::nullopt);
  const auto noisy = occgrid::simulated_scans(scenario, 5);
  for (std::uint32_t s = 0; s < poses.size(); ++s) {
    const auto plain = noise_free().value();
    const auto ranges = occgrid::simulate_lidar_scan(
        poses[s], scenario.walls, occgrid::beam_angles(occgrid::pi, 181),
        10.0);
    EXPECT_TRUE((plain.ranges == ranges).all());
    EXPECT_EQ(plain.pose.x, poses[s].x);
    EXPECT_TRUE((noisy().value().ranges ==
                 occgrid::add_range_noise(ranges, 0.02, 5, s, 10.0))
                    .all());
  }
  EXPECT_FALSE(noise_free());
  EXPECT_FALSE(noisy());
}

}  // namespace
