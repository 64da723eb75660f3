// Reading a scenario: a CARMEN log with PARAM, WALL and POSE lines (SPEC.md
// sections 5 and 8).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grid.hpp"
#include "portable_math.hpp"
#include "sensor.hpp"
#include "world.hpp"

namespace occgrid {

/// What the PARAM lines set: metres, radians, probabilities, log-odds; the
/// table of SPEC.md section 5.2.
struct Settings {
  std::int64_t width = 0;
  std::int64_t height = 0;
  double resolution = 0.0;
  double origin_x = 0.0;
  double origin_y = 0.0;
  double max_range = 0.0;
  double p0 = 0.5;
  double p_occ = 0.75;
  double p_free = 0.30;
  double l_min = -8.0;
  double l_max = 8.0;
  NoReturn no_return = NoReturn::free;
  double fov = pi;
  std::int64_t beams = 181;
  double noise_std = 0.02;

  /// An empty map.
  OccupancyGrid new_grid() const;
};

/// A bare pose, whose scan is to be simulated, or a recorded scan.
using ScenarioScan = std::variant<Pose, Scan>;

/// Settings, walls and scans, the scans read one by one as they are asked for.
struct Scenario {
  std::string name;
  Settings settings;
  std::vector<Segment> walls;
  /// The next scan, or none after the last. Throws ScenarioError.
  std::function<std::optional<ScenarioScan>()> next_scan;
};

/// A scenario that breaks a rule; its text is "FILE:LINE: REASON".
class ScenarioError : public std::runtime_error {
 public:
  ScenarioError(const std::string& file, std::int64_t line,
                const std::string& reason);

  const std::int64_t line;
  const std::string reason;
};

/// Opens a scenario and reads it up to its first scan. Throws ScenarioError
/// here for what is wrong before the first scan, and from next_scan for what
/// is wrong later.
Scenario read_scenario(const std::string& file);

/// A scenario's name: its file name without the part from its last dot on.
std::string scenario_name(const std::string& file);

/// A number of SPEC.md section 5.1, NaN and infinity included, or none.
std::optional<double> parse_number(std::string_view token);

/// A whole number, digits only; 2^62 for any that is greater. Or none.
std::optional<std::int64_t> parse_whole(std::string_view token);

}  // namespace occgrid
