// Mapping on several threads, for the fast path.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "beams.hpp"
#include "occgrid/grid.hpp"
#include "occgrid/scenario.hpp"

namespace occgrid {

/// Maps all scans of a scenario into a grid on so many threads, this one among
/// them.
///
/// Scans come in batches, each of which goes through three kinds of tasks: one
/// reads the scans; some find the beams, each those of a part of the scans;
/// some update the grid, each a band of its rows by all beams of the batch in
/// order. A thread that is free takes what is to be done next, so that one
/// reads while others update.
///
/// Why the bits are the same: only the order of the updates of one cell
/// matters. A cell lies in one band of a batch, which one thread updates beam
/// by beam; and a batch is updated when the one before it is done.
///
/// Example with 2 threads and two batches: A reads 1; A reads 2 while B finds
/// the beams of one half of 1; A finds those of the other half; A updates the
/// lower rows by 1 and B the upper ones; and so on with 2.
void map_on_threads(OccupancyGrid& grid, const Scenario& scenario,
                    std::optional<std::uint32_t> seed, int threads);

/// Cuts the rows 0 .. height-1 into bands, in order, that take about as many
/// updates by these beams each. Some may be empty.
std::vector<Rows> cut_bands(const std::vector<std::vector<Beam>>& beams,
                            std::int64_t height, std::size_t bands);

}  // namespace occgrid
