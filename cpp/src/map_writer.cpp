#include "occgrid/map_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "one_line.hpp"
#include "whole_files.hpp"

namespace occgrid {

// [snippet: pixel]
int pixel(double log_odds) {
  const double free = 1.0 - sigmoid(log_odds);
  return static_cast<int>(std::floor(free * 255.0 + 0.5));
}
// [/snippet]

namespace {

/// Appends a number's shortest text that reads back to it; <charconv> knows no
/// locale.
template <typename Number>
void append(std::string& text, Number number) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

/// The exact value rounded to nine decimals, without trailing zeros but one.
std::string fixed(double value) {
  std::array<char, 400>
      digits;  // the greatest double has 309 before its point
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 value, std::chars_format::fixed, 9)
                       .ptr;
  std::string text(digits.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

}  // namespace

// [snippet: map-pgm]
void map_pgm(const OccupancyGrid& grid, std::ostream& out) {
  const GridArray& log_odds = grid.log_odds();
  std::string line = "P2\n";
  append(line, log_odds.cols());
  line += ' ';
  append(line, log_odds.rows());
  out << line << "\n255\n";
  for (Eigen::Index gy = log_odds.rows() - 1; gy >= 0; --gy) {
    line.clear();
    for (Eigen::Index gx = 0; gx < log_odds.cols(); ++gx) {
      if (gx > 0) line += ' ';
      append(line, pixel(log_odds(gy, gx)));
    }
    out << line << '\n';
  }
}
// [/snippet]

namespace {

/// A file name as YAML has it: plain where nothing can be mistaken, else in
/// double quotes.
std::string quoted(const std::string& name) {
  constexpr std::string_view hexadecimal = "0123456789ABCDEF";
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
  };
  if (!name.empty() && std::all_of(name.begin(), name.end(), is_plain) &&
      name[0] != '-' && name[0] != '.') {
    return name;
  }
  std::string text = "\"";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      text += {'\\', 'x', hexadecimal[byte >> 4], hexadecimal[byte & 15]};
    } else {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
  }
  return text += '"';
}

}  // namespace

void map_yaml(const OccupancyGrid& grid, const std::string& image,
              std::ostream& out) {
  const GridSpec& spec = grid.spec();
  // Between the thresholds lies what is not known: the prior, as its pixel
  // reads back.
  const double l0 = grid.l0();
  const double prior = 255.0 - pixel(l0);
  const double occupied = std::min(
      1.0, std::max(sigmoid(l0 + logit(0.65)), (prior + 0.5) / 255.0));
  const double free = std::max(
      0.0, std::min(sigmoid(l0 + logit(0.196)), (prior - 0.5) / 255.0));
  out << "image: " << quoted(image) << "\n"
      << "mode: trinary\n"
      << "resolution: " << fixed(spec.resolution) << "\n"
      << "origin: [" << fixed(spec.origin_x) << ", " << fixed(spec.origin_y)
      << ", 0.0]\n"
      << "negate: 0\n"
      << "occupied_thresh: " << fixed(occupied) << "\n"
      << "free_thresh: " << fixed(free) << "\n";
}

void map_log_odds(const OccupancyGrid& grid, std::ostream& out) {
  const GridArray& log_odds = grid.log_odds();
  std::string line = "# logodds ";
  append(line, log_odds.cols());
  line += ' ';
  append(line, log_odds.rows());
  out << line << '\n';
  for (Eigen::Index gy = 0; gy < log_odds.rows(); ++gy) {
    line.clear();
    for (Eigen::Index gx = 0; gx < log_odds.cols(); ++gx) {
      if (gx > 0) line += ' ';
      append(line, log_odds(gy, gx));
    }
    out << line << '\n';
  }
}

WriteError::WriteError(const std::string& path)
    : std::runtime_error(one_line(path) + ": cannot be written") {}

void write_map(const std::string& folder, const std::string& name,
               const OccupancyGrid& grid) {
  WholeFiles files(folder);
  const std::string image = name + ".pgm";
  files.write(image, [&](std::ostream& out) { map_pgm(grid, out); });
  files.write(name + ".yaml",
              [&](std::ostream& out) { map_yaml(grid, image, out); });
  files.write(name + ".logodds",
              [&](std::ostream& out) { map_log_odds(grid, out); });
  files.publish();
}

}  // namespace occgrid
