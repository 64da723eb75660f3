#include "occgrid/scenario.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <string_view>

#include "line_reader.hpp"
#include "numbers.hpp"
#include "one_line.hpp"

namespace occgrid {
namespace {

constexpr std::int64_t max_cells = 25000000;
constexpr std::int64_t max_range_cells = 1000000;

enum class Kind { whole, real, probability, no_return };

/// A row of the table of parameters: name, kind, limits as they are printed,
/// and where the value goes.
struct Parameter {
  std::string_view name;
  Kind kind;
  std::string_view low;
  std::string_view high;
  std::int64_t Settings::*whole;
  double Settings::*real;
};

struct Limits {
  std::string_view low;
  std::string_view high;
};

constexpr Limits coordinate_limits{"-10000000", "10000000"};
constexpr Limits angle_limits{"-1000000", "1000000"};
constexpr Limits beam_limits{"1", "100000"};
constexpr Limits remission_limits{"0", "100000"};

constexpr Parameter whole(std::string_view name, Limits limits,
                          std::int64_t Settings::*value) {
  return {name, Kind::whole, limits.low, limits.high, value, nullptr};
}

constexpr Parameter real(std::string_view name, Limits limits,
                         double Settings::*value) {
  return {name, Kind::real, limits.low, limits.high, nullptr, value};
}

constexpr Parameter probability(std::string_view name,
                                double Settings::*value) {
  return {name, Kind::probability, "", "", nullptr, value};
}

constexpr std::array<Parameter, 16> parameters{{
    whole("width", {"1", "25000000"}, &Settings::width),
    whole("height", {"1", "25000000"}, &Settings::height),
    real("resolution", {"0.001", "1000"}, &Settings::resolution),
    real("origin_x", coordinate_limits, &Settings::origin_x),
    real("origin_y", coordinate_limits, &Settings::origin_y),
    real("max_range", {"0.001", "10000"}, &Settings::max_range),
    real("min_range", {"0", "10000"}, &Settings::min_range),
    probability("p0", &Settings::p0),
    probability("p_occ", &Settings::p_occ),
    probability("p_free", &Settings::p_free),
    real("l_min", {"-1000", "1000"}, &Settings::l_min),
    real("l_max", {"-1000", "1000"}, &Settings::l_max),
    {"no_return", Kind::no_return, "", "", nullptr, nullptr},
    real("fov", {"0", "6.283185307179586"}, &Settings::fov),
    whole("beams", beam_limits, &Settings::beams),
    real("noise_std", {"0", "1000"}, &Settings::noise_std),
}};
constexpr std::size_t required = 6;  // the first rows

constexpr std::string_view prefix = "occgrid_";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Fields = std::vector<std::string_view>;

bool is_word(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         c == '_';
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

enum : unsigned char { plain = 0, blank = 1, not_plain = 2 };

/// What each byte is in a line.
constexpr std::array<unsigned char, 256> kinds_of_bytes() {
  std::array<unsigned char, 256> kinds{};
  for (unsigned c = 0; c < 256; ++c) {
    kinds[c] = c >= 0x20 && c <= 0x7e ? plain : not_plain;
  }
  kinds[' '] = kinds['\t'] = blank;
  return kinds;
}
constexpr std::array<unsigned char, 256> kinds = kinds_of_bytes();

/// The fields of a line. Returns whether all of it is plain ASCII.
bool split(std::string_view line, Fields& fields) {
  const auto kind = [](const char* at) {
    return kinds[static_cast<unsigned char>(*at)];
  };
  fields.clear();
  unsigned seen = plain;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (true) {
    while (at != end && kind(at) == blank) ++at;
    if (at == end) return (seen & not_plain) == 0;
    const char* const start = at;
    for (; at != end && kind(at) != blank; ++at) seen |= kind(at);
    fields.emplace_back(start, static_cast<std::size_t>(at - start));
  }
}

/// Drops a field that begins with # and all after it.
void drop_comment(Fields& fields) {
  const auto comment =
      std::find_if(fields.begin(), fields.end(),
                   [](std::string_view field) { return field[0] == '#'; });
  fields.erase(comment, fields.end());
}

/// Goes through a file line by line.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), lines_(path) {}

  /// The settings and walls, up to the first scan.
  void read_settings() {
    while (next_line()) {
      if (is_scan()) {
        check_settings();
        return;
      }
      if (is_parameter()) {
        read_parameter();
      } else if (keyword() == "WALL") {
        read_wall();
      }
    }
    fail("no scan");
  }

  /// The scan at hand, then all after it.
  std::optional<ScenarioScan> next_scan() {
    for (bool more = at_first_scan_ || next_line(); more; more = next_line()) {
      at_first_scan_ = false;
      if (keyword() == "POSE") return read_pose();
      if (keyword() == "FLASER") return read_flaser();
      if (keyword() == "ROBOTLASER1") return read_robotlaser1();
      if (is_parameter() || keyword() == "WALL") {
        fail(std::string(keyword()) + " must stand before the first scan");
      }
    }
    return std::nullopt;
  }

  /// Fails where the file cannot be read from its start again.
  void require_another_time() const {
    if (!lines_.can_be_read_again()) fail("cannot be read a second time");
  }

  const Settings& settings() const { return settings_; }
  const std::vector<Segment>& walls() const { return walls_; }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    fail_at(line_, reason);
  }

