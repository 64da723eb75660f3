// Reading and writing do not depend on the host program's locale, neither C's
// nor C++'s.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <optional>
#include <sstream>

#include "occgrid/fast.hpp"
#include "occgrid/map_writer.hpp"
#include "occgrid/scenario.hpp"
#include "temp_folder.hpp"

namespace {

/// As in German: 1.234,5.
class GermanNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Both locales are German until its end. C's comes from the system, or from
/// localedef into a folder of the test.
class German {
 public:
  German() : before_(std::locale()) {
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) make_locale();
    std::locale::global(
        std::locale(std::locale::classic(), new GermanNumbers));
    // std::locale::global may have changed C's
    c_is_german_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  }
  German(const German&) = delete;
  German& operator=(const German&) = delete;
  ~German() {
    std::locale::global(before_);
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
  }

  bool c_is_german() const { return c_is_german_; }

 private:
  void make_locale() {
    const std::string command = "localedef -i de_DE -f UTF-8 '" +
                                folder_.file("de_DE.UTF-8") + "' 2>&1";
    if (std::system(command.c_str()) == 0) {
      setenv("LOCPATH", folder_.file("").c_str(), 1);
    }
  }

  TempFolder folder_;
  std::locale before_;
  bool c_is_german_ = false;
};

// A width with a thousands separator, a range of 23 digits, an odd origin.
const std::string log =
    "PARAM occgrid_width 1234\nPARAM occgrid_height 2\nPARAM "
    "occgrid_resolution 0.5\nPARAM occgrid_origin_x -1234.5\nPARAM "
    "occgrid_origin_y -0.5\nPARAM occgrid_max_range 9.75\nPARAM occgrid_p_occ "
    "0.7500000000000000000001\nFLASER 2 3.1415926535897932384626 2.5 -1200.25 "
    "0 0 a b c d e f\nPOSE -1100.125 0 1.5\n";

std::string map_of(const std::string& path) {
  std::ostringstream out;
  const auto grid =
      occgrid::map_scenario_fast(occgrid::read_scenario(path), 3);
  occgrid::map_pgm(grid, out);
  occgrid::map_yaml(grid, "1.234,5", out);
  occgrid::map_log_odds(grid, out);
  return out.str();
}

TEST(Locale, GermanHostProgram) {
  const TempFolder folder;
  const std::string path = folder.write("a.log", log);
  const std::string expected = map_of(path);
  occgrid::write_map(
      folder.file("c"), "a",
      occgrid::map_scenario_fast(occgrid::read_scenario(path), std::nullopt));
  std::string found, message;
  {
    const German german;
    ASSERT_TRUE(german.c_is_german())
        << "no de_DE.UTF-8, and localedef makes none: install locales";
    // both are what they should be
    ASSERT_EQ(std::strtod("1,5", nullptr), 1.5);
    std::ostringstream number;
    number << 1234 << ' ' << 1.5;
    ASSERT_EQ(number.str(), "1.234 1,5");

    found = map_of(path);
    occgrid::write_map(folder.file("german"), "a",
                       occgrid::map_scenario_fast(occgrid::read_scenario(path),
                                                  std::nullopt));
    try {
      occgrid::read_scenario(folder.write(
          "b.log", std::string(2000, '\n') + "PARAM occgrid_p0 1,5\n"));
    } catch (const occgrid::ScenarioError& error) {
      message = error.what();
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(message,
            folder.file("b.log") + ":2001: occgrid_p0 '1,5' is not a number");
  for (const char* file : {"a.pgm", "a.yaml", "a.logodds"}) {
    EXPECT_EQ(folder.read(std::string("german/") + file),
              folder.read(std::string("c/") + file));
  }
}

}  // namespace
