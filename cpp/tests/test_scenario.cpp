#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

#include "occgrid/scenario.hpp"
#include "temp_folder.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// six lines
const std::string grid_lines =
    "PARAM occgrid_width 20\n"
    "PARAM occgrid_height 10\n"
    "PARAM occgrid_resolution 0.5\n"
    "PARAM occgrid_origin_x -5\n"
    "PARAM occgrid_origin_y -2.5\n"
    "PARAM occgrid_max_range 8\n";

std::string repeat(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

/// Reads all of a scenario; the scans.
std::vector<occgrid::ScenarioScan> read_all(const std::string& text) {
  const TempFolder folder;
  const auto scenario = occgrid::read_scenario(folder.write("a.log", text));
  const auto next_scan = scenario.scans();
  std::vector<occgrid::ScenarioScan> scans;
  while (auto scan = next_scan()) scans.push_back(*scan);
  return scans;
}

void expect_error(const std::string& text, std::int64_t line,
                  const std::string& reason) {
  try {
    read_all(text);
    ADD_FAILURE() << "accepted, not refused for: " << reason;
  } catch (const occgrid::ScenarioError& error) {
    EXPECT_EQ(error.line(), line) << text;
    EXPECT_EQ(error.reason(), reason);
  }
}

/// An error of a line that follows the six of the grid.
void expect_line_error(const std::string& line, const std::string& reason) {
  expect_error(grid_lines + line + "\nPOSE 0 0 0\n", 7, reason);
}

// --- what is read ---

TEST(Scenario, DefaultsAndSettings) {
  const TempFolder folder;
  const auto plain =
      occgrid::read_scenario(folder.write("b.log", grid_lines + "POSE 0 0 0"));
  EXPECT_EQ(plain.settings.width, 20);
  EXPECT_EQ(plain.settings.height, 10);
  EXPECT_EQ(plain.settings.resolution, 0.5);
  EXPECT_EQ(plain.settings.origin_y, -2.5);
  EXPECT_EQ(plain.settings.p0, 0.5);
  EXPECT_EQ(plain.settings.p_occ, 0.75);
  EXPECT_EQ(plain.settings.p_free, 0.30);
  EXPECT_EQ(plain.settings.l_min, -8.0);
  EXPECT_EQ(plain.settings.l_max, 8.0);
  EXPECT_EQ(plain.settings.no_return, occgrid::NoReturn::free);
  EXPECT_EQ(plain.settings.fov, 3.141592653589793);
  EXPECT_EQ(plain.settings.beams, 181);
  EXPECT_EQ(plain.settings.noise_std, 0.02);

  const auto set = occgrid::read_scenario(folder.write(
      "c.log",
      grid_lines +
          "PARAM occgrid_no_return ignore # comment\nPARAM occgrid_beams 3\n"
          "PARAM occgrid_l_min -1\nPARAM\nPARAM #\nPARAM laser_front_offset "
          "0.0 # of others\n"
          "WALL 0 1 2 3 #4\nPOSE 0 0 0"));
  EXPECT_EQ(set.settings.no_return, occgrid::NoReturn::ignore);
  EXPECT_EQ(set.settings.beams, 3);
  EXPECT_EQ(set.settings.l_min, -1.0);
  ASSERT_EQ(set.walls.size(), 1u);
  EXPECT_EQ(set.walls[0].y1, 3.0);
  const auto grid = set.settings.new_grid();
  EXPECT_EQ(grid.log_odds().rows(), 10);
  EXPECT_EQ(grid.log_odds().cols(), 20);
}

TEST(Scenario, ScansInTheOrderOfTheFile) {
  const auto scans =
      read_all("# caf\xc3\xa9 in a comment\r\n\r\n \t \n" + grid_lines +
               "ODOM 0 0 0 0 0 0 0 host 0\npose not ours\n"
               "POSE 1 2 3 # first\r\n"
               "FLASER 3 1.5 inf nan 4 5 6 x x x x x x\n"
               "PARAM other_name 1\n"
               "\tROBOTLASER1 0 -0.5 9 0.25 9 9 0 2 7 8 3 x y z -1 -2 -3 a b "
               "c d e f g h i j k  \n"
               "POSE 7 8 9");
  ASSERT_EQ(scans.size(), 4u);
  EXPECT_EQ(std::get<occgrid::Pose>(scans[0]).theta, 3.0);
  const auto& flaser = std::get<occgrid::Scan>(scans[1]);
  EXPECT_EQ(flaser.pose.y, 5.0);
  EXPECT_EQ(flaser.ranges.size(), 3);
  EXPECT_EQ(flaser.ranges[1], infinity);
  EXPECT_TRUE(std::isnan(flaser.ranges[2]));
  EXPECT_EQ(flaser.angles[2], occgrid::flaser_angles(3)[2]);
  const auto& laser = std::get<occgrid::Scan>(scans[2]);
  EXPECT_EQ(laser.pose.x, -1.0);
  EXPECT_EQ(laser.ranges[1], 8.0);
  EXPECT_EQ(laser.angles[0], -0.5);
  EXPECT_EQ(laser.angles[1], -0.25);
  EXPECT_EQ(std::get<occgrid::Pose>(scans[3]).x, 7.0);
}

// The least range is for what was recorded, and ends nothing else.
TEST(Scenario, RangesBelowTheLeastAreIgnored) {
  const auto scans = read_all(
      grid_lines +
      "PARAM occgrid_min_range 0.5\nFLASER 4 0 0.4999 0.5 7 4 5 6 a b c d e "
      "f\nROBOTLASER1 0 0 3 1 80 0 0 2 0.1 3 0 0 0 0 a b c d e f g h i j k\n");
  const auto& flaser = std::get<occgrid::Scan>(scans.at(0)).ranges;
  EXPECT_TRUE(std::isnan(flaser[0]));
  EXPECT_TRUE(std::isnan(flaser[1]));
  EXPECT_EQ(flaser[2], 0.5);
  EXPECT_EQ(flaser[3], 7.0);
  const auto& laser = std::get<occgrid::Scan>(scans.at(1)).ranges;
  EXPECT_TRUE(std::isnan(laser[0]));
  EXPECT_EQ(laser[1], 3.0);
}

/// The x of the poses that are left.
std::vector<double> poses(const occgrid::ScanSource& next_scan) {
  std::vector<double> x;
  while (auto scan = next_scan())
    x.push_back(std::get<occgrid::Pose>(*scan).x);
  return x;
}

TEST(Scenario, ScansBeginAnewEachTime) {
  const TempFolder folder;
  const auto scenario = occgrid::read_scenario(folder.write(
      "a.log", grid_lines + "POSE 1 0 0\n\nPOSE 2 0 0\nPOSE 3 0 0\n"));
  const auto copy = scenario;
  const auto one = scenario.scans(), other = copy.scans();
  ASSERT_TRUE(one());
  EXPECT_EQ(poses(other), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(poses(one), (std::vector<double>{2, 3}));
  EXPECT_EQ(poses(scenario.scans()), (std::vector<double>{1, 2, 3}));
}

TEST(Scenario, APipeIsReadOnce) {
  const TempFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream(pipe) << grid_lines << "POSE 1 0 0\nPOSE 2 0 0\n";
  });
  const auto scenario = occgrid::read_scenario(pipe);
  EXPECT_EQ(poses(scenario.scans()), (std::vector<double>{1, 2}));
  writer.join();
  try {
    scenario.scans();
    ADD_FAILURE() << "read again";
  } catch (const occgrid::ScenarioError& error) {
    EXPECT_EQ(error.reason(), "cannot be read a second time");
  }
}

