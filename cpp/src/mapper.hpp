// The mapping loop: scan after scan into the grid (the lesson's first flow
// chart).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "grid.hpp"
#include "scenario.hpp"
#include "sensor.hpp"

namespace occgrid {

/// Maps all scans of a scenario; without a seed, free of noise. Throws
/// ScenarioError where a scan cannot be read.
OccupancyGrid map_scenario(const Scenario& scenario,
                           std::optional<std::uint32_t> seed);

/// The scans of a scenario one by one, none after the last; a bare pose is
/// simulated, with noise. The scenario must outlive it.
std::function<std::optional<Scan>()> simulated_scans(
    const Scenario& scenario, std::optional<std::uint32_t> seed);

/// map_scenario on several threads, with the same bits for any number of
/// them: each owns a band of rows and takes the updates in order, while this
/// one reads on. Memory grows with the grid and not with the log.
OccupancyGrid map_scenario_in_bands(const Scenario& scenario,
                                    std::optional<std::uint32_t> seed,
                                    int threads);

/// Cuts the rows 0 .. height-1 into bands, in order, that take about as many
/// updates by these beams each. Some may be empty.
std::vector<Rows> cut_bands(const std::vector<std::vector<Beam>>& beams,
                            std::int64_t height, int bands);

}  // namespace occgrid
