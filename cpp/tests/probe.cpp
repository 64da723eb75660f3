// Lays open what the contract is made of (CONTRIBUTING.md, "The probe"): probe
// FUNCTION INPUT OUTPUT. A line of INPUT is a question, its columns separated
// by a space; the line of OUTPUT is the answer.
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "vector_functions.hpp"

int main(int argc, char** argv) {
  const auto& functions = vector_functions();
  const auto function = argc == 4 ? functions.find(argv[1]) : functions.end();
  if (function == functions.end()) {
    std::cerr << "usage: probe FUNCTION INPUT OUTPUT, FUNCTION one of";
    for (const auto& [name, unused] : functions) std::cerr << ' ' << name;
    std::cerr << '\n';
    return 2;
  }
  std::ifstream input(argv[2]);
  std::ofstream output(argv[3]);
  for (std::string line; std::getline(input, line);) {
    std::istringstream fields(line);
    Columns columns;
    for (std::string field; fields >> field;) columns.push_back(field);
    try {
      const char* separator = "";
      for (const std::string& column : function->second(columns)) {
        output << separator << column;
        separator = " ";
      }
    } catch (const std::exception&) {
      std::cerr << "cannot be understood: " << line << '\n';
      return 1;
    }
    output << '\n';
  }
  output.close();
  return input.eof() && output ? 0 : 1;
}
