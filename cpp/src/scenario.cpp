#include "scenario.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

namespace occgrid {
namespace {

constexpr std::int64_t max_cells = 25000000;
constexpr std::int64_t max_range_cells = 1000000;
constexpr std::int64_t max_whole = std::int64_t{1} << 62;

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

constexpr Limits coordinate_limits{"-1000000", "1000000"};
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

constexpr std::array<Parameter, 15> parameters{{
    whole("width", {"1", "25000000"}, &Settings::width),
    whole("height", {"1", "25000000"}, &Settings::height),
    real("resolution", {"0.001", "1000"}, &Settings::resolution),
    real("origin_x", coordinate_limits, &Settings::origin_x),
    real("origin_y", coordinate_limits, &Settings::origin_y),
    real("max_range", {"0.001", "10000"}, &Settings::max_range),
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

using Fields = std::vector<std::string_view>;

// Characters are compared as such: the functions of <cctype> depend on the
// locale.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool is_word(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         c == '_';
}
bool is_plain(char c) {
  return (c >= 0x20 && c <= 0x7e) || c == '\t';
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  const auto same = [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
  };
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                    same);
}

void split(std::string_view line, Fields& fields) {
  fields.clear();
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && is_blank(line[i])) ++i;
    const std::size_t start = i;
    while (i < line.size() && !is_blank(line[i])) ++i;
    if (i > start) fields.push_back(line.substr(start, i - start));
  }
}

/// Drops a field that begins with # and all after it.
void drop_comment(Fields& fields) {
  const auto comment =
      std::find_if(fields.begin(), fields.end(),
                   [](std::string_view field) { return field[0] == '#'; });
  fields.erase(comment, fields.end());
}

/// An unsigned decimal, correctly rounded, or none.
std::optional<double> parse_decimal(std::string_view text) {
  constexpr std::array<double, 23> powers_of_ten{
      1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::int64_t exact_integers = std::int64_t{1} << 53;
  constexpr int exact_powers = 22;

  std::int64_t digits = 0;  // without the point
  int scale = 0;            // the value is digits * 10^scale
  bool exact = true;        // whether digits holds all of them
  std::size_t count = 0;
  std::size_t i = 0;
  const auto take_digits = [&] {
    for (; i < text.size() && is_digit(text[i]); ++i, ++count) {
      exact = exact && digits <= exact_integers / 10 - 1;
      if (exact) digits = 10 * digits + (text[i] - '0');
    }
  };
  take_digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    const std::size_t before = count;
    take_digits();
    if (count - before > exact_powers) exact = false;
    if (exact) scale = -static_cast<int>(count - before);
  }
  if (count == 0) return std::nullopt;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    const std::size_t start = i;
    int exponent = 0;
    for (; i < text.size() && is_digit(text[i]); ++i) {
      exponent = std::min(10 * exponent + (text[i] - '0'), 1000);
    }
    if (i == start) return std::nullopt;
    scale += negative ? -exponent : exponent;
  }
  if (i < text.size()) return std::nullopt;

  // both exact as doubles: one operation, rounded once
  if (exact && std::abs(scale) <= exact_powers) {
    const double power =
        powers_of_ten[static_cast<std::size_t>(std::abs(scale))];
    const auto number = static_cast<double>(digits);
    return scale < 0 ? number / power : number * power;
  }
  // the general case; std::from_chars would not tell overflow from underflow,
  // and few have it
  return std::strtod(std::string(text).c_str(), nullptr);
}

