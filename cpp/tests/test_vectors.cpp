// The vectors that all ports share, scenarios/vectors/.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "vector_functions.hpp"

namespace {

const std::filesystem::path folder = OCCGRID_SCENARIOS "/vectors";

Columns split(const std::string& line) {
  Columns columns;
  std::istringstream in(line);
  for (std::string column; std::getline(in, column, ',');) {
    columns.push_back(column);
  }
  return columns;
}

class Vectors : public testing::TestWithParam<std::string> {};

TEST_P(Vectors, AreAnswered) {
  const auto path = folder / (GetParam() + ".csv");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  std::ifstream file(path);
  ASSERT_TRUE(file.is_open()) << path;
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  const std::size_t columns = split(line).size();
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    const Columns row = split(line);
    ASSERT_EQ(row.size(), columns) << line;
    // as many of the last columns as there are answers
    const VectorFunction& function = vector_functions().at(GetParam());
    const Columns answers = function(row);
    ASSERT_LT(answers.size(), columns);
    const Columns expected(row.end() - static_cast<long>(answers.size()),
                           row.end());
    EXPECT_EQ(answers, expected) << line;
  }
  EXPECT_GT(rows, 0);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, unused] : vector_functions()) all.push_back(name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Each, Vectors, testing::ValuesIn(names()),
                         [](const auto& one) { return one.param; });

TEST(AllVectors, HaveAFunction) {
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") {
      EXPECT_EQ(vector_functions().count(entry.path().stem().string()), 1u)
          << entry.path();
    }
  }
}

}  // namespace
