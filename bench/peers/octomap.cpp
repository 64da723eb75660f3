// OctoMap at the benchmark's work: all points in the plane z = 0 of an octree.
//
// usage: octomap_peer WORK rays|cloud
//
// rays: insertRay for each beam, which updates every cell of every beam.
// cloud: insertPointCloud for each scan, as most programs call it; it
// updates a cell once per scan, however many beams cross it.
#include <octomap/octomap.h>

#include <cmath>
#include <memory>

#include "driver.hpp"

int main(int, char** argv) {
  const Work work = read_work(argv[1]);
  const bool rays = std::string(argv[2]) == "rays";

  // A beam without return goes on beyond the maximum range, where OctoMap
  // cuts it off and marks it free.
  std::vector<octomap::Pointcloud> clouds;
  std::vector<octomap::point3d> origins;
  for (const WorkScan& scan : work.scans) {
    octomap::Pointcloud cloud;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const bool hit = scan.ranges[i] < work.max_range - 1e-12;
      const double z = hit ? scan.ranges[i] : work.max_range + 1.0;
      const double a = scan.theta + work.angles[i];
      cloud.push_back(static_cast<float>(scan.x + z * std::cos(a)),
                      static_cast<float>(scan.y + z * std::sin(a)), 0.0f);
    }
    clouds.push_back(cloud);
    origins.emplace_back(static_cast<float>(scan.x),
                         static_cast<float>(scan.y), 0.0f);
  }

  std::unique_ptr<octomap::OcTree> tree;
  answer_requests(
      [&] {
        tree.reset();
        tree = std::make_unique<octomap::OcTree>(work.resolution);
        tree->setProbHit(0.75);
        tree->setProbMiss(0.30);
        tree->setClampingThresMin(1.0 / (1.0 + std::exp(8.0)));
        tree->setClampingThresMax(1.0 / (1.0 + std::exp(-8.0)));
        for (std::size_t i = 0; i < clouds.size(); ++i) {
          if (rays) {
            for (const octomap::point3d& point : clouds[i]) {
              tree->insertRay(origins[i], point, work.max_range);
            }
          } else {
            tree->insertPointCloud(clouds[i], origins[i], work.max_range);
          }
        }
      },
      [&](std::ostream& out) {
        out << "# leaves " << tree->getNumLeafNodes() << '\n';
      });
}
