#include <gtest/gtest.h>

#include <limits>

#include "occgrid/portable_math.hpp"
#include "occgrid/world.hpp"

namespace {

using occgrid::ray_segment_intersection;
using occgrid::Segment;

constexpr double none = std::numeric_limits<double>::infinity();

TEST(World, WallsOfABox) {
  const auto walls = occgrid::build_box_world(-2.0, -1.0, 4.0, 3.0);
  ASSERT_EQ(walls.size(), 4u);
  const Segment expected[] = {
      {-2, -1, 4, -1}, {4, -1, 4, 3}, {4, 3, -2, 3}, {-2, 3, -2, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(walls[i].x0, expected[i].x0);
    EXPECT_EQ(walls[i].y0, expected[i].y0);
    EXPECT_EQ(walls[i].x1, expected[i].x1);
    EXPECT_EQ(walls[i].y1, expected[i].y1);
  }
  const Segment vertical = occgrid::add_vertical_wall(1.0, 2.0, 3.0);
  EXPECT_TRUE(vertical.x0 == 1.0 && vertical.y0 == 2.0 && vertical.x1 == 1.0 &&
              vertical.y1 == 3.0);
  const Segment horizontal = occgrid::add_horizontal_wall(1.0, 2.0, 3.0);
  EXPECT_TRUE(horizontal.x0 == 2.0 && horizontal.y0 == 1.0 &&
              horizontal.x1 == 3.0 && horizontal.y1 == 1.0);
}

TEST(World, RaySegmentIntersection) {
  const Segment wall{2.0, -1.0, 2.0, 1.0};
  EXPECT_EQ(ray_segment_intersection(0.0, 0.0, 1.0, 0.0, wall), 2.0);
  EXPECT_EQ(ray_segment_intersection(0.0, 0.0, -1.0, 0.0, wall),
            none);  // behind
  EXPECT_EQ(ray_segment_intersection(0.0, 0.0, 0.0, 1.0, wall),
            none);  // parallel
  EXPECT_EQ(ray_segment_intersection(2.0, -5.0, 0.0, 1.0, wall),
            none);  // along the wall
  EXPECT_EQ(ray_segment_intersection(0.0, 1.0, 1.0, 0.0, wall),
            2.0);  // at its end
  EXPECT_EQ(ray_segment_intersection(0.0, 1.001, 1.0, 0.0, wall), none);
  EXPECT_EQ(ray_segment_intersection(2.0, 0.5, 1.0, 0.0, wall), 0.0);  // on it
  EXPECT_DOUBLE_EQ(ray_segment_intersection(0.0, 0.0, 0.8, 0.4, wall), 2.5);
}

TEST(World, SimulatedScanMeetsTheNearestWall) {
  const auto walls = occgrid::build_box_world(-1.0, -2.0, 3.0, 4.0);
  Eigen::ArrayXd angles(4);
  angles << 0.0, occgrid::pi / 2.0, occgrid::pi, -occgrid::pi / 2.0;
  const auto ranges =
      occgrid::simulate_lidar_scan({0.0, 0.0, 0.0}, walls, angles, 10.0);
  EXPECT_DOUBLE_EQ(ranges[0], 3.0);
  EXPECT_DOUBLE_EQ(ranges[1], 4.0);
  EXPECT_DOUBLE_EQ(ranges[2], 1.0);
  EXPECT_DOUBLE_EQ(ranges[3], 2.0);
  // out of reach, and without walls
  EXPECT_EQ(
      occgrid::simulate_lidar_scan({0.0, 0.0, 0.0}, walls, angles, 2.5)[0],
      2.5);
  EXPECT_TRUE(
      (occgrid::simulate_lidar_scan({0.0, 0.0, 0.0}, {}, angles, 7.0) == 7.0)
          .all());
  // bearings are relative to the heading
  const auto turned = occgrid::simulate_lidar_scan(
      {0.0, 0.0, occgrid::pi / 2.0}, walls, angles, 10.0);
  EXPECT_DOUBLE_EQ(turned[0], 4.0);
}

}  // namespace
