#include "occgrid/map_writer.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <sstream>

namespace {

using occgrid::GridSpec;
using occgrid::OccupancyGrid;

/// A grid of these log-odds, row 0 first.
OccupancyGrid grid_of(std::int64_t width, const std::vector<double>& values) {
  OccupancyGrid grid(
      {width, static_cast<std::int64_t>(values.size()) / width, 1.0, 0, 0},
      0.5, 0.75, 0.3, -1000.0, 1000.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto cell = static_cast<std::int64_t>(i);
    grid.update_cell(cell % width, cell / width, values[i]);
  }
  return grid;
}

std::string yaml_of(const GridSpec& spec, double p0 = 0.5,
                    const std::string& image = "a.pgm") {
  std::ostringstream out;
  occgrid::map_yaml(OccupancyGrid(spec, p0, 0.75, 0.3, -30.0, 30.0), image,
                    out);
  return out.str();
}

TEST(MapWriter, Pixels) {
  EXPECT_EQ(occgrid::pixel(0.0), 128);  // 127.5 goes up
  EXPECT_EQ(occgrid::pixel(-1000.0), 255);
  EXPECT_EQ(occgrid::pixel(1000.0), 0);
  EXPECT_EQ(occgrid::pixel(8.0), 0);
  EXPECT_EQ(occgrid::pixel(-8.0), 255);
  EXPECT_EQ(occgrid::pixel(occgrid::logit(0.75)), 64);
}

TEST(MapWriter, Pgm) {
  std::ostringstream out;
  occgrid::map_pgm(grid_of(3, {-8.0, 0.0, 8.0, 0.0, 0.0, -8.0}), out);
  EXPECT_EQ(out.str(), "P2\n3 2\n255\n128 128 255\n255 128 0\n");
}

TEST(MapWriter, LogOddsReadBack) {
  const std::vector<double> values{-8.0,  0.1 + 0.2,           8.0,
                                   1e-17, -0.8472978603872036, 1.0 / 3.0};
  std::ostringstream out;
  occgrid::map_log_odds(grid_of(3, values), out);
  std::istringstream in(out.str());
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "# logodds 3 2");
  for (const double value : values) {
    std::string text;
    in >> text;
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value);
    EXPECT_LE(text.size(), 24u);
  }
  EXPECT_EQ(out.str().substr(14, 2), "-8");
  EXPECT_EQ(out.str().back(), '\n');
}

TEST(MapWriter, Yaml) {
  EXPECT_EQ(yaml_of({220, 180, 0.1, -11.0, -9.0}),
            "image: a.pgm\n"
            "mode: trinary\n"
            "resolution: 0.1\n"
            "origin: [-11.0, -9.0, 0.0]\n"
            "negate: 0\n"
            "occupied_thresh: 0.65\n"
            "free_thresh: 0.196\n");
}

TEST(MapWriter, YamlHasNineDecimals) {
  const auto has = [](const std::string& text, double resolution, double x,
                      double y) {
    EXPECT_NE(yaml_of({1, 1, resolution, x, y}).find(text), std::string::npos)
        << yaml_of({1, 1, resolution, x, y});
  };
  // exactly half way between two decimals: to even
  has("resolution: 0.000976562\n", 0.0009765625, 0, 0);
  has("resolution: 0.002929688\n", 0.0029296875, 0, 0);
  has("origin: [-0.333333333, 0.0, 0.0]", 1.0, -1.0 / 3.0, -4e-10);
  has("origin: [-10000000.0, 10000000.0, 0.0]", 1.0, -1e7, 1e7);
  has("origin: [-1000000.0, 999999.999999999, 0.0]", 1.0, -1e6,
      999999.999999999);
  has("origin: [0.000000001, 100.0, 0.0]", 1.0, 6e-10, 100.0);
}

// map_server and Nav2 read the name with yaml-cpp.
TEST(MapWriter, YamlNamesReadBack) {
  for (const char* name :
       {"a",         "run #2",      "lab: monday", "[x]",     "@x",
        "'q'",       "%x",          "*x",          "- x",     "yes",
        "1",         "1e3",         "~",           "null",    "-",
        "&x",        "!x",          "{x}",         "x ",      " x",
        "\"q\"",     "back\\slash", "a\nb",        "a\tb",    "a\x7f",
        "\x01",      "\xc3\xbc",    "x: y #z",     ".hidden", "?",
        "|",         ">",           "`",           "a,b",     "0x10",
        "2024-01-01"}) {
    const std::string image = std::string(name) + ".pgm";
    const std::string text = yaml_of({1, 1, 1.0, 0.0, 0.0}, 0.5, image);
    EXPECT_EQ(YAML::Load(text)["image"].as<std::string>(), image) << text;
  }
  EXPECT_EQ(
      yaml_of({1, 1, 1.0, 0.0, 0.0}, 0.5, "run #\"2\n.pgm").substr(0, 26),
      "image: \"run #\\\"2\\x0A.pgm\"\n");
  EXPECT_EQ(yaml_of({1, 1, 1.0, 0.0, 0.0}, 0.5, "A-z_0.9.pgm").substr(0, 19),
            "image: A-z_0.9.pgm\n");
}

/// What map_server makes of a cell: 100 occupied, 0 free, -1 unknown.
int trinary(const std::string& text, double log_odds) {
  const YAML::Node yaml = YAML::Load(text);
  const double p = (255 - occgrid::pixel(log_odds)) / 255.0;
  if (p > yaml["occupied_thresh"].as<double>()) return 100;
  return p < yaml["free_thresh"].as<double>() ? 0 : -1;
}

// A cell that nothing touched is unknown, whatever the prior.
TEST(MapWriter, ThresholdsFollowThePrior) {
  for (int i = 1; i < 1000; ++i) {
    const double p0 = i / 1000.0;
    const std::string text = yaml_of({1, 1, 1.0, 0.0, 0.0}, p0);
    const double l0 = occgrid::logit(p0);
    EXPECT_EQ(trinary(text, l0), -1) << text;
    if (p0 > 0.01 && p0 < 0.99) {
      EXPECT_EQ(trinary(text, l0 + 8.0), 100) << text;
      EXPECT_EQ(trinary(text, l0 - 8.0), 0) << text;
    }
  }
  const std::string half = yaml_of({1, 1, 1.0, 0.0, 0.0});
  EXPECT_EQ(trinary(half, occgrid::logit(0.3)), -1);  // passed once
  EXPECT_EQ(trinary(half, 2.0 * occgrid::logit(0.3)), 0);
  EXPECT_NE(yaml_of({1, 1, 1.0, 0.0, 0.0}, 1e-6).find("free_thresh: 0.0\n"),
            std::string::npos);
  EXPECT_NE(yaml_of({1, 1, 1.0, 0.0, 0.0}, 1.0 - 1e-6)
                .find("occupied_thresh: 1.0\n"),
            std::string::npos);
}

}  // namespace