  [[noreturn]] void fail_at(std::int64_t line,
                            const std::string& reason) const {
    throw ScenarioError(path_, line, reason);
  }

  /// Fails with "FIELD 'TOKEN' IS_WHAT".
  [[noreturn]] void fail_value(const std::string& field,
                               std::string_view token,
                               const std::string& is_what) const {
    fail(field + " '" + std::string(token) + "' " + is_what);
  }

  // --- lines ---

  /// Goes to the next line that is neither blank nor a comment, and splits it;
  /// false at the end.
  bool next_line() {
    for (std::string_view text; lines_.next(text);) {
      ++line_;
      if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
      const bool all_plain = split(text, fields_);
      if (fields_.empty() || fields_[0][0] == '#') continue;
      if (!all_plain) fail("not plain ASCII text");
      const bool plain_word =
          std::all_of(fields_[0].begin(), fields_[0].end(), is_word);
      if (!plain_word || is_digit(fields_[0][0])) {
        fail("'" + std::string(fields_[0]) + "' is not a keyword");
      }
      return true;
    }
    if (lines_.failed()) fail("cannot be read");
    return false;
  }

  std::string_view keyword() const { return fields_[0]; }
  std::size_t value_count() const { return fields_.size() - 1; }
  std::string_view value(std::size_t i) const { return fields_[i + 1]; }

  bool is_scan() const {
    return keyword() == "POSE" || keyword() == "FLASER" ||
           keyword() == "ROBOTLASER1";
  }

  /// Whether the line sets a parameter of ours, and not of another program.
  bool is_parameter() const {
    return keyword() == "PARAM" && value_count() > 0 &&
           starts_with(value(0), prefix);
  }

  // --- PARAM and WALL ---

  void read_parameter() {
    expect(2);
    const std::string name(value(0));
    const auto row = std::find_if(
        parameters.begin(), parameters.end(), [&](const Parameter& p) {
          return p.name == value(0).substr(prefix.size());
        });
    if (row == parameters.end()) fail("unknown parameter " + name);
    std::int64_t& line = line_of(*row);
    if (line != 0) fail(name + " is given twice");
    line = line_;

    const std::string_view token = value(1);
    switch (row->kind) {
      case Kind::whole:
        settings_.*row->whole =
            whole_number(name, token, {row->low, row->high});
        break;
      case Kind::real:
        settings_.*row->real = real_number(name, token, {row->low, row->high});
        break;
      case Kind::probability: {
        const double p = number(name, token);
        if (!(p > 0.0 && p < 1.0))
          fail_value(name, token, "is not between 0 and 1");
        settings_.*row->real = p;
        break;
      }
      case Kind::no_return:
        if (token != "free" && token != "ignore") {
          fail_value(name, token, "is not free or ignore");
        }
        settings_.no_return =
            token == "free" ? NoReturn::free : NoReturn::ignore;
        break;
    }
  }

  void read_wall() {
    expect(4);
    const double x0 = coordinate("x0", value(0));
    const double y0 = coordinate("y0", value(1));
    const double x1 = coordinate("x1", value(2));
    const double y1 = coordinate("y1", value(3));
    walls_.push_back({x0, y0, x1, y1});
  }

