#include "map_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <random>
#include <vector>

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
  const GridSpec& spec = grid.spec;
  out << "P2\n" << spec.width << ' ' << spec.height << "\n255\n";
  std::string line;
  for (Eigen::Index gy = spec.height - 1; gy >= 0; --gy) {
    line.clear();
    for (Eigen::Index gx = 0; gx < spec.width; ++gx) {
      if (gx > 0) line += ' ';
      append(line, pixel(grid.log_odds(gy, gx)));
    }
    out << line << '\n';
  }
}
// [/snippet]

void map_yaml(const OccupancyGrid& grid, const std::string& image,
              std::ostream& out) {
  const GridSpec& spec = grid.spec;
  out << "image: " << image << "\n"
      << "mode: trinary\n"
      << "resolution: " << fixed(spec.resolution) << "\n"
      << "origin: [" << fixed(spec.origin_x) << ", " << fixed(spec.origin_y)
      << ", 0.0]\n"
      << "negate: 0\n"
      << "occupied_thresh: 0.65\n"
      << "free_thresh: 0.196\n";
}

void map_log_odds(const OccupancyGrid& grid, std::ostream& out) {
  const GridSpec& spec = grid.spec;
  out << "# logodds " << spec.width << ' ' << spec.height << '\n';
  std::string line;
  for (Eigen::Index gy = 0; gy < spec.height; ++gy) {
    line.clear();
    for (Eigen::Index gx = 0; gx < spec.width; ++gx) {
      if (gx > 0) line += ' ';
      append(line, grid.log_odds(gy, gx));
    }
    out << line << '\n';
  }
}

WriteError::WriteError(const std::string& path)
    : std::runtime_error(path + ": cannot be written") {}

namespace {

/// A file that is written under another name beside its own and takes its name
/// when it is whole. What was not published is removed.
class FileBeside {
 public:
  FileBeside(std::filesystem::path path, const std::string& suffix)
      : path_(std::move(path)), beside_(path_) {
    beside_.replace_filename("." + path_.filename().string() + suffix);
  }

  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  ~FileBeside() {
    std::error_code ignored;
    if (written_) std::filesystem::remove(beside_, ignored);
  }

  void write(const std::function<void(std::ostream&)>& contents) {
    std::ofstream out(beside_, std::ios::binary);
    written_ = out.is_open();
    contents(out);
    out.close();
    if (!out) throw WriteError(path_.string());
  }

  void publish() {
    std::error_code error;
    std::filesystem::rename(beside_, path_, error);
    if (error) throw WriteError(path_.string());
    written_ = false;
  }

 private:
  std::filesystem::path path_;
  std::filesystem::path beside_;
  bool written_ = false;
};

}  // namespace

void write_map(const std::filesystem::path& folder, const std::string& name,
               const OccupancyGrid& grid) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw WriteError(folder.string());

  // a random suffix, so that two runs into one folder do not meet
  std::string suffix = ".";
  append(suffix, std::random_device{}());
  suffix += ".part";
  FileBeside pgm(folder / (name + ".pgm"), suffix);
  FileBeside yaml(folder / (name + ".yaml"), suffix);
  FileBeside log_odds(folder / (name + ".logodds"), suffix);
  pgm.write([&](std::ostream& out) { map_pgm(grid, out); });
  yaml.write([&](std::ostream& out) { map_yaml(grid, name + ".pgm", out); });
  log_odds.write([&](std::ostream& out) { map_log_odds(grid, out); });
  pgm.publish();
  yaml.publish();
  log_odds.publish();
}

}  // namespace occgrid
