#include "occgrid/lesson.hpp"

#include <utility>

#include "occgrid/portable_math.hpp"

namespace occgrid {

// [snippet: lesson-settings]
Settings lesson_settings() {
  Settings settings;
  settings.width = 220;
  settings.height = 180;
  settings.resolution = 0.1;
  settings.origin_x = -11.0;
  settings.origin_y = -9.0;
  settings.max_range = 10.0;
  settings.p0 = 0.5;
  settings.p_occ = 0.75;
  settings.p_free = 0.30;
  settings.l_min = -8.0;
  settings.l_max = 8.0;
  settings.no_return = NoReturn::free;
  settings.fov = pi;
  settings.beams = 181;
  settings.noise_std = 0.02;
  return settings;
}
// [/snippet]

// [snippet: lesson-world]
std::vector<Segment> lesson_world() {
  std::vector<Segment> walls = build_box_world(-10.0, -8.0, 10.0, 8.0);
  walls.push_back(add_vertical_wall(0.0, -6.0, 6.0));
  walls.push_back(add_horizontal_wall(2.0, -8.0, -2.0));
  return walls;
}
// [/snippet]

// [snippet: lesson-poses]
std::vector<Pose> lesson_poses() {
  std::vector<Pose> poses;
  for (int t = 0; t < 120; ++t) {
    const double ang = (2.0 * pi) * (t / 120.0);
    const double x = -6.0 + 6.0 * cos(ang);
    const double y = 0.0 + 4.0 * sin(ang);
    poses.push_back({x, y, ang + pi / 2.0});
  }
  return poses;
}
// [/snippet]

Scenario lesson_scenario() {
  const auto scans = []() -> ScanSource {
    return [poses = lesson_poses(),
            t = std::size_t{0}]() mutable -> std::optional<ScenarioScan> {
      if (t == poses.size()) return std::nullopt;
      return poses[t++];
    };
  };
  return {"lesson", lesson_settings(), lesson_world(), scans};
}

}  // namespace occgrid