// A line that is longer than what is read at once.
TEST(Scenario, LongLines) {
  std::string line = "FLASER 100000";
  for (int i = 0; i < 100000; ++i) line += " 1.25";
  const auto scans = read_all(grid_lines + line + " 1 2 3 a b c d e f\n" +
                              "# " + repeat("x", 200000) + "\nPOSE 4 5 6");
  ASSERT_EQ(scans.size(), 2u);
  const auto& scan = std::get<occgrid::Scan>(scans[0]);
  EXPECT_TRUE((scan.ranges == 1.25).all());
  EXPECT_EQ(scan.pose.x, 1.0);
  EXPECT_EQ(std::get<occgrid::Pose>(scans[1]).theta, 6.0);
}

TEST(Scenario, Name) {
  EXPECT_EQ(occgrid::scenario_name("a/b/lesson.log"), "lesson");
  EXPECT_EQ(occgrid::scenario_name("a.b/intel.gfs.log"), "intel.gfs");
  EXPECT_EQ(occgrid::scenario_name("plain"), "plain");
  EXPECT_EQ(occgrid::scenario_name("a.b/.hidden"), ".hidden");
  EXPECT_EQ(occgrid::scenario_name("a/b.log//"), "b");
  EXPECT_EQ(occgrid::scenario_name("d\\e.log"), "d\\e");
  EXPECT_EQ(occgrid::scenario_name("a\n.b.c"), "a\n.b");
}

