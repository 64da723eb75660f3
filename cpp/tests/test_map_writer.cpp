#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "map_writer.hpp"
#include "temp_folder.hpp"

namespace {

using occgrid::GridSpec;
using occgrid::OccupancyGrid;

std::string yaml_of(const GridSpec& spec) {
  std::ostringstream out;
  occgrid::map_yaml(OccupancyGrid(spec), "a.pgm", out);
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
  OccupancyGrid grid({3, 2, 1.0, 0.0, 0.0});
  grid.log_odds << -8.0, 0.0, 8.0,  //
      0.0, 0.0, -8.0;
  std::ostringstream out;
  occgrid::map_pgm(grid, out);
  EXPECT_EQ(out.str(), "P2\n3 2\n255\n128 128 255\n255 128 0\n");
}

TEST(MapWriter, LogOddsReadBack) {
  OccupancyGrid grid({3, 2, 1.0, 0.0, 0.0});
  grid.log_odds << -8.0, 0.1 + 0.2, 8.0,  //
      1e-17, -0.8472978603872036, 1.0 / 3.0;
  std::ostringstream out;
  occgrid::map_log_odds(grid, out);
  std::istringstream in(out.str());
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "# logodds 3 2");
  for (int i = 0; i < 6; ++i) {
    std::string text;
    in >> text;
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), grid.log_odds(i / 3, i % 3));
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
  has("origin: [-1000000.0, 999999.999999999, 0.0]", 1.0, -1e6,
      999999.999999999);
  has("origin: [0.000000001, 100.0, 0.0]", 1.0, 6e-10, 100.0);
}

TEST(MapWriter, WritesThreeFilesAndNothingElse) {
  const TempFolder folder;
  const OccupancyGrid grid({2, 1, 1.0, 0.0, 0.0});
  folder.write("m.pgm", "old");
  occgrid::write_map(folder.file(""), "m", grid);
  occgrid::write_map(folder.file("new/deep"), "m", grid);
  EXPECT_EQ(folder.read("m.pgm"), "P2\n2 1\n255\n128 128\n");
  EXPECT_EQ(folder.read("m.logodds"), "# logodds 2 1\n0 0\n");
  EXPECT_EQ(folder.read("new/deep/m.yaml"), folder.read("m.yaml"));
  EXPECT_EQ(folder.count(), 6);
}

TEST(MapWriter, WhatCannotBeWritten) {
  const TempFolder folder;
  const OccupancyGrid grid({2, 1, 1.0, 0.0, 0.0});
  const auto message = [&](const std::string& out, const std::string& name) {
    try {
      occgrid::write_map(out, name, grid);
    } catch (const occgrid::WriteError& error) {
      return std::string(error.what());
    }
    return std::string("written");
  };
  folder.write("file", "");
  EXPECT_EQ(message(folder.file("file"), "m"),
            folder.file("file") + ": cannot be written");
  EXPECT_EQ(message(folder.file("file/below"), "m"),
            folder.file("file/below") + ": cannot be written");
  // a folder stands where the picture should
  std::filesystem::create_directories(folder.file("out/m.pgm/x"));
  EXPECT_EQ(message(folder.file("out"), "m"),
            folder.file("out/m.pgm") + ": cannot be written");
  EXPECT_EQ(folder.count(), 1);
}

}  // namespace