  /// Checks the parameters as a whole, at the first scan.
  void check_settings() const {
    for (std::size_t i = 0; i < required; ++i) {
      if (given_at_[i] == 0) {
        fail(std::string(prefix) + std::string(parameters[i].name) +
             " is missing");
      }
    }
    if (settings_.width * settings_.height > max_cells) {
      fail_at(
          latest({"width", "height"}),
          "the grid has more than " + std::to_string(max_cells) + " cells");
    }
    if (settings_.max_range / settings_.resolution >
        static_cast<double>(max_range_cells)) {
      fail_at(latest({"max_range", "resolution"}),
              "occgrid_max_range is more than " +
                  std::to_string(max_range_cells) + " cells");
    }
    if (!(settings_.l_min < settings_.l_max)) {
      fail_at(latest({"l_min", "l_max"}),
              "occgrid_l_min is not below occgrid_l_max");
    }
    const double l0 = logit(settings_.p0);
    if (!(settings_.l_min <= l0 && l0 <= settings_.l_max)) {
      fail_at(latest({"p0", "l_min", "l_max"}),
              "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max");
    }
    if (!(settings_.min_range < settings_.max_range)) {
      fail_at(latest({"min_range", "max_range"}),
              "occgrid_min_range is not below occgrid_max_range");
    }
  }

  /// The number of the line that gave a parameter; 0 while none did.
  std::int64_t& line_of(const Parameter& row) {
    return given_at_[static_cast<std::size_t>(&row - parameters.data())];
  }

  /// The latest of the lines of these parameters.
  std::int64_t latest(std::initializer_list<std::string_view> names) const {
    std::int64_t line = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (std::find(names.begin(), names.end(), parameters[i].name) !=
          names.end()) {
        line = std::max(line, given_at_[i]);
      }
    }
    return line;
  }

  // --- scans ---

  Pose read_pose() {
    expect(3);
    return pose(0);
  }

  /// FLASER n r1 .. rn x y theta and six fields that are not looked at.
  Scan read_flaser() const {
    const std::size_t found = value_count();
    if (found == 0) fail("FLASER has no beam count");
    const std::size_t n = count("beam count", value(0), beam_limits);
    if (found != n + 10) {
      fail("FLASER with " + std::to_string(n) + " beams takes " +
           std::to_string(n + 10) + " values, found " + std::to_string(found));
    }
    Eigen::ArrayXd r = ranges(1, n);
    return {pose(n + 1), flaser_angles(static_cast<Eigen::Index>(n)),
            std::move(r)};
  }

  /// ROBOTLASER1 type start fov step max accuracy mode n r1 .. rn m e1 .. em x
  /// y theta and eleven fields.
  Scan read_robotlaser1() const {
    const std::size_t found = value_count();
    if (found < 8) fail("ROBOTLASER1 has no beam count");
    const std::size_t n = count("beam count", value(7), beam_limits);
    if (found < n + 23) {
      fail("ROBOTLASER1 with " + std::to_string(n) + " beams takes at least " +
           std::to_string(n + 23) + " values, found " + std::to_string(found));
    }
    const std::size_t m =
        count("remission count", value(n + 8), remission_limits);
    if (found != n + m + 23) {
      fail("ROBOTLASER1 with " + std::to_string(n) + " beams and " +
           std::to_string(m) + " remissions takes " +
           std::to_string(n + m + 23) + " values, found " +
           std::to_string(found));
    }
    const double start = angle("start", value(1));
    const double step = angle("step", value(3));
    Eigen::ArrayXd r = ranges(8, n);
    Eigen::ArrayXd angles(r.size());
    for (Eigen::Index i = 0; i < angles.size(); ++i) {
      angles[i] = start + static_cast<double>(i) * step;
    }
    return {pose(n + m + 9), std::move(angles), std::move(r)};
  }

  /// x, y and theta, the values from the first on.
  Pose pose(std::size_t first) const {
    const double x = coordinate("x", value(first));
    const double y = coordinate("y", value(first + 1));
    const double theta = angle("theta", value(first + 2));
    return {x, y, theta};
  }