// --- errors: every row of SPEC.md section 8 ---

TEST(Scenario, CannotBeRead) {
  const TempFolder folder;
  for (const std::string& file :
       {folder.file("missing.log"), folder.file(""),
        folder.write("a.log", grid_lines) + "/", std::string("/proc/self/mem"),
        std::string()}) {
    try {
      occgrid::read_scenario(file);
      ADD_FAILURE();
    } catch (const occgrid::ScenarioError& error) {
      EXPECT_EQ(std::string(error.what()), file + ":0: cannot be read");
    }
  }
}

TEST(Scenario, MessagesAreOneLine) {
  try {
    occgrid::read_scenario("no\nsuch\x7f file\t\xc3\xbc");
    ADD_FAILURE();
  } catch (const occgrid::ScenarioError& error) {
    EXPECT_STREQ(error.what(), "no?such? file?\xc3\xbc:0: cannot be read");
  }
}

TEST(Scenario, Lines) {
  expect_line_error("POSE 0 0 0 # caf\xc3\xa9", "not plain ASCII text");
  expect_line_error("POSE 0 0 \v0", "not plain ASCII text");
  expect_line_error("POSE 0 0 0\r\r", "not plain ASCII text");
  expect_line_error(std::string("ODOM \0", 6), "not plain ASCII text");
  expect_error("\xef\xbb\xbf# with a byte order mark\n", 1,
               "not plain ASCII text");
  expect_line_error("2POSE 0 0 0", "'2POSE' is not a keyword");
  expect_line_error("PO-SE 0 0 0", "'PO-SE' is not a keyword");
  expect_line_error("POSE#", "'POSE#' is not a keyword");
}

TEST(Scenario, Place) {
  expect_error(grid_lines + "POSE 0 0 0\nPARAM occgrid_beams 3\n", 8,
               "PARAM must stand before the first scan");
  expect_error(grid_lines + "POSE 0 0 0\nPARAM occgrid_nonsense\n", 8,
               "PARAM must stand before the first scan");
  expect_error(grid_lines + "POSE 0 0 0\n\nWALL 0\n", 9,
               "WALL must stand before the first scan");
  EXPECT_EQ(read_all(grid_lines + "POSE 0 0 0\nPARAM robot_length 1\n").size(),
            1u);
}

TEST(Scenario, NumberOfValues) {
  expect_line_error("PARAM occgrid_beams", "PARAM takes 2 values, found 1");
  expect_line_error("PARAM occgrid_beams 3 4",
                    "PARAM takes 2 values, found 3");
  expect_line_error("PARAM occgrid_beams #3", "PARAM takes 2 values, found 1");
  expect_line_error("WALL", "WALL takes 4 values, found 0");
  expect_line_error("WALL x 2 3 # 4", "WALL takes 4 values, found 3");
  expect_line_error("POSE 1 2 3 4", "POSE takes 3 values, found 4");
}

