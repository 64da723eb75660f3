// The mapping loop: scan after scan into the grid (the lesson's first flow
// chart).
#pragma once

#include <cstdint>
#include <optional>

#include "grid.hpp"
#include "scenario.hpp"

namespace occgrid {

/// Maps all scans of a scenario; without a seed, free of noise. Throws
/// ScenarioError where a scan cannot be read.
OccupancyGrid map_scenario(const Scenario& scenario,
                           std::optional<std::uint32_t> seed);

}  // namespace occgrid
