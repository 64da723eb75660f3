// A map's files are written whole, all three, or not at all.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "occgrid/map_writer.hpp"
#include "temp_folder.hpp"
#include "whole_files.hpp"

namespace {

namespace fs = std::filesystem;
using occgrid::OccupancyGrid;

const OccupancyGrid grid({2, 1, 1.0, 0.0, 0.0});

/// What write_map says, or "written".
std::string message(const std::string& out, const std::string& name) {
  try {
    occgrid::write_map(out, name, grid);
  } catch (const occgrid::WriteError& error) {
    return error.what();
  }
  return "written";
}

TEST(WriteMap, ThreeFilesAndNothingElse) {
  const TempFolder folder;
  folder.write("m.pgm", "old");
  occgrid::write_map(folder.file(""), "m", grid);
  occgrid::write_map(folder.file("new/deep//"), "m", grid);
  EXPECT_EQ(folder.read("m.pgm"), "P2\n2 1\n255\n128 128\n");
  EXPECT_EQ(folder.read("m.logodds"), "# logodds 2 1\n0 0\n");
  EXPECT_EQ(folder.read("new/deep/m.yaml"), folder.read("m.yaml"));
  EXPECT_EQ(folder.count(), 6);
}

TEST(WriteMap, TheFolderIsTheTrouble) {
  const TempFolder folder;
  folder.write("file", "");
  for (const std::string bad : {"file", "file/below", "file/below/"}) {
    const std::string path = folder.file(bad);
    const std::string named =
        path.back() == '/' ? path.substr(0, path.size() - 1) : path;
    EXPECT_EQ(message(path, "m"), named + ": cannot be written");
  }
  EXPECT_EQ(folder.count(), 1);
}

// Whichever of the three it is, none is written, and what was there stays.
TEST(WriteMap, AFolderInTheWay) {
  for (const char* ending : {".pgm", ".yaml", ".logodds"}) {
    const TempFolder folder;
    const std::string out = folder.file("./out//q");
    fs::create_directories(out + "/m" + ending);
    EXPECT_EQ(message(out + "//", "m"),
              out + "/m" + ending + ": cannot be written");
    EXPECT_EQ(folder.count(), 0) << ending;
  }
}

// A name that fits with its ending is written: the temporary one is short.
TEST(WriteMap, LongNames) {
  const TempFolder folder;
  const std::string longest(255 - 8, 'n');  // and .logodds
  EXPECT_EQ(message(folder.file("out"), longest), "written");
  EXPECT_EQ(folder.count(), 3);
  EXPECT_EQ(
      message(folder.file("out"), longest + "n"),
      folder.file("out/" + longest + "n.logodds") + ": cannot be written");
  EXPECT_EQ(folder.count(), 3);
}

TEST(WriteMap, OddNames) {
  const TempFolder folder;
  for (const char* name : {"a b", "-x", "\\", "~", "*", "a\nb", "\xff\xfe",
                           "\xc3\xbc", "'", "\"", "$HOME", "a;b", ".x"}) {
    EXPECT_EQ(message(folder.file("out"), name), "written") << name;
    EXPECT_TRUE(fs::exists(folder.file("out/" + std::string(name) + ".yaml")));
  }
  EXPECT_EQ(folder.count(), 3 * 13);
  fs::create_directories(folder.file("a\nb/m.pgm"));
  EXPECT_EQ(message(folder.file("a\nb"), "m"),
            folder.file("a?b/m.pgm") + ": cannot be written");
}

// Where a file cannot be renamed, those renamed before it go again: a folder
// takes the name of the second while it is written.
TEST(WriteMap, AFailedRenamingIsUndone) {
  const TempFolder folder;
  const std::string out = folder.file("out");
  try {
    occgrid::WholeFiles files(out);
    files.write("one", [](std::ostream& text) { text << "1"; });
    files.write("two", [&](std::ostream&) {
      fs::create_directories(out + "/two/below");
    });
    files.write("three", [](std::ostream& text) { text << "3"; });
    files.publish();
    ADD_FAILURE() << "published";
  } catch (const occgrid::WriteError& error) {
    EXPECT_EQ(error.what(), out + "/two: cannot be written");
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(WriteMap, LeftoversOfADayAgoAreCleared) {
  const TempFolder folder;
  const auto put = [&](const std::string& name, int hours) {
    const fs::path path = folder.write(name, "x");
    fs::last_write_time(
        path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  put(".occgrid-old1.part", 25);
  put(".occgrid-" + std::string(40, 'Z') + ".part", 1000);
  const std::vector<std::string> kept{
      ".occgrid-new.part", ".occgrid-.part",
      ".occgrid-a_b.part", ".occgrid-a.parts",
      "occgrid-a.part",    ".occgrid-" + std::string(41, 'Z') + ".part"};
  put(kept[0], 23);
  for (std::size_t i = 1; i < kept.size(); ++i) put(kept[i], 1000);
  fs::create_directories(folder.file(".occgrid-folder.part"));
  EXPECT_EQ(message(folder.file(""), "m"), "written");
  EXPECT_EQ(folder.count(), 3 + static_cast<long>(kept.size()));
  for (const std::string& name : kept) {
    EXPECT_TRUE(fs::exists(folder.file(name))) << name;
  }
  EXPECT_TRUE(fs::exists(folder.file(".occgrid-folder.part")));
}

}  // namespace
