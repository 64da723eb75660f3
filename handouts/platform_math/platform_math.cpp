// sin, cos, exp and log as the C++ library has them: FOLDER/sin.txt to FOLDER/sin.out, and so on.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

int main(int, char** argv) {
  const std::string folder = argv[1];
  const struct {
    const char* name;
    double (*compute)(double);
  } functions[] = {
      {"sin", std::sin}, {"cos", std::cos}, {"exp", std::exp}, {"log", std::log}};
  for (const auto& function : functions) {
    std::ifstream arguments(folder + "/" + function.name + ".txt");
    std::ofstream results(folder + "/" + function.name + ".out");
    char text[32];
    for (std::string line; std::getline(arguments, line);) {
      std::snprintf(text, sizeof text, "%.17g\n", function.compute(std::strtod(line.c_str(), nullptr)));
      results << text;
    }
  }
}
