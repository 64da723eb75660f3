// The mapping loop: scan after scan into the grid (the lesson's first flow
// chart).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "occgrid/grid.hpp"
#include "occgrid/scenario.hpp"
#include "occgrid/sensor.hpp"

namespace occgrid {

/// Maps all scans of a scenario, scan by scan and beam by beam; without a
/// seed, free of noise. Throws ScenarioError where a scan cannot be read, and
/// what update_grid_from_scan throws.
OccupancyGrid map_scenario(const Scenario& scenario,
                           std::optional<std::uint32_t> seed);

/// What the simulated sensor reads from a pose (lesson section 6), with noise
/// where there is a seed; `number` is the scan's in its scenario, from 0.
Scan simulated_scan(const Scenario& scenario, const Pose& pose,
                    std::uint32_t number, std::optional<std::uint32_t> seed);

/// The scans of a scenario one by one, none after the last; a bare pose is
/// simulated. The scenario must outlive it.
std::function<std::optional<Scan>()> simulated_scans(
    const Scenario& scenario, std::optional<std::uint32_t> seed);

}  // namespace occgrid