  /// n ranges in metres, NaN and infinity among them, the values from the
  /// first on. One below min_range becomes NaN, which is ignored.
  Eigen::ArrayXd ranges(std::size_t first, std::size_t n) const {
    Eigen::ArrayXd r(static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const std::string_view token = value(first + i);
      std::optional<double> range = parse_number(token);
      if (!range || *range < 0.0) {
        fail_value("range " + std::to_string(i), token,
                   range ? "is negative" : "is not a number");
      }
      if (*range < settings_.min_range) range = nan;
      r[static_cast<Eigen::Index>(i)] = *range;
    }
    return r;
  }

  // --- values ---

  /// Drops the comment from the line and checks the number of its values.
  void expect(std::size_t n) {
    drop_comment(fields_);
    if (value_count() != n) {
      fail(std::string(keyword()) + " takes " + std::to_string(n) +
           " values, found " + std::to_string(value_count()));
    }
  }

  double number(const std::string& field, std::string_view token) const {
    const std::optional<double> value = parse_number(token);
    if (!value) fail_value(field, token, "is not a number");
    return *value;
  }

  double real_number(const std::string& field, std::string_view token,
                     Limits limits) const {
    const double value = number(field, token);
    if (!(value >= *parse_number(limits.low) &&
          value <= *parse_number(limits.high))) {
      fail_limits(field, token, limits);
    }
    return value;
  }

  std::int64_t whole_number(const std::string& field, std::string_view token,
                            Limits limits) const {
    const std::optional<std::int64_t> value = parse_whole(token);
    if (!value) fail_value(field, token, "is not a whole number");
    if (*value < *parse_whole(limits.low) ||
        *value > *parse_whole(limits.high)) {
      fail_limits(field, token, limits);
    }
    return *value;
  }

  std::size_t count(const std::string& field, std::string_view token,
                    Limits limits) const {
    return static_cast<std::size_t>(whole_number(field, token, limits));
  }

  double coordinate(const std::string& field, std::string_view token) const {
    return real_number(field, token, coordinate_limits);
  }

  double angle(const std::string& field, std::string_view token) const {
    return real_number(field, token, angle_limits);
  }

  [[noreturn]] void fail_limits(const std::string& field,
                                std::string_view token, Limits limits) const {
    fail_value(field, token,
               "is not from " + std::string(limits.low) + " to " +
                   std::string(limits.high));
  }

  std::string path_;
  LineReader lines_;
  std::int64_t line_ = 0;  // the number of the last one read
  Fields fields_;          // of the line, good until the next is read
  bool at_first_scan_ = true;
  Settings settings_;
  /// The line that gave each parameter, or 0.
  std::array<std::int64_t, parameters.size()> given_at_{};
  std::vector<Segment> walls_;
};

}  // namespace

OccupancyGrid Settings::new_grid() const {
  const GridSpec spec{width, height, resolution, origin_x, origin_y};
  return OccupancyGrid(spec, p0, p_occ, p_free, l_min, l_max);
}

ScenarioError::ScenarioError(const std::string& file, std::int64_t line,
                             const std::string& reason)
    : std::runtime_error(one_line(file) + ":" + std::to_string(line) + ": " +
                         reason),
      line_(line),
      reason_(reason) {}

Scenario read_scenario(const std::string& path) {
  const auto first = std::make_shared<Reader>(path);
  first->read_settings();
  // The reader at hand gives the scans the first time, so that a pipe can be
  // mapped. After that each time has a reader of its own.
  const auto taken = std::make_shared<std::atomic<bool>>(false);
  const auto scans = [path, first, taken]() -> ScanSource {
    std::shared_ptr<Reader> reader = first;
    if (taken->exchange(true)) {
      first->require_another_time();
      reader = std::make_shared<Reader>(path);
      reader->read_settings();
    }
    return [reader] { return reader->next_scan(); };
  };
  return {scenario_name(path), first->settings(), first->walls(), scans};
}

std::string scenario_name(const std::string& path) {
  const std::size_t end = path.find_last_not_of('/') + 1;
  const std::size_t start = path.substr(0, end).rfind('/') + 1;
  const std::string file = path.substr(start, end - start);
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

}  // namespace occgrid
