// Loads a map by the rules that map_server and Nav2 publish, and prints it as an occupancy grid message holds it:
// width, height, resolution and origin on the first line, then the cells, the row with the smallest y first.
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string yaml = argv[1];
  const YAML::Node map = YAML::LoadFile(yaml);
  const auto origin = map["origin"].as<std::vector<double>>();
  const auto occupied = map["occupied_thresh"].as<double>();
  const auto free = map["free_thresh"].as<double>();
  const auto negate = map["negate"].as<int>();
  if (map["mode"].as<std::string>() != "trinary" || origin.size() != 3) return 3;

  const auto image = yaml.substr(0, yaml.rfind('/') + 1) + map["image"].as<std::string>();
  std::ifstream file(image);
  std::string magic;
  std::size_t width = 0, height = 0;
  int most = 0;
  if (!(file >> magic >> width >> height >> most) || magic != "P2") return 4;
  std::vector<int> cells(width * height);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      int pixel = 0;
      if (!(file >> pixel)) return 5;
      const double shade = static_cast<double>(pixel) / most;
      const double p = negate ? shade : 1.0 - shade;
      cells[(height - 1 - row) * width + column] = p > occupied ? 100 : p < free ? 0 : -1;
    }
  }
  std::cout.precision(17);
  std::cout << width << ' ' << height << ' ' << map["resolution"].as<double>() << ' ' << origin[0] << ' '
            << origin[1] << ' ' << origin[2] << '\n';
  for (const int cell : cells) std::cout << cell << '\n';
}
