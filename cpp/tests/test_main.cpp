// The command line, run as a program.
#include <gtest/gtest.h>

#include <cstdlib>

#include "temp_folder.hpp"

namespace {

class Command : public testing::Test {
 protected:
  /// Runs the command; leaves its output in out() and err(). Returns the exit
  /// status.
  int run(const std::string& arguments, const std::string& out = "stdout") {
    return run_shell("'" OCCGRID_EXECUTABLE "' " + arguments + " >'" + out +
                     "' 2>stderr");
  }

  /// Runs a line of the shell in the test's folder.
  int run_shell(const std::string& line) {
    const std::string command = "cd '" + folder_.file("") + "' && " + line;
    const int status = std::system(command.c_str());
    return status % 256 == 0 ? status / 256
                             : -1;  // as POSIX puts them together
  }

  std::string out() const { return folder_.read("stdout"); }
  std::string err() const { return folder_.read("stderr"); }

  TempFolder folder_;
  const std::string scenario_ =
      "PARAM occgrid_width 3\nPARAM occgrid_height 1\nPARAM "
      "occgrid_resolution 1\n"
      "PARAM occgrid_origin_x 0\nPARAM occgrid_origin_y 0\nPARAM "
      "occgrid_max_range 9\n"
      "FLASER 1 1 0.5 0.5 1.5707963267948966 x x x x x x\n";
};

TEST_F(Command, Picture) {
  folder_.write("a.log", scenario_);
  EXPECT_EQ(run("a.log"), 0);
  EXPECT_EQ(out(), "P2\n3 1\n255\n179 64 128\n");
  EXPECT_EQ(err(), "");
}

TEST_F(Command, LessonWithoutScenario) {
  EXPECT_EQ(run(""), 0);
  const std::string noisy = out();
  EXPECT_EQ(noisy.substr(0, 15), "P2\n220 180\n255\n");
  EXPECT_EQ(run("--seed 0"), 0);
  EXPECT_EQ(out(), noisy);
  EXPECT_EQ(run("--seed 1 --seed 4294967295"), 0);
  EXPECT_NE(out(), noisy);
  EXPECT_EQ(run("--out d --noise-free"), 0);
  EXPECT_EQ(out(), "");
  EXPECT_EQ(folder_.read("d/lesson.yaml").substr(0, 18),
            "image: lesson.pgm\n");
}

TEST_F(Command, ThreadsDrawTheSameMap) {
  EXPECT_EQ(run("--out a"), 0);
  EXPECT_EQ(run("--out b --threads 2"), 0);
  EXPECT_EQ(folder_.read("a/lesson.logodds"),
            folder_.read("b/lesson.logodds"));
  EXPECT_EQ(folder_.read("a/lesson.pgm"), folder_.read("b/lesson.pgm"));
  folder_.write("a.log", scenario_ + "POSE 0 0\n");
  EXPECT_EQ(run("--out d --threads 2 a.log"), 1);
  EXPECT_EQ(err(), "a.log:8: POSE takes 3 values, found 2\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("d/a.pgm")));
}

TEST_F(Command, SeveralScenarios) {
  folder_.write("a.log", scenario_);
  folder_.write("b.log", "POSE 0 0 0\n");
  folder_.write("c.log", scenario_);
  EXPECT_EQ(run("a.log c.log --out d/e"), 0);
  EXPECT_EQ(folder_.read("d/e/a.logodds"), folder_.read("d/e/c.logodds"));
  // the first error ends the run; what earlier scenarios wrote stays
  EXPECT_EQ(run("--out f ./a.log ./b.log c.log"), 1);
  EXPECT_EQ(err(), "./b.log:1: occgrid_width is missing\n");
  EXPECT_TRUE(std::filesystem::exists(folder_.file("f/a.pgm")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("f/b.pgm")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("f/c.pgm")));
}

TEST_F(Command, ErrorsLaterInAScenarioWriteNothing) {
  folder_.write("a.log", scenario_ + "POSE 0 0\n");
  EXPECT_EQ(run("--out d a.log"), 1);
  EXPECT_EQ(err(), "a.log:8: POSE takes 3 values, found 2\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("d/a.pgm")));
  EXPECT_EQ(run("a.log"), 1);
  EXPECT_EQ(out(), "");
  EXPECT_EQ(run("missing.log"), 1);
  EXPECT_EQ(err(), "missing.log:0: cannot be read\n");
  folder_.write("ok.log", scenario_);
  EXPECT_EQ(run("--out a.log ok.log"), 1);
  EXPECT_EQ(err(), "a.log: cannot be written\n");
}

TEST_F(Command, PlainDrawsTheSameMap) {
  EXPECT_EQ(run("--out a --seed 7"), 0);
  EXPECT_EQ(run("--plain --out b --seed 7"), 0);
  EXPECT_EQ(folder_.read("a/lesson.logodds"),
            folder_.read("b/lesson.logodds"));
  EXPECT_EQ(folder_.read("a/lesson.pgm"), folder_.read("b/lesson.pgm"));
}

// One scenario's files are all written or none.
TEST_F(Command, AllOrNothing) {
  folder_.write("ok.log", scenario_);
  std::filesystem::create_directories(folder_.file("o/ok.logodds"));
  EXPECT_EQ(run("--out ./o//./ ok.log"), 1);
  EXPECT_EQ(err(), "./o//./ok.logodds: cannot be written\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("o/ok.pgm")));
}

TEST_F(Command, WhatCannotBeWritten) {
  folder_.write("a.log", scenario_);
  const std::string standard_output = "standard output: cannot be written\n";
  for (const char* arguments : {"", "a.log", "--help", "--version"}) {
    EXPECT_EQ(run(arguments, "/dev/full"), 1) << arguments;
    EXPECT_EQ(err(), standard_output);
  }
  // a closed pipe is no signal
  EXPECT_EQ(
      run_shell("{ '" OCCGRID_EXECUTABLE "' 2>stderr; echo $? >status; } | :"),
      0);
  EXPECT_EQ(folder_.read("status"), "1\n");
  EXPECT_EQ(err(), standard_output);
  // a full disk, as a limit on the size of files
  EXPECT_EQ(run_shell("trap '' XFSZ; ulimit -f 8; '" OCCGRID_EXECUTABLE
                      "' --out full 2>stderr"),
            1);
  EXPECT_EQ(err(), "full/lesson.pgm: cannot be written\n");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.file("full")));
}

TEST_F(Command, WhatCannotBeRead) {
  folder_.write("a.log", scenario_);
  std::filesystem::create_directories(folder_.file("d"));
  const auto refused = [&](const std::string& arguments,
                           const std::string& path) {
    EXPECT_EQ(run(arguments), 1) << arguments;
    EXPECT_EQ(err(), path + ":0: cannot be read\n");
    EXPECT_EQ(out(), "");
  };
  refused("a.log/", "a.log/");
  refused("d/", "d/");
  refused("--out o d/ a/", "d/");
  refused("/proc/self/mem", "/proc/self/mem");
  refused("''", "");
  refused("\"$(printf 'n\\nm')\"", "n?m");
}

TEST_F(Command, ArgumentsFromLeftToRight) {
  folder_.write("a.log", scenario_);
  EXPECT_EQ(run("--seed 00000000000000000000000007 a.log"), 0);
  EXPECT_EQ(run("--out -d a.log"), 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.file("-d/a.pgm")));
  EXPECT_EQ(run("a.log --out x --out y"), 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("x")));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("y/a.pgm")));
  EXPECT_EQ(run("--help --bogus"), 0);
  EXPECT_EQ(run("--bogus --help"), 2);
  EXPECT_EQ(run("--seed x --version"), 2);
  EXPECT_EQ(run("--version --seed x"), 0);
  EXPECT_EQ(run("--noise-free --noise-free a.log"), 0);
}

