// Several threads draw the map that one draws, bit for bit.
#include "mapper.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <random>

#include "crew.hpp"
#include "lesson.hpp"

namespace {

using occgrid::OccupancyGrid;
using occgrid::Rows;
using occgrid::Scan;
using occgrid::Scenario;
using occgrid::ScenarioScan;

bool same_bits(const OccupancyGrid& one, const OccupancyGrid& other) {
  const auto cells = static_cast<std::size_t>(one.log_odds.size());
  return one.log_odds.size() == other.log_odds.size() &&
         std::memcmp(one.log_odds.data(), other.log_odds.data(),
                     cells * sizeof(double)) == 0;
}

/// Scans in and around a grid of this height; the log is read from its start
/// each time that it is asked for.
Scenario random_log(std::int64_t height, int scans) {
  occgrid::Settings settings;
  settings.width = 97;
  settings.height = height;
  settings.resolution = 0.1;
  settings.origin_x = -4.0;
  settings.origin_y = -2.0;
  settings.max_range = 9.0;
  settings.l_min = -1.5;  // within reach of a few updates
  settings.l_max = 2.0;
  const auto next_scan =
      [=, s = 0,
       random = std::mt19937(5)]() mutable -> std::optional<ScenarioScan> {
    const auto uniform = [&random](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    if (s++ >= scans) return std::nullopt;
    Scan scan;
    scan.pose = {uniform(-6.0, 8.0), uniform(-4.0, 6.0), uniform(-9.0, 9.0)};
    scan.angles = occgrid::beam_angles(6.0, 300);
    scan.ranges = Eigen::ArrayXd::NullaryExpr(
        300, [&](Eigen::Index) { return uniform(0.0, 12.0); });
    scan.ranges[7] = std::numeric_limits<double>::quiet_NaN();
    return scan;
  };
  return {"random", settings, {}, next_scan};
}

TEST(Mapper, LessonInBands) {
  for (const std::optional<std::uint32_t> seed :
       {std::optional<std::uint32_t>{}, std::optional<std::uint32_t>{3}}) {
    const auto plain = occgrid::map_scenario(occgrid::lesson_scenario(), seed);
    for (const int threads : {1, 2, 3, 7}) {
      const auto banded = occgrid::map_scenario_in_bands(
          occgrid::lesson_scenario(), seed, threads);
      EXPECT_TRUE(same_bits(plain, banded)) << threads;
    }
  }
}

// Enough beams for several batches; grids of fewer rows than threads.
TEST(Mapper, RandomLogsInBands) {
  for (const std::int64_t height : {60, 5, 1}) {
    const auto plain =
        occgrid::map_scenario(random_log(height, 500), std::nullopt);
    EXPECT_TRUE((plain.log_odds == plain.l_min).any());
    for (const int threads : {1, 2, 3, 7}) {
      const auto banded = occgrid::map_scenario_in_bands(
          random_log(height, 500), std::nullopt, threads);
      EXPECT_TRUE(same_bits(plain, banded)) << height << ' ' << threads;
    }
  }
}

// An error comes out while the bands are at work on the batch before.
TEST(Mapper, ErrorsOfTheLogComeThrough) {
  for (const int after : {0, 500}) {
    Scenario log = random_log(60, 600);
    log.next_scan = [next = log.next_scan, after, s = 0]() mutable {
      if (s++ == after) throw occgrid::ScenarioError("a.log", 7, "bad");
      return next();
    };
    EXPECT_THROW(occgrid::map_scenario_in_bands(log, std::nullopt, 3),
                 occgrid::ScenarioError);
  }
}

TEST(Crew, EachTakesItsPieceEachTime) {
  std::vector<int> done(5, 0);
  occgrid::Crew crew(5);
  for (int round = 1; round <= 200; ++round) {
    crew.start([&](int i) { ++done[static_cast<std::size_t>(i)]; });
    crew.wait();
    EXPECT_EQ(done, std::vector<int>(5, round));
  }
}

TEST(Crew, ErrorsComeThroughAndTheCrewGoesOn) {
  std::atomic<int> done = 0;
  occgrid::Crew crew(3);
  crew.start([](int i) {
    if (i == 1) throw std::runtime_error("bad");
  });
  EXPECT_THROW(crew.wait(), std::runtime_error);
  crew.start([&](int) { ++done; });
  crew.wait();
  EXPECT_EQ(done, 3);
}

TEST(Mapper, CutBandsCoversEveryRowOnce) {
  for (const std::int64_t height : {1, 2, 7, 400}) {
    for (const int bands : {1, 2, 3, 7}) {
      const std::vector<occgrid::Beam> beams{{{0, -5}, {10, 300}, true},
                                             {{0, 3}, {50, 3}, false},
                                             {{0, -9}, {0, -1}, true}};
      std::int64_t row = 0;
      for (const Rows rows : occgrid::cut_bands({beams}, height, bands)) {
        EXPECT_EQ(rows.first, row);
        EXPECT_GE(rows.last, rows.first - 1);
        row = rows.last + 1;
      }
      EXPECT_EQ(row, height);
    }
  }
}

TEST(Mapper, CutBandsSharesTheWork) {
  // a fan of 40 beams in rows 10 to 13, and one long one along row 90
  std::vector<occgrid::Beam> beams;
  for (int i = 0; i < 40; ++i) beams.push_back({{0, 10}, {3, 13}, true});
  EXPECT_EQ(occgrid::cut_bands({beams}, 100, 2).front().last, 11);
  beams.push_back({{0, 90}, {1000, 90}, true});
  EXPECT_EQ(occgrid::cut_bands({beams}, 100, 2).front().last, 90);
}

}  // namespace
