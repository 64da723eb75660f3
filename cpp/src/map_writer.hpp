// Writing a map: the picture (PGM), what a navigation stack needs beside it
// (YAML), the log-odds (SPEC.md section 7). Maps are written row by row, not
// held as text.
#pragma once

#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>

#include "grid.hpp"

namespace occgrid {

/// Grey value of log-odds: 0 is occupied, 255 is free.
int pixel(double log_odds);

/// The map as an ASCII PGM (P2), the row with the largest y first.
void map_pgm(const OccupancyGrid& grid, std::ostream& out);

/// The description that map_server and Nav2 read beside the picture `image`.
void map_yaml(const OccupancyGrid& grid, const std::string& image,
              std::ostream& out);

/// The log-odds as text that reads back to the same doubles, the row with the
/// smallest y first.
void map_log_odds(const OccupancyGrid& grid, std::ostream& out);

/// A folder or file that cannot be written; its text is "PATH: cannot be
/// written".
class WriteError : public std::runtime_error {
 public:
  explicit WriteError(const std::string& path);
};

/// Writes NAME.pgm, NAME.yaml and NAME.logodds into a folder, which is made
/// where it is missing. Each file is renamed into place when all of them are
/// whole. Throws WriteError.
void write_map(const std::filesystem::path& folder, const std::string& name,
               const OccupancyGrid& grid);

}  // namespace occgrid