/// Goes through a file line by line; line_ is the number of the last one read.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(file, ignored))
      stream_.open(file, std::ios::binary);
    if (!stream_.is_open()) fail("cannot be read");
  }

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

  const Settings& settings() const { return settings_; }
  const std::vector<Segment>& walls() const { return walls_; }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    fail_at(line_, reason);
  }

  [[noreturn]] void fail_at(std::int64_t line,
                            const std::string& reason) const {
    throw ScenarioError(file_, line, reason);
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
    while (std::getline(stream_, text_)) {
      ++line_;
      if (!text_.empty() && text_.back() == '\r') text_.pop_back();
      split(text_, fields_);
      if (fields_.empty() || fields_[0][0] == '#') continue;
      if (!std::all_of(text_.begin(), text_.end(), is_plain))
        fail("not plain ASCII text");
      const bool plain_word =
          std::all_of(fields_[0].begin(), fields_[0].end(), is_word);
      if (!plain_word || is_digit(fields_[0][0])) {
        fail("'" + std::string(fields_[0]) + "' is not a keyword");
      }
      return true;
    }
    if (stream_.bad()) fail("cannot be read");
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
      if (lines_[i] == 0) {
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
  }

  /// The number of the line that gave a parameter; 0 while none did.
  std::int64_t& line_of(const Parameter& row) {
    return lines_[static_cast<std::size_t>(&row - parameters.data())];
  }

  /// The latest of the lines of these parameters.
  std::int64_t latest(std::initializer_list<std::string_view> names) const {
    std::int64_t line = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (std::find(names.begin(), names.end(), parameters[i].name) !=
          names.end()) {
        line = std::max(line, lines_[i]);
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
    const double start = coordinate("start", value(1));
    const double step = coordinate("step", value(3));
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
    const double theta = coordinate("theta", value(first + 2));
    return {x, y, theta};
  }

  /// n ranges in metres, NaN and infinity among them, the values from the
  /// first on.
  Eigen::ArrayXd ranges(std::size_t first, std::size_t n) const {
    Eigen::ArrayXd r(static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const std::string_view token = value(first + i);
      const std::optional<double> range = parse_number(token);
      if (!range || *range < 0.0) {
        fail_value("range " + std::to_string(i), token,
                   range ? "is negative" : "is not a number");
      }
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

  [[noreturn]] void fail_limits(const std::string& field,
                                std::string_view token, Limits limits) const {
    fail_value(field, token,
               "is not from " + std::string(limits.low) + " to " +
                   std::string(limits.high));
  }

  std::string file_;
  std::ifstream stream_;
  std::int64_t line_ = 0;
  std::string text_;  // of the line
  Fields fields_;     // of the line, views into text_
  bool at_first_scan_ = true;
  Settings settings_;
  std::array<std::int64_t, parameters.size()>
      lines_{};  // that gave each parameter, or 0
  std::vector<Segment> walls_;
};

}  // namespace

OccupancyGrid Settings::new_grid() const {
  const GridSpec spec{width, height, resolution, origin_x, origin_y};
  return OccupancyGrid(spec, p0, p_occ, p_free, l_min, l_max);
}

ScenarioError::ScenarioError(const std::string& file, std::int64_t line_,
                             const std::string& reason_)
    : std::runtime_error(file + ":" + std::to_string(line_) + ": " + reason_),
      line(line_),
      reason(reason_) {}

Scenario read_scenario(const std::string& file) {
  const auto reader = std::make_shared<Reader>(file);
  reader->read_settings();
  return {scenario_name(file), reader->settings(), reader->walls(),
          [reader] { return reader->next_scan(); }};
}

std::string scenario_name(const std::string& file) {
  const std::string file_name =
      std::filesystem::path(file).filename().string();
  const std::size_t dot = file_name.rfind('.');
  return dot == std::string::npos || dot == 0 ? file_name
                                              : file_name.substr(0, dot);
}

std::optional<double> parse_number(std::string_view token) {
  const bool negative = !token.empty() && token[0] == '-';
  if (negative || (!token.empty() && token[0] == '+')) token.remove_prefix(1);
  if (equals_ignoring_case(token, "nan"))
    return std::numeric_limits<double>::quiet_NaN();

  double magnitude = std::numeric_limits<double>::infinity();
  if (!equals_ignoring_case(token, "inf") &&
      !equals_ignoring_case(token, "infinity")) {
    const std::optional<double> decimal = parse_decimal(token);
    if (!decimal) return std::nullopt;
    magnitude = *decimal;
  }
  // Near the ends of the range languages read differently; no measurement lies
  // there.
  if (magnitude >= 1e300) magnitude = std::numeric_limits<double>::infinity();
  if (magnitude < 1e-300) return 0.0;
  return negative ? -magnitude : magnitude;
}

std::optional<std::int64_t> parse_whole(std::string_view token) {
  if (token.empty() || !std::all_of(token.begin(), token.end(), is_digit))
    return std::nullopt;
  std::int64_t value = 0;
  for (const char c : token) {
    if (value > max_whole / 10) return max_whole;
    value = 10 * value + (c - '0');
  }
  return std::min(value, max_whole);
}

}  // namespace occgrid