TEST(Scenario, Parameters) {
  expect_line_error("PARAM occgrid_colour 1",
                    "unknown parameter occgrid_colour");
  expect_line_error("PARAM occgrid_ 1", "unknown parameter occgrid_");
  expect_line_error("PARAM occgrid_width x", "occgrid_width is given twice");
  expect_line_error("PARAM occgrid_p0 half",
                    "occgrid_p0 'half' is not a number");
  expect_line_error("PARAM occgrid_beams 1.0",
                    "occgrid_beams '1.0' is not a whole number");
  expect_line_error("PARAM occgrid_beams -1",
                    "occgrid_beams '-1' is not a whole number");
  expect_line_error("PARAM occgrid_no_return Free",
                    "occgrid_no_return 'Free' is not free or ignore");
}

TEST(Scenario, Limits) {
  const auto refused = [](const std::string& name, const std::string& value,
                          const std::string& limits) {
    expect_error("PARAM occgrid_" + name + " " + value + "\n", 1,
                 "occgrid_" + name + " '" + value + "' is not " + limits);
  };
  refused("width", "0", "from 1 to 25000000");
  refused("width", "25000001", "from 1 to 25000000");
  refused("height", repeat("9", 40), "from 1 to 25000000");
  refused("resolution", "0.0009999", "from 0.001 to 1000");
  refused("resolution", "1000.1", "from 0.001 to 1000");
  refused("resolution", "nan", "from 0.001 to 1000");
  refused("origin_x", "-10000001", "from -10000000 to 10000000");
  refused("origin_y", "inf", "from -10000000 to 10000000");
  refused("min_range", "-0.1", "from 0 to 10000");
  refused("min_range", "nan", "from 0 to 10000");
  refused("max_range", "10001", "from 0.001 to 10000");
  refused("p0", "0", "between 0 and 1");
  refused("p_occ", "1", "between 0 and 1");
  refused("p_free", "nan", "between 0 and 1");
  refused("l_min", "-1001", "from -1000 to 1000");
  refused("l_max", "1001", "from -1000 to 1000");
  refused("fov", "6.283185307179587", "from 0 to 6.283185307179586");
  refused("fov", "-0.1", "from 0 to 6.283185307179586");
  refused("beams", "0", "from 1 to 100000");
  refused("beams", "100001", "from 1 to 100000");
  refused("noise_std", "1000.5", "from 0 to 1000");
  expect_line_error("POSE 0 1.1e7 x",
                    "y '1.1e7' is not from -10000000 to 10000000");
  expect_line_error("WALL 0 -1e9 0 0",
                    "y0 '-1e9' is not from -10000000 to 10000000");
  expect_line_error("POSE 0 0 1e7",
                    "theta '1e7' is not from -1000000 to 1000000");
  expect_line_error("POSE 0 0 nan",
                    "theta 'nan' is not from -1000000 to 1000000");
  expect_line_error("WALL 0 1 2 three", "y1 'three' is not a number");
}

TEST(Scenario, MissingParameters) {
  expect_error("POSE 0 0 0\n", 1, "occgrid_width is missing");
  expect_error("\nPARAM occgrid_width 1\nPARAM occgrid_origin_x 0\nFLASER\n",
               4, "occgrid_height is missing");
  expect_error(grid_lines.substr(0, grid_lines.rfind("PARAM")) + "POSE x", 6,
               "occgrid_max_range is missing");
}

