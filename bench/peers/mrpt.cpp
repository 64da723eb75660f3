// MRPT's occupancy grid at the benchmark's work: COccupancyGridMap2D with
// cells of 8 bits, one observation per scan, no widening of beams.
//
// usage: mrpt WORK
//
// Its grid grows where a scan reaches beyond it, so on a grid that does not
// hold every beam it maps more than is asked for.
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <memory>

#include "driver.hpp"

int main(int, char** argv) {
  const Work work = read_work(argv[1]);
  using mrpt::maps::COccupancyGridMap2D;
  const double first = work.angles.front(), last = work.angles.back();

  std::vector<mrpt::obs::CObservation2DRangeScan> scans;
  std::vector<mrpt::poses::CPose3D> poses;
  for (const WorkScan& scan : work.scans) {
    mrpt::obs::CObservation2DRangeScan observation;
    observation.aperture = static_cast<float>(last - first);
    observation.rightToLeft = true;
    observation.maxRange = static_cast<float>(work.max_range);
    observation.sensorPose =
        mrpt::poses::CPose3D(0, 0, 0, (first + last) / 2.0, 0, 0);
    observation.resizeScan(scan.ranges.size());
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      // A beam without return is one of the greatest distance: MRPT frees it
      // and sets nothing occupied. Marked as invalid, it is freed in part.
      observation.setScanRange(
          i, static_cast<float>(std::min(scan.ranges[i], work.max_range)));
      observation.setScanRangeValidity(i, true);
    }
    scans.push_back(observation);
    poses.emplace_back(scan.x, scan.y, 0, scan.theta, 0, 0);
  }

  std::unique_ptr<COccupancyGridMap2D> grid;
  answer_requests(
      [&] {
        grid.reset();
        grid = std::make_unique<COccupancyGridMap2D>();
        grid->setSize(
            static_cast<float>(work.origin_x),
            static_cast<float>(work.origin_x + work.width * work.resolution),
            static_cast<float>(work.origin_y),
            static_cast<float>(work.origin_y + work.height * work.resolution),
            static_cast<float>(work.resolution), 0.5f);
        auto& options = grid->insertionOptions;
        options.maxDistanceInsertion = static_cast<float>(work.max_range);
        options.maxOccupancyUpdateCertainty = 0.75f;
        options.maxFreenessUpdateCertainty = 0.70f;
        options.wideningBeamsWithDistance = false;
        options.decimation = 1;
        for (std::size_t i = 0; i < scans.size(); ++i) {
          grid->insertObservation(scans[i], poses[i]);
        }
      },
      [&](std::ostream& out) {
        const int width = static_cast<int>(grid->getSizeX());
        const int height = static_cast<int>(grid->getSizeY());
        out << "# cells " << width << ' ' << height << '\n';
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) out << grid->getCell(x, y) << ' ';
          out << '\n';
        }
      });
}
