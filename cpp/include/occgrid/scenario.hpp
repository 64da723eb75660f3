// Reading a scenario: a CARMEN log with PARAM, WALL and POSE lines (SPEC.md
// sections 5 and 8).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "occgrid/grid.hpp"
#include "occgrid/portable_math.hpp"
#include "occgrid/sensor.hpp"
#include "occgrid/world.hpp"

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
  double min_range = 0.0;
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

/// A bare pose, whose scan is to be simulated, or a recorded scan. Ranges
/// below min_range have become NaN: they are ignored.
using ScenarioScan = std::variant<Pose, Scan>;

/// Gives the next scan each time that it is called, and none after the last.
/// Throws ScenarioError.
using ScanSource = std::function<std::optional<ScenarioScan>()>;

/// Settings, walls and scans, the scans read one by one as they are asked for.
struct Scenario {
  std::string name;
  Settings settings;
  std::vector<Segment> walls;
  /// The scans, from the first on each time that they are asked for: a
  /// scenario can be mapped again. Throws ScenarioError where they cannot be
  /// read again, as from a pipe.
  std::function<ScanSource()> scans;
};

/// A scenario that breaks a rule; its text is "FILE:LINE: REASON", one line.
class ScenarioError : public std::runtime_error {
 public:
  ScenarioError(const std::string& file, std::int64_t line,
                const std::string& reason);

  std::int64_t line() const { return line_; }
  const std::string& reason() const { return reason_; }

 private:
  std::int64_t line_;
  std::string reason_;
};

/// Opens a scenario and reads it up to its first scan. Throws ScenarioError
/// here for what is wrong before the first scan, and from its scans for what
/// is wrong later.
Scenario read_scenario(const std::string& path);

/// A scenario's name: its file name without the part from its last dot on,
/// where that is not its first character.
std::string scenario_name(const std::string& path);

}  // namespace occgrid
