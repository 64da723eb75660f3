// Paths in messages.
#pragma once

#include <string>

namespace occgrid {

/// A path as messages show it, on one line: each byte below 0x20 and 0x7F as
/// a question mark (SPEC.md section 8).
inline std::string one_line(std::string path) {
  for (char& c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return path;
}

}  // namespace occgrid