TEST_F(Command, BadUsage) {
  folder_.write("a.log", scenario_);
  for (const char* arguments : {"--bogus",
                                "--seed",
                                "--seed x",
                                "--seed -1",
                                "--seed ''",
                                "--seed 4294967296",
                                "--seed 1.0",
                                "--seed=7",
                                "--seed 18446744073709551616",
                                "--out",
                                "--out --noise-free a.log",
                                "--out ''",
                                "--noise-free --seed 1",
                                "a.log b.log",
                                "--out d a.log d/a.txt",
                                "--out d a.log d/a.log/",
                                "-x a.log",
                                "-",
                                "--",
                                "-5",
                                "--threads",
                                "--threads 0",
                                "--threads -1",
                                "--threads x",
                                "--threads 257",
                                "--plain --threads 2",
                                "--threads 1 --plain",
                                "--bogus --help"}) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_NE(err().find("usage: occgrid"), std::string::npos);
    EXPECT_EQ(out(), "");
    EXPECT_FALSE(std::filesystem::exists(folder_.file("d")));
  }
}

TEST_F(Command, HelpAndVersion) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_EQ(out().substr(0, 14), "usage: occgrid");
  EXPECT_EQ(run("--version"), 0);
  EXPECT_EQ(out().substr(0, 8), "occgrid ");
  EXPECT_EQ(out().find('\n'), out().size() - 1);
}

}  // namespace