TEST(Scenario, JointRules) {
  const auto replaced = [](std::string text, const std::string& from,
                           const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string wide = replaced(grid_lines, "width 20", "width 2500001");
  expect_error(wide + "POSE 0 0 0", 2,
               "the grid has more than 25000000 cells");
  const std::string fine =
      replaced(grid_lines, "resolution 0.5", "resolution 0.001");
  expect_error(
      replaced(fine, "max_range 8", "max_range 1000.001") + "POSE 0 0 0", 6,
      "occgrid_max_range is more than 1000000 cells");
  expect_error(
      grid_lines + "PARAM occgrid_l_max 1\nPARAM occgrid_l_min 1\nPOSE 0 0 0",
      8, "occgrid_l_min is not below occgrid_l_max");
  expect_error(grid_lines + "PARAM occgrid_l_min 9\n\nPOSE 0 0 0", 7,
               "occgrid_l_min is not below occgrid_l_max");
  const std::string outside =
      "logit(occgrid_p0) is not from occgrid_l_min to occgrid_l_max";
  expect_error(grid_lines + "PARAM occgrid_l_min 0.1\nPOSE 0 0 0", 7, outside);
  expect_error(
      grid_lines + "PARAM occgrid_l_max 1\nPARAM occgrid_p0 0.9\nPOSE 0 0 0",
      8, outside);
  const std::string blind = "occgrid_min_range is not below occgrid_max_range";
  expect_error(grid_lines + "PARAM occgrid_min_range 8\n\nPOSE 0 0 0", 7,
               blind);
  expect_error("PARAM occgrid_min_range 8.5\n" + grid_lines + "POSE 0 0 0", 7,
               blind);
  // the grid's rule comes before the others
  expect_error(wide + "PARAM occgrid_l_min 9\nPOSE 0 0 0", 2,
               "the grid has more than 25000000 cells");
}

TEST(Scenario, Flaser) {
  expect_line_error("FLASER", "FLASER has no beam count");
  expect_line_error("FLASER two", "beam count 'two' is not a whole number");
  expect_line_error("FLASER 0", "beam count '0' is not from 1 to 100000");
  expect_line_error("FLASER 2 1 1 0 0 0",
                    "FLASER with 2 beams takes 12 values, found 6");
  expect_line_error("FLASER 02 1 1 0 0 0 a b c d e f g",
                    "FLASER with 2 beams takes 12 values, found 13");
  expect_line_error("FLASER 2 1 x y 0 0 a b c d e f",
                    "range 1 'x' is not a number");
  expect_line_error("FLASER 2 -0.1 1 0 0 0 a b c d e f",
                    "range 0 '-0.1' is negative");
  expect_line_error("FLASER 2 1 -inf 0 0 0 a b c d e f",
                    "range 1 '-inf' is negative");
  expect_line_error("FLASER 2 1 1 y 0 0 a b c d e f", "x 'y' is not a number");
  expect_line_error("FLASER 1 1 0 0 #0 a b c d e f",
                    "theta '#0' is not a number");
  EXPECT_EQ(read_all(grid_lines + "FLASER 1 -1e-301 0 0 0 # b c d e f").size(),
            1u);
}

TEST(Scenario, Robotlaser1) {
  const std::string head = "ROBOTLASER1 0 -1 3 0.5 80 0 0 ";
  const std::string tail = " 0 0 0 a b c d e f g h i j k";
  expect_line_error("ROBOTLASER1 0 -1 3 0.5 80 0 0",
                    "ROBOTLASER1 has no beam count");
  expect_line_error(head + "x", "beam count 'x' is not a whole number");
  expect_line_error(head + "100001",
                    "beam count '100001' is not from 1 to 100000");
  expect_line_error(
      head + "2 1 1 0 0",
      "ROBOTLASER1 with 2 beams takes at least 25 values, found 12");
  expect_line_error(head + "2 1 1 -" + tail,
                    "remission count '-' is not a whole number");
  expect_line_error(head + "2 1 1 100001" + tail,
                    "remission count '100001' is not from 0 to 100000");
  expect_line_error(
      head + "2 1 1 1" + tail,
      "ROBOTLASER1 with 2 beams and 1 remissions takes 26 values, found 25");
  expect_line_error("ROBOTLASER1 0 a 3 b 80 0 0 1 x 0" + tail,
                    "start 'a' is not a number");
  expect_line_error("ROBOTLASER1 0 0 3 inf 80 0 0 1 x 0" + tail,
                    "step 'inf' is not from -1000000 to 1000000");
  expect_line_error(head + "2 1 -1 0" + tail, "range 1 '-1' is negative");
  expect_line_error(head + "1 1 0 0 0 t" + tail.substr(6),
                    "theta 't' is not a number");
}

TEST(Scenario, NoScan) {
  expect_error("", 0, "no scan");
  expect_error("# only\n\n", 2, "no scan");
  expect_error(grid_lines + "ODOM 1", 7, "no scan");
}

TEST(Scenario, ErrorsInLaterScans) {
  expect_error(grid_lines + "POSE 0 0 0\n# comment\nPOSE 0 0\n", 9,
               "POSE takes 3 values, found 2");
}

}  // namespace
