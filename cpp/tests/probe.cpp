// Lays open what the contract is made of (CONTRIBUTING.md, "The probe"): probe
// FUNCTION INPUT OUTPUT.
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "noise.hpp"
#include "portable_math.hpp"
#include "ray.hpp"

namespace {

/// Writes the answer to one line of the input.
using Answer = std::function<void(std::istream& in, std::ostream& out)>;

Answer real_function(double (*f)(double)) {
  return [f](std::istream& in, std::ostream& out) {
    std::uint64_t bits;
    in >> std::hex >> bits;
    const double y = f(occgrid::detail::double_of(bits));
    const std::uint64_t result =
        std::isnan(y) ? 0x7ff8000000000000 : occgrid::detail::bits_of(y);
    out << std::hex << std::setfill('0') << std::setw(16) << result;
  };
}

void philox(std::istream& in, std::ostream& out) {
  std::array<std::uint32_t, 4> counter;
  std::array<std::uint32_t, 2> key;
  in >> std::hex >> counter[0] >> counter[1] >> counter[2] >> counter[3] >>
      key[0] >> key[1];
  const char* separator = "";
  for (const std::uint32_t word : occgrid::philox4x32(counter, key)) {
    out << separator << std::hex << std::setfill('0') << std::setw(8) << word;
    separator = " ";
  }
}

void bresenham(std::istream& in, std::ostream& out) {
  occgrid::Cell from, to;
  in >> from.gx >> from.gy >> to.gx >> to.gy;
  const char* separator = "";
  for (const occgrid::Cell cell : occgrid::bresenham(from, to)) {
    out << separator << cell.gx << ',' << cell.gy;
    separator = " ";
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, Answer> answers{
      {"sin", real_function(occgrid::sin)},
      {"cos", real_function(occgrid::cos)},
      {"exp", real_function(occgrid::exp)},
      {"log", real_function(occgrid::log)},
      {"philox", philox},
      {"bresenham", bresenham},
  };
  const auto answer = argc == 4 ? answers.find(argv[1]) : answers.end();
  if (answer == answers.end()) {
    std::cerr
        << "usage: probe sin|cos|exp|log|philox|bresenham INPUT OUTPUT\n";
    return 2;
  }
  std::ifstream input(argv[2]);
  std::ofstream output(argv[3]);
  std::string line;
  while (std::getline(input, line)) {
    std::istringstream in(line);
    answer->second(in, output);
    if (!in) {
      std::cerr << "cannot be understood: " << line << '\n';
      return 1;
    }
    output << '\n';
  }
  output.close();
  return input.eof() && output ? 0 : 1;
}
