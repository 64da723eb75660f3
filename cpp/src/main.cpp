// The command line (SPEC.md section 6).
#include <algorithm>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "lesson.hpp"
#include "map_writer.hpp"
#include "mapper.hpp"
#include "scenario.hpp"

namespace {

constexpr std::int64_t max_seed = 4294967295;
constexpr std::int64_t max_threads = 256;

const char* const usage =
    "usage: occgrid [--noise-free | --seed N] [--out DIR] [--threads N] "
    "[SCENARIO...]\n"
    "\n"
    "Maps range scans into an occupancy grid. Without a scenario: the "
    "built-in lesson.\n"
    "\n"
    "  SCENARIO      scenario files (CARMEN logs)\n"
    "  --noise-free  simulate ranges without noise\n"
    "  --seed N      seed of the noise, 0 to 4294967295 (default: 0)\n"
    "  --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds there, not a "
    "PGM to standard output\n"
    "  --threads N   map on N threads, 1 to 256 (default: 1); the map is the "
    "same\n"
    "  --version     print the version\n"
    "  --help        print this\n";

const char* const version =
    "occgrid " OCCGRID_VERSION " (C++17, " OCCGRID_COMPILER
    ", Eigen " OCCGRID_EIGEN ")\n";

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::optional<std::uint32_t> seed = 0;  ///< none: free of noise
  std::optional<std::string> out;
  int threads = 1;
  std::vector<std::string> scenarios;
  const char* text = nullptr;  ///< to print instead of mapping
};

std::uint32_t parse_seed(const std::string& text) {
  const std::optional<std::int64_t> seed = occgrid::parse_whole(text);
  if (!seed || *seed > max_seed) {
    throw UsageError(
        "--seed takes a whole number from 0 to 4294967295, not '" + text +
        "'");
  }
  return static_cast<std::uint32_t>(*seed);
}

int parse_threads(const std::string& text) {
  const std::optional<std::int64_t> threads = occgrid::parse_whole(text);
  if (!threads || *threads < 1 || *threads > max_threads) {
    throw UsageError("--threads takes a whole number from 1 to 256, not '" +
                     text + "'");
  }
  return static_cast<int>(*threads);
}

/// Throws UsageError.
Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  bool noise_free = false;
  bool seeded = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto value = [&] {
      if (i + 1 == arguments.size() || arguments[i + 1].empty() ||
          arguments[i + 1][0] == '-') {
        throw UsageError(argument + " takes a value");
      }
      return arguments[++i];
    };
    if (argument == "--help") {
      options.text = usage;
      return options;
    } else if (argument == "--version") {
      options.text = version;
      return options;
    } else if (argument == "--noise-free") {
      noise_free = true;
    } else if (argument == "--seed") {
      options.seed = parse_seed(value());
      seeded = true;
    } else if (argument == "--out") {
      options.out = value();
    } else if (argument == "--threads") {
      options.threads = parse_threads(value());
    } else if (!argument.empty() && argument[0] == '-') {
      throw UsageError("unknown option " + argument);
    } else {
      options.scenarios.push_back(argument);
    }
  }
  if (noise_free && seeded)
    throw UsageError("--noise-free and --seed exclude each other");
  if (noise_free) options.seed.reset();
  if (options.scenarios.size() > 1 && !options.out) {
    throw UsageError("several scenarios need --out");
  }
  std::set<std::string> names;
  for (const std::string& file : options.scenarios) {
    const std::string name = occgrid::scenario_name(file);
    if (!names.insert(name).second)
      throw UsageError("two scenarios are named " + name);
  }
  return options;
}

/// Maps one scenario and writes what was asked for.
void map_one(const occgrid::Scenario& scenario, const Options& options) {
  const occgrid::OccupancyGrid grid =
      options.threads == 1 ? occgrid::map_scenario(scenario, options.seed)
                           : occgrid::map_scenario_in_bands(
                                 scenario, options.seed, options.threads);
  if (options.out) {
    occgrid::write_map(*options.out, scenario.name, grid);
  } else {
    occgrid::map_pgm(grid, std::cout);
    if (!std::cout.flush()) throw occgrid::WriteError("standard output");
  }
}

int run(const std::vector<std::string>& arguments) {
  const Options options = parse_options(arguments);
  if (options.text) {
    std::cout << options.text;
    return 0;
  }
  if (options.scenarios.empty()) map_one(occgrid::lesson_scenario(), options);
  for (const std::string& file : options.scenarios) {
    map_one(occgrid::read_scenario(file), options);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  try {
    return run({argv + 1, argv + argc});
  } catch (const UsageError& error) {
    std::cerr << "occgrid: " << error.what() << '\n' << usage;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
