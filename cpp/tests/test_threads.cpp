// Several threads draw the map that the plain program draws, bit for bit.
#include <gtest/gtest.h>

#include <stdexcept>

#include "occgrid/fast.hpp"
#include "occgrid/lesson.hpp"
#include "occgrid/mapper.hpp"
#include "random_worlds.hpp"
#include "same_bits.hpp"
#include "scan_pipeline.hpp"

namespace {

using occgrid::map_scenario_fast;
using occgrid::Rows;
using occgrid::ScanSource;
using occgrid::Scenario;

TEST(Threads, LessonSameAsPlain) {
  const Scenario lesson = occgrid::lesson_scenario();
  for (const std::optional<std::uint32_t> seed :
       {std::optional<std::uint32_t>{}, std::optional<std::uint32_t>{3}}) {
    const auto plain = occgrid::map_scenario(lesson, seed);
    for (const int threads : {2, 3, 7}) {
      EXPECT_TRUE(same_bits(plain, map_scenario_fast(lesson, seed, threads)))
          << threads;
    }
  }
}

// Enough beams for several batches; grids of fewer rows than threads.
TEST(Threads, RandomWorldsSameAsPlain) {
  RandomWorld random(13);
  for (int i = 0; i < 12; ++i) {
    const Scenario scenario = random.scenario(2000);
    const auto plain = occgrid::map_scenario(scenario, 3);
    for (const int threads : {2, 5}) {
      ASSERT_TRUE(same_bits(plain, map_scenario_fast(scenario, 3, threads)))
          << i << ", " << threads << " threads";
    }
  }
}

/// The scenario with an end of its own after some scans.
Scenario ends_after(const Scenario& scenario, int scans,
                    const std::function<occgrid::ScenarioScan()>& end) {
  Scenario other = scenario;
  other.scans = [=]() -> ScanSource {
    return [next = scenario.scans(), scans, end,
            s = 0]() mutable -> std::optional<occgrid::ScenarioScan> {
      if (s++ == scans) return end();
      return next();
    };
  };
  return other;
}

// At the first scan, in the first batch and in a later one, while others work
// on those before.
TEST(Threads, ErrorsComeThrough) {
  const Scenario log = RandomWorld(14).scenario(3000);
  for (const int scans : {0, 20, 2500}) {
    const auto bad_line =
        ends_after(log, scans, []() -> occgrid::ScenarioScan {
          throw occgrid::ScenarioError("a.log", 7, "bad");
        });
    EXPECT_THROW(map_scenario_fast(bad_line, 3, 3), occgrid::ScenarioError);
    const auto bad_scan =
        ends_after(log, scans, []() -> occgrid::ScenarioScan {
          return occgrid::Scan{
              {0, 0, 0}, Eigen::ArrayXd::Zero(1), Eigen::ArrayXd::Zero(2)};
        });
    EXPECT_THROW(map_scenario_fast(bad_scan, 3, 3), std::invalid_argument);
  }
}

TEST(Threads, CutBandsCoversEveryRowOnce) {
  const std::vector<std::vector<occgrid::Beam>> some{
      {{{0, -5}, {10, 300}, true},
       {{0, 3}, {50, 3}, false},
       {{0, -9}, {0, -1}, true}},
      {}};
  for (const auto& beams : {some, {{}}, {{{{0, 5}, {1, 5}, true}}}}) {
    for (const std::int64_t height : {1, 2, 7, 400, 25000000}) {
      for (const std::size_t bands : {1u, 2u, 3u, 7u}) {
        std::int64_t row = 0;
        const auto cut = occgrid::cut_bands(beams, height, bands);
        EXPECT_EQ(cut.size(), bands);
        for (const Rows rows : cut) {
          EXPECT_EQ(rows.first, row);
          EXPECT_GE(rows.last, rows.first - 1);
          row = rows.last + 1;
        }
        EXPECT_EQ(row, height);
      }
    }
  }
}

TEST(Threads, CutBandsSharesTheWork) {
  // a fan of 40 beams in rows 10 to 13, and one long one along row 90
  std::vector<occgrid::Beam> beams;
  for (int i = 0; i < 40; ++i) beams.push_back({{0, 10}, {3, 13}, true});
  EXPECT_EQ(occgrid::cut_bands({beams}, 100, 2).front().last, 11);
  beams.push_back({{0, 90}, {1000, 90}, true});
  EXPECT_EQ(occgrid::cut_bands({beams}, 100, 2).front().last, 90);
}

}  // namespace
