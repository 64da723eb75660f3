// Writing a map: the picture (PGM), what a navigation stack needs beside it
// (YAML), the log-odds (SPEC.md section 7). Maps are written row by row, not
// held as text, and no locale has a say.
#pragma once

#include <ostream>
#include <stdexcept>
#include <string>

#include "occgrid/grid.hpp"

namespace occgrid {

/// Grey value of log-odds: 0 is occupied, 255 is free.
int pixel(double log_odds);

/// Writes the map as an ASCII PGM (P2), the row with the largest y first. The
/// stream's state says whether it could be written, here and below.
void map_pgm(const OccupancyGrid& grid, std::ostream& out);

/// Writes the description that map_server and Nav2 read beside the picture
/// `image`, a file name. Its thresholds follow the grid's prior.
void map_yaml(const OccupancyGrid& grid, const std::string& image,
              std::ostream& out);

/// Writes the log-odds as text that reads back to the same doubles, the row
/// with the smallest y first.
void map_log_odds(const OccupancyGrid& grid, std::ostream& out);

/// A folder or file that cannot be written; its text is "PATH: cannot be
/// written", one line.
class WriteError : public std::runtime_error {
 public:
  explicit WriteError(const std::string& path);
};

/// Writes NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is made
/// where it is missing: all three or, where one cannot be written, none.
/// Throws WriteError.
void write_map(const std::string& folder, const std::string& name,
               const OccupancyGrid& grid);

}  // namespace occgrid
