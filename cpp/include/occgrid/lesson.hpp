// The lesson, built in (lesson section 6): a robot drives an ellipse in a box
// with two inner walls.
#pragma once

#include <vector>

#include "occgrid/scenario.hpp"
#include "occgrid/world.hpp"

namespace occgrid {

/// Grid, inverse sensor model and simulated sensor of the lesson.
Settings lesson_settings();

/// A box of 20 m x 16 m, a vertical and a horizontal wall in it.
std::vector<Segment> lesson_world();

/// 120 poses on an ellipse, the heading along it.
std::vector<Pose> lesson_poses();

/// The lesson as a scenario, named "lesson".
Scenario lesson_scenario();

}  // namespace occgrid
