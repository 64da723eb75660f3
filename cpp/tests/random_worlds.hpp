// Scenarios at random, with everything that is easily got wrong: robots
// outside the grid, hits in the robot's cell, ranges one bit beside max_range,
// ends on the edges of cells, limits that few updates reach, evidence of the
// other sign.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

#include "occgrid/scenario.hpp"

class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed) {}

  occgrid::Scenario scenario(int scans) {
    occgrid::Settings settings;
    settings.width = whole(1, 120);
    settings.height = whole(1, 120);
    settings.resolution = pick({0.05, 0.1, 0.13, 0.5, 1.0});
    const double far = pick({0.0, 0.0, 1e7, -1e7});
    settings.origin_x = far + std::round(uniform(-5.0, 0.0));
    settings.origin_y = -far + uniform(-5.0, 0.0);
    settings.max_range = pick({3.0, 8.0, 12.25});
    std::tie(settings.p0, settings.p_occ, settings.p_free, settings.l_min,
             settings.l_max) =
        pick<std::tuple<double, double, double, double, double>>(
            {{0.5, 0.75, 0.3, -8, 8},
             {0.2, 0.9, 0.05, -1.5, 1.0},
             {0.5, 0.5, 0.5, -1, 1},
             {0.4, 0.2, 0.7, -2, 3},     // of the other sign
             {0.5, 0.75, 0.3, 0, 0.5},   // at a limit from the start
             {0.9, 0.3, 0.99, -3, 4}});  // both of one sign
    settings.no_return =
        whole(0, 2) == 0 ? occgrid::NoReturn::ignore : occgrid::NoReturn::free;
    settings.beams = whole(1, 60);
    settings.fov = uniform(0.0, 6.28);
    std::vector<occgrid::Segment> walls;
    for (int i = 0; i < 5; ++i) {
      walls.push_back({x(settings), y(settings), x(settings), y(settings)});
    }
    std::vector<occgrid::ScenarioScan> all;
    for (int i = 0; i < scans; ++i) {
      const occgrid::Pose pose{x(settings), y(settings), uniform(-10, 10)};
      if (whole(0, 2) == 0) {
        all.push_back(pose);
      } else {
        all.push_back(scan(settings, pose));
      }
    }
    const auto source = [all]() -> occgrid::ScanSource {
      return [all, i = std::size_t{
                       0}]() mutable -> std::optional<occgrid::ScenarioScan> {
        if (i == all.size()) return std::nullopt;
        return all[i++];
      };
    };
    return {"random", settings, walls, source};
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  template <typename T = double>
  T pick(std::vector<T> values) {
    return values[static_cast<std::size_t>(
        whole(0, static_cast<std::int64_t>(values.size()) - 1))];
  }

  /// In the grid or beside it, now and then on the edge of a cell.
  double x(const occgrid::Settings& s) {
    return s.origin_x + along(static_cast<double>(s.width), s.resolution);
  }
  double y(const occgrid::Settings& s) {
    return s.origin_y + along(static_cast<double>(s.height), s.resolution);
  }
  double along(double cells, double resolution) {
    const double at = uniform(-0.3 * cells, 1.3 * cells);
    return (whole(0, 3) == 0 ? std::floor(at) : at) * resolution;
  }

  occgrid::Scan scan(const occgrid::Settings& s, const occgrid::Pose& pose) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double horizon = s.max_range - 1e-12;
    const auto n = static_cast<Eigen::Index>(whole(1, 80));
    occgrid::Scan scan{pose, Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
    const bool along_axes = whole(0, 3) == 0;
    if (along_axes) scan.pose.theta = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      scan.angles[i] =
          along_axes ? 1.5707963267948966 * static_cast<double>(whole(-4, 4))
                     : uniform(-7.0, 7.0);
      scan.ranges[i] =
          pick({uniform(0.0, 1.4 * s.max_range), uniform(0.0, s.max_range),
                std::floor(uniform(0.0, 9.0)) * s.resolution, 0.0,
                std::numeric_limits<double>::quiet_NaN(), infinity,
                s.max_range, horizon, std::nextafter(horizon, 0.0),
                std::nextafter(horizon, infinity),
                std::nextafter(s.max_range, 0.0)});
    }
    return scan;
  }

  std::mt19937 random_;
};
