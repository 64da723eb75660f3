// Whether two grids are equal in every bit.
#pragma once

#include <cstring>

#include "occgrid/grid.hpp"

inline bool same_bits(const occgrid::OccupancyGrid& one,
                      const occgrid::OccupancyGrid& other) {
  const auto cells = static_cast<std::size_t>(one.log_odds().size());
  return one.log_odds().rows() == other.log_odds().rows() &&
         one.log_odds().cols() == other.log_odds().cols() &&
         std::memcmp(one.log_odds().data(), other.log_odds().data(),
                     cells * sizeof(double)) == 0;
}
