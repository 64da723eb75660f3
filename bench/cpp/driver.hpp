// What the C++ programs of the benchmark share: the work, and the answers to
// the benchmark's requests.
//
// A driver is started with the file of the work. Each line of its standard
// input is a request, answered by one line on standard output:
//
//   map K         maps the work K times; the seconds of each
//   write FILE    writes the log-odds of the last map; "written"
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct WorkScan {
  double x, y, theta;          ///< pose: metres, radians
  std::vector<double> ranges;  ///< metres, all finite
};

/// Poses and ranges that every contestant maps.
struct Work {
  int width, height;                      ///< cells
  double resolution, origin_x, origin_y;  ///< metres
  double max_range;                       ///< metres
  std::vector<double> angles;             ///< bearings, radians
  std::vector<WorkScan> scans;
};

inline Work read_work(const std::string& file) {
  std::ifstream in(file);
  Work work;
  std::size_t scans = 0, beams = 0;
  in >> work.width >> work.height >> work.resolution >> work.origin_x >>
      work.origin_y >> work.max_range >> scans >> beams;
  work.angles.resize(beams);
  for (double& angle : work.angles) in >> angle;
  work.scans.resize(scans);
  for (WorkScan& scan : work.scans) {
    in >> scan.x >> scan.y >> scan.theta;
    scan.ranges.resize(beams);
    for (double& range : scan.ranges) in >> range;
  }
  if (!in) throw std::runtime_error(file + ": cannot be read");
  return work;
}

/// Answers requests until the input ends. `map` maps the work into a grid of
/// its own; `write` writes what it has mapped last.
inline void answer_requests(const std::function<void()>& map,
                            const std::function<void(std::ostream&)>& write) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream request(line);
    std::string verb;
    request >> verb;
    if (verb == "map") {
      int times = 0;
      request >> times;
      for (int i = 0; i < times; ++i) {
        const auto start = std::chrono::steady_clock::now();
        map();
        const std::chrono::duration<double> seconds =
            std::chrono::steady_clock::now() - start;
        std::printf("%.9f ", seconds.count());
      }
      std::printf("\n");
    } else if (verb == "write") {
      std::string file;
      request >> file;
      std::ofstream out(file);
      write(out);
      std::printf("written\n");
    } else {
      throw std::runtime_error("no request: " + line);
    }
    std::fflush(stdout);
  }
}

/// Writes log-odds (height rows of width) so that they read back exactly.
inline void write_log_odds(std::ostream& out, const double* log_odds,
                           int width, int height) {
  out.precision(17);
  out << "# logodds " << width << ' ' << height << '\n';
  for (int gy = 0; gy < height; ++gy) {
    for (int gx = 0; gx < width; ++gx) {
      out << (gx ? " " : "") << log_odds[gy * width + gx];
    }
    out << '\n';
  }
}
