// The command line (SPEC.md section 6).
#include <csignal>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "numbers.hpp"
#include "occgrid/exact_arithmetic.hpp"
#include "occgrid/fast.hpp"
#include "occgrid/lesson.hpp"
#include "occgrid/map_writer.hpp"
#include "occgrid/mapper.hpp"
#include "occgrid/scenario.hpp"
#include "one_line.hpp"
#include "whole_files.hpp"

// CMake gives it.
#ifndef OCCGRID_VERSION
#define OCCGRID_VERSION "of no version"
#endif

namespace {

constexpr std::int64_t max_seed = 4294967295;
constexpr std::int64_t max_threads = 256;

const char* const usage =
    "usage: occgrid [--noise-free | --seed N] [--plain | --threads N] [--out "
    "DIR] [SCENARIO...]\n"
    "\n"
    "Maps range scans into an occupancy grid. Without a scenario: the "
    "built-in lesson.\n"
    "\n"
    "  SCENARIO      scenario files (CARMEN logs)\n"
    "  --noise-free  simulate ranges without noise\n"
    "  --seed N      seed of the noise, 0 to 4294967295 (default: 0)\n"
    "  --plain       map with the program as the handouts print it; the map "
    "is "
    "the same\n"
    "  --threads N   map on N threads, 1 to 256 (default: 1); the map is the "
    "same\n"
    "  --out DIR     write NAME.pgm, NAME.yaml and NAME.logodds there, not a "
    "PGM to standard output\n"
    "  --version     print the version\n"
    "  --help        print this\n";

std::string version() {
#ifdef __clang__
  const std::string compiler = "Clang " __clang_version__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return "occgrid " OCCGRID_VERSION " (C++17, " +
         compiler.substr(0, compiler.find(' ', compiler.find(' ') + 1)) +
         ", Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." +
         std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION) + ")\n";
}

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::optional<std::uint32_t> seed = 0;  ///< none: free of noise
  std::optional<std::string> out;
  bool plain = false;
  int threads = 1;
  std::vector<std::string> scenarios;
  std::optional<std::string> text;  ///< to print instead of mapping
};

/// The value of an option that takes a whole number from low to high.
std::int64_t whole_number(const std::string& option, const std::string& text,
                          std::int64_t low, std::int64_t high) {
  const std::optional<std::int64_t> number = occgrid::parse_whole(text);
  if (!number || *number < low || *number > high) {
    throw UsageError(option + " takes a whole number from " +
                     std::to_string(low) + " to " + std::to_string(high) +
                     ", not '" + text + "'");
  }
  return *number;
}

/// Reads the arguments from left to right. Throws UsageError.
Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  bool noise_free = false, seeded = false, threaded = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto value = [&] {
      const bool missing = i + 1 == arguments.size() ||
                           arguments[i + 1].empty() ||
                           arguments[i + 1].substr(0, 2) == "--";
      if (missing) throw UsageError(argument + " takes a value");
      return arguments[++i];
    };
    if (argument == "--help") {
      options.text = usage;
      return options;
    } else if (argument == "--version") {
      options.text = version();
      return options;
    } else if (argument == "--noise-free") {
      noise_free = true;
    } else if (argument == "--seed") {
      options.seed = static_cast<std::uint32_t>(
          whole_number(argument, value(), 0, max_seed));
      seeded = true;
    } else if (argument == "--plain") {
      options.plain = true;
    } else if (argument == "--threads") {
      options.threads =
          static_cast<int>(whole_number(argument, value(), 1, max_threads));
      threaded = true;
    } else if (argument == "--out") {
      options.out = value();
    } else if (!argument.empty() && argument[0] == '-') {
      throw UsageError("unknown option " + argument);
    } else {
      options.scenarios.push_back(argument);
    }
  }
  if (noise_free && seeded)
    throw UsageError("--noise-free and --seed exclude each other");
  if (options.plain && threaded)
    throw UsageError("--plain and --threads exclude each other");
  if (options.scenarios.size() > 1 && !options.out) {
    throw UsageError("several scenarios need --out");
  }
  std::set<std::string> names;
  for (const std::string& path : options.scenarios) {
    const std::string name = occgrid::scenario_name(path);
    if (!names.insert(name).second)
      throw UsageError("two scenarios are named " + name);
  }
  if (noise_free) options.seed.reset();
  return options;
}

/// Maps one scenario and writes what was asked for.
void map_one(const occgrid::Scenario& scenario, const Options& options) {
  const occgrid::OccupancyGrid grid =
      options.plain ? occgrid::map_scenario(scenario, options.seed)
                    : occgrid::map_scenario_fast(scenario, options.seed,
                                                 options.threads);
  if (options.out) {
    occgrid::write_map(*options.out, scenario.name, grid);
  } else {
    occgrid::map_pgm(grid, std::cout);
  }
}

void run(const Options& options) {
  occgrid::require_exact_arithmetic();
  if (options.text) {
    std::cout << *options.text;
  } else if (options.scenarios.empty()) {
    map_one(occgrid::lesson_scenario(), options);
  } else {
    for (const std::string& path : options.scenarios) {
      map_one(occgrid::read_scenario(path), options);
    }
  }
  if (!std::cout.flush()) throw occgrid::WriteError("standard output");
}

/// A signal that ends the program leaves no temporary file.
extern "C" void clean_up(int signal) {
  occgrid::remove_temporary_files();
  // back to what the system does at this signal, when this function returns
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void watch_signals() {
  for (const int signal : {SIGINT, SIGTERM}) {
    // who started the program may have it ignored, as nohup does with another
    if (std::signal(signal, clean_up) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  // a closed pipe is a write that fails
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  watch_signals();
  try {
    run(parse_options({argv + 1, argv + argc}));
    return 0;
  } catch (const UsageError& error) {
    std::cerr << "occgrid: " << occgrid::one_line(error.what()) << '\n'
              << usage;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
