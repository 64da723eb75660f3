// A signal in the middle of writing leaves no temporary file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "temp_folder.hpp"

namespace {

/// A map that takes a while to write.
const std::string large =
    "PARAM occgrid_width 5000\nPARAM occgrid_height 5000\nPARAM "
    "occgrid_resolution 1\nPARAM occgrid_origin_x 0\nPARAM occgrid_origin_y "
    "0\nPARAM occgrid_max_range 9\nPOSE 0 0 0\n";

long temporary_files(const std::string& folder) {
  long found = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error);
       !error && entry != std::filesystem::directory_iterator();
       entry.increment(error)) {
    found += entry->path().extension() == ".part" ? 1 : 0;
  }
  return found;
}

class Signals : public testing::TestWithParam<int> {};

TEST_P(Signals, LeaveNothing) {
  const TempFolder folder;
  const std::string log = folder.write("large.log", large);
  const std::string out = folder.file("out");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    execl(OCCGRID_EXECUTABLE, "occgrid", "--out", out.c_str(), log.c_str(),
          nullptr);
    _exit(127);
  }
  while (temporary_files(out) < 2 && waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_EQ(kill(child, GetParam()), 0) << "it was quicker";
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(WTERMSIG(status), GetParam());
  EXPECT_EQ(folder.count(), 1);  // the scenario
}

INSTANTIATE_TEST_SUITE_P(Each, Signals, testing::Values(SIGINT, SIGTERM));

}  // namespace
