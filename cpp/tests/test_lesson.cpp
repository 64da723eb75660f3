#include <gtest/gtest.h>

#include <cmath>

#include "occgrid/lesson.hpp"
#include "occgrid/mapper.hpp"
#include "occgrid/noise.hpp"
#include "occgrid/ray.hpp"
#include "temp_folder.hpp"

namespace {

TEST(Lesson, Trajectory) {
  const auto poses = occgrid::lesson_poses();
  ASSERT_EQ(poses.size(), 120u);
  EXPECT_EQ(poses[0].x, 0.0);
  EXPECT_EQ(poses[0].y, 0.0);
  EXPECT_EQ(poses[0].theta, occgrid::pi / 2.0);
  EXPECT_EQ(poses[60].x, -12.0);
  EXPECT_EQ(poses[7].theta,
            (2.0 * occgrid::pi) * (7.0 / 120.0) + occgrid::pi / 2.0);
}

// Facts of the lesson: where beams start and end.
TEST(Lesson, Beams) {
  const auto settings = occgrid::lesson_settings();
  const auto walls = occgrid::lesson_world();
  EXPECT_EQ(walls.size(), 6u);
  const auto grid = settings.new_grid();
  const auto angles = occgrid::beam_angles(settings.fov, settings.beams);
  std::int64_t outside = 0, hits = 0;
  for (const auto& pose : occgrid::lesson_poses()) {
    const auto [gx, gy] = grid.world_to_grid(pose.x, pose.y);
    if (!grid.in_bounds(gx, gy)) outside += settings.beams;
    const auto ranges =
        occgrid::simulate_lidar_scan(pose, walls, angles, settings.max_range);
    hits += (ranges < settings.max_range - 1e-12).count();
  }
  EXPECT_EQ(outside, 4163);
  EXPECT_EQ(hits, 17356);
}

TEST(Lesson, MapOfTheWorld) {
  const auto grid =
      occgrid::map_scenario(occgrid::lesson_scenario(), std::nullopt);
  EXPECT_EQ(grid.log_odds().rows(), 180);
  EXPECT_EQ(grid.log_odds().cols(), 220);
  EXPECT_GE(grid.log_odds().minCoeff(), -8.0);
  EXPECT_LE(grid.log_odds().maxCoeff(), 8.0);
  const auto p = grid.probability_grid();
  const auto free = grid.world_to_grid(-5.0, 0.0);
  EXPECT_LT(p(free.gy, free.gx), 0.01);
  EXPECT_EQ(p(179, 219), 0.5);  // never seen
}

TEST(Lesson, NoiseIsOfTheSeed) {
  const auto map = [](std::optional<std::uint32_t> seed) {
    return occgrid::map_scenario(occgrid::lesson_scenario(), seed).log_odds();
  };
  const auto noise_free = map(std::nullopt);
  EXPECT_TRUE((map(7) == map(7)).all());
  EXPECT_GT((map(7) != map(8)).count(), 500);
  EXPECT_GT((map(0) != noise_free).count(), 500);
}

// Scans are numbered in the order of the file, recorded ones too, and only
// simulated ones get noise.
TEST(Lesson, NoiseOfAScanBetweenRecordedOnes) {
  const TempFolder folder;
  const std::string head =
      "PARAM occgrid_width 1000\nPARAM occgrid_height 1\nPARAM "
      "occgrid_resolution 0.01\n"
      "PARAM occgrid_origin_x 0\nPARAM occgrid_origin_y -0.005\nPARAM "
      "occgrid_max_range 9\n"
      "PARAM occgrid_beams 1\nWALL 5 -1 5 1\n";
  const std::string recorded =
      "FLASER 1 3 0 0 1.5707963267948966 x x x x x x\n";
  const auto file =
      folder.write("mixed.log", head + recorded + "POSE 0 0 0\n" + recorded);
  const auto grid = occgrid::map_scenario(occgrid::read_scenario(file), 11);
  EXPECT_EQ(grid.log_odds()(0, 300),
            grid.l_free() + grid.l_occ() + grid.l_occ());
  const double range = 5.0 + 0.02 * occgrid::normal_deviate(11, 1, 0);
  EXPECT_EQ(grid.log_odds()(0, grid.world_to_grid(range, 0.0).gx),
            grid.l_occ());
}

}  // namespace
